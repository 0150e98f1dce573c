"""Test what the data shows: a claim is a test here, and a wording for every outcome in a template."""

import math
import operator
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import accumulate
from typing import Any

from markupsafe import Markup

from measured_report.files.columns import Schema
from measured_report.files.errors import ReportError
from measured_report.parts.macros import macros
from measured_report.parts.words import Wording
from measured_report.values.quantities import (
    VALUES_FILE,
    Quantity,
    Value,
    mixed,
)

Number = (
    Quantity | float
)  # a test compares quantities, and numbers that were chosen in their unit, `why` in words


@dataclass(frozen=True)
class Outcome:
    """Tell what a test finds: ``holds``, ``fails`` or ``unknown``, and what it looked at for that."""

    name: str
    reason: str = ""
    is_inconclusive: bool = False  # unknown for being near the noise, so that the same measured again may be decided
    is_opposite: bool = field(
        default=False, compare=False
    )  # fails because the opposite is shown
    reads: frozenset[str] = field(
        default=frozenset(), compare=False, repr=False
    )  # pointers to all that it stands on
    bounds: tuple[str, ...] = field(
        default=(), compare=False, repr=False
    )  # chosen for it alone, with unit and why

    def having_read(self, *quantities: Quantity) -> "Outcome":
        """Return the same, for a test that looked at these as well."""
        reads = self.reads.union(*(quantity.reads for quantity in quantities))
        return replace(self, reads=reads)

    @property
    def answer(self) -> str:
        """Say one of four: holds, the opposite, fails, cannot tell."""
        return {"unknown": "cannot tell"}.get(
            self.name, "the opposite" if self.is_opposite else self.name
        )


HOLDS = Outcome("holds")
FAILS = Outcome("fails")
OPPOSITE = Outcome("fails", is_opposite=True)
WITHIN = Outcome("unknown", "the difference is within its noise", is_inconclusive=True)


@dataclass(frozen=True)
class Claim:
    """Check a sentence: its test's outcome, and what its wording can name."""

    name: str
    outcome: Outcome
    numbers: Mapping[str, Any] = field(default_factory=dict)
    """Quantities, which must all be there for it to tell, and texts and flags; "" for one that it does without."""
    wording: Wording | None = None
    confirmed: str = ""  # says how many measurements agree, where there are several
    effect: Outcome = HOLDS  # whether there is what its `because` explains; where that fails it is not explained

    @cached_property
    def sentence(self) -> Markup:
        """Word the outcome; one that is unknown, or fails without words for that, by what the claim asks."""
        outcome = self.outcome
        parts = ["opposite", "fails"] if outcome.is_opposite else [outcome.name]
        for sentence in filter(None, map(self.render, parts)):
            return sentence
        question = self.render("asks")
        verdict = "cannot be told" if outcome.name == "unknown" else "is not shown"
        sentence = Markup("{}{} {}").format(question[:1].upper(), question[1:], verdict)
        reason = Markup(" ({})").format(outcome.reason) if outcome.reason else ""
        return sentence + reason + "."

    def checked(self) -> "Claim":
        """Return the same; where a number that its sentence names is not there, it can't tell, and says why."""
        lost = _absent(
            *(each for each in self.numbers.values() if isinstance(each, Quantity))
        )
        if not lost or self.outcome.name == "unknown":
            return self
        outcome = replace(
            self.outcome, name="unknown", reason=lost.reason, is_opposite=False
        )
        return replace(self, outcome=outcome)

    def unread(self, columns: Schema) -> Iterator[str]:
        """Yield the numbers it may print of which its test read neither themselves nor all that makes them."""
        if self.outcome.name == "unknown":
            return
        for name, number in self.numbers.items():
            if not isinstance(number, Quantity) or number.source in self.outcome.reads:
                continue
            for leaf in number.reads - self.outcome.reads:
                column = leaf.rpartition("/")[2]
                if VALUES_FILE not in leaf and not columns[column].is_setting:
                    yield name
                    break

    @property
    def text(self) -> str:
        return self.sentence.striptags().replace("\xa0", " ")

    def html(self, section: str) -> Markup:
        return macros().claim(
            self,
            section,
            self.render("because") if self.outcome == self.effect == HOLDS else "",
        )

    def render(self, part: str) -> Markup:
        """Render one part of its wording."""
        assert self.wording, f"the claim {self.name} has no words yet"
        return self.wording(part, self.numbers)


def decided(is_so: bool, *quantities: Quantity) -> Outcome:
    """Hold or fail by a condition that was computed from these; cannot tell where one of them is missing."""
    assert not (is_so and isinstance(is_so, Quantity | str)), (
        f"{is_so} is no yes or no: test it, as x.value == 0"
    )
    return _judged(lambda *_: HOLDS if is_so else FAILS, *quantities, compares=False)


def at_least(a: Quantity, bound: Number, why: str = "") -> Outcome:
    """Test whether a bound is reached; cannot tell if the interval of ``a`` has the bound in it."""
    return _bounded(a, bound, why, operator.ge)


def at_most(a: Quantity, bound: Number, why: str = "") -> Outcome:
    """Test whether a bound is kept; cannot tell if the interval of ``a`` has the bound in it."""
    return _bounded(a, bound, why, operator.le)


