"""The rooms of the project and who reads whom, drawn from the imports: ``python docs/rooms.py`` renews the picture."""

from collections.abc import Mapping
from functools import cache
from pathlib import Path

from measured_report.records.code import Graph

ROOT = Path(__file__).resolve().parent.parent
ARCHITECTURE = ROOT / "docs" / "architecture.md"
START, END = "```mermaid\n", "```\n"
GENERATOR = "measured_report"
PLACES = {"": ROOT, GENERATOR: ROOT / "packages/measured-report", "newton_lint": ROOT / "packages/newton-lint"}
FOLDERS = ("experiments", "report", GENERATOR, "newton_lint")
OUTSIDE = {
    "build": "build.py",
    "experiments": "experiments/<br>the sections, simulation, media",
    "experiments.facts": "experiments/facts/<br>plain Python for both sides",
    "report": "report/<br>sections, story",
    "newton_lint": "newton_lint/<br>the lint",
}
"""Rooms beside the generator's, by the start of their modules' names, and what they are called in the picture."""
Arrows = frozenset[tuple[str, str]]


@cache
def modules() -> Mapping[str, Path]:
    """Every module of the project, by its name."""
    found = {"build": ROOT / "build.py"}
    for folder in FOLDERS:
        root = PLACES.get(folder, ROOT)
        for path in sorted((root / folder).rglob("*.py")):
            if "skeleton" in path.parts:  # what a new report begins as
                continue
            found[".".join(path.relative_to(root).with_suffix("").parts).removesuffix(".__init__")] = path
    return found


@cache
def imports() -> Mapping[str, frozenset[str]]:
    """The project's modules that each of its modules imports, wherever in it the import stands, and their packages."""
    graph, names = Graph(tuple(map(str, PLACES.values()))), {str(path): name for name, path in modules().items()}
    found = {name: graph.imported(str(path)) for name, path in modules().items()}
    return {name: frozenset(names[file] for file in files) - {name} for name, files in found.items()}


def room_of(module: str) -> str:
    """The room that a module is in: a folder of the generator, or one of those outside; empty for a bare package."""
    parts = module.split(".")
    if parts[0] == GENERATOR:
        return parts[1] if len(parts) > 1 else ""
    return max((room for room in OUTSIDE if module == room or module.startswith(f"{room}.")), key=len)


def arrows() -> Arrows:
    """Pairs of rooms of which the first imports the second; packages themselves, which all may name, left out."""
    pairs = ((room_of(module), room_of(named)) for module, found in imports().items() for named in found)
    return frozenset(pair for pair in pairs if all(pair) and pair[0] != pair[1] and pair[1] not in FOLDERS[:2])


def reduced(found: Arrows) -> list[tuple[str, str]]:
    """The arrows that do not follow from others."""

    def leads(start: str, end: str, without: tuple[str, str]) -> bool:
        steps = (low for high, low in found if high == start and (high, low) != without)
        return any(low == end or leads(low, end, without) for low in steps)

    return sorted(pair for pair in found if not leads(*pair, pair))


def picture() -> str:
    """The rooms as a diagram in Mermaid's language; an arrow that others imply is left out."""
    found = arrows()
    own = sorted({room for pair in found for room in pair} - {*OUTSIDE})
    lines = ["flowchart TD", f"    subgraph {GENERATOR}", *(f"        {room}" for room in own), "    end"]
    lines += [f'    {room.replace(".", "_")}["{words}"]' for room, words in OUTSIDE.items()]
    lines += [f"    {one.replace('.', '_')} --> {other.replace('.', '_')}" for one, other in reduced(found)]
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    before, _, rest = ARCHITECTURE.read_text(encoding="utf-8").partition(START)
    ARCHITECTURE.write_text(before + START + picture() + END + rest.partition(END)[2], encoding="utf-8")
