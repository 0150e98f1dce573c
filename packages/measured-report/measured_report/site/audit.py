"""Audit: whether the numbers and words of a text, by the marks behind them, are still what the results say."""

import math
import operator
import re
import shutil
from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass
from decimal import Decimal
from functools import cache
from pathlib import Path

from measured_report.files.atomic import atomic_file, read_own_file
from measured_report.files.errors import ReportError
from measured_report.records.columns import PLAIN
from measured_report.site.check_numbers import UNRESOLVED
from measured_report.site.marks import BEFORE, CLOSING, FORMS, UNMARKED, Mark, Printed, marks_of
from measured_report.site.sources import Source, scale_of
from measured_report.values.format import undusted
from measured_report.values.quantities import Quantity, Term, constant

BYTE_LIMIT = 64 << 20
AGAIN = math.sqrt(2)  # the printed number was measured once, too, and may be off by as much as the source's
TOKEN = re.compile(
    r'\s*(?:"(?P<quoted>[^"]*#/[^"]*)"|(?P<pointer>[^\s"()]*#/[^\s()]+)|(?P<name>[^\W\d]\w*)|(?P<sign>[-+*/()])'
    r"|(?P<number>\d+(?:\.\d+)?(?:e-?\d{1,2})?)(?P<unit>[^\W\d_]*|%))\s*"
)
COMPARED = {"<": operator.lt, ">": operator.gt, "<=": operator.le, ">=": operator.ge}


@dataclass(frozen=True)
class Finding:
    """Tells what came of a mark."""

    file: str
    line: int
    kind: str
    text: str
    value: float | None = None  # by the source, in `unit`, as its noise is
    unit: str = ""
    noise: float | None = None
    span: tuple[int, int] = (0, 0)  # what is to be replaced in the text
    replacement: str = ""

    @property
    def is_wrong(self) -> bool:
        return self.kind in ("stale", "false", "missing")  # others are fresh and unclear


