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
from number_audit.marks import NumberMark, WordMark, read_marks
from number_audit.quantities import (
    LOWERED,
    Quantity,
    in_base_unit,
    in_unit,
    is_known,
    same_unit,
)
from number_audit.sources import Repeats

MINUS = "\u2212"
NUMBER = r"""
    # The number is not part of a word, of a decimal, of a number such as 1 000 or
    # 1.5(2), or of a power.
    (?<![^\W_])(?<!\w_)(?<![.,/:])(?<!\d\()(?<!\^)(?<!\^\{)(?<!<sup>)
    (?<!\b\d[ \xa0\u2009\u202f])(?<!\b\d\d[ \xa0\u2009\u202f])
    (?<!\b\d\d\d[ \xa0\u2009\u202f])
    (?P<digits>
        [−-]?
        (\d{1,3}(?P<group>[,_'\u202f\u2009\xa0]|[ ](?=\d{3}[ ]\d{3}))\d{3}
            ((?P=group)\d{3})*(?!\d)|\d+)
        (\.\d+)?
    )
    ((?P<ten>[eE]|\s?[×·x]\s?10(?=[⁻⁰¹²³⁴-⁹]))(?P<power>[+-]?\d{1,3}|[⁻⁰¹²³⁴-⁹]+))?
"""
UNIT = r"(?P<unit>[^\W\d_]*[%×°]?(/[^\W\d_]+)?)"
CLOSING = r"(\]\([^()\n]{0,200}\)|[\s*_`~)\]}$,;]|\\[,;\ ]|\\(?=%)|&\w{1,9};|</?\w[^<>\n]{0,80}>){0,20}"
"""Matches the spaces, punctuation, closing tags and brackets after a number."""

NUMBER_AT_END = re.compile(NUMBER + CLOSING + UNIT + CLOSING + r"\Z", re.VERBOSE)
CLOSING_AT_END = re.compile(CLOSING + r"\Z", re.VERBOSE)
BOUND_BEFORE = re.compile(
    r"""
    (?P<negation>\bnot?\s+)?
    ((?P<upper>
        <|&lt;|≤|&le;|\\leq?\b|\\lt\b
        |\bsub-
        |\b(at\ most|up\ to|max(imum)?(\ of)?|below|under|within
            |(less|fewer|shorter|smaller|lower)\ than)
    )|(?P<lower>
        ((?<=[^\s>][\ (])|(?<=[(|]))>|&gt;|≥|&ge;|\\geq?\b|\\gt\b
        |\b(at\ least|min(imum)?(\ of)?|above|over|exceed(s|ing)?
            |(more|longer|later|larger|greater|higher)\ than)
    )|\b(faster|slower|better|worse)\ than)
    [\s$*_(~]{0,9}\Z
    """,
    re.VERBOSE | re.IGNORECASE,
)
"""Matches a text that makes the number after it a bound.

At the start of a line, > is the sign of a quote and not of a bound.
"""

RANGE_BEFORE = re.compile(
    rf"""
    (?P<between>between\s+)?{NUMBER}{CLOSING}{UNIT}
    (?P<joint>[\s$(]*(–|—|-|…|\.\.\.?|±|\\pm|\+/-|to|or|and)[\s$]*)\Z
    """,
    re.VERBOSE,
)
"""Matches the first number of a range and the sign after it, such as 12.3 ms ±."""

LINK_BEFORE = re.compile(r"\]\([^()\n]*\Z")
"""Matches a text that ends in the address of a link."""

OPERAND = re.compile(r"[^\s(]+\#/\S+|\b[^\W\d_]\w*", re.VERBOSE)
"""Matches a place in a file, or the name of a mark."""

OPERATIONS: Mapping[type, Callable[[Quantity, Quantity], Quantity]] = {
    ast.Add: Quantity.__add__,
    ast.Sub: Quantity.__sub__,
    ast.Mult: Quantity.__mul__,
    ast.Div: Quantity.__truediv__,
}
ROUNDED = 0.5000001
"""The largest change of a number by rounding, in units of its last digit."""

PROBLEMS = (AuditError, ArithmeticError, LookupError, OSError, TypeError, ValueError)
"""The errors that a mark or a file can raise if it is missing, damaged or unknown."""


@dataclass(frozen=True)
class Finding:
    """The result for one mark."""

    line: int
    kind: str
    """This is "fresh", "unclear", "stale", "false", "missing" or "invalid"."""
    text: str
    start: int = 0
    end: int = 0
    replacement: str = ""
    """The text that replaces the part from ``start`` to ``end``, if it is not empty."""

    @property
    def is_error(self) -> bool:
        return self.kind not in ("fresh", "unclear")


