"""Measuring for an upgrade: what it is held against, and where progress is said."""

from argparse import Namespace

import pytest
from conftest import program

from measured_report.changes.upgrade import base_of, lacking
from measured_report.commands import upgrade
from measured_report.editions.project import Manifest, Project, write_manifest
from measured_report.editions.release import release_of
from measured_report.files.config import config
from measured_report.files.errors import UsageError
from measured_report.measuring.batch import is_expected, reason_of


@pytest.mark.parametrize(
    ("error", "reason"),
    [
        (OSError("no mesh was found"), "no mesh was found"),
        (FileNotFoundError(2, "No such file or directory", "a.urdf"), "a.urdf: No such file or directory"),
        (OSError(28, "No space left on device"), "No space left on device"),
        (OSError(), "OSError"),
        (RuntimeError("CPU kernel build failed with error code -1"), "its kernels can't be compiled by Warp "),
    ],
)
def test_what_the_system_says_is_the_reason_and_names_a_file_only_where_it_has_one(error, reason):
    assert reason_of(error).startswith(reason) and is_expected(error)


def test_progress_does_not_run_into_an_answer_for_a_program():
    code = (
        "import subprocess, sys; from measured_report.commands.upgrade import _apart; answer = _apart();"
        "print('measuring', flush=True); subprocess.run(['echo', 'compiling']); print('{}', file=answer)"
    )
    done = program("-c", code)
    assert (done.stdout, done.stderr) == ("{}\n", "measuring\ncompiling\n")


def test_an_upgrade_is_held_against_the_edition_before_it_whatever_its_profile(toy):
    newer = toy.of("1.9.0")
    assert base_of(newer.project) is None
    for release, profile in (("1.4.0", "quick"), ("1.8.0", "full"), ("1.10.0", "full")):
        for section in config().changes.deciding:
            path = Project(release, profile, root=toy.project.root).record_path(section)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("{}")
    for profile in ("full", "quick"):
        assert base_of(Project("1.9.0", profile, root=toy.project.root)) == "1.8.0"
    measured = Project("1.8.0", root=toy.project.root)
    write_manifest(measured.results, Manifest("1.8.0", "2026-11-11"))
    for profile in ("full", "quick"):
        pinned = Project("1.8.0+mujoco-warp-4.0.0", profile, root=toy.project.root)
        assert base_of(pinned) == "1.8.0", "one package is another, and nothing of it was measured"
    assert lacking(newer.project) == [*config().changes.deciding]


def test_what_was_asked_for_is_tried_before_a_base_is_measured_for_it(toy, monkeypatch):
    def refuse(project, release, *others):
        raise UsageError(f"{release} cannot run the scene")

    monkeypatch.setattr(upgrade, "measure_what_can", refuse)
    monkeypatch.setattr(upgrade, "kept_by", lambda side, *others: side)
    asked = Namespace(device="cpu", since=release_of("1.8.0"), release=release_of("1.9.0"), format="text")
    with pytest.raises(UsageError, match=r"1\.9\.0 cannot run the scene"):
        upgrade.run(toy.project.of("1.9.0"), asked)
