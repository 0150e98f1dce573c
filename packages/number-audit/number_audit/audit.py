"""The audit of a text: compares its numbers and words with the sources of its marks."""

import ast
import math
import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from decimal import ROUND_HALF_UP, Decimal, InvalidOperation
from graphlib import CycleError, TopologicalSorter

from number_audit.files import AuditError
from number_audit.marks import Mark, NumberMark, WordMark, read_marks
from number_audit.quantities import (
    LOWERED,
    Quantity,
    in_base_unit,
    in_unit,
    is_known,
)
from number_audit.sources import Source

MINUS = "\u2212"
NUMBER = r"""
    # No part of a word, of a decimal, of a number such as 1 000 or of a power.
    (?<![^\W_])(?<![.,])(?<!\d[ \xa0\u2009\u202f])(?<!\^)(?<!\^\{)(?<!<sup>)
    (?P<digits>
        [−-]?
        (\d{1,3}(?P<group>[,_'\u202f\u2009\xa0])\d{3}((?P=group)\d{3})*(?!\d)|\d+)
        (\.\d+)?
    )
    ((?P<ten>[eE]|\s?[×·x]\s?10(?=[⁻⁰¹²³⁴-⁹]))(?P<power>[+-]?\d{1,3}|[⁻⁰¹²³⁴-⁹]+))?
"""
UNIT = r"(?P<unit>[^\W\d_]*[%×°]?(/[^\W\d_]+)?)"
CLOSING = r"([\s*_`~)\]}$,;]|\\[,;\ ]|&\w{1,9};|</?\w[^<>\n]{0,80}>){0,20}"
"""Spaces, punctuation and the ends of what emphasizes a number."""

NUMBER_AT_END = re.compile(NUMBER + CLOSING + UNIT + CLOSING + r"\Z", re.VERBOSE)
CLOSING_AT_END = re.compile(CLOSING + r"\Z", re.VERBOSE)
OPERAND = re.compile(r"[^\s(]+\#/\S+|\b[^\W\d_]\w*", re.VERBOSE)
"""A place in a file, or the name of a mark."""

OPERATIONS: Mapping[type, Callable[[Quantity, Quantity], Quantity]] = {
    ast.Add: Quantity.__add__,
    ast.Sub: Quantity.__sub__,
    ast.Mult: Quantity.__mul__,
    ast.Div: Quantity.__truediv__,
}
ROUNDED = 0.5000001
"""The most that rounding changes a number, in units of its last digit."""

PROBLEMS = (AuditError, ArithmeticError, LookupError, OSError, TypeError, ValueError)
"""Raised for files that are missing, damaged or of an unknown form."""


@dataclass(frozen=True)
class Finding:
    """One line of an audit."""

    line: int
    kind: str
    """"fresh", "unclear", "stale", "false", "missing" or "invalid"."""
    text: str
    start: int = 0
    end: int = 0
    replacement: str = ""
    """The text to write between ``start`` and ``end``; empty if there is none."""

    @property
    def is_error(self) -> bool:
        return self.kind not in ("fresh", "unclear")


def printed_value(match: re.Match[str]) -> Decimal:
    """Return a number that ``NUMBER`` matched, with the exponent of its last digit."""
    digits = re.sub(r"[^\d.-]", "", match["digits"].replace(MINUS, "-"))
    power = (match["power"] or "0").translate(LOWERED)
    return Decimal(digits).scaleb(int(power))


