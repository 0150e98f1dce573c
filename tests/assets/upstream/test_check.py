"""The patches for upstream apply to the released packages, and docs/upstream.md says what came of it."""

import json
import re

import pytest

from assets.upstream import check
from measured_report.files.errors import UsageError
from measured_report.files.root import ROOT

DOCUMENT = (ROOT / "docs/upstream.md").read_text(encoding="utf-8")
SHORT = "not test_step0 and not test_step2 and not test_step3 and not stays"
"""All new tests but for other integrators and Newton's turntable, which take a minute to compile."""


PASSED = {"passed", "deselected", "subtests"}


@pytest.fixture(scope="module")
def python():
    try:
        return check.environment()
    except UsageError as error:
        if re.search(r"(?i)dns|network|connect|failed to fetch|timed out", str(error)):
            pytest.skip("there is no index to install the released packages from")
        raise


@pytest.mark.slow
def test_the_patches_apply_to_the_released_packages_and_their_tests_pass(python, tmp_path):
    found = check.counts(python, check.patched(check.copied(python, tmp_path)), *check.NEW, "-k", SHORT)
    assert found["passed"] >= 31 and found.keys() <= PASSED


def test_what_was_checked_are_these_patches():
    checked = json.loads(check.CHECKED.read_text(encoding="utf-8"))
    assert checked["patches"] == check.digests()
    assert checked["own_after"] == checked["own_before"] and checked["same_when_off"]
    assert all(found.keys() <= PASSED for found in checked["new"].values())


def test_the_document_has_the_numbers_that_were_measured():
    checked = json.loads(check.CHECKED.read_text(encoding="utf-8"))
    rows = json.loads((ROOT / "results/newton-1.4.0/cure.json").read_text(encoding="utf-8"))["rows"]
    slips = {row["case"]: row.get("slip_mm") for row in rows}
    shake = "newton-implicitfast-50-shipped-3cm"
    walks, new = checked["walk_mm"], [found["passed"] for found in checked["new"].values()]
    said = [
        f"slides {slips[f'{shake}-plain-rounded']:.1f} mm",
        f"{slips[f'{shake}-term-rounded']:.2f} mm with the term",
        f"{checked['own_before']['passed']} pass and {checked['own_before']['skipped']} are skipped",
        f"all {new[0]} and {new[1]} pass",
        f"walks by {walks['false']:.2f} mm in a second without the term and by {walks['true']:.2f} mm with it",
    ]
    words = " ".join(DOCUMENT.split())
    assert [sentence for sentence in said if sentence not in words] == []
    named = {name.partition("==")[0].replace("-", "_"): name.partition("==")[2] for name in check.PACKAGES}
    assert all(patch.name in words and named[package] in patch.name for package, patch in check.PATCHES.items())