class Audit:
    """Compares the numbers and words of a text with the sources that their marks name."""

    def __init__(self, path: Path, source: Callable[[str], Source]):
        self.path, self._source = path, source
        # Bytes that are no UTF-8 are written back as they were read.
        self.text = read_own_file(path, BYTE_LIMIT).decode("utf-8", "surrogateescape")
        self.marks, self._unmarked = marks_of(path, self.text)
        self._named = {mark.name: mark for mark in reversed(self.marks)}
        self._open: set[str] = set()
        self._quantity = cache(self._evaluated)

    def findings(self) -> Iterator[Finding]:
        """Yield what came of each mark."""
        for mark in self.marks:
            try:
                if mark.name and self._named[mark.name] is not mark:
                    raise ReportError(f"line {self._named[mark.name].line} has a mark {mark.name}, too")
                yield self._of_words(mark) if mark.words else self._of_number(mark)
            except (*UNRESOLVED, AttributeError, ReportError, ArithmeticError, SyntaxError, RecursionError) as error:
                text = "it has too many digits" if isinstance(error, ArithmeticError) else str(error).strip("'")
                yield Finding(str(self.path), mark.line, "missing", " ".join(text.split()))

    def _of_number(self, mark: Mark) -> Finding:
        expression, options = mark.expression, mark.options
        match = BEFORE.search(mark.before)
        if not match or (len(match["digits"]) == 3 and re.search(r"(?<!\d)\d{1,3} \Z", mark.before[: match.start()])):
            raise ReportError(f"no number stands right before = {expression}, or one with a blank in it")
        number, (quantity, unit) = Printed(match, mark.start), self._quantity(expression)
        value, noise, unit = _in_unit(quantity, unit, options.get("unit", number.unit), "unit" in options)
        exact, step = Decimal(repr(value)), number.step
        if "digits" in options and value:
            step = exact.adjusted() + 1 - int(options["digits"])
        tolerance = float(options.get("tolerance", 0)) * (abs(value) / 100 if "share" in options else 1)
        limit = max(0.5000001 * 10.0**step, AGAIN * (noise or 0), tolerance)
        kind = "fresh" if abs(float(number.value) - value) <= limit else "stale"
        within, label = f" ± {noise:.2g}" if noise else "", "" if unit == PLAIN else f" {unit}"
        text = f"{match[0].strip()} is {value:.6g}{within}{label} by {expression}"
        replacement = number.written(exact, step) if kind == "stale" else ""
        return Finding(str(self.path), mark.line, kind, text, value, unit, noise, number.span, replacement)

    def _of_words(self, mark: Mark) -> Finding:
        yes, left, sign, right, no = mark.words
        before = re.sub(rf"{CLOSING}\Z", "", mark.before)
        words = [word for word in (yes, no) if word and re.search(rf"(?i)(?<!\w){re.escape(word)}\Z", before)]
        if not words and (yes or not before.split()):
            raise ReportError(f"neither {yes} nor {no} stands right before the mark")
        word = max(words, key=len, default=before.split()[-1])
        difference, start = self._quantity(left)[0] - self._quantity(right)[0], mark.start + len(before) - len(word)
        holds, noise = COMPARED[sign](difference.number, 0), difference.noise
        kind = "unclear" if noise and abs(difference.number) <= noise else "fresh" if holds == (word != no) else "false"
        text = f"{word}, and {left}{sign}{right} {'holds' if holds else 'does not hold'}"
        text += ", within the noise" if kind == "unclear" else ""
        replacement = (yes if holds else no) if kind == "false" else ""
        if self.text[start : start + 1].isupper():
            replacement = replacement[:1].upper() + replacement[1:]
        return Finding(str(self.path), mark.line, kind, text, span=(start, start + len(word)), replacement=replacement)

    def _evaluated(self, expression: str) -> tuple[Quantity, str]:
        """Return what an expression comes to, in a unit without prefix, and the unit of what is there alone."""
        place, code, operands = 0, "", list[tuple[Quantity, str]]()
        while place < len(expression):
            if not (token := TOKEN.match(expression, place)):
                raise ReportError(f"{expression[place:].strip():.60} is no FILE#/PLACE, name, number or sign")
            place, (name, number) = token.end(), token.group("name", "number")
            if token["sign"]:
                code += token["sign"]
                continue
            if name and (name not in self._named or name in self._open):
                raise ReportError(f"{name} is {'made of itself' if name in self._open else 'the name of no mark'}")
            if name:
                self._open.add(name)
                try:
                    operands.append(self._quantity(self._named[name].expression))
                finally:
                    self._open.discard(name)
            elif number:
                factor, base = scale_of(token["unit"] or PLAIN) or (1.0, token["unit"])
                operands.append((constant(float(number) * factor, base), token["unit"] or PLAIN))
            else:
                file, _, pointer = (token["quoted"] or token["pointer"]).partition("#")
                operands.append(self._source(file).quantity(pointer))
            code += f" q[{len(operands) - 1}] "
        if code == " q[0] ":
            return operands[0]
        # It has nothing but operands by their number, signs and brackets in it.
        result = eval(code, {"__builtins__": {}}, {"q": [quantity for quantity, _ in operands]})
        if not isinstance(result, Quantity) or result.value is None:
            raise ReportError(getattr(result, "reason", f"{expression} is no number"))
        return result, result.unit

    def write(self, findings: Sequence[Finding]) -> None:
        """Put the replacements into the file, and change nothing else of it."""
        pieces, end = [], 0
        for finding in (finding for finding in findings if finding.replacement):
            pieces += [self.text[end : finding.span[0]], finding.replacement]
            end = finding.span[1]
        if pieces:
            with atomic_file(self.path) as temporary:
                temporary.write_bytes("".join([*pieces, self.text[end:]]).encode("utf-8", "surrogateescape"))
                shutil.copymode(self.path, temporary)

    def suggestions(self, file: str) -> Iterator[Finding]:
        """Yield a mark for each number without one that is a single number of the results; others have a choice."""
        source, form = self._source(file), FORMS.get(self.path.suffix, "{}<!-- = {} -->")
        sourced = [(f"{file}#{pointer}", *source.quantity(pointer)) for pointer in source.pointers()]

        @cache
        def printed_in(unit: str) -> list[tuple[str, float]]:
            values = list[tuple[str, float]]()
            for pointer, quantity, own_unit in sourced:
                with suppress(ReportError):  # of another unit
                    values.append((pointer, _in_unit(quantity, own_unit, unit, False)[0]))
            return values

        stretches = (
            (end, match) for begin, end in self._unmarked for match in UNMARKED.finditer(self.text, begin, end)
        )
        for end, match in stretches:
            if self.text.startswith("<!--", end) and re.compile(CLOSING).fullmatch(self.text, match.end(), end):
                continue  # it has a mark
            number = Printed(match)
            printed, limit = float(number.value), 0.5000001 * 10.0**number.step
            pointers = [pointer for pointer, value in printed_in(number.unit) if abs(value - printed) <= limit]
            # A number such as 2 or 10 is in any results by chance.
            if pointers and len(number.value.as_tuple().digits) > (1 if number.step < 0 else 2):
                text = re.sub(r"(?=[#%_&])", r"\\", pointers[0]) if self.path.suffix == ".tex" else pointers[0]
                is_unit = number.unit and (scale_of(number.unit) or number.unit in "×°")
                written = self.text[match.start() : match.end() if is_unit else match.start("unit")].rstrip()
                mark = form.format(written, text) if len(pointers) == 1 else ""
                said, line = (
                    mark or f"{written} is {' or '.join(pointers)}",
                    self.text.count("\n", 0, match.start()) + 1,
                )
                span, kind = (match.start(), match.start() + len(written)), "fresh" if mark else "unclear"
                yield Finding(str(self.path), line, kind, said, span=span, replacement=mark)


def _in_unit(quantity: Quantity, own_unit: str, unit: str, is_explicit: bool) -> tuple[float, float | None, str]:
    """Return value, noise and unit of a number as it is printed in ``unit``, which may be a word that is none."""
    scale = scale_of(unit) if unit else None
    if quantity.unit == PLAIN and not (unit == "%" and (is_explicit or isinstance(quantity, Term))):
        scale = None  # a count has no unit, and a source may have shares in percent
    elif scale and scale[1] != quantity.unit:
        raise ReportError(f"{unit} is printed, and the source is in {own_unit}")
    unit = unit if scale else own_unit
    factor, _ = scale or scale_of(own_unit) or (1.0, "")
    value = float(undusted(quantity.number / factor) or 0)
    return value, None if quantity.noise is None else quantity.noise / factor, unit
