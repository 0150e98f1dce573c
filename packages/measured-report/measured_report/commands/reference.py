"""Write REFERENCE.md: the settings, what measuring, deriving and templates can name, and the units."""

import ast
from collections.abc import Collection, Iterator, Sequence
from pathlib import Path
from typing import Any

from measured_report.commands.options import Arguments
from measured_report.editions.project import Project
from measured_report.files.atomic import write_file
from measured_report.files.config import Report

FILE = "REFERENCE.md"
GENERATOR = Path(__file__).parents[1]
NAMES = {
    "files/settings": "Config Page Columns ColumnTraits Changes",
    "measuring/measurement": "Conditions Measurement absent",
    "measuring/batch": "Batch",
    "measuring/machine": "needs_device",
    "values/results": "Results Row",
    "values/quantities": "Quantity constant combined",
    "findings/sections": "Outline",
    "parts/section": "Section Table Figure Download",
    "parts/figures": "new_figure",
    "parts/claim": "Claim decided at_least at_most negligible greater decreases all_of",
    **dict.fromkeys(("parts/words", "pages/passages", "parts/citations"), ""),
}  # what is listed of each module below its docstring
HANDED = "values/"  # begins the modules whose classes a report is handed, so that their properties and methods count


def run(project: Project, arguments: Arguments) -> int:
    write_file(project.root / FILE, reference(project.report))
    print(f"wrote {FILE}")
    return 0


def reference(report: Report) -> str:
    parts = [
        "# Reference",
        "Made from what the generator says of itself; `make reference` makes it anew.",
    ]
    for module, names in NAMES.items():
        text = (GENERATOR / f"{module}.py").read_text(encoding="utf-8")
        tree = ast.parse(text)
        title, _, description = (ast.get_docstring(tree) or "").partition("\n")
        entries = _entries(
            text.splitlines(),
            tree.body,
            names.split(),
            ast.FunctionDef if HANDED in module else (),
        )
        parts += [f"## {title.rstrip('.')}", description.strip("\n"), *entries]
    ends = ", ".join(f"`_{end}` {unit}" for end, unit in report.columns.units.items())
    return "\n\n".join(
        filter(None, [*parts, "## Units by the end of a column's name", ends])
    )


def _entries(
    lines: Sequence[str], body: Sequence[ast.stmt], names: Collection[str], methods: Any
) -> Iterator[str]:
    """Yield what is defined under these names of a module, and the fields of its classes with their ``methods``."""
    for node, below in zip(body, [*body[1:], ast.Pass()], strict=True):
        if isinstance(node, ast.AnnAssign):
            value = getattr(
                below, "value", None
            )  # what a field is stands behind it or, where that is long, below it
            long = (
                value.value
                if isinstance(below, ast.Expr) and isinstance(value, ast.Constant)
                else ""
            )
            if (
                description := " ".join(str(long).split())
                or lines[(node.end_lineno or 0) - 1].partition("  # ")[2]
            ):
                yield f"- `{ast.unparse(node)}` {description}"
        elif isinstance(node, ast.ClassDef) and node.name in names:
            fields = [part for part in node.body if isinstance(part, ast.AnnAssign)]
            order = ", ".join(
                f"{ast.unparse(part.target)}{'=…' if part.value else ''}"
                for part in fields
            )
            yield "\n\n".join(
                [
                    f"### {node.name}",
                    f"`{node.name}({order})`",
                    str(ast.get_docstring(node)),
                ]
            )
            handed = [
                part.name
                for part in node.body
                if isinstance(part, methods) and not part.name.startswith("_")
            ]
            yield from _entries(lines, node.body, handed, methods)
        elif (
            isinstance(node, ast.FunctionDef)
            and node.name in names
            and ast.get_docstring(node)
        ):
            yield f"- `{node.name}({ast.unparse(node.args)})` {' '.join(str(ast.get_docstring(node)).split())}"
