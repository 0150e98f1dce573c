"""The audit is a program for any scene, and without stages that are not used nothing changes."""

import re
import sys
from dataclasses import replace
from importlib import import_module

import numpy as np

from experiments.facts.case import LEAN
from experiments.simulation.simulation import simulate
from measured_report.files.root import ROOT


def test_the_audit_is_a_program_where_the_page_says_and_finds_the_shake_scene(monkeypatch, capsys):
    words = (ROOT / "templates/sections/leave_out.md.j2").read_text(encoding="utf-8")
    program = import_module(re.search(r"python -m ([\w.]+)</code>", words)[1])
    monkeypatch.setattr(program, "shake_scene", lambda: "the scene")
    monkeypatch.setattr(program, "audit", lambda scene, frame_count: [program.Item(scene, frame_count, 0)])
    monkeypatch.setattr(sys, "argv", ["audit"])
    assert program.main() == 0
    assert capsys.readouterr().out.split() == ["there", "used", "the", "scene", "300", "0"]


def test_stages_that_are_not_used_change_no_bit():
    off = ({}, {"sensors": False}, {"limits": False})
    short = replace(LEAN, cube_in_hand=True, frame_count=100)  # 10 of them in the shake
    cases = [replace(short, name=str(change), **change) for change in off]
    kept, *others = simulate(cases, device="cpu")
    for case, trace in zip(cases[1:], others, strict=True):
        assert np.array_equal(trace.poses, kept.poses), case.name
