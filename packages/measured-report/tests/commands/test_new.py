"""A new report: it is named after its folder, and nothing that is there is overwritten."""

import os
import re
import sys

import pytest

from measured_report.commands import new as new_command
from measured_report.commands.new import new
from measured_report.files.config import Report
from measured_report.files.errors import UsageError


def test_a_new_report_has_the_name_of_its_folder_and_no_mark_left(tmp_path, capsys):
    folder = tmp_path / "in a" / "mine"
    new(folder)
    assert f"cd '{os.path.relpath(folder)}' &&" in capsys.readouterr().out
    files = [path for path in folder.rglob("*") if path.is_file()]
    for path in files:
        if path.suffix != ".whl":
            text = path.read_text()
            assert not any(mark in text for mark in ("@NAME@", "@AUTHOR@", "@SOURCE@"))
    assert "pendulum.py" in {path.name for path in files}
    assert Report(folder).settings.name == "mine"
    upgrade = (folder / ".github/workflows/upgrade.yml").read_text()
    assert "steps.new.outputs.release" in upgrade


def test_a_new_report_pins_a_release_that_runs_on_this_python(tmp_path, monkeypatch):
    new(tmp_path / "mine")
    project = (tmp_path / "mine/pyproject.toml").read_text()
    least = re.search(r"requires-python = \">=3\.(\d+)", project)[1]
    assert int(least) <= sys.version_info.minor
    monkeypatch.setattr(new_command, "OLDER", {"numpy==2.4.6": "numpy==2.2.6"})
    new(tmp_path / "older")
    assert '"numpy==2.2.6"' in (tmp_path / "older/pyproject.toml").read_text()


def test_a_folder_that_holds_something_is_left_alone(tmp_path):
    (tmp_path / "letter.txt").write_text("dear")
    with pytest.raises(UsageError, match="is not empty"):
        new(tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["letter.txt"]