def printed_value(match: re.Match[str]) -> tuple[float, int]:
    """Return the value of a ``NUMBER`` match, and the power of ten of its last digit."""
    digits = re.sub(r"[^\d.-]", "", match["digits"].replace(MINUS, "-"))
    power = (match["power"] or "0").translate(LOWERED)
    last_digit = int(power) - len(digits.partition(".")[2])
    return float(f"{digits}e{power}"), last_digit


class Audit:
    """Compares the numbers and words of a text with the sources of its marks."""

    def __init__(self, text: str, suffix: str, source_of: Callable[[str], Repeats]):
        self._source_of = source_of
        self._marks = list(read_marks(text, suffix))
        self._named = {
            mark.name: mark
            for mark in self._marks
            if isinstance(mark, NumberMark) and mark.name
        }
        self._values: dict[str, Quantity | Exception] = {}
        self._evaluate_names()

    def findings(self) -> Iterator[Finding]:
        """Yield a finding for each mark."""
        for mark in self._marks:
            try:
                if isinstance(mark, NumberMark):
                    yield self._of_number(mark)
                elif isinstance(mark, WordMark):
                    yield self._of_word(mark)
                else:
                    yield Finding(mark.context.line, "invalid", mark.problem)
            except PROBLEMS as error:
                yield Finding(mark.context.line, "missing", message_of(error))

    def _of_number(self, mark: NumberMark) -> Finding:
        """Compare a printed number with its source."""
        if mark.name:
            named = self._named[mark.name]
            if (named.source, named.unit) != (mark.source, mark.unit):
                raise AuditError(
                    f"the name {mark.name} is used for another mark too: rename one"
                )
        match = NUMBER_AT_END.search(mark.context.before)
        if not match or LINK_BEFORE.search(mark.context.before, 0, match.start()):
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
        printed, last_digit = printed_value(match)
        low, high, obstacle = _printed_range(
            mark.context.before[: match.start("digits")], printed
        )
        if match["ten"]:
            obstacle = "a power of ten"
        elif match["group"] == " ":
            obstacle = "a number with spaces, which may be several numbers"
        elif not same_unit(match["unit"] or mark.unit, quantity.unit):
            obstacle = "this number because its unit is not known: write it in the mark"
        # repr has the shortest digits of a float, so 1.005 is rounded as it is written.
        exact = Decimal(repr(value))
        if mark.digits and value:
            last_digit = exact.adjusted() + 1 - int(mark.digits)
        is_bound = math.inf in (-low, high)
        limit = max(
            0.0 if is_bound else ROUNDED * 10.0**last_digit,
            math.sqrt(2) * measured.noise,  # The text may be from another measurement.
            float(mark.tolerance or 0) / 100 * abs(value),
        )
        text = f"the text has {match[0].strip()}"
        source = f"{mark.source} has {measured}"
        if low - limit <= value <= high + limit:
            return Finding(mark.context.line, "fresh", f"{text}, and {source}")
        replacement = "" if obstacle else _rounded(exact, last_digit, match)
        if not replacement:
            obstacle = obstacle or "a number by 0 or by more than 28 digits"
            source += f" (--fix does not replace {obstacle})"
        return Finding(
            mark.context.line,
            "stale",
            f"{text}, but {source}",
            mark.context.start + match.start("digits"),
            mark.context.start + match.end("digits"),
            replacement,
        )

    def _of_word(self, mark: WordMark) -> Finding:
        """Check whether a word agrees with the comparison in its mark."""
        before = CLOSING_AT_END.sub("", mark.context.before)
        words = f"{re.escape(mark.yes)}|{re.escape(mark.no)}"
        match = re.search(rf"(?<!\w)({words})\Z", before)
        if not match:
            raise AuditError(f"the mark does not follow {mark.yes} or {mark.no}")
        word = match[0]
        difference = self._evaluated(f"( {mark.left} ) - ( {mark.right} )", "")
        holds = difference.value < 0 if mark.sign == "<" else difference.value > 0
        is_clear = abs(difference.value) > difference.noise
        comparison = f"{mark.left} {mark.sign} {mark.right}"
        text = f"the text has {word}, and {comparison} is {str(holds).lower()}"
        if not is_clear:
            text += ", but within the noise"
        correction = ""
        if holds == (word == mark.yes):
            kind = "fresh"
        elif not is_clear:
            kind = "unclear"
        else:
            kind = "false"
            correction = mark.yes if holds else mark.no
        start = mark.context.start + match.start()
        end = start + len(word)
        return Finding(mark.context.line, kind, text, start, end, correction)

    def _evaluate_names(self) -> None:
        """Evaluate each named mark once, after the marks on which it depends."""
        sorter = TopologicalSorter(
            {
                name: self._named.keys() & set(OPERAND.findall(mark.source))
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
        """Return the quantity at a place or of a named mark."""
        file, is_place, place = text.partition("#")
        if is_place:
            return self._source_of(file).quantity(place)
        if file not in self._named:
            raise AuditError(f"no mark has the name {file}")
        value = self._values.get(file)
        if value is None:
            raise AuditError(f"the mark {file} depends on itself")
        if isinstance(value, Exception):
            # Each mark that uses the name reports the error, so it is raised anew.
            raise AuditError(message_of(value))
        return value

    def _evaluated(self, expression: str, unit: str) -> Quantity:
        """Return the value of an expression, in ``unit`` if its operands have none."""
        operands: dict[str, Quantity] = {}

        def operand_name(match: re.Match[str]) -> str:
            # A place contains characters that are not allowed in a Python name.
            name = f"q{len(operands)}"
            operands[name] = self._operand(match[0])
            return name

        code = OPERAND.sub(operand_name, expression).strip()
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
    """Compute an expression of numbers and operands with ``+ - * /`` and brackets."""

    def value_of(node: ast.expr) -> Quantity:
        if isinstance(node, ast.Name):
            return operands[node.id]
        if isinstance(node, ast.Constant) and isinstance(node.value, int | float):
            return Quantity(float(node.value))
        if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
            return -value_of(node.operand)
        if isinstance(node, ast.BinOp) and type(node.op) in OPERATIONS:
            operation = OPERATIONS[type(node.op)]
            return operation(value_of(node.left), value_of(node.right))
        raise AuditError(
            "expected FILE#/PLACE or an arithmetic expression of places and names,"
            f" got {expression:.60}"
        )

    try:
        # The text may be from a stranger, so its expressions are never executed.
        return value_of(ast.parse(code, mode="eval").body)
    except SyntaxError as error:
        raise AuditError(f"cannot compute {expression:.60}: {error.msg}") from None
    except (RecursionError, MemoryError):
        raise AuditError(f"the expression {expression:.60} is too long") from None


def _printed_range(before: str, printed: float) -> tuple[float, float, str]:
    """Return the smallest and the largest value that a printed number allows.

    The third result describes a bound or a range, which ``--fix`` does not replace. It
    is empty for other numbers. ``before`` is the text before the number.
    """
    if match := BOUND_BEFORE.search(before):
        # Whether 3 ms is "faster than" 4 depends on what is measured.
        if not (match["upper"] or match["lower"]):
            return printed, printed, "a bound"
        # "not more than 5" is an upper bound, although "more than 5" is a lower one.
        if bool(match["upper"]) != bool(match["negation"]):
            return -math.inf, printed, "a bound"
        return printed, math.inf, "a bound"
    match = RANGE_BEFORE.search(before)
    if not match or ("and" in match["joint"] and not match["between"]):
        return printed, printed, ""
    first = printed_value(match)[0]
    joint = match["joint"]
    # The m is part of \pm in LaTeX, and the / is part of +/-.
    if re.search(r"[±m/]", joint):
        return first - printed, first + printed, "a number with ±"
    if re.fullmatch(r"\s+[–—-]\s+|.*(to|or).*", joint):  # It may fall from 5 to 3.
        return printed, printed, "a number that may end a range"
    return min(first, printed), max(first, printed), "a range"


def _rounded(value: Decimal, last_digit: int, printed: re.Match[str]) -> str:
    """Return a number in the format of the printed one.

    The result is empty if the number would become 0 or have more than 28 digits.
    """
    try:
        rounded = value.quantize(Decimal(1).scaleb(last_digit), ROUND_HALF_UP)
    except InvalidOperation:
        return ""
    if value and not rounded:
        return ""
    minus = MINUS if MINUS in printed[0] else "-"
    return f"{rounded:,f}".replace("-", minus).replace(",", printed["group"] or "")


def message_of(error: Exception) -> str:
    """Return the message of an error in one line."""
    if isinstance(error, ArithmeticError):
        return "a number is too large or too small for floating point"
    return " ".join(str(error).strip("'").split())
