"""Test the alarm with changed copies of the tracked records; untrusted numbers come first."""

import json
import re
from collections.abc import Callable, Iterable
from dataclasses import replace

import pytest
from conftest import SOURCES
from toys import compared, derived, link

from measured_report.changes.alarm import check_text, diff_text
from measured_report.changes.compare import Comparison
from measured_report.commands.upgrade import verdict
from measured_report.editions.project import Project, own_release
from measured_report.files.root import ROOT
from measured_report.parts.claim import Claim
from measured_report.records.record import Record, load_record, write_record

SECTIONS = ("contact_source", "noise", "reproduction", "upgrade")
SHAKEN = "slip_mm drift_mm_s oscillation_mm wander_mm increment_mean_mm increment_last_mm cycle_count".split()
"""Numbers that are missing in a run without finite poses."""


def broken(row: dict, frame: int) -> dict:
    """Return the row of a run whose poses are not finite from a frame on, as the
    recorder writes it.
    """
    reason = f"a body's pose is not finite in frame {frame}"
    lost = [name for name in SHAKEN if name in row]
    return row | {
        "failure": reason,
        **dict.fromkeys(lost),
        **{f"{name}_reason": reason for name in lost},
    }


def say(section: str, claim: Claim) -> str:
    """Return words that repeat the test of the claim."""
    return f"{section}.{claim.name} {claim.outcome.answer}"


@pytest.fixture
def measured(tmp_path) -> Callable[..., Project]:
    """Make an edition from the tracked records of 1.8.0, which a function changes."""
    link(tmp_path, *SOURCES)

    def make(
        release: str, change: Callable[[Record], Record] = lambda record: record
    ) -> Project:
        project = Project(release, root=tmp_path, own_release=own_release())
        for section in SECTIONS:
            record = load_record(ROOT / "results/newton-1.8.0" / f"{section}.json")
            packages = {**record.identity.packages, "newton": release}
            record = replace(
                record, identity=replace(record.identity, packages=packages), traces={}
            )
            write_record(project.record_path(section), change(record))
        return project

    make("1.8.0")
    return make


def changed(project: Project, before: str = "1.8.0") -> Comparison:
    return compared(project.of(before), project)


def change_of(
    section: str, *rows_of: Callable[[dict], dict]
) -> Callable[[Record], Record]:
    """Apply these functions one after the other to each row of a section, or of all
    sections.
    """

    def change(record: Record) -> Record:
        rows = record.rows
        for change_row in rows_of if section in ("all", record.section) else ():
            rows = [change_row(row) for row in rows]
        return replace(record, rows=rows)

    return change


def rows_changed(
    section: str, cases: Iterable[str], frame: int
) -> Callable[[Record], Record]:
    return change_of(
        section,
        lambda row: broken(row, frame) if not cases or row["case"] in cases else row,
    )


@pytest.mark.parametrize(
    ("section", "cases", "frame"),
    [
        ("all", (), 1),
        ("reproduction", ("as-shipped",), 500),
        ("reproduction", (), 1),
        ("noise", (), 1),
    ],
)
def test_what_is_not_a_number_is_named_first(measured, section, cases, frame):
    """Test a release in which all runs fail in the first frame, as in Newton 1.3.0 with
    a later Warp, and a release with one run that fails in frame 500.
    """
    found = changed(measured("1.9.0", rows_changed(section, cases, frame)))
    assert found.is_alarm
    said = diff_text(found, "", "text", say).splitlines()
    assert f"frame {frame}" in said[2] and "newton 1.9.0" in said[2]
    assert json.loads(diff_text(found, "", "json", say))["status"] == 1


@pytest.mark.parametrize(
    ("lost", "said"),
    [
        (
            {"slip_mm": None, "slip_mm_reason": "ValueError: no such array"},
            "slip 0.326 mm → n/a (shipped pads: ValueError",
        ),
        ({"dropped": True}, "dropped no → yes worse"),
    ],
)
def test_a_named_number_that_is_gone_or_whose_run_was_lost_rings(measured, lost, said):
    change = change_of(
        "upgrade", lambda row: row | (lost if row["case"] == "as-shipped" else {})
    )
    project = measured("1.9.0", change)
    found = changed(project)
    assert found.is_alarm and not found.faults
    assert (
        diff_text(found, "", "text", say).splitlines()[3].startswith(f"alarm: {said}")
    )
    sides = derived(project.of("1.8.0")), derived(project)
    advice = verdict(found, say, *sides, SECTIONS)[-1]
    assert ("make bisect" in advice) == ("dropped" in lost), (
        "a search between a number and none would be refused"
    )


def test_a_broken_edition_alarms_by_itself_and_on_both_sides(measured):
    project = measured("1.9.0", rows_changed("all", (), 1))
    edition = derived(project)
    assert check_text(edition, "text", say).startswith("cannot tell: newton 1.9.0, ")
    assert changed(project, before="1.9.0").is_alarm, "broken alike is no agreement"
    assert changed(project.of("1.8.0"), before="1.9.0").is_alarm
    assert not changed(project.of("1.8.0")).is_alarm


def test_the_documentation_names_what_the_json_has(measured):
    text = (ROOT / "docs/alarm.md").read_text(encoding="utf-8")
    project = measured("1.9.0", rows_changed("reproduction", ("as-shipped",), 500))
    said = diff_text(changed(project), "", "json", say)
    edition = derived(project)
    for each in (said, check_text(edition, "json", say)):
        names = set(re.findall(r'"([a-z_]+)":', each)) - {"case", *SECTIONS}
        assert {name for name in names if f"`{name}`" not in text} == set()
