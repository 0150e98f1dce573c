"""Test the comparison of a measurement for an upgrade, and where its progress is
printed.
"""

import json
import os
import subprocess
import sys
from argparse import Namespace
from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
from toys import ROWS, derived, program

from measured_report.changes.compare import compare
from measured_report.changes.moves import moves_between
from measured_report.changes.query import Query
from measured_report.commands import diff, upgrade
from measured_report.commands.new import SKELETON
from measured_report.commands.upgrade import base_of, lacking
from measured_report.editions.project import Manifest, Project, write_manifest
from measured_report.editions.release import release_of
from measured_report.files.config import report, report_in
from measured_report.files.errors import UsageError
from measured_report.files.settings import Columns
from measured_report.records.replicas import FOLDER

SECTIONS = ["toy"]


def test_progress_does_not_run_into_an_answer_for_a_program():
    code = (
        "import subprocess, sys; from measured_report.commands.upgrade import _output_file; answer = _output_file();"
        "print('measuring', flush=True); subprocess.run(['echo', 'compiling']); print('{}', file=answer)"
    )
    done = program("-c", code)
    assert (done.stdout, done.stderr) == ("{}\n", "measuring\ncompiling\n")


def test_an_upgrade_is_held_against_the_edition_before_it_whatever_its_profile(toy):
    newer = toy.of("1.9.0")
    toy.record_path.unlink()
    assert base_of(newer.project, SECTIONS) is None
    for release, profile in (("1.4.0", "quick"), ("1.8.0", "full"), ("1.10.0", "full")):
        for section in SECTIONS:
            path = Project(release, profile, root=toy.project.root).record_path(section)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("{}")
    for profile in ("full", "quick"):
        assert (
            base_of(Project("1.9.0", profile, root=toy.project.root), SECTIONS)
            == "1.8.0"
        )
    measured = Project("1.8.0", root=toy.project.root)
    write_manifest(measured.results, Manifest("1.8.0", "2026-11-11", ()))
    for profile in ("full", "quick"):
        pinned = Project("1.8.0+mujoco-warp-4.0.0", profile, root=toy.project.root)
        assert base_of(pinned, SECTIONS) == "1.8.0", (
            "one package is another, and nothing of it was measured"
        )
    assert lacking(newer.project, SECTIONS) == SECTIONS


def test_what_was_asked_for_is_tried_before_a_base_is_measured_for_it(toy, monkeypatch):
    def refuse(project, release, *others):
        raise UsageError(f"{release} cannot run the scene")

    monkeypatch.setattr(upgrade, "measure_available", refuse)
    asked = Namespace(
        device="cpu",
        since=release_of("1.8.0"),
        release=release_of("1.9.0"),
        format="text",
    )
    with pytest.raises(UsageError, match=r"1\.9\.0 cannot run the scene"):
        upgrade.run(toy.project.of("1.9.0"), asked)


def test_an_edition_is_never_compared_with_itself(toy):
    given = Namespace(
        device="cpu",
        since=release_of("1.4.0"),
        release=release_of("1.4.0"),
        format="text",
        a="1.4.0",
        b="1.4.0",
    )
    for command in (upgrade, diff):
        with pytest.raises(
            UsageError,
            match=r"Newton 1\.4\.0 would be compared with itself: name another",
        ):
            command.run(toy.project, given)


@pytest.mark.parametrize("edition", ["numpy", "scikit-learn", "opencv_Python"])
def test_the_variable_of_make_is_the_package_s_own_whatever_is_in_its_name(
    tmp_path, edition
):
    """Test that the edition reaches the command.

    Otherwise it would measure nothing and report success.
    """
    (tmp_path / "report.toml").write_text(f'edition = "{edition}"\n')
    (tmp_path / "pyproject.toml").write_text(
        f'[project]\ndependencies = ["{edition}==1.4.0"]\n'
    )
    (tmp_path / "report/sections").mkdir(parents=True)
    (tmp_path / "build.py").write_text((SKELETON / "build.py").read_text())
    option = edition.upper().replace("-", "_")
    told = {"TYPED": f"{option}=9.9.9 A=9.9.9 B=9.9.9"}
    command = [sys.executable, "build.py", "upgrade"]
    done = subprocess.run(
        command,
        cwd=tmp_path,
        env={**os.environ, **told},
        capture_output=True,
        text=True,
    )
    assert done.stdout.startswith(f"{edition} 9.9.9 against 1.4.0: "), done.stderr


