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
from types import SimpleNamespace
from typing import Any, NamedTuple

from jinja2 import Environment, nodes, pass_context
from jinja2.meta import find_undeclared_variables
from jinja2.parser import Parser
from jinja2.runtime import Context
from markupsafe import Markup

from measured_report.parts.claim import Claim
from measured_report.parts.macros import macros
from measured_report.parts.prose import token
from measured_report.values.quantities import lost_reason

NEED = re.compile(r"(\w+)\.(\w+)( holds| fails| opposite)?")
# What a passage may name besides the sections that it needs: each is one number's own name.
NAMED = {"cell", "value", "row", "release", "config"}


class Need(NamedTuple):
    """Name a claim and the outcome that a passage rests on."""

    section: str
    claim: str
    outcome: str

    def is_met(self, claim: Claim | None) -> bool:
        """Tell whether the claim, None where there is none, has this outcome."""
        if claim is None:
            return False
        outcome = claim.outcome
        if self.outcome == "opposite":
            return outcome.is_opposite
        return outcome.name == self.outcome

    def __str__(self) -> str:
        return f"{self.section}.{self.claim} {self.outcome}"


def needs_of(text: str) -> list[Need]:
    """Read what a passage needs; ValueError for what is none."""
    needs = []
    for entry in map(str.strip, text.split(",")):
        if not (need := NEED.fullmatch(entry)):
            raise ValueError(f'needs: expects "section.claim", got {entry!r}')
        needs.append(Need(need[1], need[2], (need[3] or "holds").strip()))
    return needs


def parse_passage(parser: Parser, environment: Environment) -> list[nodes.Node]:
    """Parse a passage into a call of ``passage``, which decides what of it is said."""
    line = next(parser.stream).lineno
    text = _attribute(parser, "needs")
    has_answer = parser.stream.current.test("name:answer")
    answer = _attribute(parser, "answer") if has_answer else ""
    try:
        sections = sorted({need.section for need in needs_of(text)})
    except ValueError as error:
        parser.fail(str(error), line)
    body = parser.parse_statements(("name:otherwise", "name:endpassage"))
    otherwise: list[nodes.Node] = []
    end = next(parser.stream)
    if has_other := end.value == "otherwise":
        otherwise = parser.parse_statements(("name:endpassage",))
        end = next(parser.stream)
    template = nodes.Template(body)
    template.set_environment(environment)
    named = find_undeclared_variables(template)
    if strange := sorted(named - {*sections, *NAMED, "passage"}):
        parser.fail(
            f"the passage names {strange[0]}, which is no section that it needs", line
        )
    name = f"otherwise_{line}_{end.lineno}"
    macro = nodes.Macro(name, [], [], otherwise, lineno=line)
    is_inline = end.lineno == line
    arguments = [
        *map(nodes.Const, (text, answer, is_inline)),
        nodes.Name(name, "load") if has_other else nodes.Const(None),
    ]
    call = nodes.Call(nodes.Name("passage", "load"), arguments, [], None, None)
    parameters = [nodes.Name(section, "param") for section in sections]
    return [macro, nodes.CallBlock(call, parameters, [], body, lineno=line)]


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
        otherwise: Callable[[], str] | None,
        caller: Callable[..., str],
    ) -> str:
        printed: list[Any] = context["printed"]
        claims = {need: find(need.section, need.claim) for need in needs_of(text)}
        measured = {need: claim for need, claim in claims.items() if claim}
        is_measured = len(measured) == len(claims)
        stands = all(need.is_met(claim) for need, claim in claims.items())
        start = len(printed)
        body = ""
        if is_measured:
            # Said where it falls as well: with other numbers it stands, and must not err.
            body = caller(*_numbers(measured))
            stands &= not any(map(lost_reason, printed[start:]))
        if not stands:
            # Tokens are counted: what nobody sees may not stand among them.
            del printed[start:]
            body = ""
        if otherwise:
            start = len(printed)
            alternative = otherwise()
            if not stands:
                return alternative
            del printed[start:]
        elif is_measured and not stands:  # the page lists what was not measured
            said = [claim.html(need.section) for need, claim in measured.items()]
            body = token(printed, Markup(" ").join([*said, macros().other_data()]))
        if not body:
            return Markup("")
        element, edge = ("span", "") if is_inline else ("div", "\n\n")
        needs = ", ".join(map(str, claims))
        opening = macros().passage(element, needs, stands, answer)
        before = token(printed, opening)
        behind = token(printed, Markup(f"</{element}>"))
        end = "" if is_inline else "\n"
        return Markup(edge.join(["", before, body.strip(), behind, end]))

    return passage


def _numbers(claims: Mapping[Need, Claim]) -> list[SimpleNamespace]:
    """Return what a passage can name of each section, by claim and number."""
    numbers: dict[str, dict[str, Any]] = {}
    for need, claim in claims.items():
        named = SimpleNamespace(**claim.numbers)
        numbers.setdefault(need.section, {})[need.claim] = named
    return [SimpleNamespace(**numbers[section]) for section in sorted(numbers)]
