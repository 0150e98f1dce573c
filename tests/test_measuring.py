"""Measuring: sections side by side, what one's fault costs the others, and where it is said."""

import os
import subprocess
import sys

import warp as wp

from experiments import run
from report import ReportError
from report.commands.editions import aside
from report.records.project import Project, own_release
from report.upgrade import DECIDING, base_of, unmeasured


def test_sections_are_measured_side_by_side_but_for_those_about_time(monkeypatch, tmp_path, capfd):
    def measure(project, section, module, device, count):
        (tmp_path / section).write_text(f"{os.getpid()} {count}")
        if section == "gap":
            raise ReportError("it has no width")

    monkeypatch.setattr(run, "measure_section", measure)
    project, device, own = Project(own_release(), "quick"), wp.get_device("cpu"), str(os.getpid())
    capfd.readouterr()  # what Warp says of itself
    assert run.measure_all(project, ["speed", "gap", "friction", "noise"], device, 2, 0.0) == 1
    found = {path.name: path.read_text().split() for path in tmp_path.iterdir()}
    assert found.pop("speed") == [own, "1"]
    assert all(pid != own and count == "2" for pid, count in found.values())
    out, err = capfd.readouterr()
    assert out.splitlines() == ["[1–3/4] gap, friction, noise, 2 at a time", "[4/4] speed"]
    assert err.startswith("gap: measuring failed; what was there is kept: it has no width")


def test_what_does_not_compile_is_said_in_one_line(capfd):
    said = run.reason_of(RuntimeError("CPU kernel build failed with error code -1"))
    assert said.startswith("its kernels can't be compiled by Warp ") and capfd.readouterr().err == ""


def test_progress_does_not_run_into_an_answer_for_a_program(capfd):
    with aside():
        print("measuring")
        subprocess.run([sys.executable, "-c", "print('compiling')"], check=True)
    print("{}")
    assert capfd.readouterr() == ("{}\n", "measuring\ncompiling\n")


def test_an_upgrade_is_held_against_the_edition_before_it_whatever_its_profile(toy):
    newer = toy.of("1.9.0")
    assert base_of(newer.project) is None
    for release, profile in (("1.4.0", "quick"), ("1.8.0", "full"), ("1.10.0", "full")):
        for section in DECIDING:
            path = Project(release, profile, root=toy.project.root).record_path(section)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("{}")
    for profile in ("full", "quick"):
        assert base_of(Project("1.9.0", profile, root=toy.project.root)) == "1.8.0"
    assert [fault.kind for fault in unmeasured(newer.project)] == ["missing"] * len(DECIDING)
