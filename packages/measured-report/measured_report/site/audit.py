"""Audit: whether the numbers and words of a text, by the marks behind them, are still what the results say."""

import math
import operator
import re
import shutil
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from decimal import Decimal
from functools import cache
from pathlib import Path

from measured_report.files.atomic import atomic_file, read_own_file
from measured_report.files.errors import ReportError
from measured_report.records.columns import PLAIN
from measured_report.site.check_numbers import UNRESOLVED
from measured_report.site.marks import BEFORE, CLOSING, FORMS, UNMARKED, Mark, marks_of, printed
from measured_report.site.sources import Source, scale_of
from measured_report.values.format import undusted
from measured_report.values.quantities import Quantity, Term, constant

BYTE_LIMIT = 64 << 20
AGAIN = math.sqrt(2)  # the printed number was measured once, too, and may be off by as much as the source's
OPTION = re.compile(r"\s(?:digits\s+(?P<digits>\d{1,2})|(?:±|\+-)\s*(?P<tolerance>\d[\d.]{0,9})\s*(?P<share>%?))\s*\Z")
MARK_UNIT = re.compile(r"(?<=[\w)\"\]])\s+([^\W\d_]\S{0,20}|%)\s*\Z")
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
                yield self._of_words(mark) if mark.is_of_words else self._of_number(mark)
            except (*UNRESOLVED, ReportError, ArithmeticError, SyntaxError, RecursionError) as error:
                yield Finding(str(self.path), mark.line, "missing", " ".join(str(error).strip("'").split()))

    def _of_number(self, mark: Mark) -> Finding:
        expression, options = mark.text.partition("=")[2].strip(), dict[str, str]()
        while option := OPTION.search(expression):
            options |= {name: text for name, text in option.groupdict().items() if text}
            expression = expression[: option.start()]
        if explicit := MARK_UNIT.search(expression):
            expression = expression[: explicit.start()]
        if not (match := BEFORE.search(mark.before)):
            raise ReportError(f"no number stands right before {mark.text:.60}")
        number = printed(match, mark.start)
        if re.search(r"(?<!\d)\d{1,3} \Z", mark.before[: match.start()]) and re.fullmatch(
            r"\d{3}(\.\d*)?", number.digits
        ):
            raise ReportError(f"{number.text} may be the end of a larger number: write that without a blank in it")
        quantity, unit = self._quantity(expression)
        value, noise, unit = _in_unit(quantity, unit, explicit[1] if explicit else number.unit, bool(explicit))
        exact, step = Decimal(repr(value)), number.step
        if "digits" in options and value:
            step = exact.adjusted() + 1 - int(options["digits"])
        tolerance = float(options.get("tolerance", 0)) * (abs(value) / 100 if "share" in options else 1)
        limit = max(0.5000001 * 10.0**step, AGAIN * (noise or 0), tolerance)
        kind = "fresh" if abs(float(number.plain) - value) <= limit else "stale"
        within, label = f" ± {noise:.2g}" if noise else "", "" if unit == PLAIN else f" {unit}"
        text = f"{number.text} is {value:.6g}{within}{label} by {expression}"
        replacement = number.written(exact, step) if kind == "stale" else ""
        return Finding(str(self.path), mark.line, kind, text, value, unit, noise, number.span, replacement)

    def _of_words(self, mark: Mark) -> Finding:
        yes, _, rest = f" {mark.text}".partition(" if ")
        condition, _, no = (text.strip() for text in rest.rpartition(" else "))
        before = re.sub(rf"{CLOSING}\Z", "", mark.before)
        words = [word for word in (yes.strip(), no) if word and re.search(rf"(?i)(?<!\w){re.escape(word)}\Z", before)]
        if not words and (yes.strip() or not before.split()):
            raise ReportError(f"neither {yes.strip()} nor {no} stands right before the mark")
        word = max(words, key=len, default=before.split()[-1])
        left, sign, right = re.split("(<=|>=|<|>)", condition, maxsplit=1)
        difference = self._quantity(left)[0] - self._quantity(right)[0]
        holds, start = COMPARED[sign](difference.number, 0), mark.start + len(before) - len(word)
        is_close = abs(difference.number) <= (difference.noise or 0)
        kind = "unclear" if is_close else "fresh" if holds == (word != no) else "false"
        text = f"{word}, and {condition} {'is within the noise' if is_close else 'holds' if holds else 'does not hold'}"
        replacement = (yes.strip() if holds else no) if kind == "false" else ""
        if kind == "false" and not replacement:
            text += "; the mark has no word for it: WORD if … else …"
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
                    operands.append(self._quantity(self._named[name].text.partition("=")[2].strip()))
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
        """Yield a mark for each number without one that is a single number of the results."""
        source, form = self._source(file), FORMS.get(self.path.suffix, "{}<!-- = {} -->")
        sourced = [(pointer, *source.quantity(pointer)) for pointer in source.pointers()]
        for begin, end in self._unmarked:
            for match in UNMARKED.finditer(self.text, begin, end):
                number = printed(match)
                if len(number.plain.as_tuple().digits) < (2 if number.step < 0 else 3):
                    continue
                ways = []
                for pointer, quantity, own_unit in sourced:
                    try:
                        value, _, unit = _in_unit(quantity, own_unit, number.unit, False)
                    except ReportError:
                        continue
                    if abs(value - float(number.plain)) <= 0.5000001 * 10.0**number.step:
                        ways.append(f"{file}#{pointer}")
                line = self.text.count("\n", 0, match.start()) + 1
                if len(ways) == 1:
                    replacement = form.format(
                        match[0], ways[0].replace("#", r"\#").replace("%", r"\%") if 0 else ways[0]
                    )
                    yield Finding(
                        str(self.path), line, "fresh", replacement, span=match.span(), replacement=replacement
                    )
                elif ways:
                    yield Finding(str(self.path), line, "unclear", f"{match[0]} is {' or '.join(ways)}")


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
