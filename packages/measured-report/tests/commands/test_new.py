"""A new report: on the package and with the title that it was asked for, everywhere."""

import json
import os
import re

import pytest

from measured_report.commands.new import new
from measured_report.files.config import Report
from measured_report.files.errors import UsageError


def test_a_report_on_another_package_names_no_other(tmp_path):
    new(
        folder := tmp_path / "mine",
        "scikit-learn==1.5.0",
        title := "How \"it\" changes: a 'title'",
    )
    paths = (
        path
        for path in folder.rglob("*")
        if path.is_file() and path.suffix not in (".whl", ".json")
    )
    texts = {
        path: path.read_text() for path in paths if path.parent.name != "docs"
    }  # a wheel's, with its example
    for path, text in texts.items():
        assert not re.search("(?i)pendulum|numpy|@[A-Z]+@", text), path
    assert all(
        title in texts[folder / name] for name in ("README.md", "templates/front.md.j2")
    )
    assert (
        Report(folder).settings.title == title
        and f"title: {json.dumps(title)}" in texts[folder / "CITATION.cff"]
    )
    assert '"scikit-learn==1.5.0"' in texts[folder / "pyproject.toml"]
    assert Report(folder).settings.option == "SCIKIT_LEARN"
    assert (
        "steps.new.outputs.release" in texts[folder / ".github/workflows/upgrade.yml"]
    )
    compiled = [
        compile(text, path, "exec")
        for path, text in texts.items()
        if path.suffix == ".py"
    ]
    assert len(compiled) == 4


def test_without_one_it_is_the_pendulum_and_what_is_no_package_or_title_is_refused(
    tmp_path, capsys
):
    new(tmp_path / "in a" / "mine")
    assert (
        f"cd '{os.path.relpath(tmp_path / 'in a' / 'mine')}' &&"
        in capsys.readouterr().out
    )
    (tmp_path / "in a" / "mine").rename(tmp_path / "mine")
    names = {path.name for path in (tmp_path / "mine").rglob("*") if path.is_file()}
    assert "pendulum.py" in names and "importing.py" not in names
    assert len(names) >= 3
    for package, title in (
        ("no package", ""),
        ("numpy==one", ""),
        ("numpy==2.3.0", "A {title}"),
        ("", "a\x1b[2Jb"),
    ):
        with pytest.raises(
            UsageError, match=r"which no title takes|names one with its release"
        ):
            new(tmp_path / "other", package, title)
    assert not (tmp_path / "other").exists()


@pytest.mark.parametrize("package", ["JINJA2", "no-such-thing"])
def test_a_package_is_imported_however_its_name_is_spelt(tmp_path, package):
    new(folder := tmp_path / "mine", f"{package}==1.0")
    module, codes = {}, []
    exec((folder / "experiments/importing.py").read_text(), module)
    module["start"] = lambda code: (
        codes.append(code) or (1.0 if code == "pass" else 3.0)
    )
    if "no" in package:
        with pytest.raises(
            ImportError, match="no-such-thing has no module that can be imported"
        ):
            module["measure"](None)
    else:
        rows = module["measure"](None).rows
        assert [row["import_ratio"] for row in rows] == [3.0] * 5 and codes[:3] == [
            "import jinja2"
        ] * 2 + ["pass"]
