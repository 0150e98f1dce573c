"""Marks: comments, macros and roles behind the numbers and words of a text, which say where these are from."""

import re
from dataclasses import dataclass
from decimal import ROUND_HALF_UP, Decimal
from pathlib import Path

from measured_report.values.format import DIGITS, MINUS

REACH, MOST = 200, 600  # the most characters of what a mark is of, and of a mark
FENCE = r"^[ >]*(?P<fence>`{3,}|~{3,}).*\n(?:.*\n)*?(?:[ >]*(?P=fence)[`~]*[ \t\r]*$|\Z)"
COMMENT = r"<!--(?P<mark>(?s:.*?))(?:-->|\Z)"
ROLE = rf"(?::audit:|\{{audit\}})`(?P<of>[^`<]{{1,{REACH}}})<(?P<role>[^`]{{1,{MOST}}})>`"
CODE = rf"(?P<ticks>`+)(?:(?!\n\s*\n)(?s:.)){{1,{REACH}}}?(?<!`)(?P=ticks)(?!`)|`+"
LITERAL = r"::[ \t\r]*\n(?:[ \t\r]*\n)+(?:[ \t]+\S.*\n|[ \t\r]*\n)+"
MACRO = rf"\\audited\{{(?P<of>[^{{}}]{{1,{REACH}}})\}}\{{(?P<role>[^{{}}]{{1,{MOST}}})\}}"
VERBATIM = r"\\begin\{(?P<verbatim>verbatim|lstlisting|minted)\}(?s:.*?)(?:\\end\{(?P=verbatim)\}|\Z)|(?<!\\)%.*$"
SYNTAXES = {".html": [COMMENT], ".htm": [COMMENT], ".rst": [LITERAL, ROLE, CODE], ".tex": [VERBATIM, MACRO]}
FORMS = {".rst": ":audit:`{} <= {}>`", ".tex": r"\audited{{{}}}{{= {}}}"}
MARKDOWN = [FENCE, COMMENT, ROLE, CODE]  # also of what has another name

SEPARATORS = r",_'\u202f\u2009\xa0"
GROUPED = rf"\d{{1,3}}(?P<group>[{SEPARATORS}])\d{{3}}(?:(?P=group)\d{{3}})*(?:\.\d+)?(?!\d)"
POWER = r"(?:[eE](?P<e>[+-]?\d{1,3})|\s?(?:[×x·]|\\times|\\cdot)\s?10(?:\^\{?(?P<caret>[-−]?\d{1,3})\}?|(?P<raised>[⁻⁰¹²³⁴-⁹]+)))"
NUMBER = rf"(?<![^\W_])(?<!\d[.,])(?P<sign>[+−-])?(?P<digits>{GROUPED}|\d+(?:[.,]\d+)?|\.\d+)(?:{POWER})?"
UNIT = r"(?P<unit>\\?[^\W\d_]*[%×°]?(?:[/·][^\W\d_]+)?[²³]?)"
CLOSING = r"(?:[\s*_`~)\]}$,;]|\\[,; ]|&\w{1,9};|</?\w[^<>\n]{0,80}>){0,20}"
BEFORE = re.compile(rf"{NUMBER}{CLOSING}{UNIT}{CLOSING}\Z")
UNMARKED = re.compile(rf"(?<![\w./#-]){NUMBER}(?:(?:[ \xa0\u2009\u202f]|\\,)?{UNIT})?(?![\w./-]|{CLOSING}<!--)")
WORDS = re.compile(r"(^|.*\s)if\s.*[<>].*\selse\s", re.DOTALL)


@dataclass(frozen=True)
class Mark:
    """Holds what a mark says, ``text``, and what stands before it."""

    line: int
    start: int  # of `before`
    before: str
    text: str

    @property
    def is_of_words(self) -> bool:
        return bool(WORDS.match(self.text))

    @property
    def name(self) -> str:
        return "" if self.is_of_words else self.text.partition("=")[0].strip()


@dataclass(frozen=True)
class Printed:
    """Holds a number as a text has it."""

    text: str
    digits: str
    span: tuple[int, int]  # of its sign and digits
    unit: str
    group: str  # what is between its thousands
    power: int

    @property
    def plain(self) -> Decimal:
        text = re.sub(f"[{SEPARATORS}]", "", self.digits) if self.group else self.digits.replace(",", ".")
        return Decimal(text.replace(MINUS, "-")).scaleb(self.power)

    @property
    def step(self) -> int:
        """Return the power of ten of its last digit."""
        return int(self.plain.as_tuple().exponent)

    def written(self, exact: Decimal, step: int) -> str:
        """Write another number as this one is: to as many places, with its sign and its thousands."""
        rounded = exact.quantize(Decimal(1).scaleb(step), ROUND_HALF_UP)
        if exact and not rounded:  # it would be written as nothing
            step = exact.adjusted() + 1 - len(self.plain.as_tuple().digits)
            rounded = exact.quantize(Decimal(1).scaleb(step), ROUND_HALF_UP)
        text = f"{rounded.scaleb(-self.power):{'+' if self.digits[0] == '+' else ''}{',' if self.group else ''}f}"
        text = text.replace(",", self.group) if self.group else text
        text = text.replace(".", ",") if "," in self.digits and not self.group else text
        return text.replace("-", MINUS if MINUS in self.text else "-")


def printed(match: re.Match[str], start: int = 0) -> Printed:
    """Read what matches NUMBER and UNIT."""
    begin, end = match.start("digits") - len(match["sign"] or ""), match.end("digits")
    power = int((match["e"] or match["caret"] or (match["raised"] or "0").translate(DIGITS)).replace(MINUS, "-"))
    digits = match.string[begin:end]
    unit = (match["unit"] or "").strip("\\")
    return Printed(match[0].strip(), digits, (start + begin, start + end), unit, match["group"] or "", power)


def marks_of(path: Path, text: str) -> tuple[list[Mark], list[tuple[int, int]]]:
    """Return the marks of a text, and the stretches that are neither marks nor code."""
    patterns = SYNTAXES.get(path.suffix, MARKDOWN)
    marks, ends, line, counted = [], [0], 1, 0
    for match in re.compile("|".join(patterns), re.MULTILINE).finditer(text):
        groups, start = match.groupdict(), match.start()
        said = (groups.get("mark") or groups.get("role") or "").strip()
        said = re.sub(r"\\([#%_&])", r"\1", said) if path.suffix == ".tex" else said
        is_mark = len(said) <= MOST and (WORDS.match(said) or re.match(r"(?:[^\W\d]\w*\s*)?=(?!=)", said))
        if is_mark and not (patterns is MARKDOWN and _is_indented(text, start)):
            line, counted = line + text.count("\n", counted, start), start
            begin = match.start("of") if groups.get("of") else max(ends[-1], start - REACH)
            marks.append(Mark(line, begin, groups.get("of") or text[begin:start], said))
        ends += [start, match.end()]
    return marks, list(zip(ends[::2], [*ends[1::2], len(text)], strict=True))


def _is_indented(text: str, place: int) -> bool:
    """Tell whether a place is in an indented block of code, which is in no list."""
    lines = text[max(0, place - 4 * MOST) : place].split("\n")
    above = next((line for line in reversed(lines[:-1]) if re.match(r"\S", line)), "")
    return bool(re.match(r" {4}|\t", lines[-1])) and not re.match(r"[-*+]\s|\d+[.)]\s|\[\^|[!?]{3}", above)
