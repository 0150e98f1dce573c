"""Freshness: what makes a record stale, and what does not."""

import ast
import subprocess
import sys
from pathlib import Path

import pytest

from measured_report import ROOT
from measured_report.records.identity import canonical, identity_of, sections


def changed(toy) -> tuple[str, ...]:
    return toy.state().notes


def replace_in(toy, name: str, old: str, new: str) -> None:
    text = (toy.project.root / name).read_text()
    assert old in text
    toy.write(name, text.replace(old, new))


def test_a_record_of_this_code_is_fresh(toy):
    assert toy.state().kind == "fresh"


def test_comments_docstrings_and_layout_change_nothing(toy):
    replace_in(toy, "experiments/scene.py", '"""How far it slips."""', '"""Something else."""  # a remark')
    replace_in(toy, "experiments/scene.py", "1.0", "(\n        1.0\n    )")
    replace_in(toy, "experiments/toy.py", "def measure", "# why\ndef measure")
    assert toy.state().kind == "fresh"


def test_a_helper_counts(toy):
    replace_in(toy, "experiments/scene.py", "1.0", "2.0")
    assert toy.state().kind == "stale"
    assert changed(toy) == ("code: experiments/scene.py",)


def test_an_asset_counts(toy):
    toy.write("assets/robot.urdf", "<robot name='other'/>")
    assert changed(toy) == ("config: assets/robot.urdf",)


def test_the_profile_counts(toy):
    full, quick = (identity_of("toy", profile, toy.project.root) for profile in ("full", "quick"))
    assert full.config != quick.config
    assert full.code == quick.code


def test_a_module_that_is_not_imported_does_not_count(toy):
    toy.write("experiments/other.py", "x = 1\n")
    assert toy.state().kind == "fresh"


@pytest.mark.parametrize(
    "statement",
    [
        "import experiments.extra",
        "from experiments import extra",
        "from . import extra",
        "from .extra import x",
        "def late():\n    from experiments.extra import x",
    ],
)
def test_every_way_to_import_is_followed(toy, statement):
    toy.write("experiments/extra.py", "x = 1\n")
    toy.write("experiments/toy.py", statement + "\n")
    toy.measure()
    toy.write("experiments/extra.py", "x = 2\n")
    assert changed(toy) == ("code: experiments/extra.py",)


def test_package_versions_count(toy, monkeypatch):
    from measured_report.records import identity

    installed = {**toy.packages, "warp-lang": "9.9"}
    monkeypatch.setattr(identity.metadata, "version", installed.__getitem__)
    assert any(note.startswith("packages: warp-lang") and note.endswith("→ 9.9") for note in changed(toy))


def test_the_machine_does_not_count(toy):
    text = toy.record_path.read_text().replace("A processor", "Another")
    toy.record_path.write_text(text)
    assert toy.state().kind == "fresh"


def test_every_python_agrees_on_the_identity():
    versions = Path.home() / ".pyenv/versions"
    pythons = [path for minor in range(10, 14) for path in versions.glob(f"3.{minor}.*/bin/python")]
    if not pythons:
        pytest.skip("there is no other Python here")
    code = (
        "from measured_report.records.identity import identity_of; import sys;"
        "print([identity_of(name, 'full').code for name in sys.argv[1:]])"
    )
    digests = {
        subprocess.run([python, "-c", code, *sections()], cwd=ROOT, capture_output=True, check=True).stdout
        for python in [sys.executable, *pythons]
    }
    assert len(digests) == 1


def test_a_digest_does_not_depend_on_how_a_python_reads_nested_format_specifications():
    earlier, later = ast.parse('f"{name:{width}}"'), ast.parse('f"{name:{width}}"')
    specification = later.body[0].value.values[0].format_spec
    specification.values = [part for part in specification.values if isinstance(part, ast.FormattedValue)]
    without = canonical(later)
    specification.values.append(ast.Constant(""))
    assert canonical(earlier) == without == canonical(later)
