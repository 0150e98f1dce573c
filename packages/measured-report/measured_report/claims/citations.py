"""Statements from documentation or source code, which are not measured here and say where they are from.

    {% stated sea_level %} The sea rises by 3 to 4 mm a year. {% endstated %}

``templates/sources.toml`` has a table for each name: ``url``, or ``package``, ``version``, ``file`` below its folder
and an ``excerpt`` that the file must hold.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from jinja2 import nodes
from jinja2.ext import Extension
from jinja2.parser import Parser
from markupsafe import Markup

from measured_report import ReportError
from measured_report.files.config import read_toml

NAME = "sources.toml"


@dataclass(frozen=True)
class Reference:
    """Where a statement is from: an address, or a line in a file of a package."""

    url: str = ""
    package: str = ""
    version: str = ""
    file: str = ""
    excerpt: str = ""
    """One line of the file, or a part of one."""

    def __html__(self) -> Markup:
        if self.url:
            return Markup('<a href="{0}">{1}</a>').format(self.url, self.url.partition("://")[2].partition("#")[0])
        return Markup("read in {} {}, <code>{}</code>").format(self.package, self.version, self.file)


def references(templates: Path) -> Mapping[str, Reference]:
    """The references of a folder of templates by name; ReportError, one line, for one that is not whole."""
    path = templates / NAME
    if not path.is_file():
        return {}
    try:
        found = {name: Reference(**fields) for name, fields in read_toml(path).items()}
    except (ValueError, TypeError) as error:
        raise ReportError(f"templates/{NAME}: {error}") from None
    for name, reference in found.items():
        if not (reference.url or all((reference.package, reference.version, reference.file, reference.excerpt))):
            raise ReportError(f"templates/{NAME}: {name} needs url, or package, version, file and excerpt")
    return found


class StatedTag(Extension):
    """The tag; an environment that has it has ``references`` among its globals."""

    tags = {"stated"}  # noqa: RUF012, as Jinja has it

    def parse(self, parser: Parser) -> nodes.Node:
        line = next(parser.stream).lineno
        name = parser.stream.expect("name")
        known: Any = self.environment.globals["references"]
        if name.value not in known:
            parser.fail(f"templates/{NAME} has no {name.value}", name.lineno)
        body = parser.parse_statements(("name:endstated",), drop_needle=True)
        call = self.call_method("_stated", [nodes.Const(name.value)])
        return nodes.CallBlock(call, [], [], body).set_lineno(line)

    def _stated(self, name: str, caller) -> Markup:
        known: Any = self.environment.globals["references"]
        words = Markup(" ".join(caller().split()))
        html = '<span class="stated">{} <span class="source">[not measured here: {}]</span></span>\n'
        return Markup(html).format(words, known[name])
