"""Test which folders import which, and that the diagram of the architecture agrees with
the imports.
"""

import re
from collections.abc import Mapping
from functools import cache
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

from measured_report.files.root import ROOT
from measured_report.records.code import Code
from measured_report.records.identity import sections

GENERATOR = ROOT / "packages/measured-report"
PACKAGES = {
    "measured_report": GENERATOR,
    "newton_lint": ROOT / "packages/newton-lint",
    "number_audit": ROOT / "packages/number-audit",
}
FOLDERS = ("experiments", "report", *PACKAGES)
TERM = (
    ROOT / "packages/contact-bias"
)  # modules without a folder: the site offers two of them as files
OUTSIDE = (
    "build",
    "experiments.facts",
    "experiments",
    "report",
    "newton_lint",
    "contact_bias",
    "number_audit",
)
"""Folders outside the generator."""
ARROW = re.compile(r"^ +([\w.]+) --> ([\w.]+)$", re.MULTILINE)

SIMULATOR = re.compile(
    r"^\s*(?:import|from) (warp|newton|mujoco|mujoco_warp)\b", re.MULTILINE
)
WORDING = re.compile(
    r"\b(holds|fails|unknown|explanation|caption|alt)=f?[\"']|\bcannot tell whether\b"
)
CARRYING = {
    f"measured_report.measuring.{name}" for name in ("batch", "measurement", "pool")
}
CARRYING |= {
    f"measured_report.{name}"
    for name in ("files.errors", "files.root", "editions.environment")
}
"""Modules that pass calls on to other modules.

Their code is not part of a record's identity and does not change any row.
"""
MOST_ROOMS, MOST_ARROWS = 11, 60


@cache
def modules() -> Mapping[str, Path]:
    """Return every module of the project by its name, except the skeleton of a new
    report.
    """
    roots = {folder: PACKAGES.get(folder, ROOT) for folder in FOLDERS}
    files = {
        path: root
        for folder, root in roots.items()
        for path in sorted((root / folder).rglob("*.py"))
    }
    names = {
        path: ".".join(path.relative_to(root).with_suffix("").parts)
        for path, root in files.items()
    }
    named = {
        name.removesuffix(".__init__"): path
        for path, name in names.items()
        if "skeleton" not in path.parts
    }
    return {
        "build": ROOT / "build.py",
        **named,
        **{path.stem: path for path in TERM.glob("*.py")},
    }


@cache
def imports() -> Mapping[str, frozenset[str]]:
    """Return the project's modules that each of its modules imports anywhere, and their
    packages.
    """
    graph = Code(ROOT)
    names = {str(path): name for name, path in modules().items()}
    named = {
        name: {names[file] for file in graph.imported(str(path))}
        for name, path in modules().items()
    }
    return {name: frozenset(found - {name}) for name, found in named.items()}


def room_of(module: str) -> str:
    """Return the folder of a module: one of the generator or one outside; empty for a
    package.
    """
    if module.startswith("measured_report"):
        return module.partition(".")[2].partition(".")[0]
    if module.startswith("contact_"):
        return "contact_bias"
    return next(room for room in OUTSIDE if f"{module}.".startswith(f"{room}."))


@cache
def arrows() -> frozenset[tuple[str, str]]:
    """Return pairs of folders in which the first folder imports the second.

    Packages are left out because every folder may import them.
    """
    pairs = (
        (room_of(module), room_of(named))
        for module, found in imports().items()
        for named in found
    )
    return frozenset(
        pair
        for pair in pairs
        if all(pair) and pair[0] != pair[1] and pair[1] not in FOLDERS[:2]
    )


@pytest.mark.parametrize(
    ("side", "allowed"),
    [
        ("measured_report", ("number_audit",)),
        ("newton_lint", ("measured_report",)),
        ("contact_bias", ()),
        ("number_audit", ()),
        ("experiments", ("measured_report", "newton_lint", "contact_bias")),
    ]
    + [("report", ("measured_report", "experiments.facts"))],
)
def test_each_side_reads_no_more_of_the_others_than_it_may(side, allowed):
    def is_in(name: str, room: str) -> bool:
        return f"{name}.".startswith(f"{room}.") or (
            room == "contact_bias" and name.startswith("contact_")
        )

    named = {
        (module, name)
        for module, found in imports().items()
        if is_in(module, side)
        for name in found
    }
    outside = {
        (module, name)
        for module, name in named
        if not any(is_in(name, room) for room in (side, *allowed))
    }
    assert {
        (module, name) for module, name in outside if name != "experiments"
    } == set()


def test_the_page_s_side_never_imports_the_simulator():
    reached = {
        name
        for name in modules()
        if name.partition(".")[0] in ("build", "measured_report", "report")
    }
    while more := {named for name in reached for named in imports()[name]} - reached:
        reached |= more
    files = [modules()[name] for name in reached]
    assert [
        path for path in files if SIMULATOR.search(path.read_text(encoding="utf-8"))
    ] == []


