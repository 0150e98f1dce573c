"""Define quantities: numbers with their unit, their noise and a pointer to their
source.
"""

import json
import math
import operator
import re
from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
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
NOISE_FILE = "noise.json"  # the noise of record cells that pages print
LEAST_TOGETHER = 3
"""Chosen: with fewer measurements, the shared part of the error of times is unknown."""
POWERS = "⁰¹²³⁴⁵⁶⁷⁸⁹"
FACTOR = re.compile(f"(/?)([^/·{POWERS}]+)([{POWERS}]?)")  # of a unit like mm/s²


def local(text: str, folder: str) -> str:
    """Return ``text`` with shorter addresses for the values of the site's own edition.

    ``folder`` contains the data of this edition.
    """
    return text.replace(f"{folder}/{VALUES_FILE}", VALUES_FILE)


@dataclass(frozen=True)
class Pointer:
    """Points to a number of a record, or to a trace, below the site's ``data/``."""

    text: str  # such as `engine-1.4.0/friction.json#/rows/3/drag_n`

    @property
    def file(self) -> str:
        return self.text.partition("#")[0]

    @property
    def is_trace(self) -> bool:
        """Return whether it points to a whole trace."""
        return self.text.endswith(".csv.gz")

    @property
    def cell(self) -> tuple[int, str] | None:
        """Return row and column, or None if it does not point to a cell."""
        match = re.fullmatch(r"[^#]*#/rows/(\d+)/(\w+)", self.text)
        return (int(match[1]), match[2]) if match else None


class Lost(Markup):
    """The markup of a missing number, with the reason why it is missing."""

    reason = ""

    @classmethod
    def because(cls, html: Markup, reason: str) -> "Lost":
        markup = cls(html)
        markup.reason = reason or "the reason is not known"
        return markup


def lost_reason(printed: Any) -> str:
    """Return why a printed number is missing, or an empty string if it is not."""
    return printed.reason if isinstance(printed, Lost) else ""


