"""Cite statements from documentation or source code, which are not measured here.

    {% call stated("sea_level") %} The sea rises by 3 to 4 mm a year. {% endcall %}

``templates/sources.toml`` has a table for each source. The table contains either
``url`` and ``title``, or ``package``, ``version``, ``file`` (its path in the package),
``line`` and ``excerpt``, a text that this line must contain. The table ``packages``
contains the address of each package's files, with the fields ``{version}``, ``{file}``
and ``{line}``. A page numbers its citations and lists their sources at the end.
"""

from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from markupsafe import Markup

from measured_report.files.config import read_toml
from measured_report.files.errors import ReportError
from measured_report.parts.macros import macros

NAME = "sources.toml"
LINE = ("version", "file", "line", "excerpt")  # fields that locate a line of a package
FIELDS = dict.fromkeys(("url", "title", "package", *LINE), "")

References = Mapping[str, Mapping[str, Any]]


def references(templates: Path) -> References:
    """Return the references in a folder of templates by name.

    Raise ReportError if one is incomplete.
    """
    path = templates / NAME
    tables = read_toml(path) if path.is_file() else {}
    addresses = tables.pop("packages", {})
    for name, table in tables.items():
        table = FIELDS | table
        try:
            table["url"] = table["url"] or addresses[table["package"]].format(**table)
        except LookupError:
            raise ReportError(
                f"templates/{NAME}: {name} has neither a url nor a package of the "
                f"table packages: add url, or package, {', '.join(LINE)}"
            ) from None
        tables[name] = table
    return tables


def stated(references: References, name: str, caller: Callable[[], str]) -> Markup:
    """Return a statement with the name of its source, which pages number."""
    if name not in references:
        raise ReportError(
            f"templates/{NAME} does not contain the source {name}: add a table for it"
        )
    return macros().stated(Markup(" ".join(caller().split())), name) + "\n"