def negligible(change: Quantity, bound: Number, why: str = "") -> Outcome:
    """Test whether a change is too small to matter; one above the bound is the opposite.

    For a change in either direction it takes the size, ``negligible(abs(a - b), bound)``.
    """
    outcome = at_most(change, bound, why)
    return replace(outcome, is_opposite=outcome == FAILS)


def _bounded(
    a: Quantity, bound: Number, why: str, keeps: Callable[[float, float], bool]
) -> Outcome:
    def judge(a: Quantity, bound: Quantity) -> Outcome:
        noise = math.hypot(a.noise or 0.0, bound.noise or 0.0)
        if abs(a.number - bound.number) < noise:
            reason = Markup("the bound of {} lies within the interval {}")
            said = reason.format(
                _said(bound), a.interval if a.source else f"±{noise:.2g}"
            )
            return Outcome("unknown", said, is_inconclusive=True)
        return HOLDS if keeps(a.number, bound.number) else FAILS

    return _judged(judge, a, bound, why=why)


def greater(a: Number, b: Number, why: str = "") -> Outcome:
    """Test whether ``a`` is greater than ``b``; less is the opposite, and cannot tell if their
    difference is within its own noise."""
    if a is b:
        raise ReportError(f"a test compares {a} with itself")

    def judge(a: Quantity, b: Quantity) -> Outcome:
        difference = a - b
        if difference.noise is None:
            return Outcome("unknown", "nobody measured its noise")
        if abs(difference.number) <= difference.noise:
            return WITHIN
        return HOLDS if difference.number > 0 else OPPOSITE

    return _judged(judge, a, b, why=why)


def decreases(sequence: Sequence[Number], *, by: Number, why: str = "") -> Outcome:
    """Test whether a sequence falls by more than ``by``, and nowhere rises by more.

    A sequence that rises so is the opposite. It cannot tell if the whole change is not surely
    larger than ``by``.
    """

    def judge(*quantities: Quantity) -> Outcome:
        *cells, bound = quantities
        assert bound.number >= 0, f"{bound} is no bound of a change: it is below 0"
        if len(cells) < 2:
            return Outcome("unknown", "it takes two values to see a trend")
        change = cells[-1] - cells[0]
        if abs(change.number) - (change.noise or 0.0) <= bound.number:
            reason = Markup("the change is not surely larger than {}")
            return Outcome("unknown", reason.format(_said(bound)), is_inconclusive=True)
        values = [cell.number for cell in cells]
        if _rises(values[::-1], bound.number):
            return HOLDS
        return OPPOSITE if _rises(values, bound.number) else FAILS

    return _judged(judge, *sequence, by, why=why)


def _rises(values: Sequence[float], bound: float) -> bool:
    falls = [
        top - value for top, value in zip(accumulate(values, max), values, strict=True)
    ]
    return values[-1] - values[0] > bound >= max(falls)


def _judged(
    judge: Callable[..., Outcome],
    *numbers: Number,
    why: str = "",
    compares: bool = True,
) -> Outcome:
    """Return what ``judge`` says of them where all may be compared; a plain number was chosen for ``why``."""
    measured = [number for number in numbers if isinstance(number, Quantity)]
    unit = measured[0].unit if measured else "1"
    quantities = []
    bounds = []
    for number in numbers:
        if not isinstance(number, Quantity):
            if not (why.strip() and hasattr(number, "__float__")):
                raise ReportError(
                    f"{number!r:.80} was not measured: "
                    'a chosen number takes why="…", or a name by chosen(…)'
                )
            number = Quantity(number, unit, "", noise=0.0)
            bounds.append(f"{number} ({why})")
        quantities.append(number)
    if compares:
        _refuse_units(*quantities)
    reason = mixed(*(quantity.origins for quantity in quantities))
    if not (outcome := _absent(*quantities)):
        outcome = Outcome("unknown", reason) if reason else judge(*quantities)
    bounds = list(dict.fromkeys((*outcome.bounds, *bounds)))
    return replace(outcome.having_read(*quantities), bounds=tuple(bounds))


def _said(bound: Quantity) -> Quantity | str:
    """Return a bound as a reason prints it: one that was chosen has no source."""
    return bound if bound.source or isinstance(bound, Value) else str(bound)


def _refuse_units(*quantities: Quantity) -> None:
    measured = [quantity for quantity in quantities if quantity.value is not None]
    if differing := next(
        (quantity for quantity in measured if quantity.unit != measured[0].unit), None
    ):
        raise ReportError(
            f"a test compares {measured[0]} with {differing}: derive them in one unit"
        )


def _absent(*quantities: Quantity) -> Outcome | None:
    return next(
        (
            Outcome("unknown", quantity.reason)
            for quantity in quantities
            if quantity.value is None
        ),
        None,
    )


def all_of(*outcomes: Outcome) -> Outcome:
    """Hold when all hold; one that is not shown decides, then one whose opposite is, then one that can't tell."""
    reads: frozenset[str] = frozenset().union(*(outcome.reads for outcome in outcomes))
    bounds = tuple(
        dict.fromkeys(bound for outcome in outcomes for bound in outcome.bounds)
    )
    order = ("fails", "the opposite", "cannot tell", "holds")
    decisive = min(
        outcomes, key=lambda outcome: order.index(outcome.answer), default=HOLDS
    )
    return replace(decisive, reads=reads, bounds=bounds)
