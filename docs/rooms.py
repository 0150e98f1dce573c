"""The rooms of the project and who reads whom, drawn from the imports: ``python docs/rooms.py`` renews the picture."""

import ast
from collections.abc import Iterator
from graphlib import TopologicalSorter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
ARCHITECTURE = ROOT / "docs" / "architecture.md"
START, END = "```mermaid\n", "```\n"
GENERATOR = "measured_report"
FOLDERS = {
    "experiments": ROOT,
    "report": ROOT,
    GENERATOR: ROOT / "packages" / "measured-report",
    "newton_lint": ROOT / "packages" / "newton-lint",
}
"""Where each top-level package lies."""

Graph = dict[str, set[str]]


def modules() -> dict[str, Path]:
    """Find every module of the project, by its name."""
    found = {"build": ROOT / "build.py"}
    for folder, base in FOLDERS.items():
        for path in sorted((base / folder).rglob("*.py")):
            found[".".join(path.relative_to(base).with_suffix("").parts).removesuffix(".__init__")] = path
    return found


def imports() -> Graph:
    """Read which of the project's modules each of them imports, wherever in it the import stands."""
    known = modules()
    return {
        name: set(_named(ast.parse(path.read_text(encoding="utf-8")))) & known.keys() - {name}
        for name, path in known.items()
    }


def _named(tree: ast.Module) -> Iterator[str]:
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from (alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            yield node.module
            yield from (f"{node.module}.{alias.name}" for alias in node.names)


def room_of(module: str) -> str:
    """Name the room of a module: a folder of the generator, or else its top-level package."""
    return ".".join(module.split(".")[: 2 if module.startswith(f"{GENERATOR}.") else 1])


def rooms() -> Graph:
    """Say which rooms each room imports; the packages themselves, which all may name, are left out."""
    found: Graph = {room_of(module): set() for module in modules() if module != GENERATOR}
    for module, names in imports().items():
        if module != GENERATOR:
            found[room_of(module)] |= {room_of(name) for name in names - FOLDERS.keys()} - {room_of(module)}
    return found


def floors(graph: Graph) -> dict[str, int]:
    """Count how many floors of rooms each stands on; CycleError where there is a circle."""
    found: dict[str, int] = {}
    for room in TopologicalSorter(graph).static_order():
        found[room] = 1 + max((found[below] for below in graph[room]), default=0)
    return found


def picture() -> str:
    """Draw the rooms in Mermaid's language, without the arrows that a longer way says already."""
    graph, below = rooms(), {}
    for room in TopologicalSorter(graph).static_order():
        below[room] = graph[room].union(*(below[each] for each in graph[room]))
    direct = {room: found - set().union(*(below[each] for each in found)) for room, found in graph.items()}
    lines = [f'    {_id(room)}["{room.removeprefix(f"{GENERATOR}.")}"]' for room in sorted(graph)]
    lines += [f"    {_id(room)} --> {_id(each)}" for room in sorted(graph) for each in sorted(direct[room])]
    return "\n".join(["flowchart TD", *lines]) + "\n"


def _id(room: str) -> str:
    return room.replace(".", "_")


if __name__ == "__main__":
    before, _, rest = ARCHITECTURE.read_text(encoding="utf-8").partition(START)
    ARCHITECTURE.write_text(before + START + picture() + END + rest.partition(END)[2], encoding="utf-8")
