"""The rooms of the project and who reads whom, drawn from the imports: ``python docs/rooms.py`` renews the picture."""

import ast
from collections.abc import Iterator
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
ARCHITECTURE = ROOT / "docs" / "architecture.md"
START, END = "```mermaid\n", "```\n"
FOLDERS = ("experiments", "report")
ROOMS = ("report.records", "report.deriving", "report.sections", "experiments", "report", "build")
"""Rooms by the start of a module's name; the first that fits counts."""
FACTS = "facts"
SHARED = ("experiments.facts.case", "experiments.facts.classes", "experiments.facts.metrics", "experiments.facts.trace")
"""The room of what both sides read, which has no name of its own, and its modules: the last two are what classify
reads."""
LABELS = {
    "build": "build.py<br>the command line",
    "experiments": "experiments/<br>measure",
    FACTS: "experiments/: case, classify<br>facts of the scene and of how a run ends",
    "report.records": "report/records/<br>what was measured",
    "report": "report/<br>claims, figures, pages",
    "report.deriving": "report/deriving/<br>what sections share",
    "report.sections": "report/sections/<br>a module each",
}


def modules() -> dict[str, Path]:
    """Every module of the project, by its name."""
    files = [path for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*.py"))]
    names = {".".join(path.relative_to(ROOT).with_suffix("").parts): path for path in files}
    return {name.removesuffix(".__init__"): path for name, path in names.items()} | {"build": ROOT / "build.py"}


def imports() -> dict[str, set[str]]:
    """The project's modules that each of its modules imports, wherever in it the import stands."""
    known = modules()
    found = {}
    for name, path in known.items():
        named = set(_named(ast.parse(path.read_text(encoding="utf-8"))))
        found[name] = {each for each in named if each in known and each != name}
    return found


def _named(tree: ast.Module) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            yield node.module
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def room_of(module: str) -> str:
    if module in SHARED:
        return FACTS
    return next(room for room in ROOMS if module == room or module.startswith(f"{room}."))


def arrows() -> set[tuple[str, str]]:
    """Pairs of rooms of which the first imports the second; the folders themselves, which all may name, left out."""
    return {
        (room_of(module), room_of(named))
        for module, found in imports().items()
        for named in found
        if room_of(module) != room_of(named) and named not in FOLDERS
    }


def picture() -> str:
    """The rooms as a diagram in Mermaid's language."""
    lines = ["flowchart TD"]
    lines += [f'    {_id(room)}["{LABELS[room]}"]' for room in LABELS]
    lines += [f"    {_id(one)} --> {_id(other)}" for one, other in sorted(arrows())]
    # These two are found by their names when they are needed, and imported nowhere.
    lines += [f"    {_id('report')} -. by name .-> {_id('report.sections')}"]
    lines += [f"    {_id('report.records')} -. a process .-> {_id('experiments')}"]
    return "\n".join(lines) + "\n"


def _id(room: str) -> str:
    return room.replace(".", "_")


if __name__ == "__main__":
    before, _, rest = ARCHITECTURE.read_text(encoding="utf-8").partition(START)
    ARCHITECTURE.write_text(before + START + picture() + END + rest.partition(END)[2], encoding="utf-8")
