"""Quantities: numbers that know their unit and where they come from."""

import json
import math
import operator
import re
from collections import Counter
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from functools import cached_property, partial, partialmethod
from itertools import zip_longest
from statistics import fmean
from typing import Any

from markupsafe import Markup, escape

from measured_report.files.columns import PLAIN
from measured_report.files.errors import ReportError
from measured_report.records.record import Origin
from measured_report.values.format import (
    INTERVAL,
    LEAST,
    MOST,
    WRITES,
    format_code,
    format_number,
    unit_label,
)
from measured_report.values.noise import NORMAL, SURE, WRITTEN_SHARE, Z, t_quantile

VALUES_FILE = "values.json"
NOISE_FILE = "noise.json"  # of the cells of records that pages print
LEAST_TOGETHER = 3  # chosen: how many measurements show what times have in common
POWERS = "⁰¹²³⁴⁵⁶⁷⁸⁹"
FACTOR = re.compile(f"(/?)([^/·{POWERS}]+)([{POWERS}]?)")  # of a unit, as mm/s² or N·m


def local(text: str, folder: str) -> str:
    """Return ``text`` with shorter addresses of the values of the site's own edition,
    whose data lie in ``folder``."""
    return text.replace(f"{folder}/{VALUES_FILE}", VALUES_FILE)


@dataclass(frozen=True)
class Pointer:
    """Names the place of a number of a record, or of a trace, below the site's ``data/``."""

    text: str  # such as `engine-1.4.0/friction.json#/rows/3/drag_n`

    @property
    def file(self) -> str:
        return self.text.partition("#")[0]

    @property
    def is_trace(self) -> bool:
        """Return whether it names a whole trace."""
        return self.text.endswith(".csv.gz")

    @property
    def cell(self) -> tuple[int, str] | None:
        """Return row and column; None for what is in no row."""
        match = re.fullmatch(r"[^#]*#/rows/(\d+)/(\w+)", self.text)
        return (int(match[1]), match[2]) if match else None


class Lost(Markup):
    """Write a number that is not there."""

    reason = ""

    @classmethod
    def because(cls, html: Markup, reason: str) -> "Lost":
        written = cls(html)
        written.reason = reason or "no reason is known"
        return written


def lost_reason(printed: Any) -> str:
    """Return why a number that is printed is not there; empty for anything else."""
    return printed.reason if isinstance(printed, Lost) else ""


