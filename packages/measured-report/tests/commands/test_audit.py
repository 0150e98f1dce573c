"""Test the command ``measured-report audit``: number-audit with the noise of this
report's records.
"""

import sys

import pytest

from measured_report.commands.audit import evidence_of, noise_of_record
from measured_report.commands.new import main


def test_a_number_of_a_record_is_audited(toy, monkeypatch, capsys):
    pytest.importorskip("number_audit", reason="the audit is a package of its own")
    toy.measure()
    (toy.project.root / ".git").mkdir()
    path = toy.project.root / "README.md"
    source = toy.record_path.relative_to(toy.project.root).as_posix()
    path.write_text(f"6.36 mm<!-- = {source}#/rows/soft/slip_mm -->", encoding="utf-8")
    monkeypatch.setattr("sys.argv", ["measured-report", "audit", str(path), "--check"])
    assert (main(), capsys.readouterr().out) == (0, "")
    path.write_text(
        path.read_text(encoding="utf-8").replace("6.36", "6.37"), encoding="utf-8"
    )
    assert main() == 1
    assert "stale: the text has 6.37 mm, but " in capsys.readouterr().out


def test_a_record_whose_noise_can_not_be_read_is_an_error_of_its_mark(toy):
    toy.measure()
    text = toy.record_path.read_text(encoding="utf-8")
    toy.record_path.write_text(
        text.replace("6.3617", "6.3618"), encoding="utf-8"
    )  # because it is sealed
    evidence_of.cache_clear()
    with pytest.raises(ValueError, match="cannot compute the noise of slip_mm"):
        noise_of_record(toy.record_path, 0, "slip_mm")


def test_without_the_package_a_line_names_it(monkeypatch, capsys):
    monkeypatch.setitem(sys.modules, "number_audit.command", None)
    monkeypatch.setattr("sys.argv", ["measured-report", "audit", "README.md"])
    assert main() == 2
    assert "pip install ./packages/number-audit" in capsys.readouterr().err
