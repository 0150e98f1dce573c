"""Passages: paragraphs for the data that there is, which stand only while the claims that they rest on do.

    {% passage needs="tower.leans, ground.is_soft" %}
    The tower leans by {{ tower.leans.angle }}, for the ground is soft on one side.
    {% otherwise %}
    {% passage needs="tower.leans fails" %} The tower stands upright. {% endpassage %}
    {% endpassage %}

A need is a claim that holds, or one with an outcome behind it: ``fails``, or ``opposite``. A passage may print numbers
of the claims that it needs, by ``section.claim.number``, and those that the template around it can name.
Where a need is not met, what is under ``otherwise`` is said, or else what these claims say themselves. On one line a
passage is a part of a paragraph, on several it is whole ones. ``answer="why"`` behind needs is its ``data-answer``.
"""

import re
from collections.abc import Callable, Mapping
from types import SimpleNamespace
from typing import Any

from jinja2 import Environment, nodes, pass_context
from jinja2.parser import Parser
from jinja2.runtime import Context
from markupsafe import Markup

from measured_report.parts.claim import Claim
from measured_report.parts.macros import macros
from measured_report.parts.prose import token
from measured_report.values.quantities import lost_reason

NEED = re.compile(r"(\w+)\.(\w+)( holds| fails| opposite)?")
Need = tuple[str, str, str]  # a section, its claim, and the outcome that is needed


def needs_of(text: str) -> list[Need]:
    """Read what a passage needs; ValueError for what is none."""
    needs = []
    for entry in map(str.strip, text.split(",")):
        if not (need := NEED.fullmatch(entry)):
            raise ValueError(f'needs: expects "section.claim", got {entry!r}')
        needs.append((need[1], need[2], (need[3] or "holds").strip()))
    return needs


def is_met(need: Need, claim: Claim | None) -> bool:
    """Tell whether the claim, None where there is none, has the outcome that is needed."""
    if claim is None:
        return False
    if need[2] == "opposite":
        return claim.outcome.is_opposite
    return claim.outcome.name == need[2]


def parse_passage(parser: Parser, environment: Environment) -> list[nodes.Node]:
    """Parse a passage into a call of ``passage``, which decides what of it is said."""
    line = next(parser.stream).lineno
    text = _attribute(parser, "needs")
    has_answer = parser.stream.current.test("name:answer")
    answer = _attribute(parser, "answer") if has_answer else ""
    try:
        sections = sorted({section for section, _, _ in needs_of(text)})
    except ValueError as error:
        parser.fail(str(error), line)
    body = parser.parse_statements(("name:otherwise", "name:endpassage"))
    otherwise: list[nodes.Node] = []
    end = next(parser.stream)
    if has_other := end.value == "otherwise":
        otherwise = parser.parse_statements(("name:endpassage",))
        end = next(parser.stream)
    arguments = map(nodes.Const, (text, answer, end.lineno == line, has_other))
    call = nodes.Call(nodes.Name("passage", "load"), [*arguments], [], None, None)
    names = [nodes.Name(name, "param") for name in ("stands", *sections)]
    choice = nodes.If(nodes.Name("stands", "load"), body, [], otherwise, lineno=line)
    return [nodes.CallBlock(call, names, [], [choice], lineno=line)]


def _attribute(parser: Parser, name: str) -> str:
    parser.stream.expect(f"name:{name}")
    parser.stream.expect("assign")
    return parser.stream.expect("string").value


def passages(find: Callable[[str, str], Claim | None]) -> Callable[..., str]:
    """Return what says passages, by claims that ``find`` finds by section and name."""

    @pass_context
    def passage(
        context: Context,
        text: str,
        answer: str,
        is_inline: bool,
        has_other: bool,
        caller: Callable[..., str],
    ) -> str:
        printed: list[Any] = context["printed"]
        start = len(printed)
        needs = needs_of(text)
        claims = {need: find(*need[:2]) for need in needs}
        measured = {need: claim for need, claim in claims.items() if claim}
        is_measured = len(measured) == len(claims)
        body = ""
        if is_measured:
            # Said where it falls as well: with other numbers it stands, and must not err.
            body = caller(True, *_numbers(measured))
        stands = all(is_met(need, claim) for need, claim in claims.items())
        stands &= not any(map(lost_reason, printed[start:]))
        if not stands:
            # Tokens are counted: what nobody sees may not stand among them.
            del printed[start:]
            if has_other:
                return caller(False)
            if not is_measured:  # the page lists what was not measured
                return Markup("")
            said = [claim.html(need[0]) for need, claim in measured.items()]
            body = token(printed, Markup(" ").join([*said, macros().other_data()]))
        if not body:
            return Markup("")
        element, edge = ("span", "") if is_inline else ("div", "\n\n")
        text = ", ".join(f"{section}.{name} {end}" for section, name, end in needs)
        before = token(printed, macros().passage(element, text, stands, answer))
        behind = token(printed, Markup(f"</{element}>"))
        last = "" if is_inline else "\n"
        return Markup(edge.join(["", before, body.strip(), behind, last]))

    return passage


def _numbers(claims: Mapping[Need, Claim]) -> list[SimpleNamespace]:
    """Return what a passage can name of each section, by claim and number."""
    numbers: dict[str, dict[str, Any]] = {}
    for (section, name, _), claim in claims.items():
        numbers.setdefault(section, {})[name] = SimpleNamespace(**claim.numbers)
    return [SimpleNamespace(**numbers[section]) for section in sorted(numbers)]