@dataclass(frozen=True)
class Quantity:
    """Holds a measured number, shown with a pointer to the file that holds it.

    Arithmetic makes a ``Term`` of it, whose unit, noise and sources are worked out.
    """

    value: float | int | None
    unit: str
    source: str  # pointer below the site's ``data/``, see ``Pointer``; empty for a number that no file has a place for
    reason: str = ""  # why there is no number, where there is none
    origins: frozenset[Origin] = (
        frozenset()
    )  # releases and machines that measured it; none for what was not measured
    noise: float | None = None
    """How far the truth may be from it, in its unit; None where nobody knows, 0 for what is exact."""
    formula: str = ""  # words for how it is computed; of what was measured more than once between what
    samples: Sequence[float | None] = field(default=(), compare=False, repr=False)
    """The number in each measurement of its edition, None where it was not measured; empty where it is exact."""
    is_shared: bool = field(default=False, compare=False, repr=False)
    """Whether all numbers of one measurement share a part of its error, as times do."""

    def _with(
        self, function: Callable[..., Any], *operands: "Quantity | float"
    ) -> "Term":
        return combined(function, self, *operands)

    def _after(self, function: Callable[..., Any], number: float) -> "Term":
        return combined(function, number, self)

    def __radd__(self, number: float) -> "Quantity":
        return self + number if number else self  # sum() begins with 0

    __add__ = partialmethod(_with, operator.add)
    __sub__ = partialmethod(_with, operator.sub)
    __mul__ = partialmethod(_with, operator.mul)
    __truediv__ = partialmethod(_with, operator.truediv)
    __neg__ = partialmethod(_with, operator.neg)
    __abs__ = partialmethod(_with, abs)
    __rmul__ = __mul__
    __rsub__ = partialmethod(_after, operator.sub)
    __rtruediv__ = partialmethod(_after, operator.truediv)

    @property
    def reads(self) -> frozenset[str]:
        """Return pointers to itself and to all that it is computed from."""
        return frozenset({self.source} if self.source else ())

    @property
    def number(self) -> float:
        """Return the value of one that is known to be there."""
        assert self.value is not None, self.reason
        return self.value

    @property
    def bare(self) -> Markup:
        """Write the number without its unit, for places that say the unit themselves."""
        return self._written(self.written)

    @property
    def written(self) -> str:
        """Write the number as people do, without its unit."""
        return format_number(self.value, noise=self.noise)

    @property
    def code(self) -> Markup:
        """Write the number as it is typed into a program."""
        return self._written(format_code(self.value))

    @property
    def interval(self) -> Markup:
        """Write the number with its confidence interval and unit, as 0.042 ± 0.010 %."""
        return self._in_words(INTERVAL)

    @property
    def is_distinct(self) -> bool:
        """Return whether it is farther from 0 than its noise."""
        return self.value is not None and abs(self.value) > (self.noise or 0.0)

    @property
    def most(self) -> Markup:
        """Write the number with its unit, rounded up: where the words say *at most*, *within* or *less than*."""
        return self._in_words(MOST)

    @property
    def least(self) -> Markup:
        """Write the number with its unit, rounded down: where the words say *at least* or *more than*."""
        return self._in_words(LEAST)

    def _written(self, text: str, written_as: str = "") -> Markup:
        if not self.source:
            absent = Markup('<span title="{}">{}</span>').format(
                self.reason, format_number(None)
            )
            return Lost.because(absent, self.reason)
        attributes = {
            "value": "" if self.value is None else json.dumps(self.value),
            "data-src": self.source,
        }
        hint = self.reason or "; ".join(filter(None, (self.formula, self._uncertainty)))
        attributes |= {
            name: text
            for name, text in (("data-as", written_as), ("title", hint))
            if text
        }
        # Not with Markup's own format, which takes many times as long, and there are tens of thousands of numbers.
        written = "".join(
            f' {name}="{escape(value)}"' for name, value in attributes.items()
        )
        html = Markup(f"<data{written}>{escape(text)}</data>")
        return Lost.because(html, self.reason) if self.value is None else html

    @property
    def _uncertainty(self) -> str:
        """Say how far the truth may be from it, and what a derived one was in each of several measurements."""
        if self.value is None or not self.noise:
            return ""
        present = [sample for sample in self.samples if sample is not None]
        several = f", in {len(present)} measurements {', '.join(f'{sample:.4g}' for sample in present)}"
        return f"±{self.noise:.2g}" + (
            several if len(present) > 1 and isinstance(self, Value) else ""
        )

    def __html__(self) -> Markup:
        return self._in_words()

    def _in_words(self, way: str = "") -> Markup:
        number = self._written(WRITES[way](self.value, noise=self.noise), way)
        return number + Markup("&nbsp;") + self._label if self._label else number

    def __str__(self) -> str:
        return f"{self.written} {self._label}".rstrip()

    @property
    def _label(self) -> str:
        return "" if self.value is None else unit_label(self.unit)


def absent(unit: str, reason: str) -> Quantity:
    """Make a number that is not there, and say why."""
    return Quantity(None, unit, "", reason)


def constant(value: float, unit: str = PLAIN) -> Quantity:
    """Make an exact number that nobody measured, as a factor."""
    return Quantity(value, unit, "", noise=0.0)


PERCENT = constant(100, "%")  # makes a share one in percent, as ``PERCENT * a / b``


