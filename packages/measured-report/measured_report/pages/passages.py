"""Passages: paragraphs for the data that there is, which stand only while the claims that they rest on do.

    {% passage needs="tower.leans, ground.is_soft" %}
    The tower leans by {{ tower.leans.angle }}, for the ground is soft on one side.
    {% otherwise %}
    {% passage needs="tower.leans fails" %} The tower stands upright. {% endpassage %}
    {% endpassage %}

A need is a claim that holds, or one with an outcome behind it: ``fails``, or ``opposite``. A passage may print numbers
of the claims that it needs, by ``section.claim.number``, and what it names itself: a ``cell``, a ``value``, a ``row``.
Where a need is not met, what is under ``otherwise`` is said, or else what these claims say themselves. On one line a
passage is a part of a paragraph, on several it is whole ones. ``answer="why"`` behind needs is its ``data-answer``.
"""

import re
from collections.abc import Callable, Mapping
from functools import partial
from types import SimpleNamespace
from typing import Any, NamedTuple

from jinja2 import nodes, pass_context
from jinja2.ext import Extension
from jinja2.meta import find_undeclared_variables
from jinja2.parser import Parser
from jinja2.runtime import Context
from markupsafe import Markup

from measured_report.parts.claim import Claim
from measured_report.parts.macros import macros
from measured_report.parts.words import token
from measured_report.values.format import ABSENT

NEED = re.compile(r"(\w+)\.(\w+)( holds| fails| opposite)?")
LOST = re.compile(f'<(?:data|span)[^>]* title="([^"]*)"[^>]*>{ABSENT}<')  # a number that is not there, as it is printed
# Besides the sections that it needs; each says itself which number it is.
NAMED = {"cell", "value", "row", "release", "config"}


class Need(NamedTuple):
    """Name a claim and the outcome that a passage rests on."""

    section: str
    claim: str
    outcome: str

    def is_met(self, claim: Claim | None) -> bool:
        """Tell whether the claim, None where there is none, has this outcome."""
        outcome = claim.outcome if claim else None
        return bool(outcome and (outcome.is_opposite if self.outcome == "opposite" else outcome.name == self.outcome))

    def __str__(self) -> str:
        return f"{self.section}.{self.claim} {self.outcome}"


def needs_of(text: str) -> list[Need]:
    """Read what a passage needs; ValueError for what is none."""
    matches = [(entry.strip(), NEED.fullmatch(entry.strip())) for entry in text.split(",")]
    if wrong := [entry for entry, need in matches if not need]:
        raise ValueError(f"{wrong[0]!r} is no need of a passage; one is section.claim")
    return [Need(need[1], need[2], (need[3] or "holds").strip()) for _, need in matches if need]


class PassageTag(Extension):
    """Add the tag; a template with one is given a ``passage``."""

    tags = {"passage"}  # noqa: RUF012, as Jinja has it

    def parse(self, parser: Parser) -> list[nodes.Node]:
        line = next(parser.stream).lineno
        text = _attribute(parser, "needs")
        answer = _attribute(parser, "answer") if parser.stream.current.test("name:answer") else ""
        try:
            needs = needs_of(text)
        except ValueError as error:
            parser.fail(str(error), line)
        body, otherwise = parser.parse_statements(("name:otherwise", "name:endpassage")), []
        end = next(parser.stream)
        if has_other := end.value == "otherwise":
            otherwise = parser.parse_statements(("name:endpassage",))
            end = next(parser.stream)
        sections = sorted({need.section for need in needs})
        template = nodes.Template(body)
        template.set_environment(self.environment)
        if strange := sorted(find_undeclared_variables(template) - {*sections, *NAMED, "passage"}):
            parser.fail(f"the passage names {strange[0]}, which is no section that it needs", line)
        name = f"otherwise_{line}_{end.lineno}"
        macro = nodes.Macro(name, [], [], otherwise, lineno=line)
        alternative = nodes.Name(name, "load") if has_other else nodes.Const(None)
        call_arguments = [*map(nodes.Const, (text, answer, end.lineno == line)), alternative]
        call = nodes.Call(nodes.Name("passage", "load"), call_arguments, [], None, None)
        arguments = [nodes.Name(section, "param") for section in sections]
        return [macro, nodes.CallBlock(call, arguments, [], body, lineno=line)]


def _attribute(parser: Parser, name: str) -> str:
    parser.stream.expect(f"name:{name}")
    parser.stream.expect("assign")
    return parser.stream.expect("string").value


def teller(find: Callable[[str, str], Claim | None]) -> Callable[..., str]:
    """Make what says the passages of a template of the claims that ``find`` finds by section and name."""

    @pass_context
    def passage(context: Context, text: str, answer: str, is_inline: bool, otherwise: Any, caller: Any) -> str:
        printed, claims = context["printed"], {need: find(need.section, need.claim) for need in needs_of(text)}
        measured = {need: claim for need, claim in claims.items() if claim}
        are_met = all(need.is_met(claim) for need, claim in claims.items())
        body, is_measured = None, len(measured) == len(claims)
        if is_measured:  # rendered as well where another story is told: with other numbers it is this
            render = partial(caller, *_numbers(measured))
            body = _rendered(render, printed, lambda items: are_met and not any(map(_is_lost, items)))
        stands = body is not None
        if otherwise:
            if (alternative := _rendered(otherwise, printed, lambda _: not stands)) is not None:
                return alternative
        elif is_measured and not stands:  # what was not measured is listed on the page: no other answer
            sentences = [claim.html(need.section) for need, claim in measured.items()]
            body = token(printed, Markup(" ").join([*sentences, macros().other_data()]))
        if not body:
            return Markup("")
        element, edge = ("span", "") if is_inline else ("div", "\n\n")
        opened = macros().passage(element, ", ".join(map(str, claims)), stands, answer)
        before, behind = (token(printed, end) for end in (opened, Markup(f"</{element}>")))
        return Markup(edge.join(["", before, body.strip(), behind, "" if is_inline else "\n"]))

    return passage


def _rendered(render: Callable[[], str], printed: list[Any], is_kept: Callable[[list[Any]], bool]) -> str | None:
    """Render a text; None, with what it printed taken back, where that is not to be kept."""
    start = len(printed)
    text = render()
    if is_kept(printed[start:]):
        return text
    del printed[start:]  # the places of tokens are counted: what nobody shows may not stand among them
    return None


def _is_lost(item: Any) -> bool:
    return isinstance(item, Markup) and bool(LOST.search(item))


def _numbers(claims: Mapping[Need, Claim]) -> list[SimpleNamespace]:
    numbers: dict[str, dict[str, Any]] = {}
    for need, claim in claims.items():
        numbers.setdefault(need.section, {})[need.claim] = SimpleNamespace(**claim.numbers)
    return [SimpleNamespace(**numbers[section]) for section in sorted(numbers)]
