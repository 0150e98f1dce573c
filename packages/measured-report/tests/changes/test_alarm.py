"""Test that the alarm lists untrusted numbers first with status 1, and that numbers
without a counterpart are not flips.
"""

import re
from argparse import Namespace
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest
from damage import damage
from toys import MODULE, ROWS, TEMPLATE, compared

from measured_report.changes.alarm import (
    _lines,
    check_text,
    diff_text,
    largest,
    summary,
)
from measured_report.changes.compare import Comparison
from measured_report.commands import check as check_command
from measured_report.commands import diff
from measured_report.editions.project import Project
from measured_report.editions.release import release_of
from measured_report.files.config import report
from measured_report.findings.editions import derive_edition
from measured_report.parts.claim import Claim
from measured_report.records.record import write_record

SOFT, STIFF = ROWS


def say(section: str, claim: Claim) -> str:
    """Return a text for a claim that consists of its name and outcome."""
    return f"{section}.{claim.name} {claim.outcome.answer}"


def changed(project: Project, before: str = "1.8.0") -> Comparison:
    return compared(project.of(before), project)


def test_a_comment_that_is_too_long_ends_with_a_whole_line_and_a_note():
    text = _lines([f"line {index:05}" for index in range(9000)], "markdown")
    *_, last, note, end = text.splitlines()
    assert re.fullmatch(r"line \d{5}", last)
    assert (note, end) == ("… shortened: FORMAT=json has everything", "```")
    assert len(text) < 65_536
    assert "shortened" not in _lines(["line"] * 9000, "text")


def test_a_section_that_is_gone_or_damaged_is_named_first(toy, capsys):
    newer = toy.of("1.8.0")
    arguments = Namespace(
        a=release_of("1.4.0"), b=release_of("1.8.0"), format="text", values="sums"
    )
    for change, kind in (
        (partial(damage, name="field: unit 'm'"), "damaged"),
        (Path.unlink, "missing"),
    ):
        newer.measure()
        newer.write("report/sections/other.py", MODULE.replace("order = 1", ""))
        newer.write(
            "templates/sections/other.md.j2",
            (toy.project.templates / "sections/toy.md.j2").read_text(),
        )
        newer.write("experiments/other.py", "")
        for side in (toy, newer):
            write_record(
                side.project.record_path("other"), side.record(section="other")
            )
        assert diff.run(toy.project, arguments) == 0
        capsys.readouterr()
        change(newer.record_path)
        assert diff.run(toy.project, arguments) == 1
        assert (
            capsys.readouterr()
            .out.splitlines()[2]
            .startswith(f"{kind}: newton 1.8.0, toy: ")
        )


FORMATS = ("text", "markdown", "json")


@pytest.mark.parametrize("form", FORMATS)
def test_each_damaged_replica_is_said_by_itself(toy, form):
    toy.measure()
    for name in ("a", "b"):
        folder = toy.project.results / "replicas"
        folder.mkdir(exist_ok=True)
        (folder / f"{name}.tgz").write_bytes(b"")
    text = check_text(derive_edition(toy.project), form, say)
    assert all(
        f"{name}.tgz was changed after it was sealed" in text for name in ("a", "b")
    )


@pytest.mark.parametrize(
    ("cells", "cpu", "flipped"),
    [
        ({}, "A processor", ["helps"]),
        ({}, "Another", []),
        ({"frame_count": 450}, "A processor", []),
    ],
)
def test_a_cost_flips_on_one_machine_for_as_many_frames_alone(
    toy, monkeypatch, cells, cpu, flipped
):
    monkeypatch.setitem(
        vars(report()),
        "settings",
        replace(report().settings, cost_terms=["frame_count"]),
    )
    vars(report()).pop("columns", None)
    toy.write("report/sections/toy.py", MODULE.replace("slip_mm", "frame_ms"))
    toy.write("templates/sections/toy.md.j2", TEMPLATE.replace("slip_mm", "frame_ms"))
    costs = [
        {"case": case, "frame_count": 900, "frame_ms": cost}
        for case, cost in (("soft", 40.0), ("stiff", 2.0))
    ]
    toy.measure(costs)
    newer = toy.of("1.8.0")
    record = newer.record(
        [{**costs[0], "frame_ms": 4.0, **cells}, {**costs[1], **cells}]
    )
    write_record(
        newer.record_path, replace(record, machine={**record.machine, "cpu": cpu})
    )
    found = changed(newer.project, before="1.4.0")
    assert [flip.name for flip in found.flips] == flipped
    assert any(note.startswith("speed and cost in toy: ") for note in found.notes) == (
        cpu == "Another"
    )


