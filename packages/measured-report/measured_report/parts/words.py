"""Words: what a template says of claims, figures and tables, found before anything is rendered.

    {% claim leans %}
    {% holds %} The tower leans by {{ angle }}.
    {% fails %} The tower stands upright.
    {% asks %} whether the tower leans
    {% because %} The ground is soft on one side.
    {% endclaim %}

    {% figure tower %} The tower from the south. {% alt %} It leans by {{ angle }}. {% endfigure %}
    {% table cases %} All cases. {% endtable %}

``{% opposite %}`` may stand beside ``{% fails %}``, or in its place. Parts name what Python hands over, nothing else; a
number behind *at most* or *up to* is ``{{ angle.most }}``, behind *at least* ``{{ angle.least }}``. Around them the
template of a section has ``row["north"].lean_mm``, ``rows``, ``value.lean`` as it was derived, ``release``,
``table(name)``, ``figure(name)``, ``download(name)`` and ``holds("section.claim")``; the texts of pages have
``sections.tower.claim("leans")`` and the same of its tables and figures, and ``measured``, the names of the sections
that have a record.
"""

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from typing import Any

from jinja2 import Environment, TemplateSyntaxError, nodes
from jinja2.parser import Parser
from markupsafe import Markup

# The parts of each kind; `caption` follows the opening tag, the others have a tag each.
PARTS = {
    "claim": ("holds", "fails", "opposite", "asks", "because"),
    "figure": ("caption", "alt"),
    "table": ("caption",),
}
TAGS = re.compile(r"\{\{.*?\}\}|\{%.*?%\}|\{#.*?#\}|```.*?```|`[^`]*`", re.DOTALL)
TYPED = re.compile(
    r"""
    (?<![\w.])\d[\d.,]*(?:e[+-]?\d+)?(?:\s|&nbsp;)?
    (?:
        [nµmkMGT]?(?:[msgNJWB]|Pa|Hz|rad|bit)[²³]?(?:/\w+)?
        |[mk][AV]|min|times|[%°×x]
    )(?!\w)
    """,
    re.VERBOSE,
)
"""A number with a unit, as one that was measured has it."""
BOUNDS = {
    "at most|within|no more than|not more than|up to|as much as": (".most",),
    "at least|no less than|not less than": (".least",),
    # Which of them depends on what the sentence denies.
    "more than|less than": (".most", ".least"),
}
"""Words that bound the number behind them, and how it is rounded there."""


@dataclass(frozen=True)
class Wording:
    """Hold what a template says of one claim, figure or table."""

    parts: Mapping[str, str]  # names of the template's blocks
    render: Callable[[str, Mapping[str, Any]], Markup]  # renders a block

    def __call__(self, part: str, numbers: Mapping[str, Any]) -> Markup:
        """Return a part with its numbers; empty if the template has no such part."""
        if part not in self.parts:
            return Markup("")
        return self.render(self.parts[part], numbers)


def wordings_of(
    blocks: Iterable[str], render: Callable[[str, Mapping[str, Any]], Markup]
) -> dict[tuple[str, str], Wording]:
    """Return what the blocks of a template say, by kind and name of the item."""
    parts: dict[tuple[str, str], dict[str, str]] = {}
    for block in blocks:
        kind, name, part = block.split("__")
        parts.setdefault((kind, name), {})[part] = block
    return {item: Wording(named, render) for item, named in parts.items()}


def parse_words(parser: Parser, environment: Environment) -> list[nodes.Node]:
    """Parse a claim, figure or table: its parts become blocks, and the whole a call."""
    tag = next(parser.stream)
    kind, name = tag.value, parser.stream.expect("name").value
    blocks = _parse_parts(parser, kind, name, tag.lineno)
    optional = {"opposite", "because"} | ({"fails"} if "opposite" in blocks else set())
    for part in PARTS[kind]:
        if part not in optional | blocks.keys():
            parser.fail(f"{kind} {name} has no {{% {part} %}}", tag.lineno)
    call = nodes.Call(nodes.Name(kind, "load"), [nodes.Const(name)], [], None, None)
    # The line behind the last tag ends there, and no sentence runs into the next.
    output = nodes.Output([call, nodes.TemplateData("\n")], lineno=tag.lineno)
    # Jinja keeps every block of a template, those as well that are never reached.
    never = nodes.If(nodes.Const(False), [*blocks.values()], [], [], lineno=tag.lineno)
    return [never, output]


def _parse_parts(
    parser: Parser, kind: str, name: str, line: int
) -> dict[str, nodes.Block]:
    """Parse all up to the end tag into a block for each part."""
    parts, end = PARTS[kind], f"end{kind}"
    tags = [f"name:{tag}" for tag in (*parts, end) if tag != "caption"]
    blocks: dict[str, nodes.Block] = {}
    part = "caption"
    while part != end:
        body = parser.parse_statements(tuple(tags))
        if part in blocks:
            parser.fail(f"{kind} {name} is worded twice", line)
        if part in parts:
            block = f"{kind}__{name}__{part}"
            blocks[part] = nodes.Block(block, body, False, False, lineno=line)
        elif not _is_blank(body):
            parser.fail(
                f"{kind} {name}: what it says belongs behind one of its tags", line
            )
        tag = next(parser.stream)
        part, line = tag.value, tag.lineno
    return blocks


def refuse_numbers(source: str) -> None:
    """Refuse numbers that are typed, and bounds that rounding could move past theirs."""
    prose = TAGS.sub(lambda tag: re.sub(r"[^\n]", " ", tag[0]), source)
    if match := TYPED.search(prose):
        number = " ".join(match[0].split())
        raise TemplateSyntaxError(
            f"{number} is typed; name one that was measured, or of results.chosen(…)",
            _line_of(match),
        )
    for words, ends in BOUNDS.items():
        spaced = words.replace(" ", r"\s+")
        bounded = rf"\b(?:{spaced})\s+(?:a factor of\s+)?\{{\{{\s*(.*?)\s*\}}\}}"
        for match in re.finditer(bounded, source, re.IGNORECASE):
            if not match[1].endswith(ends):
                bound = " ".join(match[0].split())
                raise TemplateSyntaxError(
                    f"{bound} takes {' or '.join(ends)}", _line_of(match)
                )


def _line_of(match: re.Match[str]) -> int:
    return match.string.count("\n", 0, match.start()) + 1


def _is_blank(body: list[nodes.Node]) -> bool:
    children = [node for output in body for node in getattr(output, "nodes", [output])]
    return all(
        isinstance(node, nodes.TemplateData) and not node.data.strip()
        for node in children
    )