@dataclass(frozen=True)
class Value(Quantity):
    """Holds a number derived from others, which says how."""

    sources: Sequence[str] = ()  # pointers to what it is computed from
    roots: frozenset[str] = (
        frozenset()
    )  # the same, and pointers to what those are computed from, down to the records

    @property
    def reads(self) -> frozenset[str]:
        return super().reads | self.roots

    @property
    def entry(self) -> dict[str, Any]:
        """Return what the site's values file says of it."""
        entry: dict[str, Any] = {
            name: getattr(self, name) for name in ("value", "unit", "noise", "formula")
        }
        entry["sources"] = list(self.sources)
        return entry | ({"reason": self.reason} if self.reason else {})


def mixed(*origins: frozenset[Origin]) -> str:
    """Say why what has these origins is not to be compared; empty for one origin, or for the same several."""
    if len({origin for origin in origins if origin}) < 2:
        return ""
    return f"it would compare {' with '.join(map(str, sorted(frozenset().union(*origins))))}"


def samples_of(
    function: Callable[..., float], sources: Sequence[Any]
) -> list[float | None]:
    """Return what each measurement by itself makes of the function; nothing where all sources are exact."""
    rows = _measurements(sources)
    return [None if None in row else _evaluated(function, row)[0] for row in rows]


def _measurements(sources: Sequence[Any]) -> list[tuple[Any, ...]]:
    """Return what each measurement has of all sources; none where all of them are exact, or one is no number."""
    sampled = [
        source.samples if isinstance(source, Quantity) else None for source in sources
    ]
    count = max((len(samples) for samples in sampled if samples), default=0)
    if None in sampled or not count:
        return []
    ways = [
        samples or count * (source.value,)
        for samples, source in zip(sampled, sources, strict=True)
    ]
    return [*zip_longest(*(way[:count] for way in ways))]


def noise_of(function: Callable[..., float], sources: Sequence[Any]) -> float | None:
    """Return the noise of a value that a function makes of its sources.

    Errors that are independent add in squares, as in the Guide to the Expression of
    Uncertainty in Measurement (JCGM 100:2008), 5.1.2, with differences for derivatives.
    A chosen number has a noise of 0. Times of one measurement share the error of its host,
    which cancels in a ratio: if there are enough measurements of times, all sources are
    moved together as they differ from one measurement to the next.
    """
    values: list[Any] = [source.value for source in sources]
    noises = [
        source.noise if isinstance(source, Quantity) else None for source in sources
    ]
    if None in noises:
        return None
    middle = function(*values)
    rows = [row for row in _measurements(sources) if None not in row]
    is_shared = any(getattr(source, "is_shared", False) for source in sources)
    if is_shared and len(rows) >= LEAST_TOGETHER:
        scale = t_quantile(SURE, len(rows) - 1) / math.sqrt(len(rows) * (len(rows) - 1))
        means = [*map(fmean, zip(*rows, strict=True))]
        offs = [
            [scale * (number - mean) for number, mean in zip(row, means, strict=True)]
            for row in rows
        ]
        moves = (
            [[*map(way, values, off)] for way in (operator.add, operator.sub)]
            for off in offs
        )
    else:
        noisy = [(at, by) for at, by in enumerate(noises) if by]
        moves = (
            [[*values[:at], values[at] + way, *values[at + 1 :]] for way in (by, -by)]
            for at, by in noisy
        )
    noise = _moved(function, middle, moves)
    if not math.isfinite(noise):
        return None
    return max(float(noise), WRITTEN_SHARE * abs(middle)) if any(noises) else 0.0


