"""Words: what a template says of claims, figures and tables, found before anything is rendered.

    {% claim leans %}
    {% holds %} The tower leans by {{ angle }}.
    {% fails %} The tower stands upright.
    {% asks %} whether the tower leans
    {% because %} The ground is soft on one side.
    {% endclaim %}

    {% figure tower %} The tower from the south. {% alt %} It leans by {{ angle }}. {% endfigure %}

    {% table cases %} All cases. {% endtable %}

A claim may have ``{% opposite %}`` beside ``{% fails %}`` or in place of it, for a test that shows it.
Each stands where it is printed. Its parts can name what Python hands over with it, and nothing else.
"""

import re
import secrets
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from jinja2 import Environment, TemplateSyntaxError, nodes
from jinja2.ext import Extension
from jinja2.meta import find_undeclared_variables
from jinja2.parser import Parser
from markupsafe import Markup

from measured_report.files.config import read_toml
from measured_report.files.errors import ReportError

PARTS = {
    "claim": ("holds", "fails", "opposite", "asks", "because"),
    "figure": ("caption", "alt"),
    "table": ("caption",),
}
"""The parts of each kind. ``caption`` is what follows the opening tag; the others have a tag of their own."""
OPTIONAL = {"opposite", "because"}
SEPARATOR = "__"
"""Between kind, name and part in the name of the block that Jinja keeps a part as."""
# The token has a part that nobody can know before, so that no text of a record can be one.
OPEN, CLOSE = f"\ue000{secrets.token_hex(16)}n", "\ue001"

TAGS = re.compile(r"\{\{.*?\}\}|\{%.*?%\}|\{#.*?#\}|```.*?```|`[^`]*`", re.DOTALL)
TYPED = re.compile(r"(?<![\w.])\d[\d.,]*(?:e[+-]?\d+)?(?:\s|&nbsp;)?(?:mm/s|mm|µm|ms|kg|Hz|[Ns%°×])(?!\w)")
"""A number with the unit of one that is measured."""
CONSTANTS = frozenset(("none", "None", "true", "True", "false", "False"))
"""Names that Jinja has for itself, so that what is given under them is never said."""
FAILS = re.compile(
    r"\{% claim (\w+) %\}(?:(?!\{% endclaim).)*?\{% fails %\}(.*?)\{% (?!el|if|endif|for|endfor|set)", re.DOTALL
)
SENTENCE, STOP = re.compile(r"[.;?!](?:\s|$)|\{% el.*?%\}"), re.compile(r":\s")
UNSHOWN = re.compile(
    r"\b(?:cannot|(?:not?|none|nothing|never|nor)\b[^,:;]*) (?:be )?(?:shown|seen|told|known|found)\b|\bopen\b",
    re.IGNORECASE,
)


@dataclass(frozen=True)
class Wording:
    """Hold what a template says of one claim, figure or table."""

    place: str
    """File and line."""
    blocks: Mapping[str, str]
    """Names of its blocks by part."""
    names: frozenset[str]
    """Names in all parts."""
    render: Callable[[str, Mapping[str, Any]], Markup] | None = None
    """Renders the block of a name with what it can name; None until the template is compiled."""

    def __call__(self, part: str, numbers: Mapping[str, Any]) -> Markup:
        """Return a part with its numbers; empty where the template has no such part."""
        assert self.render, f"{self.place}: the words can't be rendered yet"
        return self.render(self.blocks[part], numbers) if part in self.blocks else Markup("")

    def refuse_unknown(self, what: str, numbers: Mapping[str, Any]) -> None:
        """Refuse a wording that names something that it is not given, or could not name what it is given."""
        if taken := sorted(CONSTANTS & set(numbers)):
            raise ReportError(f"{self.place}: {what} is given {taken[0]}, which is a constant in a template: rename it")
        if unknown := sorted(self.names - set(numbers)):
            there = ", ".join(sorted(numbers)) or "none"
            raise ReportError(f"{self.place}: {what} names {unknown[0]}, which it is not given; it is given: {there}")


