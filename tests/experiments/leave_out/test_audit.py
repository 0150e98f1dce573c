"""The audit is a program for any scene."""

import re
import sys
from importlib import import_module

from measured_report.files.root import ROOT


def test_the_audit_is_a_program_where_the_page_says_and_finds_the_shake_scene(monkeypatch, capsys):
    words = (ROOT / "templates/sections/leave_out.md.j2").read_text(encoding="utf-8")
    program = import_module(re.search(r"python -m ([\w.]+)</code>", words)[1])
    monkeypatch.setattr(program, "shake_scene", lambda: "the scene")
    monkeypatch.setattr(program, "audit", lambda scene, frame_count: [program.Item(scene, frame_count, 0)])
    monkeypatch.setattr(sys, "argv", ["audit"])
    assert program.main() == 0
    assert capsys.readouterr().out.split() == ["there", "used", "the", "scene", "300", "0"]
