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
``sections.tower.claim("leans")`` and the same of its tables and figures.
"""

import re
import secrets
from collections import defaultdict
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from jinja2 import Environment, TemplateSyntaxError, nodes
from jinja2.ext import Extension
from jinja2.meta import find_undeclared_variables
from jinja2.parser import Parser
from markupsafe import Markup

from measured_report.files.errors import ReportError

# The parts of each kind; `caption` is what follows the opening tag, the others have a tag of their own.
CLAIM = ("holds", "fails", "opposite", "asks", "because")
PARTS = {"claim": CLAIM, "figure": ("caption", "alt"), "table": ("caption",)}
# The token has a part that nobody can know before, so that no text of a record can be one.
OPEN, CLOSE = f"\ue000{secrets.token_hex(16)}n", "\ue001"

TAGS = re.compile(r"\{\{.*?\}\}|\{%.*?%\}|\{#.*?#\}|```.*?```|`[^`]*`", re.DOTALL)
TYPED = re.compile(
    r"(?<![\w.])\d[\d.,]*(?:e[+-]?\d+)?(?:\s|&nbsp;)?"
    r"(?:[nµmkMGT]?(?:[msgNJWB]|Pa|Hz|rad|bit)[²³]?(?:/\w+)?|[mk][AV]|min|times|[%°×x])(?!\w)"
)  # a number with the unit of one that is measured
MARKDOWN = re.compile(r"\*\*|(?<![\w*])\*\w|`|\]\(")
FORMULA = re.compile(TAGS.pattern + r"|\$\$(.+?)\$\$|\$(?=\S)([^$\n]*\S)\$(?!\w)", re.DOTALL)  # in TeX; none in code
BOUNDS = {
    "at most|within|no more than|not more than|up to|as much as": (".most",),
    "at least|no less than|not less than": (".least",),
    "more than|less than": (".most", ".least"),  # which of them depends on what the sentence denies
}  # words that bound the number behind them, and how it is rounded there
CONSTANTS = frozenset(("none", "None", "true", "True", "false", "False"))  # which Jinja has for itself


@dataclass(frozen=True)
class Wording:
    """Hold what a template says of one claim, figure or table."""

    source: str
    blocks: Mapping[str, str]
    names: frozenset[str]
    render: Callable[[str, Mapping[str, Any]], Markup] | None = None  # a block; None until the template is compiled

    def __call__(self, part: str, numbers: Mapping[str, Any]) -> Markup:
        """Return a part with its numbers; empty where the template has no such part."""
        assert self.render, f"{self.source}: the words can't be rendered yet"
        return self.render(self.blocks[part], numbers) if part in self.blocks else Markup("")

    def refuse_unknown(self, item: str, numbers: Mapping[str, Any]) -> None:
        """Refuse a wording that names something that it is not given, or could not name what it is given."""
        if name := min(CONSTANTS & set(numbers), default=""):
            raise ReportError(f"{self.source}: {item} is given {name}, which is a constant in a template: rename it")
        if unknown := sorted(self.names - set(numbers)):
            names = ", ".join(sorted(numbers)) or "none"
            raise ReportError(f"{self.source}: {item} names {unknown[0]}, which it is not given; it is given: {names}")


class WordTags(Extension):
    """Add the tags: each part becomes a block, and the whole a call; ``wordings`` has them by template, kind, name."""

    tags = set(PARTS)  # noqa: RUF012, as Jinja has it

    def __init__(self, environment: Environment):
        super().__init__(environment)
        environment.extend(wordings=defaultdict(dict))

    def parse(self, parser: Parser) -> list[nodes.Node]:
        tag = next(parser.stream)
        kind, name, parts = tag.value, parser.stream.expect("name").value, PARTS[tag.value]
        ends = [*(part for part in parts if part != "caption"), f"end{kind}"]
        part, line, blocks = "caption", tag.lineno, {}
        if (kind, name) in (worded := vars(parser).setdefault("worded", set())):
            parser.fail(f"{kind} {name} is worded twice", line)
        worded.add((kind, name))
        while part != ends[-1]:
            body = parser.parse_statements(tuple(f"name:{end}" for end in ends))
            if part in blocks:
                parser.fail(f"{kind} {name} is worded twice", line)
            if part in parts:
                blocks[part] = nodes.Block(f"{kind}__{name}__{part}", body, False, False, lineno=line)
            elif not _is_blank(body):
                parser.fail(f"{kind} {name}: what it says belongs behind one of its tags", line)
            token = next(parser.stream)
            part, line = token.value, token.lineno
        optional = {"opposite", "because"} | ({"fails"} if "opposite" in blocks else set())
        if missing := [part for part in parts if part not in optional | blocks.keys()]:
            parser.fail(f"{kind} {name} has no {{% {missing[0]} %}}", tag.lineno)
        if any(MARKDOWN.search(text.data) for block in blocks.values() for text in block.find_all(nodes.TemplateData)):
            parser.fail(f"{kind} {name} has Markdown, and its words are HTML, as <em>", tag.lineno)
        tree = nodes.Template([node for block in blocks.values() for node in block.body])
        tree.set_environment(self.environment)
        source = f"templates/{parser.name}:{min(block.lineno for block in blocks.values())}"
        named = {part: block.name for part, block in blocks.items()}
        wordings: Any = self.environment
        wordings.wordings[parser.name][kind, name] = Wording(source, named, frozenset(find_undeclared_variables(tree)))
        call = nodes.Call(nodes.Name(kind, "load"), [nodes.Const(name)], [], None, None)
        # Jinja keeps every block of a template, those as well that are never reached where they stand.
        # The line behind the last tag ends there, and a sentence must not run into the next.
        output = nodes.Output([call, nodes.TemplateData("\n")], lineno=tag.lineno)
        return [nodes.If(nodes.Const(False), [*blocks.values()], [], [], lineno=tag.lineno), output]


def refuse_numbers(source: str) -> None:
    """Refuse numbers that are typed where measured ones belong, and bounds that rounding could move past theirs."""
    prose = TAGS.sub(lambda tag: re.sub(r"[^\n]", " ", tag[0]), source)
    if match := TYPED.search(prose):
        line = prose.count("\n", 0, match.start()) + 1
        number = " ".join(match[0].split())
        raise TemplateSyntaxError(f"{number} is typed; name one that was measured, or of results.chosen(…)", line)
    for bound, ends in BOUNDS.items():
        spaced = bound.replace(" ", r"\s+")
        bounded = rf"\b(?:{spaced})\s+(?:a factor of\s+)?\{{\{{\s*(.*?)\s*\}}\}}"
        for match in re.finditer(bounded, source, re.IGNORECASE):
            if not match[1].endswith(ends):
                line = source.count("\n", 0, match.start()) + 1
                raise TemplateSyntaxError(f"{' '.join(match[0].split())} takes {' or '.join(ends)}", line)


def with_formulas(source: str) -> str:
    """Write as MathML what a template has in TeX between dollars, and between two of them what is set apart."""

    def written(match: re.Match[str]) -> str:
        if not (tex := match[1] or match[2]):
            return match[0]
        from latex2mathml.converter import convert  # few templates have any

        try:
            formula = convert(tex, display="block" if match[1] else "inline")
        except Exception:  # it has no one error, and no words for any
            formula = "\\"
        if "\\" in formula:
            line = source.count("\n", 0, match.start()) + 1
            raise TemplateSyntaxError(f"{tex:.60} is no TeX that is known here", line)
        return f"<span>{formula}</span>"

    if "$$" in TAGS.sub("", text := FORMULA.sub(written, source)):
        raise TemplateSyntaxError("$$ begins a formula that no $$ ends", source.count("\n", 0, source.rfind("$$")) + 1)
    return text


def token(printed: list[Any], item: Any) -> Markup:
    """Return what stands in a text for a thing that is printed, which is kept for the time after Markdown."""
    printed.append(item)
    return Markup(f"{OPEN}{len(printed) - 1}{CLOSE}")


def _is_blank(body: list[nodes.Node]) -> bool:
    children = [node for output in body for node in getattr(output, "nodes", [output])]
    return all(isinstance(node, nodes.TemplateData) and not node.data.strip() for node in children)
