"""Test that a new report is named after its folder and does not overwrite an existing
file.
"""

import os

import pytest

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


def test_a_folder_that_holds_something_is_left_alone(tmp_path):
    (tmp_path / "letter.txt").write_text("dear")
    with pytest.raises(UsageError, match="is not empty"):
        new(tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["letter.txt"]
