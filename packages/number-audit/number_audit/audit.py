"""Compares the numbers and words of a text with the sources that its marks name."""

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
    # The number is not part of a word, of a decimal, of a number such as 1 000 or of a
    # power.
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
"""Spaces, punctuation and closing tags or brackets after a number."""

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
"""Largest change of a number by rounding, in units of its last digit."""

PROBLEMS = (AuditError, ArithmeticError, LookupError, OSError, TypeError, ValueError)
"""Errors for files that are missing, damaged or in an unknown format."""


@dataclass(frozen=True)
class Finding:
    """The result for one mark."""

    line: int
    kind: str
    """One of "fresh", "unclear", "stale", "false", "missing" and "invalid"."""
    text: str
    start: int = 0
    end: int = 0
    replacement: str = ""
    """The text that replaces the part from ``start`` to ``end``, or an empty string."""

    @property
    def is_error(self) -> bool:
        return self.kind not in ("fresh", "unclear")


def printed_value(match: re.Match[str]) -> Decimal:
    """Return the value of a ``NUMBER`` match as a Decimal with the printed digits."""
    digits = re.sub(r"[^\d.-]", "", match["digits"].replace(MINUS, "-"))
    power = (match["power"] or "0").translate(LOWERED)
    return Decimal(digits).scaleb(int(power))


class Audit:
    """Compares the numbers and words of a text with the sources of its marks."""

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
            named = self._named[mark.name]
            if (named.source, named.unit) != (mark.source, mark.unit):
                raise AuditError(
                    f"the name {mark.name} is used for another mark too: rename one"
                )
        match = NUMBER_AT_END.search(mark.context.before)
        if not match:
            source = mark.source
            raise AuditError(
                f"the mark = {source} does not follow a number, or follows one in an"
                " unsupported form such as 1 000 or 1,5"
            )
        quantity = self._evaluated(mark.source, mark.unit)
        unit = match["unit"] if is_known(match["unit"]) else mark.unit
        measured = in_unit(quantity, unit)
        if measured is None:
            raise AuditError(
                f"the text has the unit {unit}, but the source is in {quantity.unit}"
            )
        value = measured.value
        printed = printed_value(match)
        last_digit = printed.as_tuple().exponent
        assert isinstance(last_digit, int)
        exact = Decimal(repr(value))
        if mark.digits and value:
            last_digit = exact.adjusted() + 1 - int(mark.digits)
        limit = max(
            ROUNDED * 10.0**last_digit,
            math.sqrt(2) * measured.noise,  # The text may be from another measurement.
            float(mark.tolerance or 0) / 100 * abs(value),
        )
        text = f"the text has {match[0].strip()}"
        source = f"{mark.source} has {measured}"
        if abs(float(printed) - value) <= limit:
            return Finding(mark.context.line, "fresh", f"{text}, and {source}")
        return Finding(
            mark.context.line,
            "stale",
            f"{text}, but {source}",
            start=mark.context.start + match.start("digits"),
            end=mark.context.start + match.end("digits"),
            replacement=_rounded(exact, last_digit, match),
        )

    def _of_word(self, mark: WordMark) -> Finding:
        """Compare a word with the comparison that decides about it."""
        before = CLOSING_AT_END.sub("", mark.context.before)
        words = [
            word
            for word in (mark.yes, mark.no)
            if re.search(rf"(?<!\w){re.escape(word)}\Z", before)
        ]
        if not words:
            raise AuditError(f"the mark does not follow {mark.yes} or {mark.no}")
        word = max(words, key=len)
        difference = self._evaluated(f"( {mark.left} ) - ( {mark.right} )", "")
        holds = difference.value < 0 if mark.sign == "<" else difference.value > 0
        is_clear = abs(difference.value) > difference.noise
        comparison = f"{mark.left} {mark.sign} {mark.right}"
        truth = "true" if holds else "false"
        text = f"the text has {word}, and {comparison} is {truth}"
        if not is_clear:
            text += ", but within the noise"
        right = ""
        if holds == (word == mark.yes):
            kind = "fresh"
        elif not is_clear:
            kind = "unclear"
        else:
            kind = "false"
            right = mark.yes if holds else mark.no
        end = mark.context.start + len(before)
        start = end - len(word)
        return Finding(
            mark.context.line, kind, text, start=start, end=end, replacement=right
        )

    def _evaluate_names(self) -> None:
        """Evaluate each named mark once, after the marks on which it depends."""
        sorter = TopologicalSorter(
            {
                name: {
                    used for used in OPERAND.findall(mark.source) if used in self._named
                }
                for name, mark in self._named.items()
            }
        )
        with suppress(CycleError):  # Names outside the cycle are still evaluated.
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
        """Return the quantity at a place, or that of a named mark."""
        file, is_place, place = text.partition("#")
        if is_place:
            return self._source_of(file).quantity(place)
        if file not in self._named:
            raise AuditError(f"no mark has the name {file}")
        value = self._values.get(file)
        if value is None:
            raise AuditError(f"the mark {file} depends on itself")
        if isinstance(value, Exception):
            raise AuditError(message_of(value))
        return value

    def _evaluated(self, expression: str, unit: str) -> Quantity:
        """Return the value of an expression, in ``unit`` if its operands have none."""
        operands: dict[str, Quantity] = {}

        def named(match: re.Match[str]) -> str:
            name = f"q{len(operands)}"
            operands[name] = self._operand(match[0])
            return name

        code = OPERAND.sub(named, expression).strip()
        if code in operands:
            result = operands[code]
        else:
            in_base = {
                name: in_base_unit(operand) for name, operand in operands.items()
            }
            result = _computed(code, in_base, expression)
        if not math.isfinite(result.value):
            raise AuditError("the value is not finite")
        if unit and not is_known(result.unit):
            return Quantity(result.value, unit, result.offsets)
        return result


def _computed(code: str, operands: Mapping[str, Quantity], expression: str) -> Quantity:
    """Compute sums, differences, products and ratios; raise AuditError for others."""

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
            "expected FILE#/PLACE or an arithmetic expression of places and names,"
            f" got {expression:.60}"
        )

    try:
        return of(ast.parse(code, mode="eval").body)
    except SyntaxError as error:
        raise AuditError(f"cannot compute {expression:.60}: {error.msg}") from None
    except (RecursionError, MemoryError):
        raise AuditError(f"the expression {expression:.60} is too long") from None


def _rounded(value: Decimal, last_digit: int, printed: re.Match[str]) -> str:
    """Return a number in the format of the printed one.

    The result is empty if the number has a power of ten or more than 28 digits.
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
    """Return the message of an error in one line."""
    if isinstance(error, ArithmeticError):
        return "a number is too large or too small for floating point"
    return " ".join(str(error).strip("'").split())
