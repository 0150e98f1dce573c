"""Statements from documentation or source code, which are not measured here and say where they are from.

    {% call stated("sea_level") %} The sea rises by 3 to 4 mm a year. {% endcall %}

``templates/sources.toml`` has a table for each name: ``url`` with a ``title``, or ``package``, ``version``, ``file``
below its folder, ``line``, and an ``excerpt`` that this line must hold. Its table ``packages`` has the address of a
package's files, with ``{version}``, ``{file}`` and ``{line}``. A page numbers its statements; their sources end it.
"""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from markupsafe import Markup

from measured_report.files.config import read_toml
from measured_report.files.errors import ReportError
from measured_report.parts.macros import macros

NAME = "sources.toml"
LINE = ("version", "file", "line", "excerpt")  # tell where in a package a statement is
FIELDS = dict.fromkeys(("url", "title", "package", *LINE), "")

References = Mapping[str, Mapping[str, Any]]


def references(templates: Path) -> References:
    """Read the references of a folder of templates by name; ReportError for a wrong one."""
    path = templates / NAME  # which need not be there
    tables = read_toml(path) if path.is_file() else {}
    addresses = tables.pop("packages", {})
    for name, table in tables.items():
        table = FIELDS | table
        try:
            table["url"] = table["url"] or addresses[table["package"]].format(**table)
        except LookupError:
            raise ReportError(
                f"templates/{NAME}: {name} needs url, "
                f"or a package of the table packages, {', '.join(LINE)}"
            ) from None
        tables[name] = table
    return tables


def stated(references: References, name: str, caller: Callable[[], str]) -> Markup:
    """Write a statement with the name of its source, for which the page puts a number."""
    if name not in references:
        raise ReportError(f"templates/{NAME} has no {name}")
    return macros().stated(Markup(" ".join(caller().split())), name) + "\n"
