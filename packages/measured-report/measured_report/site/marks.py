"""Marks: comments, macros and roles behind the numbers and words of a text, which say where these are from."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from decimal import ROUND_HALF_UP, Decimal
from pathlib import Path

from measured_report.values.format import DIGITS, MINUS, SUPERSCRIPTS

REACH, MOST = 200, 600  # the most characters of what a mark is of, and of a mark
FENCE = r"^[ >]*(?P<fence>`{3,20}|~{3,20}).*\n(?:.*\n)*?(?:[ >]*(?P=fence)[`~]*[ \t\r]*$|\Z)"
COMMENT = r"<!--(?:(?P<mark>(?s:.*?))-->|(?s:.*)\Z)"
ROLE = rf"(?::audit:|\{{audit\}})`(?P<of>[^`<]{{1,{REACH}}})<(?P<role>[^`]{{1,{MOST}}})>`"
CODE = rf"(?<!`)(?P<ticks>`{{1,8}})(?!`)(?:(?!\n\s*\n)(?s:.)){{1,{REACH}}}?(?<!`)(?P=ticks)(?!`)|`+"
LITERAL = r"::[ \t\r]*\n(?:[ \t\r]*\n)+(?:[ \t]+\S.*\n|[ \t\r]*\n)+"
MACRO = rf"\\audited\{{(?P<of>[^{{}}]{{1,{REACH}}})\}}\{{(?P<role>[^{{}}]{{1,{MOST}}})\}}"
VERBATIM = r"\\begin\{(?P<verbatim>verbatim|lstlisting|minted)\}(?s:.*?)(?:\\end\{(?P=verbatim)\}|\Z)|(?<!\\)%.*$"
MARKDOWN = (FENCE, COMMENT, ROLE, CODE)  # also of what has another name
SYNTAXES = {".html": (COMMENT,), ".htm": (COMMENT,), ".rst": (LITERAL, ROLE, CODE), ".tex": (VERBATIM, MACRO)}
FORMS = {".rst": ":audit:`{} <= {}>`", ".tex": r"\audited{{{}}}{{= {}}}"}

SEPARATORS = r",_'\u202f\u2009\xa0"
GROUPED = rf"\d{{1,3}}(?P<group>[{SEPARATORS}])\d{{3}}(?:(?P=group)\d{{3}})*(?:\.\d+)?(?!\d)"
TEN = r"\s?(?:[×x·]|\\times|\\cdot)\s?10(?:\^\{?(?P<caret>[-−]?\d{1,3})\}?|(?P<raised>[⁻⁰¹²³⁴-⁹]+))"
NUMBER = (
    rf"(?<![^\W_])(?<!\d[.,])(?P<digits>[+−-]?(?:{GROUPED}|\d+(?:[.,]\d+)?|\.\d+))(?:[eE](?P<e>[+-]?\d{{1,3}})|{TEN})?"
)
UNIT = r"\\?(?P<unit>[^\W\d_]*[%×°]?(?:[/·][^\W\d_]+)?[²³]?)"
CLOSING = r"(?:[\s*_`~)\]}$,;]|\\[,; ]|&\w{1,9};|</?\w[^<>\n]{0,80}>){0,20}"
BEFORE = re.compile(rf"{NUMBER}{CLOSING}{UNIT}{CLOSING}\Z")
UNMARKED = re.compile(rf"(?<![\w./#-]){NUMBER}(?:(?:[ \xa0\u2009\u202f~]|\\,)?{UNIT})?(?![\w./-])")
OPTIONS = re.compile(
    r"(?P<rest>.*?[\w)\"\]])(?:\s+(?P<unit>[^\W\d_]\S{0,20}|%))?(?:\s+digits\s+(?P<digits>\d{1,2}))?"
    r"(?:\s*(?:±|\+-)\s*(?P<tolerance>\d[\d.]{0,9})\s*(?P<share>%?))?"
)


@dataclass(frozen=True)
class Mark:
    """Holds what a mark says, and what stands before it."""

    line: int
    start: int  # of `before`
    before: str
    name: str
    expression: str  # of a number
    options: Mapping[str, str]
    words: tuple[str, ...]  # of a word: yes if left < right else no


class Printed:
    """Reads a number that NUMBER and UNIT matched, ``value`` times a power of ten with ``step`` for its last digit."""

    def __init__(self, match: re.Match[str], start: int = 0):
        self.digits, self.unit, self.group = match["digits"], match["unit"] or "", match["group"] or ""
        self.exponent = match["e"] or match["caret"] or match["raised"] or ""
        end = max(match.end(name) for name in ("digits", "e", "caret", "raised"))
        self.between = match.string[match.end("digits") : end - len(self.exponent)]
        self.span = start + match.start("digits"), start + end
        self.power = int(
            (match["e"] or match["caret"] or (match["raised"] or "0").translate(DIGITS)).replace(MINUS, "-")
        )
        plain = self.digits.replace(self.group, "") if self.group else self.digits.replace(",", ".")
        self.value = Decimal(plain.replace(MINUS, "-")).scaleb(self.power)
        self.step = int(self.value.as_tuple().exponent)

    def written(self, exact: Decimal, step: int) -> str:
        """Write another number as this one is: to as many places, with its sign, point, thousands and power of ten."""
        power = self.power
        if self.exponent and exact and step == self.step:  # the power of ten follows, so that as many digits stay
            power += exact.adjusted() - self.value.adjusted()
            step += power - self.power
        rounded = exact.quantize(Decimal(1).scaleb(step), ROUND_HALF_UP)
        if exact and not rounded:  # it keeps its digits where it would be nothing with as many places
            step = exact.adjusted() + 1 - len(self.value.as_tuple().digits)
            rounded = exact.quantize(Decimal(1).scaleb(step), ROUND_HALF_UP)
        text = f"{rounded.scaleb(-power):{'+' if self.digits[0] == '+' else ''}{',' if self.group else ''}f}"
        text = text.replace(",", self.group) if self.group or "," not in self.digits else text.replace(".", ",")
        text = text.replace("-", MINUS) if MINUS in self.digits else text
        if not self.exponent:
            return text
        plain = (
            f"{power:{'+0' if self.between in 'eE' and self.exponent[0] in '+-' else ''}{len(self.exponent)}d}".strip()
        )
        return (
            text + self.between + (str(power).translate(SUPERSCRIPTS) if self.exponent[-1] in "⁰¹²³⁴⁵⁶⁷⁸⁹" else plain)
        )


def marks_of(path: Path, text: str) -> tuple[list[Mark], list[tuple[int, int]]]:
    """Return the marks of a text, and the stretches that are neither marks nor code."""
    syntax = SYNTAXES.get(path.suffix, MARKDOWN)
    marks, ends, line, counted = list[Mark](), [0], 1, 0
    for match in re.compile("|".join(syntax), re.MULTILINE).finditer(text):
        groups, start = match.groupdict(), match.start()
        said = " ".join((groups.get("mark") or groups.get("role") or "").split())
        said = re.sub(r"\\([#%_&])", r"\1", said) if path.suffix == ".tex" else said
        name, _, expression = said.partition("=")
        yes, _, rest = f" {said}".partition(" if ")
        condition, _, no = rest.rpartition(" else ")
        words = (yes.strip(), *re.split("(<=|>=|<|>)", condition, maxsplit=1), no.strip())
        is_mark = len(words) == 5 or (expression and re.fullmatch(r"([^\W\d]\w*\s*)?", name))
        if is_mark and len(said) <= MOST and not (syntax is MARKDOWN and _is_indented(text, start)):
            line, counted = line + text.count("\n", counted, start), start
            begin = match.start("of") if groups.get("of") else max(ends[-1], start - REACH)
            before, words = groups.get("of") or text[begin:start], words if len(words) == 5 else ()
            options = option.groupdict() if (option := OPTIONS.fullmatch(expression.strip())) else {"rest": expression}
            marks.append(
                Mark(
                    line,
                    begin,
                    before,
                    "" if words else name.strip(),
                    options.pop("rest"),
                    {name: text for name, text in options.items() if text},
                    words,
                )
            )
        ends += [start, match.end()]
    return marks, list(zip(ends[::2], [*ends[1::2], len(text)], strict=True))


def _is_indented(text: str, place: int) -> bool:
    """Tell whether a place is in an indented block of code, which is in no list."""
    lines = text[max(0, place - 4 * MOST) : place].split("\n")
    above = next((line for line in reversed(lines[:-1]) if re.match(r"\S", line)), "")
    return bool(re.match(r" {4}|\t", lines[-1])) and not re.match(r"[-*+]\s|\d+[.)]\s|\[\^|[!?]{3}", above)
