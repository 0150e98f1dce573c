"""Test statements about the data: a claim has a test, and a wording for each outcome.

The test is Python code in a section; the wordings are in its template.
"""

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

Number = Quantity | float
"""A number that a test compares.

A plain number is a chosen bound, in the unit of the quantities with which it is
compared. The argument ``why`` gives the reason for it in words.
"""


@dataclass(frozen=True)
class Outcome:
    """The outcome of a test and the numbers that it depends on."""

    name: str  # `holds`, `fails` or `unknown`
    reason: str = ""  # why it is unknown
    is_inconclusive: bool = False
    """Whether it is unknown because of noise; then a second measurement may decide."""
    is_opposite: bool = field(default=False, compare=False)
    """Whether it fails because the opposite is shown."""
    reads: frozenset[str] = field(default=frozenset(), compare=False, repr=False)
    """Pointers to all numbers that it depends on."""
    bounds: tuple[str, ...] = field(default=(), compare=False, repr=False)
    """Bounds that were chosen for this test, each with its unit and its reason."""

    def having_read(self, *quantities: Quantity) -> "Outcome":
        """Return the outcome with these quantities added to ``reads``."""
        reads = self.reads.union(*(quantity.reads for quantity in quantities))
        return replace(self, reads=reads)

    @property
    def answer(self) -> str:
        """Return one of four answers: holds, the opposite, fails or cannot tell."""
        return {"unknown": "cannot tell"}.get(
            self.name, "the opposite" if self.is_opposite else self.name
        )


HOLDS = Outcome("holds")
FAILS = Outcome("fails")
OPPOSITE = Outcome("fails", is_opposite=True)
WITHIN = Outcome("unknown", "the difference is within its noise", is_inconclusive=True)


@dataclass(frozen=True)
class Claim:
    """A statement of the report, with the outcome of its test, its wording and its numbers."""

    name: str
    outcome: Outcome
    numbers: Mapping[str, Any] = field(default_factory=dict)
    """Quantities, texts and flags that the wording can name.

    If a quantity is missing, the outcome is unknown. Use "" instead of a quantity that
    the claim can do without.
    """
    wording: Wording | None = None
    confirmed: str = ""  # how many of several measurements agree
    effect: Outcome = HOLDS
    """Whether the effect exists that `because` explains.

    The explanation is printed only if it does.
    """
    shared_wording: str = ""
    """The name of its wording in the template, if several claims share one."""

    def __post_init__(self) -> None:
        assert isinstance(self.outcome, Outcome), (
            f"the outcome of {self.name} is {self.outcome!r}: use a test, such as "
            "greater(a, b)"
        )

    @property
    def wording_name(self) -> str:
        return self.shared_wording or self.name

    @cached_property
    def sentence(self) -> Markup:
        """Return the sentence for the outcome.

        If the template has no sentence for it, this is the question with a verdict,
        such as "We cannot tell whether the tower leans".
        """
        outcome = self.outcome
        parts = ["opposite", "fails"] if outcome.is_opposite else [outcome.name]
        for sentence in filter(None, map(self.render, parts)):
            return sentence
        question = self.render("asks")
        is_open = outcome.name == "unknown"
        verdict = "We cannot tell" if is_open else "It is not shown"
        sentence = Markup("{} {}").format(verdict, question)
        reason = Markup(" ({})").format(outcome.reason) if outcome.reason else ""
        return sentence + reason + "."

    def checked(self) -> "Claim":
        """Return the claim; its outcome is unknown if any of its numbers is missing."""
        quantities = [
            number for number in self.numbers.values() if isinstance(number, Quantity)
        ]
        absent = _absent(*quantities)
        if not absent or self.outcome.name == "unknown":
            return self
        outcome = replace(
            self.outcome, name="unknown", reason=absent.reason, is_opposite=False
        )
        return replace(self, outcome=outcome)

    def unread(self, columns: Schema) -> Iterator[str]:
        """Yield the names of numbers that the claim may print, but did not test.

        A number counts as tested if the test depends on it, or on all measured numbers
        that it is computed from.
        """
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
        """Return one part of the claim's wording with its numbers."""
        assert self.wording, f"the claim {self.name} does not have a wording yet"
        return self.wording[part](self.numbers) if part in self.wording else Markup("")


def decided(is_so: bool, *quantities: Quantity) -> Outcome:
    """Test a condition that was computed from quantities.

    The outcome is unknown if any of them is missing.
    """
    assert not (is_so and isinstance(is_so, Quantity | str)), (
        f"decided() got {is_so} instead of True or False: compare it, as in "
        "x.value == 0"
    )
    return _judged(lambda *_: HOLDS if is_so else FAILS, *quantities, compares=False)


def at_least(a: Quantity, bound: Number, why: str = "") -> Outcome:
    """Test whether ``a`` is at least ``bound``.

    The outcome is unknown if the interval of ``a`` contains the bound.
    """
    return _bounded(a, bound, why, operator.ge)


def at_most(a: Quantity, bound: Number, why: str = "") -> Outcome:
    """Test whether ``a`` is at most ``bound``.

    The outcome is unknown if the interval of ``a`` contains the bound.
    """
    return _bounded(a, bound, why, operator.le)