def test_what_computes_rows_has_the_generator_for_carrying_alone():
    """Test that the modules that compute rows import only ROOT and the errors, besides
    the modules for carrying. An identity does not contain the generator.
    """
    reached = {f"experiments.{section}" for section in sections()}
    while (
        more := {
            n
            for name in reached
            for n in imports()[name]
            if n.startswith("experiments.")
        }
        - reached
    ):
        reached |= more
    used = {
        name
        for module in reached
        for name in imports()[module]
        if name.startswith("measured_report.")
    }
    assert {
        name for name in used if name.count(".") > 1
    } == CARRYING  # except the packages of these modules


def test_no_import_leads_in_a_circle_and_the_generator_has_few_rooms():
    names = imports()
    # A package is imported before its modules, so their imports from it are not a
    # cycle.
    inner = {
        module: {name for name in found if not module.startswith(f"{name}.")}
        for module, found in names.items()
    }
    assert len(list(TopologicalSorter(inner).static_order())) == len(names)
    inside = [pair for pair in arrows() if not {*pair} & {*OUTSIDE}]
    below = {
        room: {low for high, low in inside if high == room}
        for pair in inside
        for room in pair
    }
    assert (
        len(list(TopologicalSorter(below).static_order())) <= MOST_ROOMS
        and len(inside) <= MOST_ARROWS
    )


def test_findings_exist_without_words():
    """Test that the code that compares editions does not import pages or parse a
    template.
    """
    below = {"changes": "pages", "findings": "pages", "editions": "findings"}
    assert [pair for pair in arrows() if below.get(pair[0]) == pair[1]] == []


def test_words_are_in_templates():
    files = [
        path for name, path in modules().items() if name.startswith("report.sections.")
    ]
    files += (ROOT / "packages/measured-report/measured_report/pages").glob("*.py")
    texts = {path.name: path.read_text(encoding="utf-8") for path in files}
    assert [
        (name, match[0])
        for name, text in texts.items()
        for match in WORDING.finditer(text)
    ] == []


def test_the_picture_has_the_arrows_that_the_imports_make_but_for_those_that_others_imply():
    text = (ROOT / "docs/architecture.md").read_text(encoding="utf-8")
    drawn = set(ARROW.findall(text.replace("experiments_facts", "experiments.facts")))
    implied = set(drawn)
    while (
        more := {
            (high, end) for high, low in implied for start, end in drawn if start == low
        }
        - implied
    ):
        implied |= more
    assert drawn <= arrows() <= implied


SUBJECT = re.compile(
    r"(?i:newton|mujoco|grasp|meta-?world)"
    r"|(?<![A-Za-z])(?:warps?|cubes?|pads?|slip(?:s|ped|ping)?|shak(?:es?|en|ing))(?![a-z])"
    r"|(?:Warp|Cube|Pad|Slip|Shake)s?(?![a-z])"
    r"|(?<![A-Z])(?:WARP|CUBE|PAD|SLIP|SHAKE)S?(?![A-Z])"
)
"""Terms of this report's subject, as words or as parts of identifiers.

Padding and warping are not among them.
"""
OF_LANGUAGES = re.compile(r"\bpad(?:Start|End)\b")
"""Names that are built into JavaScript."""


def generator_files() -> dict[str, str]:
    """Return the texts of all files in the generator, by path."""
    files = [
        path
        for path in sorted((GENERATOR / "measured_report").rglob("*"))
        if path.is_file()
    ]
    files = [path for path in files if "__pycache__" not in path.parts]
    return {
        path.relative_to(GENERATOR).as_posix(): path.read_text(
            encoding="utf-8", errors="ignore"
        )
        for path in files
    }


def test_the_generator_names_no_subject():
    for path, text in generator_files().items():
        for number, line in enumerate([path, *text.splitlines()]):
            assert not SUBJECT.search(OF_LANGUAGES.sub("", line)), (
                f"{path}:{number}: {line.strip()}"
            )


def test_the_glossary_explains_each_concept_of_the_table():
    table, glossary = (
        (ROOT / f"docs/{name}.md").read_text(encoding="utf-8")
        for name in ("architecture", "glossary")
    )
    rows = re.findall(
        r"^\| ([a-z, ]+) \| .* \| (`.*`) \|$",
        table.partition("## Concepts")[2],
        re.MULTILINE,
    )
    headings = re.findall("^## (.+)$", glossary, re.MULTILINE)
    assert [heading.lower() for heading in headings] == [name for name, _ in rows]
    assert len(rows) == 15
    paths = re.findall("`([^`]+)`", " ".join(files for _, files in rows))
    places = (ROOT, GENERATOR / "measured_report")
    assert [p for p in paths if not any((at / p).is_file() for at in places)] == []