class WordTags(Extension):
    """Add the tags: each part becomes a block that is printed by name, and the whole a call that prints it in place."""

    tags = set(PARTS)  # noqa: RUF012, as Jinja has it

    def parse(self, parser: Parser) -> list[nodes.Node]:
        kind = next(parser.stream)
        name = parser.stream.expect("name").value
        parts = PARTS[kind.value]
        ends = [*(part for part in parts if part != "caption"), f"end{kind.value}"]
        part, line, blocks = "caption", kind.lineno, []
        while part != ends[-1]:
            body = parser.parse_statements(tuple(f"name:{end}" for end in ends))
            if part in parts:
                label = SEPARATOR.join((kind.value, name, part))
                blocks.append(nodes.Block(label, body, False, False, lineno=line))
            elif not _is_blank(body):
                parser.fail(f"{kind.value} {name}: what it says belongs behind one of its tags", line)
            token = next(parser.stream)
            part, line = token.value, token.lineno
        said = {block.name.rpartition(SEPARATOR)[2] for block in blocks}
        optional = OPTIONAL | ({"fails"} if "opposite" in said else set())
        if missing := [part for part in parts if part not in optional | said]:
            parser.fail(f"{kind.value} {name} has no {{% {missing[0]} %}}", kind.lineno)
        call = nodes.Call(nodes.Name(kind.value, "load"), [nodes.Const(name)], [], None, None)
        # Jinja keeps every block of a template, those as well that are never reached where they stand.
        # The line behind the last tag ends there, and a sentence must not run into the next.
        shown = nodes.Output([call, nodes.TemplateData("\n")], lineno=kind.lineno)
        return [nodes.If(nodes.Const(False), blocks, [], [], lineno=kind.lineno), shown]


def refuse_typed(source: str) -> None:
    """Refuse a number that is typed into the words of a template, where a measured one belongs."""
    words = TAGS.sub(lambda tag: re.sub(r"[^\n]", " ", tag[0]), source)
    if found := TYPED.search(words):
        line = words.count("\n", 0, found.start()) + 1
        number = " ".join(found[0].split())
        raise TemplateSyntaxError(f"{number} is typed; name one that was measured, or of results.chosen(…)", line)


def overstated(templates: Path) -> list[str]:
    """Say which claims of a folder of templates say more than that they are not shown, a line each.

    A claim fails for want of what would show it as well as where its contrary is shown. So what stands between two
    stops in ``{% fails %}`` prints something, or its sentence says that this is not shown (not seen, cannot be told).
    """
    return [
        f"{path.relative_to(templates.parent)}: claim {name}: {{% fails %}} asserts “{words}”, and all that is known "
        "there is that the claim is not shown: say so, name a number instead, or move it to {% opposite %}"
        for path in sorted(templates.rglob("*.md.j2"))
        for name, fails in FAILS.findall(path.read_text(encoding="utf-8"))
        for words in _assertions(fails)
    ]


def _assertions(fails: str) -> Iterator[str]:
    """Yield what stands between two stops and neither prints anything nor says that something is not shown."""
    for sentence in SENTENCE.split(re.sub(r"\{\{.*?\}\}", "#", " ".join(fails.split()))):
        if not UNSHOWN.search(sentence):
            parts = (re.sub(r"\{%.*?%\}|<[^>]*>", "", part).strip() for part in STOP.split(sentence))
            yield from (part for part in parts if part and "#" not in part)


def token(printed: list[Any], thing: Any) -> Markup:
    """Return what stands in a text for a thing that is printed, which is kept for the time after Markdown."""
    printed.append(thing)
    return Markup(f"{OPEN}{len(printed) - 1}{CLOSE}")


def table_beside(templates: Path, name: str) -> dict[str, Any]:
    """Read a TOML file of a folder of templates, which need not be there; ReportError, one line, for what is none."""
    path = templates / name
    try:
        return read_toml(path) if path.is_file() else {}
    except ValueError as error:
        raise ReportError(f"templates/{name}: {error}") from None


def _is_blank(body: list[nodes.Node]) -> bool:
    found = [node for output in body for node in getattr(output, "nodes", [output])]
    return all(isinstance(node, nodes.TemplateData) and not node.data.strip() for node in found)


def worded(environment: Environment, parsed: nodes.Template, place: str) -> dict[tuple[str, str], Wording]:
    """Return what a template, parsed with ``environment``, says, by kind and name; errors name it as ``place``."""
    found: dict[tuple[str, str], Wording] = {}
    for block in parsed.find_all(nodes.Block):
        kind, name, part = block.name.split(SEPARATOR)
        body = nodes.Template(block.body)
        body.set_environment(environment)
        known = found.get((kind, name), Wording(f"{place}:{block.lineno}", {}, frozenset()))
        if part in known.blocks:
            raise TemplateSyntaxError(f"{kind} {name} is worded twice", block.lineno)
        names = known.names | find_undeclared_variables(body)
        found[kind, name] = Wording(known.place, {**known.blocks, part: block.name}, names)
    return found
