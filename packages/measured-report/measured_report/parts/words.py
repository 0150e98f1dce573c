"""Parse the wordings of claims, figures and tables in a template.

    {% claim leans %}
    {% holds %} The tower leans by {{ angle }}.
    {% fails %} The tower stands upright.
    {% asks %} whether the tower leans
    {% because %} The ground is soft on one side.
    {% endclaim %}

    {% figure tower %}
    This is the tower from the south. {% alt %} It leans by {{ angle }}.
    {% endfigure %}
    {% table cases %} All cases. {% endtable %}

``{% opposite %}`` can be used in addition to ``{% fails %}``, or instead of it. These
parts can name only the numbers that Python passes to the claim, figure or table. After
*at most* or *up to*, write ``{{ angle.most }}``. After *at least*, write
``{{ angle.least }}``.

Outside of these parts, the template of a section can name ``row["north"].lean_mm``,
``rows``, the derived ``value.lean``, ``release``, ``table(name)``, ``figure(name)``,
``download(name)`` and ``holds("section.claim")``. The template of a page can
name a claim as ``sections.tower.claim("leans")``, and the tables and figures of a
section in the same way. ``measured`` contains the names of the sections with a record.
"""

import re
from collections.abc import Callable, Iterable, Mapping
from functools import partial
from typing import Any

from jinja2 import Environment, TemplateSyntaxError, nodes
from jinja2.parser import Parser
from markupsafe import Markup

# The parts of each kind. The caption follows the opening tag; each other part has a tag.
PARTS = {
    "claim": ("holds", "fails", "opposite", "asks", "because"),
    "figure": ("caption", "alt"),
    "table": ("caption",),
}
TAGS = re.compile(r"\{\{.*?\}\}|\{%.*?%\}|\{#.*?#\}|```.*?```", re.DOTALL)
TYPED = re.compile(
    r"""
    (?<![\w.])\d[\d.,]*(?:e[+-]?\d+)?(?:\s|&nbsp;)?
    (?:
        [nµmkMGT]?(?:[msgNJWB]|Pa|Hz|rad|bit)[²³]?(?:/\w+)?
        |[mk][AV]|min|times|percent|[%°×x]
    )(?!\w)
    | (?<=\|)\s*\d[\d.,]*\s*(?=\|)  # a cell of a table
    | \b(?i:
        (?:two|three|four|five|six|seven|eight|nine|ten|twenty|fifty|hundred|thousand)
        (?:\s+(?:times|per\s?cent)|-?fold)
        | twice\s+(?:as|the) | thrice | half\s+as | orders?\s+of\s+magnitude
        | (?:nearly|almost|about|more\s+than)\s+(?:twice|double|half)
        | (?:an?|one|two|three)[\s-](?:third|quarter|fifth|eighth|tenth)s?\s+of
    )\b
    """,
    re.VERBOSE,
)
"""Matches a hard-coded number with a unit, or a ratio in words.

These should be measured numbers instead.
"""
BOUNDS = {
    "at most|within|no more than|not more than|up to|as much as": (".most",),
    "at least|no less than|not less than": (".least",),
    # The direction depends on whether the sentence contains a negation.
    "more than|less than": (".most", ".least"),
}
"""Words that make the next number a bound, and the attributes that round it safely."""


Wording = Mapping[str, Callable[[Mapping[str, Any]], Markup]]
"""The texts of one claim, figure or table, each as a function of its numbers."""


def wordings_of(
    blocks: Iterable[str], render: Callable[[str, Mapping[str, Any]], Markup]
) -> dict[tuple[str, str], Wording]:
    """Return the wordings in the blocks of a template, by kind and name."""
    wordings: dict[tuple[str, str], dict[str, Any]] = {}
    for block in blocks:
        kind, name, part = block.split("__")
        wordings.setdefault((kind, name), {})[part] = partial(render, block)
    return {**wordings}


def parse_words(parser: Parser, environment: Environment) -> list[nodes.Node]:
    """Parse the tags of a claim, figure or table.

    Its parts become blocks, and a call of the function ``claim``, ``figure`` or
    ``table`` prints it.
    """
    tag = next(parser.stream)
    kind, name = tag.value, parser.stream.expect("name").value
    blocks = _parse_parts(parser, kind, name, tag.lineno)
    optional = {"opposite", "because"} | ({"fails"} if "opposite" in blocks else set())
    for part in PARTS[kind]:
        if part not in optional | blocks.keys():
            parser.fail(
                f"{kind} {name} does not have {{% {part} %}}: add it", tag.lineno
            )
    call = nodes.Call(nodes.Name(kind, "load"), [nodes.Const(name)], [], None, None)
    # Jinja removes the line break after the end tag; without one, the next sentence
    # would follow without a space.
    output = nodes.Output([call, nodes.TemplateData("\n")], lineno=tag.lineno)
    # Jinja keeps the blocks of a template even if they are never reached.
    never = nodes.If(nodes.Const(False), [*blocks.values()], [], [], lineno=tag.lineno)
    return [never, output]


def _parse_parts(
    parser: Parser, kind: str, name: str, line: int
) -> dict[str, nodes.Block]:
    """Return a block for each part before the end tag."""
    parts, end = PARTS[kind], f"end{kind}"
    tags = [f"name:{tag}" for tag in (*parts, end) if tag != "caption"]
    blocks: dict[str, nodes.Block] = {}
    part = "caption"
    while part != end:
        body = parser.parse_statements(tuple(tags))
        if part in blocks:
            parser.fail(
                f"{kind} {name} has two texts for {part}: remove one of them", line
            )
        if part in parts:
            if part != "caption" and _is_blank(body):
                parser.fail(f"{kind} {name} has no text for {part}: add it", line)
            block = f"{kind}__{name}__{part}"
            blocks[part] = nodes.Block(block, body, False, False, lineno=line)
        elif not _is_blank(body):
            parser.fail(
                f"{kind} {name} has text before its first tag: move it after a tag",
                line,
            )
        tag = next(parser.stream)
        part, line = tag.value, tag.lineno
    return blocks


def refuse_numbers(source: str) -> None:
    """Raise TemplateSyntaxError for hard-coded numbers, and for bounds that are not rounded.

    Rounding to the nearest digit could move a number past its bound.
    """
    prose = TAGS.sub(lambda tag: re.sub(r"[^\n]", " ", tag[0]), source)
    if match := TYPED.search(prose):
        number = " ".join(match[0].split())
        raise TemplateSyntaxError(
            f"{number} is hard-coded: use a measured number or results.chosen(…)",
            _line_of(match),
        )
    for words, ends in BOUNDS.items():
        spaced = words.replace(" ", r"\s+")
        bounded = rf"\b(?:{spaced})\s+(?:a factor of\s+)?\{{\{{\s*(.*?)\s*\}}\}}"
        for match in re.finditer(bounded, source, re.IGNORECASE):
            if not match[1].endswith(ends):
                bound = " ".join(match[0].split())
                raise TemplateSyntaxError(
                    f"{bound} may be rounded past its bound: add {' or '.join(ends)}",
                    _line_of(match),
                )


def _line_of(match: re.Match[str]) -> int:
    return match.string.count("\n", 0, match.start()) + 1


def _is_blank(body: list[nodes.Node]) -> bool:
    children = [node for output in body for node in getattr(output, "nodes", [output])]
    return all(
        isinstance(node, nodes.TemplateData) and not node.data.strip()
        for node in children
    )