class Audit:
    """Compares the numbers and words of a text with the sources that its marks name."""

    def __init__(self, text: str, suffix: str, source_of: Callable[[str], Source]):
        self._source_of = source_of
        self._marks = list(read_marks(text, suffix))
        self._named: dict[str, NumberMark] = {}
        for mark in self._marks:
            if isinstance(mark, NumberMark) and mark.name:
                self._named[mark.name] = mark
        self._values: dict[str, Quantity | Exception] = {}
        self._evaluate_names()

    def findings(self) -> Iterator[Finding]:
        """Yield a finding for each mark."""
        for mark in self._marks:
            try:
                yield self._finding(mark)
            except PROBLEMS as error:
                yield Finding(mark.context.line, "missing", message_of(error))

    def _finding(self, mark: Mark) -> Finding:
        if isinstance(mark, NumberMark):
            return self._of_number(mark)
        if isinstance(mark, WordMark):
            return self._of_word(mark)
        return Finding(mark.context.line, "invalid", mark.problem)

    def _of_number(self, mark: NumberMark) -> Finding:
        """Compare a printed number with its source."""
        if mark.name:
            other = self._named[mark.name]
            if (other.source, other.unit) != (mark.source, mark.unit):
                raise AuditError(f"another mark is called {mark.name}, too")
        match = NUMBER_AT_END.search(mark.context.before)
        if not match:
            source = mark.source
            raise AuditError(
                f"no number stands right before = {source}, or one as 1 000 or 1,5"
            )
        quantity = self._evaluated(mark.source, mark.unit)
        unit = match["unit"] if is_known(match["unit"]) else mark.unit
        measured = in_unit(quantity, unit)
        if measured is None:
            raise AuditError(f"{unit} is printed, and the source is in {quantity.unit}")
        value = measured.value
        printed = printed_value(match)
        last_digit = printed.as_tuple().exponent
        assert isinstance(last_digit, int)
        exact = Decimal(repr(value))
        if mark.digits and value:
            last_digit = exact.adjusted() + 1 - int(mark.digits)
        limit = max(
            ROUNDED * 10.0**last_digit,
            math.sqrt(2) * measured.noise,  # the text may be of another measurement
            float(mark.tolerance or 0) / 100 * abs(value),
        )
        text = f"{match[0].strip()} is {measured} by {mark.source}"
        if abs(float(printed) - value) <= limit:
            return Finding(mark.context.line, "fresh", text)
        start = mark.context.start + match.start("digits")
        end = mark.context.start + match.end("digits")
        new = _rounded(exact, last_digit, match)
        return Finding(mark.context.line, "stale", text, start, end, new)

    def _of_word(self, mark: WordMark) -> Finding:
        """Compare a word with the comparison that it depends on."""
        before = CLOSING_AT_END.sub("", mark.context.before)
        words = [
            word
            for word in (mark.yes, mark.no)
            if re.search(rf"(?<!\w){re.escape(word)}\Z", before)
        ]
        if not words:
            raise AuditError(
                f"neither {mark.yes} nor {mark.no} stands right before the mark"
            )
        word = max(words, key=len)
        difference = self._evaluated(f"( {mark.left} ) - ( {mark.right} )", "")
        holds = difference.value < 0 if mark.sign == "<" else difference.value > 0
        is_clear = abs(difference.value) > difference.noise
        comparison = f"{mark.left} {mark.sign} {mark.right}"
        text = f"{word}, and {comparison} {'holds' if holds else 'is not so'}"
        if not is_clear:
            text += " by noise"
        right = ""
        if holds == (word == mark.yes):
            kind = "fresh"
        elif not is_clear:
            kind = "unclear"
        else:
            kind = "false"
            right = mark.yes if holds else mark.no
        end = mark.context.start + len(before)
        return Finding(mark.context.line, kind, text, end - len(word), end, right)

    def _evaluate_names(self) -> None:
        """Evaluate each named mark once, those first that others are computed from."""
        sorter = TopologicalSorter(
            {
                name: {
                    used for used in OPERAND.findall(mark.source) if used in self._named
                }
                for name, mark in self._named.items()
            }
        )
        with suppress(CycleError):  # names outside the cycle are evaluated all the same
            sorter.prepare()
        while ready := sorter.get_ready():
            for name in ready:
                mark = self._named[name]
                try:
                    self._values[name] = self._evaluated(mark.source, mark.unit)
                except PROBLEMS as error:
                    self._values[name] = error
            sorter.done(*ready)

    def _operand(self, text: str) -> Quantity:
        """Return the number at a place, or that of another mark."""
        file, is_place, place = text.partition("#")
        if is_place:
            return self._source_of(file).quantity(place)
        if file not in self._named:
            raise AuditError(f"{file} is the name of no mark")
        value = self._values.get(file)
        if value is None:
            raise AuditError(f"{file} is computed from itself")
        if isinstance(value, Exception):
            raise AuditError(message_of(value))
        return value

    def _evaluated(self, expression: str, unit: str) -> Quantity:
        """Return what an expression comes to, in ``unit`` if its operands have none."""
        operands: dict[str, Quantity] = {}

        def named(match: re.Match[str]) -> str:
            name = f"q{len(operands)}"
            operands[name] = self._operand(match[0])
            return name

        code = OPERAND.sub(named, expression).strip()
        if code in operands:
            result = operands[code]
        else:
            in_base = {name: in_base_unit(each) for name, each in operands.items()}
            result = _computed(code, in_base, expression)
        if not math.isfinite(result.value):
            raise AuditError("it has no finite value")
        if unit and not is_known(result.unit):
            return Quantity(result.value, unit, result.offsets)
        return result


def _computed(code: str, operands: Mapping[str, Quantity], expression: str) -> Quantity:
    """Compute sums, products and ratios; anything else is an AuditError."""

    def of(node: ast.expr) -> Quantity:
        if isinstance(node, ast.Name):
            return operands[node.id]
        if isinstance(node, ast.Constant) and type(node.value) in (int, float):
            return Quantity(float(code[node.col_offset : node.end_col_offset]))
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            return -of(node.operand)
        if isinstance(node, ast.BinOp) and type(node.op) in OPERATIONS:
            return OPERATIONS[type(node.op)](of(node.left), of(node.right))
        raise AuditError(
            f"{expression:.60} is no FILE#/PLACE,"
            " and no arithmetic of such and of names"
        )

    try:
        return of(ast.parse(code, mode="eval").body)
    except SyntaxError as error:
        raise AuditError(f"{expression:.60} can't be computed: {error.msg}") from None
    except (RecursionError, MemoryError):
        raise AuditError(f"{expression:.60} has too many parts") from None


def _rounded(value: Decimal, last_digit: int, printed: re.Match[str]) -> str:
    """Write a number in the form of the one that is printed.

    The text is empty for a number with a power of ten, or of more than 28 digits.
    """
    if printed["ten"]:
        return ""
    try:
        rounded = value.quantize(Decimal(1).scaleb(last_digit), ROUND_HALF_UP)
    except InvalidOperation:
        return ""
    group = printed["group"]
    text = f"{rounded:,f}" if group else f"{rounded:f}"
    minus = MINUS if MINUS in printed[0] else "-"
    return text.replace("-", minus).replace(",", group or "")


def message_of(error: Exception) -> str:
    """Return what went wrong, in one line."""
    if isinstance(error, ArithmeticError):
        return "a number is too large or too small"
    return " ".join(str(error).strip("'").split())
