"""The patches for upstream apply to the released packages, and docs/upstream.md says what came of it."""

import hashlib
import json

from measured_report.files.root import ROOT

FOLDER = ROOT / "assets/upstream"
CHECKED = json.loads((FOLDER / "checked.json").read_text(encoding="utf-8"))
DOCUMENT = (ROOT / "docs/upstream.md").read_text(encoding="utf-8")


def test_what_was_checked_are_these_patches():
    digests = {patch.name: hashlib.sha256(patch.read_bytes()).hexdigest() for patch in FOLDER.glob("*.patch")}
    assert CHECKED["patches"] == digests
    assert CHECKED["own_after"] == CHECKED["own_before"] and CHECKED["same_when_off"]
    assert all("failed" not in found for found in CHECKED["new"].values())


def test_the_document_has_the_numbers_that_were_measured():
    rows = json.loads((ROOT / "results/newton-1.4.0/cure.json").read_text(encoding="utf-8"))["rows"]
    slips = {row["case"]: row.get("slip_mm") for row in rows}
    shake = "newton-implicitfast-50-shipped-3cm"
    walks, new = CHECKED["walk_mm"], [found["passed"] for found in CHECKED["new"].values()]
    said = [
        f"slides {slips[f'{shake}-plain-rounded']:.1f} mm",
        f"{slips[f'{shake}-term-rounded']:.2f} mm with the term",
        f"{CHECKED['own_before']['passed']} pass and {CHECKED['own_before']['skipped']} are skipped",
        "all {}, {} and {} pass".format(*new),
        f"walks by {walks['false']:.2f} mm in a second without the term and by {walks['true']:.2f} mm with it",
    ]
    words = " ".join(DOCUMENT.split())
    assert [sentence for sentence in said if sentence not in words] == []
