"""Freshness of this report: what moves its simulation makes no record stale, in any Python."""

import re
import shutil
import subprocess
from functools import cache
from pathlib import Path

import pytest

from measured_report.files.root import ROOT
from measured_report.records.code import unchanged_files
from measured_report.records.identity import identity_of, sections


@pytest.fixture(scope="module")
def copied(tmp_path_factory) -> Path:
    """A copy of the real experiments."""
    root = tmp_path_factory.mktemp("copied")
    shutil.copytree(ROOT / "experiments", root / "experiments", ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("packages", "assets", "report"):
        (root / name).symlink_to(ROOT / name)
    return root


def identities(root: Path) -> dict[str, tuple[str, str]]:
    with unchanged_files():
        found = {section: identity_of(section, "full", root, {}) for section in sections(root)}
    return {section: (identity.code, identity.config) for section, identity in found.items()}


@cache
def tracked() -> dict[str, tuple[str, str]]:
    return identities(ROOT)


def test_no_record_is_stale_when_the_simulation_moves(copied):
    before = identities(copied)
    assert before == tracked() and len(before) > 20
    moved = copied / "experiments/elsewhere/deeper"
    moved.parent.mkdir()
    (copied / "experiments/simulation").rename(moved)
    for path in set((copied / "experiments").rglob("*.py")) - set((copied / "experiments").rglob("apart/*")):
        text = path.read_text(encoding="utf-8")
        path.write_text(re.sub(r"\bexperiments\.simulation\b", "experiments.elsewhere.deeper", text), encoding="utf-8")
    assert identities(copied) == before


def test_the_generator_never_counts():
    with unchanged_files():
        found = {name for section in sections() for name in identity_of(section, "full", ROOT, {}).files}
    assert "experiments/simulation/simulation.py" in found
    assert not [name for name in found if name.startswith("measured_report/")]


def test_every_python_agrees_on_the_identity():
    versions = Path.home() / ".pyenv/versions"
    pythons = [path for minor in (10, 13) for path in versions.glob(f"3.{minor}.*/bin/python")]
    if not pythons:
        pytest.skip("there is no other Python here")
    code = (
        "import sys; sys.path.append('packages/measured-report');"
        "from measured_report.records.code import files, roots_of; from pathlib import Path;"
        "graph = files().graph(roots_of(Path.cwd()));"
        "print([graph.summary(f'experiments.{name}.measure')[0] for name in sys.argv[1:]])"
    )
    expected = str([tracked()[name][0] for name in sections()])
    for python in pythons:
        done = subprocess.run([python, "-c", code, *sections()], cwd=ROOT, capture_output=True, text=True, check=True)
        assert done.stdout.strip() == expected
