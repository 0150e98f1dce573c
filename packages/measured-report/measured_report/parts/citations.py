"""Statements from documentation or source code, which are not measured here and say where they are from.

    {% stated sea_level %} The sea rises by 3 to 4 mm a year. {% endstated %}

``templates/sources.toml`` has a table for each name: ``url``, or ``package``, ``version``, ``file`` below its folder,
``line``, and an ``excerpt`` that this line must hold. Its table ``packages`` has the address of a package's files, with
``{version}``, ``{file}`` and ``{line}``. A page numbers its statements and lists their sources at its end.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
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

NAME = "sources.toml"


@dataclass(frozen=True)
class Reference:
    """The source of a statement: an address, and for a package's file the line in it."""

    url: str = ""
    package: str = ""
    version: str = ""
    file: str = ""
    line: int = 0
    excerpt: str = ""
    """One line of the file, or a part of one."""


def references(templates: Path) -> Mapping[str, Reference]:
    """Read the references of a folder of templates by name; ReportError, one line, for one that is not whole."""
    path = templates / NAME
    if not path.is_file():
        return {}
    try:
        tables = read_toml(path)
        addresses = tables.pop("packages", {})
        found = {name: _reference(addresses, **fields) for name, fields in tables.items()}
    except (ValueError, TypeError) as error:
        raise ReportError(f"templates/{NAME}: {error}") from None
    for name, reference in found.items():
        if not reference.url:
            raise ReportError(f"templates/{NAME}: {name} needs url, or package, version, file, line and excerpt")
    return found


def _reference(addresses: Mapping[str, str], **fields: Any) -> Reference:
    known = Reference(**fields)
    if all((known.package in addresses, known.version, known.file, known.line, known.excerpt)):
        return Reference(addresses[known.package].format(**fields), **fields)
    return known


@dataclass(frozen=True)
class Cited:
    """A mark behind a statement; a page that shows it knows its number."""

    name: str

    @property
    def anchor(self) -> str:
        return f"source {self.name}"

    def __html__(self) -> str:
        return ""


class StatedTag(Extension):
    """The tag; an environment that has it has ``references`` and ``token`` among its globals."""

    tags = {"stated"}  # noqa: RUF012, as Jinja has it

    def parse(self, parser: Parser) -> nodes.Node:
        line = next(parser.stream).lineno
        name = parser.stream.expect("name")
        known: Any = self.environment.globals["references"]
        if name.value not in known:
            parser.fail(f"templates/{NAME} has no {name.value}", name.lineno)
        body = parser.parse_statements(("name:endstated",), drop_needle=True)
        call = self.call_method("_stated", [nodes.ContextReference(), nodes.Const(name.value)])
        return nodes.CallBlock(call, [], [], body).set_lineno(line)

    def _stated(self, context: Context, name: str, caller: Callable[[], str]) -> Markup:
        token: Any = self.environment.globals["token"]
        words = Markup(" ".join(caller().split()))
        return macros().stated(words, token(context["printed"], Cited(name))) + "\n"