@dataclass(frozen=True)
class Quantity:
    """A measured number with its unit and the pointer to its source.

    Arithmetic with quantities makes a ``Term``. The operands determine its unit, noise
    and sources.
    """

    value: float | int | None
    unit: str
    source: str  # see ``Pointer``; empty for a number that is not in a file
    reason: str = ""  # why there is no number
    origins: frozenset[Origin] = frozenset()
    """The releases and machines that measured it; empty if it was not measured."""
    noise: float | None = None
    """Half the confidence interval; None if it is not known, 0 for an exact number."""
    formula: str = ""  # the computation in words, or a list of the measurements
    samples: Sequence[float | None] = field(default=(), compare=False, repr=False)
    """The number by measurement of its edition, None if it is missing; empty if exact."""
    is_shared: bool = field(default=False, compare=False, repr=False)
    """Whether all numbers of one measurement share a part of their error, as times do."""

    def __lt__(self, other: object) -> bool:
        raise ReportError(
            "numbers are compared by a test that considers their noise: use "
            "greater(a, b), or .value to compare the numbers themselves"
        )

    __gt__ = __le__ = __ge__ = __lt__

    def _with(
        self, function: Callable[..., Any], *operands: "Quantity | float"
    ) -> "Term":
        return combined(function, self, *operands)

    def _after(self, function: Callable[..., Any], number: float) -> "Term":
        return combined(function, number, self)

    def __radd__(self, number: float) -> "Quantity":
        return self + number if number else self  # sum() starts with 0

    __add__ = partialmethod(_with, operator.add)
    __sub__ = partialmethod(_with, operator.sub)
    __mul__ = partialmethod(_with, operator.mul)
    __truediv__ = partialmethod(_with, operator.truediv)
    __neg__ = partialmethod(_with, operator.neg)
    __abs__ = partialmethod(_with, abs)
    __rmul__ = __mul__
    __rsub__ = partialmethod(_after, operator.sub)
    __rtruediv__ = partialmethod(_after, operator.truediv)

    def __round__(self, places: int = 0) -> float:
        raise ReportError(
            f"{self} is rounded according to its noise: print it without the filter round"
        )

    @property
    def reads(self) -> frozenset[str]:
        """Return the pointers to the number and to all numbers it is computed from."""
        return frozenset({self.source} if self.source else ())

    @property
    def number(self) -> float:
        """Return the value, which must not be missing."""
        assert self.value is not None, self.reason
        return self.value

    @property
    def bare(self) -> Markup:
        """Return the number as markup without its unit, for example for a table."""
        return self._written(self.written)

    @property
    def written(self) -> str:
        """Return the number as text without its unit, as exact as its noise allows."""
        return format_number(self.value, noise=self.noise)

    @property
    def code(self) -> Markup:
        """Return the number as markup, in the form that a program reads."""
        return self._written(format_code(self.value))

    @property
    def interval(self) -> Markup:
        """Return the number with its confidence interval and unit, like 0.042 ± 0.010 %."""
        return self._in_words(INTERVAL)

    @property
    def is_distinct(self) -> bool:
        """Return whether its distance from 0 exceeds its noise."""
        return self.value is not None and abs(self.value) > (self.noise or 0.0)

    @property
    def most(self) -> Markup:
        """Return the number with its unit, rounded up, for "at most" or "within"."""
        return self._in_words(MOST)

    @property
    def least(self) -> Markup:
        """Return the number with its unit, rounded down, for "at least" or "more than"."""
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
        # Markup's own format takes many times as long, and pages print 30,000 numbers.
        written = "".join(
            f' {name}="{escape(value)}"' for name, value in attributes.items()
        )
        html = Markup(f"<data{written}>{escape(text)}</data>")
        return Lost.because(html, self.reason) if self.value is None else html

    @property
    def _uncertainty(self) -> str:
        """Return the noise in words, and the measurements of a derived number."""
        if self.value is None or not self.noise:
            return ""
        present = [sample for sample in self.samples if sample is not None]
        listing = f", in {len(present)} measurements {', '.join(f'{sample:.4g}' for sample in present)}"
        return f"±{self.noise:.2g}" + (
            listing if len(present) > 1 and isinstance(self, Value) else ""
        )

    def __html__(self) -> Markup:
        return self._in_words()

    def _in_words(self, form: str = "") -> Markup:
        number = self._written(WRITES[form](self.value, noise=self.noise), form)
        return number + Markup("&nbsp;") + self._label if self._label else number

    def __str__(self) -> str:
        return f"{self.written} {self._label}".rstrip()

    @property
    def _label(self) -> str:
        return "" if self.value is None else unit_label(self.unit)


def absent(unit: str, reason: str) -> Quantity:
    """Return a quantity that is missing, with the reason."""
    return Quantity(None, unit, "", reason)


def constant(value: float, unit: str = PLAIN) -> Quantity:
    """Return an exact number that was not measured, such as a factor."""
    return Quantity(value, unit, "", noise=0.0)


PERCENT = constant(100, "%")  # ``PERCENT * a / b`` is a share in percent


@dataclass(frozen=True)
class Value(Quantity):
    """A number that is derived from others, with the formula in words."""

    sources: Sequence[str] = ()  # pointers to the numbers in its formula
    roots: frozenset[str] = frozenset()
    """Pointers to all numbers that it depends on, down to the records."""

    @property
    def reads(self) -> frozenset[str]:
        return super().reads | self.roots

    @property
    def entry(self) -> dict[str, Any]:
        """Return its entry in the values file of the site."""
        entry: dict[str, Any] = {
            name: getattr(self, name) for name in ("value", "unit", "noise", "formula")
        }
        entry["sources"] = list(self.sources)
        return entry | ({"reason": self.reason} if self.reason else {})


def mixed(*origins: frozenset[Origin]) -> str:
    """Return why numbers of these origins must not be compared.

    The text is empty if all of them have the same origins.
    """
    if len({origin for origin in origins if origin}) < 2:
        return ""
    return f"it would compare {' with '.join(map(str, sorted(frozenset().union(*origins))))}"


def samples_of(
    function: Callable[..., float], sources: Sequence[Any]
) -> list[float | None]:
    """Return the result of the function for each measurement; none if all sources are
    exact.
    """
    rows = _measurements(sources)
    return [None if None in row else _evaluated(function, row)[0] for row in rows]