def extreme_noise(
    choose: Callable[..., float], values: Sequence[float], noises: Sequence[float]
) -> float:
    """Return the noise of the largest or smallest of several numbers.

    Each of the numbers near the end may be the true one, and the end is that with the
    largest error. Independent errors of so many all stay below the bound that is used
    with probability ``SURE`` (Šidák 1967, J. Am. Stat. Assoc. 62, 626-633).
    """
    end = choose(values)
    noise = noises[values.index(end)]
    most = _factor(len(values))
    near = sum(
        abs(end - value) <= most * (noise + by)
        for value, by in zip(values, noises, strict=True)
    )
    wider = _factor(near)
    tops = [value + wider * by for value, by in zip(values, noises, strict=True)]
    bottoms = [value - wider * by for value, by in zip(values, noises, strict=True)]
    return max(choose(tops) - end, end - choose(bottoms))


def _factor(count: int) -> float:
    """Return how much wider an interval is that so many errors stay below at once."""
    return NORMAL.inv_cdf(max((1 + SURE) / 2, SURE ** (1 / count))) / Z


def _moved(
    function: Callable[..., float],
    middle: float,
    moves: Iterable[Sequence[Sequence[Any]]],
) -> float:
    """Return how far moves of its values take a function, each the farther of its ways; infinite where one fails."""
    with suppress(
        ArithmeticError, ValueError, LookupError
    ):  # a number that can't be changed by its noise
        return math.hypot(
            *(max(abs(function(*way) - middle) for way in ways) for ways in moves)
        )
    return math.inf


class Term(Value):
    """Works a number out of its operands; ``results.value`` gives it a name, and with that a place on the page."""

    function: Callable[..., float]
    operands: Sequence[Any]
    chooses: Callable[..., float] | None  # max or min, if it is the largest or smallest
    source = ""

    def __init__(
        self,
        function: Callable[..., float],
        operands: Sequence[Any],
        unit: str,
        across: bool,
        chooses: Callable[..., float] | None = None,
    ):
        origins = [operand.origins for operand in operands]
        refusal = "" if across else mixed(*origins)
        lost = [operand.reason for operand in operands if operand.value is None]
        if refusal or lost:
            value = None
            reason = refusal or lost[0]
        else:
            value, reason = _evaluated(
                function, [operand.value for operand in operands]
            )
        vars(self).update(
            value=value, unit=unit, reason=reason, origins=frozenset().union(*origins)
        )
        vars(self).update(
            function=function,
            operands=operands,
            chooses=chooses,
            is_shared=any(getattr(o, "is_shared", False) for o in operands),
            roots=frozenset().union(*(o.reads for o in operands)),
        )

    @property
    def leaves(self) -> list[Any]:
        """Return the quantities that it is computed from, none of them a Term."""
        leaves: dict[int, Any] = {}
        for operand in self.operands:
            parts = operand.leaves if isinstance(operand, Term) else [operand]
            leaves |= {id(part): part for part in parts}
        return list(leaves.values())

    @cached_property
    def samples(self) -> Sequence[float | None]:
        return () if self.value is None else samples_of(self.function, self.operands)

    @cached_property
    def noise(self) -> float | None:
        if self.value is None:
            return None
        noises: list[Any] = [getattr(each, "noise", None) for each in self.operands]
        if self.chooses and None not in noises:
            values: list[Any] = [operand.value for operand in self.operands]
            return extreme_noise(self.chooses, values, noises)
        return noise_of(self.function, self.operands)

    def _written(self, text: str, written_as: str = "") -> Markup:
        raise ReportError(
            f"{self} has no name to be shown by: give it one with results.value(name, formula, …)"
        )

    def __reduce__(self) -> tuple[type, tuple[Any, ...]]:  # kept without its function
        return Quantity, (
            self.value,
            self.unit,
            "",
            self.reason,
            self.origins,
            self.noise,
        )