def negligible(change: Quantity, bound: Number, why: str = "") -> Outcome:
    """Test whether a change is at most a bound; a larger change is the opposite.

    For a change in either direction, use its size: ``negligible(abs(a - b), bound)``.
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
            interval = a.interval if a.source else f"±{noise:.2g}"
            text = reason.format(_printable(bound), interval)
            return Outcome("unknown", text, is_inconclusive=True)
        return HOLDS if keeps(a.number, bound.number) else FAILS

    return _judged(judge, a, bound, why=why)


def greater(a: Number, b: Number, why: str = "") -> Outcome:
    """Test whether ``a`` is greater than ``b``; if it is less, that is the opposite.

    The outcome is unknown if their difference is within its noise.
    """
    if a is b:
        raise ReportError(
            f"a test compares {a} with itself: compare it with another number"
        )

    def judge(a: Quantity, b: Quantity) -> Outcome:
        difference = a - b
        if difference.noise is None:
            return Outcome("unknown", "its noise was not measured")
        if abs(difference.number) <= difference.noise:
            return WITHIN
        return HOLDS if difference.number > 0 else OPPOSITE

    return _judged(judge, a, b, why=why)


def decreases(sequence: Sequence[Number], *, by: Number, why: str = "") -> Outcome:
    """Test whether a sequence falls by more than ``by``, and never rises by more than it.

    The opposite is a sequence that rises by more than ``by`` and never falls by more.
    The outcome is unknown if the change from the first to the last number may be
    smaller than ``by``, given its noise.
    """

    def judge(*quantities: Quantity) -> Outcome:
        *cells, bound = quantities
        assert bound.number >= 0, (
            f"{bound} cannot bound a change: use a positive number"
        )
        if len(cells) < 2:
            return Outcome("unknown", "a trend needs at least two values")
        change = cells[-1] - cells[0]
        if abs(change.number) - (change.noise or 0.0) <= bound.number:
            reason = Markup("the change may be smaller than {}").format(
                _printable(bound)
            )
            return Outcome("unknown", reason, is_inconclusive=True)
        values = [cell.number for cell in cells]
        if _rises(values[::-1], bound.number):
            return HOLDS
        return OPPOSITE if _rises(values, bound.number) else FAILS

    return _judged(judge, *sequence, by, why=why)


def _rises(values: Sequence[float], bound: float) -> bool:
    """Return whether values rise by more than ``bound`` and never fall by more."""
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
    """Return the outcome of ``judge``, or unknown if the numbers cannot be compared.

    Each plain number must have the reason ``why``.
    """
    measured = [number for number in numbers if isinstance(number, Quantity)]
    unit = measured[0].unit if measured else "1"
    quantities = []
    bounds = []
    for number in numbers:
        if not isinstance(number, Quantity):
            if not (why.strip() and hasattr(number, "__float__")):
                raise ReportError(
                    f"{number!r:.80} was not measured: give the reason for a chosen "
                    'number as why="…", or name it with results.chosen(…)'
                )
            number = Quantity(number, unit, "", noise=0.0)
            bounds.append(f"{number} ({why})")
        quantities.append(number)
    if compares:
        _refuse_mixed_units(*quantities)
    reason = mixed(*(quantity.origins for quantity in quantities))
    if not (outcome := _absent(*quantities)):
        outcome = Outcome("unknown", reason) if reason else judge(*quantities)
    bounds = list(dict.fromkeys((*outcome.bounds, *bounds)))
    return replace(outcome.having_read(*quantities), bounds=tuple(bounds))


def _printable(bound: Quantity) -> Quantity | str:
    """Return a bound as a reason prints it: as text if it does not have a source."""
    return bound if bound.source or isinstance(bound, Value) else str(bound)


def _refuse_mixed_units(*quantities: Quantity) -> None:
    measured = [quantity for quantity in quantities if quantity.value is not None]
    if differing := next(
        (quantity for quantity in measured if quantity.unit != measured[0].unit), None
    ):
        raise ReportError(
            f"a test compares {measured[0]} with {differing}: derive them in one unit"
        )


def _absent(*quantities: Quantity) -> Outcome | None:
    """Return the outcome of a test with a missing quantity, or None if all exist."""
    return next(
        (
            Outcome("unknown", quantity.reason)
            for quantity in quantities
            if quantity.value is None
        ),
        None,
    )


def all_of(*outcomes: Outcome) -> Outcome:
    """Return the combined outcome of several tests.

    It is the first of these that occurs: fails, the opposite, cannot tell, holds.
    """
    reads: frozenset[str] = frozenset().union(*(outcome.reads for outcome in outcomes))
    bounds = tuple(
        dict.fromkeys(bound for outcome in outcomes for bound in outcome.bounds)
    )
    order = ("fails", "the opposite", "cannot tell", "holds")
    decisive = min(
        outcomes, key=lambda outcome: order.index(outcome.answer), default=HOLDS
    )
    return replace(decisive, reads=reads, bounds=bounds)