def _measurements(sources: Sequence[Any]) -> list[tuple[Any, ...]]:
    """Return the values of all sources by measurement.

    There are none if all sources are exact, or if one of them is not a number.
    """
    sampled = [
        source.samples if isinstance(source, Quantity) else None for source in sources
    ]
    count = max((len(samples) for samples in sampled if samples), default=0)
    if None in sampled or not count:
        return []
    columns = [
        samples or count * (source.value,)
        for samples, source in zip(sampled, sources, strict=True)
    ]
    return [*zip_longest(*columns)]


def noise_of(function: Callable[..., float], sources: Sequence[Any]) -> float | None:
    """Return the noise of a function's value.

    Independent errors add in squares, as in the Guide to the Expression of Uncertainty
    in Measurement (JCGM 100:2008), 5.1.2, with differences instead of derivatives. A
    chosen number has no noise. Times of one measurement share the error of its host,
    which cancels in a ratio. So if there are enough measurements of times, all sources
    are shifted together by the differences between the measurements.
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
    independent = {index: noise for index, noise in enumerate(noises) if noise}
    shifts: list[Mapping[int, float]] = []
    if is_shared and len(rows) >= LEAST_TOGETHER:
        independent = {
            index: noise
            for index, noise in independent.items()
            if not sources[index].samples
        }
        # Scaled so that the squares add up to the interval of the mean.
        scale = t_quantile(SURE, len(rows) - 1) / math.sqrt(len(rows) * (len(rows) - 1))
        means = [*map(fmean, zip(*rows, strict=True))]
        for row in rows:
            pairs = enumerate(zip(row, means, strict=True))
            shifts.append({index: scale * (x - mean) for index, (x, mean) in pairs})
    shifts += [{index: noise} for index, noise in independent.items()]
    noise = _shifted(function, values, shifts)
    if not math.isfinite(noise):
        return None
    return max(float(noise), WRITTEN_SHARE * abs(middle)) if any(noises) else 0.0


def extreme_noise(
    choose: Callable[..., float], values: Sequence[float], noises: Sequence[float]
) -> float:
    """Return the noise of the largest or smallest of several numbers.

    The true extreme may be any of the numbers near it, so the interval has to hold for all
    of these at once. Independent errors do with probability ``SURE`` if each interval is
    widened as in Šidák (1967), J. Am. Stat. Assoc. 62, 626-633.
    """
    extreme = choose(values)
    noise = noises[values.index(extreme)]
    widest = _widening(len(values))
    near = sum(
        abs(extreme - value) <= widest * (noise + other_noise)
        for value, other_noise in zip(values, noises, strict=True)
    )
    factor = _widening(near)
    tops = [value + factor * width for value, width in zip(values, noises, strict=True)]
    bottoms = [
        value - factor * width for value, width in zip(values, noises, strict=True)
    ]
    return max(choose(tops) - extreme, extreme - choose(bottoms))


def _widening(count: int) -> float:
    """Return the factor by which intervals are widened so that all of ``count`` hold."""
    return NORMAL.inv_cdf(max((1 + SURE) / 2, SURE ** (1 / count))) / Z


def _shifted(
    function: Callable[..., float],
    values: Sequence[Any],
    shifts: Iterable[Mapping[int, float]],
) -> float:
    """Return how much a function changes if its values shift; infinite if it fails.

    A shift contains the number that is added to each value, by index. The effects of
    all shifts add in squares. Each shift is also subtracted, and the larger of its two
    effects counts.
    """
    middle = function(*values)

    def effect(shift: Mapping[int, float]) -> float:
        above = list(values)
        below = list(values)
        for index, distance in shift.items():
            above[index] += distance
            below[index] -= distance
        return max(abs(function(*above) - middle), abs(function(*below) - middle))

    # The function may not be defined there, for example the root of a negative number.
    with suppress(ArithmeticError, ValueError, LookupError):
        return math.hypot(*map(effect, shifts))
    return math.inf


class Unnamed(Quantity):
    """A computed number without a name, so that it cannot be printed."""

    def _written(self, text: str, written_as: str = "") -> Markup:
        raise ReportError(
            f"{self} is printed without a name: "
            "derive it with results.value(name, formula, …)"
        )


class Term(Unnamed, Value):
    """Computes a number from its operands; ``results.value`` gives it a name."""

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
        reasons = [operand.reason for operand in operands if operand.value is None]
        if refusal or reasons:
            value = None
            reason = refusal or reasons[0]
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
        """Return the quantities in its formula that are not terms themselves."""
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
        noises: list[Any] = [
            getattr(operand, "noise", None) for operand in self.operands
        ]
        if self.chooses and None not in noises:
            values: list[Any] = [operand.value for operand in self.operands]
            return extreme_noise(self.chooses, values, noises)
        return noise_of(self.function, self.operands)

    def __reduce__(self) -> tuple[type, tuple[Any, ...]]:
        # Its function may be a local one, which pickle does not store.
        return Unnamed, (
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
    """Return a function of quantities, series and plain numbers as a term.

    Its unit is ``unit``, or the unit of the sources. A quantity that occurs twice in it
    is shifted in both places at once. Raise ReportError if the sources have different
    units.
    """
    for source in sources:
        if not (hasattr(source, "reads") or hasattr(source, "__float__")):
            raise ReportError(
                f"{source!r:.80} is not a number or a series: derive values from these"
            )
    sources = tuple(
        source if hasattr(source, "reads") else constant(source) for source in sources
    )
    if across:
        terms: dict[int, Any] = {}
        sources = tuple(_across(source, terms) for source in sources)
    if function in (max, min):
        # The noise of the extreme depends on the noise of each source.
        choose = partial(function, default=math.nan)

        def chosen(*values: Any) -> float:
            return choose(values)  # without values it is not a number

        return Term(
            chosen, sources, unit or _unit_of(function, sources), across, choose
        )
    groups = [_operands(source) for source in sources]
    operands = {id(operand): operand for group in groups for operand in group}
    indices = {key: index for index, key in enumerate(operands)}
    # Made once, because the noise of a count shifts each of up to 1,000 numbers in turn.
    getters = [
        _getter(source, [indices[id(operand)] for operand in group])
        for source, group in zip(sources, groups, strict=True)
    ]

    def composed(*values: Any) -> float:
        return function(*(getter(values) for getter in getters))

    return Term(
        composed, tuple(operands.values()), unit or _unit_of(function, sources), across
    )


def _across(source: Any, terms: dict[int, Any]) -> Any:
    """Return a source, or a copy of a term that may combine several editions.

    ``terms`` contains the terms made so far, because a term that occurs twice has to
    stay one operand.
    """
    if not isinstance(source, Term):
        return source
    if id(source) not in terms:
        operands = tuple(_across(operand, terms) for operand in source.operands)
        terms[id(source)] = Term(
            source.function, operands, source.unit, True, source.chooses
        )
    return terms[id(source)]


def _operands(source: Any) -> Sequence[Any]:
    """Return the operands of a term.

    An extreme or any other quantity is its own operand.
    """
    is_computed = isinstance(source, Term) and not source.chooses
    return source.operands if is_computed else (source,)


def _getter(source: Any, indices: Sequence[int]) -> Callable[[Sequence[Any]], Any]:
    """Return a function that computes a source from the values of all operands."""
    if isinstance(source, Term) and not source.chooses:
        return lambda values: source.function(*map(values.__getitem__, indices))
    return operator.itemgetter(*indices)


def _unit_of(function: Callable[..., float], quantities: Sequence[Quantity]) -> str:
    """Return the unit of a product, a ratio, or else the common unit of the quantities."""
    if function in (operator.mul, operator.truediv):
        a, b = (quantity.unit for quantity in quantities)
        return _product_unit(a, b, 1 if function is operator.mul else -1)
    units = {
        quantity.unit: quantity for quantity in quantities if quantity.value is not None
    }
    if len(units) > 1:
        first, second, *_ = units.values()
        raise ReportError(
            f"{first} and {second} do not have the same unit: correct the formula"
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
    """Return the value of a function, or None and the reason why it is not a number."""
    try:
        value = function(*values)
    except ZeroDivisionError:
        return None, "it would be a division by zero"
    except (ArithmeticError, ValueError, LookupError) as error:
        # A damaged record may contain impossible data, such as a coordinate twice.
        return (
            None,
            f"it cannot be computed from the measurements: {' '.join(str(error).split())}",
        )
    if isinstance(value, complex):
        return None, "it has no finite value"
    value = getattr(value, "item", lambda: value)()
    return (value, "") if math.isfinite(value) else (None, "it has no finite value")