def combined(
    function: Callable[..., float], *sources: Any, unit: str = "", across: bool = False
) -> Term:
    """Return what a function makes of quantities, series and plain numbers, in ``unit`` or else in theirs.

    What it takes twice changes in both places at once. ReportError for quantities of unlike units.
    """
    if plain := [
        source
        for source in sources
        if not (hasattr(source, "reads") or hasattr(source, "__float__"))
    ]:
        raise ReportError(
            f"{plain[0]!r:.80} is no number to compute with, nor a series"
        )
    sources = tuple(
        source if hasattr(source, "reads") else constant(source) for source in sources
    )
    if across:
        sources = tuple(map(_across, sources))
    if function in (max, min):
        # Each source keeps its own noise, which that of the largest is made of.
        choose = partial(function, default=math.nan)

        def chosen(*values: Any) -> float:
            return choose(values)  # the largest of none is not a number

        return Term(
            chosen, sources, unit or _unit_of(function, sources), across, choose
        )
    groups = [_operands(source) for source in sources]
    operands = {id(operand): operand for group in groups for operand in group}
    places = {key: place for place, key in enumerate(operands)}
    # Found once: to find the noise of a count of a thousand numbers, each of them is moved in turn.
    ways = [
        _way(source, [places[id(part)] for part in group])
        for source, group in zip(sources, groups, strict=True)
    ]

    def composed(*values: Any) -> float:
        return function(*(way(values) for way in ways))

    return Term(
        composed, tuple(operands.values()), unit or _unit_of(function, sources), across
    )


def _across(source: Any) -> Any:
    """Return a source; if it is a Term, one of numbers of several editions."""
    if not isinstance(source, Term):
        return source
    operands = tuple(map(_across, source.operands))
    return Term(source.function, operands, source.unit, True, source.chooses)


def _operands(source: Any) -> Sequence[Any]:
    """Return what a source is computed from; itself if it is an extreme, or no Term."""
    is_computed = isinstance(source, Term) and not source.chooses
    return source.operands if is_computed else (source,)


def _way(source: Any, places: Sequence[int]) -> Callable[[Sequence[Any]], Any]:
    """Return what takes a source, or works it out, of the values of all operands."""
    if isinstance(source, Term) and not source.chooses:
        return lambda values: source.function(*map(values.__getitem__, places))
    return operator.itemgetter(*places)


def _unit_of(function: Callable[..., float], quantities: Sequence[Quantity]) -> str:
    """Return the unit of a product or a ratio; what else is made of quantities has that which they have in common."""
    if function in (operator.mul, operator.truediv):
        a, b = (quantity.unit for quantity in quantities)
        return _product_unit(a, b, 1 if function is operator.mul else -1)
    if (
        len(
            units := {
                quantity.unit: quantity
                for quantity in quantities
                if quantity.value is not None
            }
        )
        > 1
    ):
        raise ReportError(
            "{} and {} have no unit in common: derive them in one".format(
                *units.values()
            )
        )
    return next(iter(units), quantities[0].unit if quantities else PLAIN)


def _product_unit(a: str, b: str, power: int) -> str:
    powers: Counter[str] = Counter()
    for unit, sign in ((a, 1), (b, power)):
        for below, symbol, exponent in FACTOR.findall(unit):
            powers[symbol] += (-sign if below else sign) * max(1, POWERS.find(exponent))
    del powers[PLAIN]
    above, below = (
        [n + POWERS[k] * (k > 1) for n, k in sorted((+side).items())]
        for side in (powers, -powers)
    )
    return "/".join(["·".join(above) or PLAIN, *below])


def _evaluated(
    function: Callable[..., float], values: Sequence[Any]
) -> tuple[float | None, str]:
    """Return what a function makes of values, and why that is no number if it is none."""
    try:
        value = function(*values)
    except ZeroDivisionError:
        return None, "it would be a division by zero"
    except (ArithmeticError, ValueError, LookupError) as error:
        # A damaged record may hold what no measurement gives, such as a coordinate twice.
        return (
            None,
            f"it cannot be computed from what was measured: {' '.join(str(error).split())}",
        )
    if isinstance(value, complex):
        return None, "it has no finite value"
    value = getattr(value, "item", lambda: value)()
    return (value, "") if math.isfinite(value) else (None, "it has no finite value")