def test_an_upgrade_says_first_what_it_measures_of_both(toy, monkeypatch, capsys):
    toy.record_path.unlink()

    def measure(project, *others):
        replace(toy, project=project).measure()
        return project, True

    monkeypatch.setattr(upgrade, "measure_available", measure)
    asked = Namespace(
        device="cpu",
        since=release_of("1.8.0"),
        release=release_of("1.9.0"),
        format="text",
    )
    upgrade.run(toy.project.of("1.9.0"), asked)
    lines = capsys.readouterr().out.splitlines()
    assert lines[:2] == [
        f"newton {name}: sections to measure: toy" for name in ("1.9.0", "1.8.0")
    ]
    assert not [line for line in lines if "not measured" in line or "rerun" in line]


@pytest.mark.parametrize(
    ("deviation", "slower", "passes", "is_listed"),
    [
        (0.001, 1.0, 2, False),
        (0.001, 1.1, 2, True),
        (0.02, 1.0, 4, False),
        (0.05, 1.0, 6, False),
    ],
)
def test_releases_are_timed_until_a_change_of_the_threshold_would_show(
    toy, monkeypatch, capsys, deviation, slower, passes, is_listed
):
    """Times of one machine differ by 0.1 to 5 % from pass to pass; the threshold is 5 %."""
    chance = np.random.default_rng(1)
    count = Counter()

    def measure(project, release, names, device):
        count[project.release] += 1
        scale = slower if project.release == "1.9.0" else 1.0
        times = 10.0 * scale * chance.normal(1.0, deviation, 6)
        rows = [
            {"case": f"c{index}", "frame_ms": float(time)}
            for index, time in enumerate(times)
        ]
        replace(toy, project=project).measure([*ROWS, *rows])
        return project, True

    monkeypatch.setattr(upgrade, "measure_available", measure)
    changes = replace(report().settings.changes, thresholds={"toy.c0.frame_ms": 0.05})
    settings = replace(report().settings, changes=changes, repeating={})
    monkeypatch.setitem(vars(report()), "settings", settings)
    vars(report()).pop("columns", None)
    sides = [toy.project.of(name) for name in ("1.8.0", "1.9.0")]
    releases = [release_of(side.release) for side in sides]
    stale = upgrade.in_turn(sides)[0].results / FOLDER
    stale.mkdir(parents=True)
    (stale / "pass-5.tgz").write_bytes(b"of an earlier upgrade")
    timed = upgrade.timed_in_turn(sides, releases, ["toy"], "cpu")
    assert count == {"1.8.0": passes, "1.9.0": passes}
    [pair] = zip(*(edition.chapters.values() for edition in timed), strict=True)
    named = next(move for move in moves_between(*pair) if move.is_named)
    assert named.exceeds_threshold == is_listed
    if passes == 2:
        assert named.noise < 0.05 * named.before
    for side in sides:
        replace(toy, project=side).measure()
    given = Namespace(a=releases[0], b=releases[1], format="json")
    assert diff.run(sides[1], given) == is_listed
    alarms = json.loads(
        capsys.readouterr().out.rpartition("pass")[2].partition("\n")[2]
    )
    assert alarms["alarms"] == ["toy.c0.frame_ms"] * is_listed
    assert not upgrade.timed_in_turn(sides, releases, ["another"], "cpu")


def test_why_names_what_was_set_otherwise_and_an_edition_without_a_name_is_not_named(
    toy, monkeypatch
):
    newer = toy.of("1.9.0")
    for side, damping in ((toy, 0.0), (newer, 0.62)):
        side.measure(
            [
                {**row, "damping": damping, "slip_mm": row["slip_mm"] * (1 + damping)}
                for row in ROWS
            ]
        )
    changed = replace(report().settings.changes, thresholds={"toy.soft.slip_mm": 0.05})
    columns = [*report().settings.columns, Columns(names=["damping"], kind="computed")]
    rules = replace(report().settings, changes=changed, columns=columns)
    with report_in(toy.project.root) as entered:
        monkeypatch.setitem(vars(entered), "settings", rules)
        vars(entered).pop("columns", None)
        sides = [derived(side.project) for side in (toy, newer)]
        lines = upgrade.verdict(compare(*sides), lambda *claim: "", *sides, SECTIONS)
        assert (
            "why: settings changed: toy.soft.damping 0 → 0.62; toy.stiff.damping 0 → 0.62"
            in lines
        )
        assert (
            Query("toy.firm.slip_mm").quantity(sides[0].chapters).reason
            == "section toy has not been measured in this way"
        )
