"""Statements from documentation or source code, which are not measured here and say where they are from.

    {% stated sea_level %} The sea rises by 3 to 4 mm a year. {% endstated %}

``templates/sources.toml`` has a table for each name: ``url`` with a ``title``, or ``package``, ``version``, ``file``
below its folder, ``line``, and an ``excerpt`` that this line must hold. Its table ``packages`` has the address of a
package's files, with ``{version}``, ``{file}`` and ``{line}``. A page numbers its statements; their sources end it.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from jinja2 import nodes
from jinja2.ext import Extension
from jinja2.parser import Parser
from jinja2.runtime import Context
from markupsafe import Markup

from measured_report.files.config import read_toml
from measured_report.files.errors import ReportError
from measured_report.parts.macros import macros
from measured_report.parts.words import token

NAME = "sources.toml"


@dataclass(frozen=True)
class Reference:
    """Lead to the source of a statement: an address, and for a package's file the line in it."""

    url: str = ""
    title: str = ""
    package: str = ""
    version: str = ""
    file: str = ""
    line: int = 0
    excerpt: str = ""


def references(templates: Path) -> Mapping[str, Reference]:
    """Read the references of a folder of templates by name; ReportError, one line, for one that is not whole."""
    path = templates / NAME  # which need not be there
    try:
        tables = read_toml(path) if path.is_file() else {}
        addresses = tables.pop("packages", {})
        by_name = {name: Reference(**fields) for name, fields in tables.items()}
    except (ValueError, TypeError) as error:
        raise ReportError(f"templates/{NAME}: {error}") from None
    for name, reference in by_name.items():
        if all((reference.package in addresses, reference.version, reference.file, reference.line, reference.excerpt)):
            by_name[name] = reference = replace(reference, url=addresses[reference.package].format(**tables[name]))
        if not str(reference.url).startswith("http"):
            raise ReportError(f"templates/{NAME}: {name} needs url, or package, version, file, line and excerpt")
    return by_name


@dataclass(frozen=True)
class Mark:
    """Hold a place that only the page can fill: ``#id`` is a link to a part, ``source name`` numbers a citation."""

    anchor: str

    def __html__(self) -> str:
        return self.anchor if self.anchor.startswith("#") else ""


class StatedTag(Extension):
    """Add the tag; an environment that has it has ``references`` among its globals."""

    tags = {"stated"}  # noqa: RUF012, as Jinja has it

    def parse(self, parser: Parser) -> nodes.Node:
        line = next(parser.stream).lineno
        name = parser.stream.expect("name").value
        references: Any = self.environment.globals["references"]
        if name not in references:
            parser.fail(f"templates/{NAME} has no {name}", line)
        body = parser.parse_statements(("name:endstated",), drop_needle=True)
        call = self.call_method("_stated", [nodes.ContextReference(), nodes.Const(name)])
        return nodes.CallBlock(call, [], [], body).set_lineno(line)

    def _stated(self, context: Context, name: str, caller: Callable[[], str]) -> Markup:
        statement = Markup(" ".join(caller().split()))
        return macros().stated(statement, token(context["printed"], Mark(f"source {name}"))) + "\n"