@pytest.mark.parametrize(
    ("slip_mm", "status", "counts"),
    [
        (5.0, 0, "alarms: 0; better: 1"),
        (0.06, 1, "alarms: 1; better: 0"),
        (0.0, 1, "alarms: 1; better: 0"),
        (8.0, 1, "alarms: 1; better: 0"),
        (6.4, 0, "alarms: 0; better: 0"),
    ],
)
def test_a_change_for_the_worse_or_a_suspicious_one_sets_the_status(
    toy, capsys, slip_mm, status, counts
):
    toy.of("1.8.0").measure([{**SOFT, "slip_mm": slip_mm}, STIFF])
    sides = {"a": release_of("1.4.0"), "b": release_of("1.8.0")}
    arguments = Namespace(**sides, format="text", values="sums")
    assert diff.run(toy.project, arguments) == status
    assert counts in capsys.readouterr().out


def test_a_change_for_the_better_does_not_hide_one_for_the_worse(toy, capsys):
    toy.of("1.8.0").measure([{**SOFT, "slip_mm": 4.0}, {**STIFF, "slip_mm": 0.36}])
    lines = largest(changed(toy.of("1.8.0").project, before="1.4.0"))
    assert [line.partition(" (")[0] for line in lines] == [
        "alarm: slip 0.312 mm → 0.36 mm, +15 % worse",
        "slip 6.4 mm → 4 mm, -37 % better",
    ]


@pytest.mark.parametrize(
    ("before", "after", "is_suspicious"),
    [
        (0.5, -0.4, True),
        (0.5, 0.4, False),
        (5.0, 0.04, True),
        (5.0, 0.06, False),
        (0.04, 5.0, True),
        (5, 0, False),
        (True, False, False),
    ],
)
def test_a_change_of_sign_or_of_more_than_a_hundredfold_is_suspicious(
    toy, before, after, is_suspicious
):
    toy.of("1.8.0").measure([{**SOFT, "slip_mm": 4.0}, STIFF])
    [move] = changed(toy.of("1.8.0").project, before="1.4.0").moves
    changed_move = replace(move, before=before, after=after)
    assert changed_move.is_suspicious == is_suspicious


def test_one_line_is_kept_for_changes_for_the_better(toy, monkeypatch):
    monkeypatch.setattr("measured_report.changes.alarm.LINES", 1)
    toy.of("1.8.0").measure([{**SOFT, "slip_mm": 4.0}, {**STIFF, "slip_mm": 0.36}])
    comparison = changed(toy.of("1.8.0").project, before="1.4.0")
    worse, better = largest(comparison)
    assert worse.startswith("alarm: ") and "better" in better
    assert "improvements: 1" in summary(comparison)


def test_diff_and_check_say_it_in_every_format_and_no_record_ends_the_block_of_markdown(
    toy, capsys, tmp_path
):
    toy.of("1.8.0").measure([{**SOFT, "slip_mm": 0.4}, STIFF])
    sides = {"a": release_of("1.4.0"), "b": release_of("1.8.0")}
    for form in FORMATS:
        assert (
            diff.run(toy.project, Namespace(**sides, format=form, values="sums")) == 1
        )
        assert "toy" in capsys.readouterr().out
        assert (
            check_command.run(
                toy.project, Namespace(release=sides["a"], format=form, strict=True)
            )
            == 0
        )
        assert "holds" in capsys.readouterr().out
    newer = toy.of("1.8.0")
    newer.measure([{**SOFT, "failure": "<img> | [x](y) ``` @all"}, STIFF])
    said = diff_text(changed(newer.project, before="1.4.0"), "", "markdown", say)
    assert (
        said.startswith("```text\n")
        and said.endswith("\n```")
        and "<img> | [x](y) ''' @all" in said
    )
