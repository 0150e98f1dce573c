"""Write REFERENCE.md: the settings, what measuring, deriving and templates can name, and the units."""

import ast
from collections.abc import Iterator, Sequence
from itertools import takewhile
from pathlib import Path
from textwrap import dedent

from measured_report.commands.options import Arguments
from measured_report.editions.project import Project
from measured_report.files.atomic import write_file
from measured_report.files.config import Report

FILE = "REFERENCE.md"
GENERATOR = Path(__file__).parents[1]
NAMES = {
    "files/settings": "Config Page Columns Changes",
    "measuring/measurement": "Conditions Measurement absent",
    "measuring/batch": "Batch",
    "measuring/machine": "needs_device",
    "values/results": "Results Row",
    "values/quantities": "Quantity constant combined",
    "findings/sections": "Outline",
    "parts/section": "Section Table Figure",
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
    """Return the reference of a report as Markdown."""
    parts = [
        "# Reference",
        "Made from what the generator says of itself; `make reference` makes it anew.",
    ]
    for module, names in NAMES.items():
        text = (GENERATOR / f"{module}.py").read_text(encoding="utf-8")
        tree = ast.parse(text)
        title, _, description = (ast.get_docstring(tree) or "").partition("\n")
        parts += [f"## {title.rstrip('.')}", description.strip("\n")]
        for node in tree.body:
            if getattr(node, "name", "") in names.split():
                parts += _entry(node, text.splitlines(), HANDED in module)
    ends = ", ".join(f"`_{end}` {unit}" for end, unit in report.columns.units.items())
    parts += ["## Units by the end of a column's name", ends]
    return "\n\n".join(filter(None, parts))


def _entry(node: ast.stmt, lines: Sequence[str], has_methods: bool) -> Iterator[str]:
    """Yield a function with its arguments, or a class with the code of its fields."""
    if isinstance(node, ast.FunctionDef):
        text = " ".join((ast.get_docstring(node) or "").split())
        yield f"- `{node.name}({ast.unparse(node.args)})` {text}"
    if isinstance(node, ast.ClassDef):
        yield f"### {node.name}\n\n{ast.get_docstring(node)}"
        fields = [*takewhile(lambda part: not hasattr(part, "name"), node.body)][1:]
        if fields:
            code = "\n".join(lines[fields[0].lineno - 1 : fields[-1].end_lineno])
            yield f"```python\n{dedent(code)}\n```"
        for part in node.body if has_methods else ():
            if not getattr(part, "name", "_").startswith("_"):
                yield from _entry(part, lines, has_methods)
