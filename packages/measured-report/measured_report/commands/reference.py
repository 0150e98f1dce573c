"""Write REFERENCE.md: what report.toml may say, what measuring, deriving and templates are given, and the units."""

import ast
from collections.abc import Collection, Iterator, Sequence
from pathlib import Path

from measured_report.commands.options import Arguments
from measured_report.editions.project import Project
from measured_report.records.columns import UNITS

FILE = "REFERENCE.md"
GENERATOR = Path(__file__).parents[1]
TOLD = {
    "files/config": "Config Page Declared Told Changes",
    "measuring/measurement": "Conditions Measurement absent",
    "measuring/batch": "Batch",
    "values/results": "Results Row",
    "values/quantities": "Quantity",
    "pages/sections": "Outline",
    "parts/section": "Section Table Figure Download",
    "parts/figures": "new_figure",
    "parts/claim": "Claim decided at_least at_most greater decreases equal_within all_of",
    "parts/words": "",
    "pages/passages": "",
    "parts/citations": "",
}
"""What is told of each module besides what it says itself."""


def run(project: Project, arguments: Arguments) -> int:
    """Write it beside report.toml."""
    (project.root / FILE).write_text(reference(), encoding="utf-8")
    print(f"wrote {project.root / FILE}")
    return 0


def reference() -> str:
    """Collect the docstrings, in Markdown."""
    parts = ["# Reference", "Made from the docstrings of the generator; `make reference` makes it anew."]
    for module, names in TOLD.items():
        tree = ast.parse((GENERATOR / f"{module}.py").read_text(encoding="utf-8"))
        title, _, words = (ast.get_docstring(tree) or "").partition("\n")
        parts += [f"## {title}", words.strip(), *_entries(tree.body, names.split())]
    units = ", ".join(f"`_{end}` {unit}" for end, unit in UNITS.items())
    return "\n\n".join(filter(None, [*parts, "## Units by the end of a column's name", units]))


def _entries(body: Sequence[ast.stmt], names: Collection[str] = ()) -> Iterator[str]:
    """Yield what these statements define and say of it: of these names, or all fields and properties of a class."""
    for node, below in zip(body, [*body[1:], ast.Pass()], strict=True):
        if isinstance(node, ast.AnnAssign) and isinstance(below, ast.Expr) and isinstance(below.value, ast.Constant):
            yield "" if names else f"- `{ast.unparse(node)}` {' '.join(str(below.value.value).split())}"
        elif isinstance(node, ast.ClassDef) and node.name in names:
            yield f"### {node.name}\n\n{ast.get_docstring(node)}"
            yield from _entries(node.body)
        elif isinstance(node, ast.FunctionDef) and (node.name in names or not names) and ast.get_docstring(node):
            yield f"- `{node.name}({ast.unparse(node.args)})` {' '.join(str(ast.get_docstring(node)).split())}"
