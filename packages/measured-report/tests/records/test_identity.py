"""Test which changes make a record stale and which do not."""

import ast
import shutil

import pytest
from toys import BY_HAND

from measured_report.files.config import report_in
from measured_report.records import code
from measured_report.records import identity as of_records
from measured_report.records.identity import identity_of, package_changes, sections
from measured_report.records.record import write_record

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
from current_columns import PLAIN

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
    """Return the toy with a section that is measured by means of two other modules."""
    for name, text in SOURCES.items():
        toy.write(name, text)
    toy.measure()
    return toy


def replace_in(toy, old: str, new: str) -> None:
    """Replace a text in all files of the experiments."""
    paths = [
        path
        for path in (toy.project.root / "experiments").rglob("*.py")
        if old in path.read_text()
    ]
    assert paths
    for path in paths:
        toy.write(
            path.relative_to(toy.project.root).as_posix(),
            path.read_text().replace(old, new),
        )


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ('"""Measure it."""', '"""Something else."""  # a remark'),
        ('"""Measure it."""', ""),
        ("LIMIT = 10.0", "LIMIT = (\n    10.0\n)"),
    ],
)
def test_what_says_nothing_leaves_a_record_fresh(chain, old, new):
    replace_in(chain, old, new)
    assert chain.state().kind == "fresh"


@pytest.mark.parametrize(
    ("old", "new", "file"),
    [
        ("RUNS = 3", "RUNS = 4", "toy"),
        ("factor=2.0", "factor=3.0", "middle"),
        ("LIMIT = 10.0", "LIMIT = 11.0", "far"),
        ("return min", "return max", "far"),
        ("return 1", "return 2", "middle"),
        (
            "    return min",
            "    from experiments.late import LIMIT\n\n    return min",
            "far",
        ),
    ],
)
def test_a_change_of_a_file_that_is_imported_makes_it_stale(chain, old, new, file):
    chain.write("experiments/late.py", "LIMIT = 1.0\n")
    replace_in(chain, old, new)
    assert f"code: experiments/{file}.py" in chain.state().notes


def test_a_file_counts_wherever_its_import_stands_and_an_asset_wherever_it_is_named(
    chain,
):
    replace_in(
        chain,
        "    return min",
        "    from experiments.late import LIMIT\n\n    return min",
    )
    chain.write("experiments/late.py", 'def unused():\n    return "assets/late.txt"\n')
    chain.write("assets/late.txt", "1")
    chain.measure()
    chain.write("assets/late.txt", "2")
    assert chain.state().notes == ("config: assets/late.txt",)
    chain.write("experiments/late.py", "LIMIT = 2.0\n")
    assert "code: experiments/late.py" in chain.state().notes


def test_the_generator_does_not_count(chain):
    assert [*identity_of("toy", "full", chain.project.root).files] == [
        "experiments/__init__.py",
        "experiments/far.py",
        "experiments/middle.py",
        "experiments/toy.py",
        "assets/robot.urdf",
    ]


def test_the_profile_and_package_versions_count_and_the_machine_does_not(
    toy, monkeypatch
):
    full, quick = (
        identity_of("toy", profile, toy.project.root) for profile in ("full", "quick")
    )
    assert full.config != quick.config
    assert full.code == quick.code
    write_record(
        toy.record_path, toy.record(machine={**BY_HAND["machine"], "cpu": "Another"})
    )
    assert toy.state().kind == "fresh"
    installed = {**toy.packages, "warp-lang": "9.9", "mujoco-core": "3.10.0"}
    monkeypatch.setattr(of_records.metadata, "version", installed.__getitem__)
    assert any(
        note.startswith("packages: warp-lang") and note.endswith("→ 9.9.0")
        for note in toy.state().notes
    )


def test_a_package_that_another_requires_in_its_own_version_ages_no_record():
    older = {"newton": "1.4.0", "mujoco": "4.0.0"}
    same, other = ({**older, "mujoco-core": f"4.0.{patch}"} for patch in (0, 1))
    assert not package_changes(older, same) + package_changes(same, older)
    assert package_changes(older, other) == ["mujoco-core missing → 4.0.1"]
    assert package_changes(same, other) == ["mujoco-core 4.0.0 → 4.0.1"]
    assert package_changes(older, {**same, "mujoco": "4.0.1"}) != []


def test_what_an_editor_locks_beside_a_section_is_no_section(toy):
    (toy.project.root / "report/sections/.#toy.py").symlink_to("somebody@here.1:2")
    assert sections(toy.project.root) == ["toy"]


def test_a_source_is_parsed_once_wherever_it_lies(chain, tmp_path, monkeypatch):
    shutil.copytree(chain.project.root, other := tmp_path / "other")
    before = identity_of("toy", "full", chain.project.root)
    monkeypatch.setattr(code.ast, "parse", None)
    with report_in(other):
        assert identity_of("toy", "full", other) == before


def test_a_syntax_tree_is_the_same_whatever_a_python_adds_to_it():
    earlier, later = ast.parse('f"{name:{width}}"'), ast.parse('f"{name:{width}}"')
    specification = later.body[0].value.values[0].format_spec
    specification.values = [
        part for part in specification.values if isinstance(part, ast.FormattedValue)
    ]
    without = code.plain(later)
    specification.values.append(ast.Constant("", kind="u"))
    assert code.plain(earlier) == without == code.plain(later)
