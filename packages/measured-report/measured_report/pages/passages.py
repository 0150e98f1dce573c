"""Print passages: paragraphs that are shown only while the claims that they need hold.

    {% passage needs="tower.leans, ground.is_soft" %}
    The tower leans by {{ tower.leans.angle }}, because the ground is soft on one side.
    {% otherwise %}
    {% passage needs="tower.leans fails" %} The tower stands upright. {% endpassage %}
    {% endpassage %}

A need is the name of a claim, which must hold, or its name and another required
outcome: ``fails`` or ``opposite``. A passage can print the numbers of these claims as
``section.claim.number``, and can use every name of the surrounding template. If a need
is not met, the text after ``otherwise`` is shown, or without one the sentences of the
claims.

A passage on one line is a part of a paragraph. On several lines it contains whole
paragraphs. ``answer="why"`` after ``needs`` sets the attribute ``data-answer``.
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
Need = tuple[str, str, str]  # a section, its claim and the required outcome


def needs_of(text: str) -> list[Need]:
    """Return the needs of a passage; raise ValueError if one is invalid."""
    needs = []
    for entry in map(str.strip, text.split(",")):
        if not (need := NEED.fullmatch(entry)):
            raise ValueError(f'needs: expects "section.claim", got {entry!r}')
        needs.append((need[1], need[2], (need[3] or "holds").strip()))
    return needs


def is_met(need: Need, claim: Claim | None) -> bool:
    """Return whether a claim exists and has the required outcome."""
    if claim is None:
        return False
    if need[2] == "opposite":
        return claim.outcome.is_opposite
    return claim.outcome.name == need[2]


def parse_passage(parser: Parser, environment: Environment) -> list[nodes.Node]:
    """Parse a passage into a call of ``passage``, which selects the text to show."""
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
    """Return the function that prints passages.

    ``find`` returns a claim by its section and its name.
    """

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
            # It is rendered even if it is not shown, so that an error in it is found
            # now and not with other data.
            body = caller(True, *_numbers(measured))
        stands = all(is_met(need, claim) for need, claim in claims.items())
        stands &= not any(map(lost_reason, printed[start:]))
        if not stands:
            # Remove the values of the hidden text, because tokens are indices of this
            # list.
            del printed[start:]
            if has_other:
                return caller(False)
            if not is_measured:  # the page lists the missing sections
                return Markup("")
            sentences = [claim.html(need[0]) for need, claim in measured.items()]
            body = token(printed, Markup(" ").join([*sentences, macros().other_data()]))
        if not body:
            return Markup("")
        element, edge = ("span", "") if is_inline else ("div", "\n\n")
        text = ", ".join(
            f"{section}.{name} {outcome}" for section, name, outcome in needs
        )
        start_tag = token(printed, macros().passage(element, text, stands, answer))
        end_tag = token(printed, Markup(f"</{element}>"))
        last = "" if is_inline else "\n"
        return Markup(edge.join(["", start_tag, body.strip(), end_tag, last]))

    return passage


def _numbers(claims: Mapping[Need, Claim]) -> list[SimpleNamespace]:
    """Return the numbers that a passage can print, one namespace for each section."""
    numbers: dict[str, dict[str, Any]] = {}
    for (section, name, _), claim in claims.items():
        numbers.setdefault(section, {})[name] = SimpleNamespace(**claim.numbers)
    return [SimpleNamespace(**numbers[section]) for section in sorted(numbers)]
