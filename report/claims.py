"""Claims: sentences that say what the data shows, each a test here and a wording for every outcome in a template."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from markupsafe import Markup

from report.quantities import Quantity, mixed
from report.words import Wording

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
    """One checked sentence: its test's outcome, and what its wording can name."""

    name: str
    outcome: Outcome
    numbers: Mapping[str, Any] = field(default_factory=dict)
    """Quantities, and texts and flags."""
    wording: Wording | None = None
    """What the section's template says of it, once that is known."""

    @property
    def sentence(self) -> Markup:
        """The wording of the outcome; where it is unknown, that what the claim asks cannot be told, and why."""
        if self.outcome.name != "unknown":
            return self.said(self.outcome.name)
        asked = self.said("asks")
        sentence = Markup("{}{} cannot be told").format(asked[:1].upper(), asked[1:])
        return sentence + (Markup(" ({}).").format(self.outcome.reason) if self.outcome.reason else ".")

    @property
    def text(self) -> str:
        return self.sentence.striptags().replace("\xa0", " ")

    def html(self, section: str) -> Markup:
        claim = Markup('<span class="claim" data-claim="{}.{}" data-outcome="{}">{}</span>')
        html = claim.format(section, self.name, self.outcome.name, self.sentence)
        because = self.said("because") if self.outcome == HOLDS else ""
        return html + Markup(" {}").format(because) if because else html

    def said(self, part: str) -> Markup:
        """One part of its wording; ``because`` is said only when the claim holds."""
        assert self.wording, f"the claim {self.name} has no words yet"
        return self.wording(part, self.numbers)


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
