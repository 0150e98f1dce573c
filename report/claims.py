"""Claims: sentences that say what the data shows, each a test with a wording for every outcome."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from markupsafe import Markup

from report.quantities import Quantity, mixed

NEAR_NOISE = 2.0
"""Chosen: beyond the noise, but up to so many times it, a difference can't tell. The noise is the largest difference
among some tens of runs, and measured again some other pair differs more."""


@dataclass(frozen=True)
class Outcome:
    """What a test on the results found: ``holds``, ``fails`` or ``unknown``."""

    name: str
    reason: str = ""
    """Why it is unknown."""
    is_near: bool = False
    """Whether that is for being near the noise, so that the same measured again may be decided."""


HOLDS = Outcome("holds")
FAILS = Outcome("fails")


@dataclass(frozen=True)
class Claim:
    """One checked sentence. The wordings name their numbers in braces, as in ``The cube slips {slip}.``"""

    name: str
    outcome: Outcome
    holds: str
    fails: str
    unknown: str = ""
    """Said when the data can't tell, if that can be; the outcome's reason is added to it."""
    numbers: Mapping[str, Quantity | str] = field(default_factory=dict)
    explanation: str = ""
    """Said only when the claim holds."""

    @property
    def sentence(self) -> Markup:
        wording = {"holds": self.holds, "fails": self.fails, "unknown": self.unknown}[self.outcome.name]
        sentence = Markup(wording).format(**self.numbers)
        if not self.outcome.reason:
            return sentence
        return Markup("{} ({}).").format(Markup(sentence.removesuffix(".")), self.outcome.reason)

    @property
    def text(self) -> str:
        return self.sentence.striptags().replace("\xa0", " ")

    def html(self, section: str) -> Markup:
        claim = Markup('<span class="claim" data-claim="{}.{}" data-outcome="{}">{}</span>')
        html = claim.format(section, self.name, self.outcome.name, self.sentence)
        if self.explanation and self.outcome == HOLDS:
            html += " " + Markup(self.explanation).format(**self.numbers)
        return html


def greater(a: Quantity, b: Quantity, *, noise: Quantity) -> Outcome:
    """Whether ``a`` is greater than ``b``; a difference that is not above the noise can't tell."""
    if undecided := _undecided(a, b, noise):
        return undecided
    difference = a.value - b.value
    if abs(difference) <= noise.value:
        return Outcome("unknown", "the difference is within the noise")
    return HOLDS if difference > 0 else FAILS


def within(difference: Quantity, noise: Quantity) -> Outcome:
    """Whether a difference is no more than noise; one that is little more can't tell."""
    if undecided := _undecided(difference, noise):
        return undecided
    if difference.value <= noise.value:
        return HOLDS
    return beyond(difference, noise)


def beyond(difference: Quantity, noise: Quantity) -> Outcome:
    """Fails; but what is only little more than the noise, either way, can't tell."""
    if abs(difference.value) > NEAR_NOISE * noise.value:
        return FAILS
    reason = Markup("{} is more than the noise of {}, but less than {:g} times that")
    return Outcome("unknown", reason.format(difference, noise, NEAR_NOISE), is_near=True)


def at_least(a: Quantity, bound: Quantity) -> Outcome:
    return _undecided(a, bound) or (HOLDS if a.value >= bound.value else FAILS)


def at_most(a: Quantity, bound: Quantity) -> Outcome:
    return _undecided(a, bound) or (HOLDS if a.value <= bound.value else FAILS)


def _undecided(*quantities: Quantity) -> Outcome | None:
    """Why these can't be compared, when they can't."""
    reasons = [quantity.reason for quantity in quantities if quantity.value is None]
    reasons += filter(None, [mixed(*(quantity.origins for quantity in quantities))])
    return Outcome("unknown", reasons[0]) if reasons else None


def all_of(*outcomes: Outcome) -> Outcome:
    """Holds when all hold; one that fails decides, otherwise one that can't tell."""
    for name in (FAILS.name, "unknown"):
        for outcome in outcomes:
            if outcome.name == name:
                return outcome
    return HOLDS
