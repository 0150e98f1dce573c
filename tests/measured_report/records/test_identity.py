"""Freshness: what makes a record stale, and what does not."""

import ast
import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest

from measured_report.files.root import ROOT
from measured_report.records import provenance
from measured_report.records.code import unchanged_files
from measured_report.records.identity import identity_of, sections
from measured_report.records.syntax import Canonical, _walk

SOURCES = {
    "experiments/toy.py": '''"""A section."""
from experiments.middle import firm, loose

RUNS = 3


def measure(conditions):
    """Measure it."""
    assert RUNS, "no runs"
    return [firm(run) - loose(run) for run in range(RUNS)]
''',
    "experiments/middle.py": """from experiments.far import scaled
from measured_report.records.columns import PLAIN

ROBOT = "assets/robot.urdf"


def firm(run, factor=2.0):
    if run < 0:
        raise ValueError(f"{run} is negative")
    return scaled(run) * factor


def loose(run):
    return len(ROBOT) + len(PLAIN) + run


def unused():
    return 1
""",
    "experiments/far.py": """LIMIT = 10.0


def scaled(run):
    return min(run, LIMIT)
""",
}


@pytest.fixture
def chain(toy):
    """The toy with a section that is measured through two other modules."""
    for name, text in SOURCES.items():
        toy.write(name, text)
    toy.measure()
    return toy


def replace_in(toy, old: str, new: str) -> None:
    """Replace a text wherever the experiments have it."""
    paths = [path for path in (toy.project.root / "experiments").rglob("*.py") if old in path.read_text()]
    assert paths
    for path in paths:
        toy.write(path.relative_to(toy.project.root).as_posix(), path.read_text().replace(old, new))


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('"""Measure it."""', '"""Something else."""  # a remark'),
        ("LIMIT = 10.0", "LIMIT = (\n    10.0\n)"),
        ("is negative", "is perhaps negative"),
        ('"no runs"', 'f"{RUNS} runs"'),
        ("return 1", "return 2"),
        ("def unused", "def later():\n    return 3\n\n\ndef unused"),
        ("scaled", "limited"),
        ("LIMIT", "BOUND"),
        ("PLAIN", "REASON"),
        ("import firm, loose", "import loose, firm as firm"),
    ],
)
def test_what_changes_no_row_leaves_a_record_fresh(chain, old, new):
    replace_in(chain, old, new)
    assert chain.state().kind == "fresh"


@pytest.mark.parametrize(
    ("old", "new", "file"),
    [
        ("RUNS = 3", "RUNS = 4", "toy"),
        ("factor=2.0", "factor=3.0", "middle"),
        ("ValueError", "TypeError", "middle"),
        ("LIMIT = 10.0", "LIMIT = 11.0", "far"),
        ("return min", "return max", "far"),
        ("firm(run) - loose(run)", "loose(run) - firm(run)", "toy"),
        ("LIMIT = 10.0", "LIMIT = 10.0\nprint(LIMIT)", "far"),
    ],
)
def test_what_may_change_a_row_makes_it_stale(chain, old, new, file):
    replace_in(chain, old, new)
    assert f"code: experiments/{file}.py" in chain.state().notes


def test_the_profile_and_package_versions_count_and_the_machine_does_not(toy, monkeypatch):
    full, quick = (identity_of("toy", profile, toy.project.root) for profile in ("full", "quick"))
    assert full.config != quick.config
    assert full.code == quick.code
    text = toy.record_path.read_text().replace("A processor", "Another")
    toy.record_path.write_text(text)
    assert toy.state().kind == "fresh"
    installed = {**toy.packages, "warp-lang": "9.9"}
    monkeypatch.setattr(provenance.metadata, "version", installed.__getitem__)
    assert any(note.startswith("packages: warp-lang") and note.endswith("→ 9.9") for note in toy.state().notes)


@pytest.mark.parametrize(
    "statement",
    ["import experiments.extra", "from experiments import extra", "from . import extra", "from .extra import x"]
    + ["def late():\n    from experiments.extra import x"],
)
def test_what_a_module_does_when_it_is_imported_counts_however_it_is(toy, statement):
    toy.write("experiments/extra.py", "x = 1\nprint(x)\n")
    toy.write("experiments/toy.py", f"{statement}\n\n\ndef measure(conditions):\n    pass\n")
    toy.measure()
    toy.write("experiments/extra.py", "x = 2\nprint(x)\n")
    assert toy.state().notes == ("code: experiments/extra.py",)


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


def edited(root: Path, edit: Callable[[str], str]) -> None:
    for path in (root / "experiments").rglob("*.py"):
        path.write_text(edit(path.read_text(encoding="utf-8")), encoding="utf-8")


def reworded(text: str) -> str:
    """A module in which every error says something else."""
    tree = ast.parse(text)
    for node in ast.walk(tree):
        if isinstance(node, ast.Raise | ast.Assert):
            said = node.exc if isinstance(node, ast.Raise) else node.msg
            for part in ast.walk(said) if said else ():
                if isinstance(part, ast.Constant) and isinstance(part.value, str):
                    part.value += " perhaps"
    return ast.unparse(tree)


def test_no_record_is_stale_when_the_simulation_moves_and_errors_are_reworded(copied):
    before = identities(copied)
    assert before == identities(ROOT) and len(before) > 30
    moved = copied / "experiments/elsewhere/deeper"
    moved.parent.mkdir()
    (copied / "experiments/simulation").rename(moved)
    edited(copied, lambda text: reworded(re.sub(r"\bexperiments\.simulation\b", "experiments.elsewhere.deeper", text)))
    assert identities(copied) == before


def test_the_generator_never_counts():
    with unchanged_files():
        found = {name for section in sections() for name in identity_of(section, "full", packages={}).files}
    assert "experiments/simulation/simulation.py" in found
    assert not [name for name in found if name.startswith("measured_report/")]


def test_every_python_agrees_on_the_identity():
    versions = Path.home() / ".pyenv/versions"
    pythons = [path for minor in range(10, 14) for path in versions.glob(f"3.{minor}.*/bin/python")]
    if not pythons:
        pytest.skip("there is no other Python here")
    code = (
        "import sys; sys.path.append('packages/measured-report');"
        "from measured_report.records.code import files, roots_of; from pathlib import Path;"
        "graph = files().graph(roots_of(Path.cwd()));"
        "print([sorted(graph.reached(f'experiments.{name}.measure').values()) for name in sys.argv[1:]])"
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
    without = Canonical().plain(later, ())
    specification.values.append(ast.Constant(""))
    assert Canonical().plain(earlier, ()) == without == Canonical().plain(later, ())


def test_a_tree_is_walked_as_python_walks_it():
    tree = ast.parse(Path(__file__).read_text(encoding="utf-8"))
    assert _walk(tree) == list(ast.walk(tree))
