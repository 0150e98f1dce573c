"""Findings of the rules, with their cures and their sentences."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from string import Template

import numpy as np

from newton_lint.changes import Changes
from newton_lint.pairs import numbered
from newton_lint.source import Element

SEVERITIES = ("note", "warning", "error")
LEAST = 1e-3
"""Smaller values are printed as below this one."""
HUGE = 1e12
"""Only larger values are printed with an exponent."""
MANY = 1000
SHOWN = 3
"""Number of names that a list contains; the rest are only counted."""


@dataclass(frozen=True)
class Cure:
    """A list of changes that was stepped for 2 s from all starts, and its effect."""

    changes: Changes
    before: float | None = None
    """The reading without the changes, in the unit of the finding."""
    after: float | None = None
    unit: str = "1"
    effect: str = ""
    """The effect in words, for changes whose effect is not a reading."""
    drawback: str = ""
    """Why ``--fix`` does not write the changes, or an empty string."""

    def __str__(self) -> str:
        return self._text

    @cached_property
    def _text(self) -> str:
        effect = self.effect
        if "{}" in effect and self.after is not None:
            effect = effect.format(rounded(self.after, self.unit))
        if not effect and self.unit != "1" and self.after is not None:
            effect = f"reduces it to {rounded(self.after, self.unit)}"
        measured = "" if self.after is None else " (measured, 2 s)"
        subjects: dict[str, list[str]] = {}
        for change in self.changes:
            subjects.setdefault(change.text, []).append(change.subject)
        changes = joined([f"{text} on {named(on)}" for text, on in subjects.items()])
        if self.changes[0].kind == "exclude":
            return f"Adding {self.changes[0].text} to <contact> {effect}{measured}"
        text = f"Setting {changes} {effect or 'prevents it'}{measured}"
        if self.drawback:
            text += f". --fix does not write this because {self.drawback}"
        return text


@dataclass(frozen=True)
class Finding:
    """A difference between a scene as it is written and as the solver simulates it."""

    rule: str
    shape: str
    """Name of the body and shape, such as ``cube/box``; empty for the whole scene."""
    parameter: str
    value: float
    """The value as it is written, or as it follows from the written parameters."""
    message: str
    """A sentence with $shape, which is its subject, $against, $value and $used in it."""
    against: tuple[str, ...] = ()
    """The other shapes of the pairs, or () if the finding is about the shape alone."""
    used: float | None = None
    """The value that is used instead, or None; for a dampratio, the critical one."""
    unit: str = "1"
    severity: str = "warning"
    element: Element | None = field(default=None, compare=False)
    cures: tuple[Cure, ...] = field(default=(), compare=False)
    """Changes that mend it, each by itself, the best one first."""
    hint: str = field(default="", compare=False)
    """A sentence on a remedy that the lint cannot try."""

    @property
    def advice(self) -> str:
        """Return the cures and the hint in words."""
        return " ".join(f"{cure}." for cure in self.cures) or self.hint


def number(value: float, digits: int = 3) -> str:
    """Return a value with some significant digits; a large one as a whole number."""
    # Three digits of 999.5 would be printed as 1e+03.
    is_long = 10.0**digits - 0.5 <= abs(value) < HUGE
    return f"{value:,.0f}" if is_long else f"{value:.{digits}g}"


def quantity(value: float, unit: str) -> str:
    """Return a value with its unit; the unit 1 is not printed."""
    space = "" if unit in ("1", "%", "°", "°/s") else " "
    return f"{number(value)}{space}{'' if unit == '1' else unit}"


def rounded(value: float, unit: str) -> str:
    """Return a reading with its unit, or "below" and the least printed value."""
    is_small = 0.0 < value < LEAST
    return f"below {quantity(LEAST, unit)}" if is_small else quantity(value, unit)


def grouped(findings: Iterable[Finding]) -> list[list[Finding]]:
    """Return the findings in groups that only differ in their shapes."""
    groups: dict[tuple, list[Finding]] = {}
    for finding in findings:
        key = replace(finding, shape="", against=()), finding.advice
        groups.setdefault(key, []).append(finding)
    return list(groups.values())


def sentence(group: Sequence[Finding]) -> str:
    """Return one sentence for findings that only differ in their shapes."""
    finding = group[0]
    shapes = named(member.shape for member in group)
    partners = [partner for member in group for partner in member.against]
    is_short = len(partners) == len({*partners}) and len(group) == 1
    count = "" if is_short else f" ({len(partners)} pairs)"
    return Template(finding.message).safe_substitute(
        shape=shapes if shapes == finding.shape else f"each of {shapes}",
        against=f"{named(partners)}{count}",
        value=quantity(finding.value, finding.unit),
        used="" if finding.used is None else quantity(finding.used, finding.unit),
    )


def named(names: Iterable[str]) -> str:
    """Return a list of names, shortened if there are many."""
    different = list(dict.fromkeys(names))
    if len(different) > SHOWN + 1:
        return f"{', '.join(different[:SHOWN])} and {len(different) - SHOWN} more"
    return joined(different)


def joined(names: Sequence[str]) -> str:
    """Return a list of names as it is written in a sentence."""
    return (
        f"{', '.join(names[:-1])} and {names[-1]}" if len(names) > 1 else "".join(names)
    )


Remedy = Sequence[tuple[Changes, str]]
"""Changes with their effects in words; one without changes is only a hint."""


@dataclass(frozen=True)
class Hits:
    """Geoms or pairs that a rule hits; the arrays are of all geoms or pairs."""

    finding: Finding
    """The finding, without its shapes and values."""
    mask: np.ndarray
    """Whether each geom or pair is hit."""
    value: np.ndarray
    used: np.ndarray | float = np.nan
    """The value that is used, one for all or one for each; NaN if there is none."""
    advise: Callable[[int], Remedy] = lambda _: ()
    """Returns the remedies of an item."""
    shape: np.ndarray | None = None
    """The geom of each pair, or None if the items are geoms."""
    partner: np.ndarray | None = None
    """The other geom of each pair, or None if the items are geoms."""


def findings_of(
    hits: Hits, names: Sequence[str]
) -> Iterator[tuple[list[Finding], Remedy]]:
    """Yield the findings with equal values, one for each shape, and their remedies."""
    items = np.flatnonzero(hits.mask)
    all_used = np.broadcast_to(hits.used, hits.value.shape)[items]
    shapes = items if hits.shape is None else hits.shape[items]
    # NaN does not equal itself, so each hit without a used value would stay alone.
    used_keys = np.nan_to_num(all_used, nan=np.inf)
    numbers = numbered(hits.value[items], used_keys)
    for alike in sorted(groups_of(numbers), key=lambda members: members[0]):
        used = all_used[alike[0]]
        findings = []
        for members in groups_of(numbered(shapes[alike])):
            rows = alike[members]
            partners = (
                () if hits.partner is None else hits.partner[items[rows]].tolist()
            )
            finding = replace(
                hits.finding,
                shape=names[shapes[rows[0]]],
                value=hits.value[items[rows[0]]],
                against=tuple(names[geom] for geom in partners),
                used=None if np.isnan(used) else used,
            )
            findings.append(finding)
        yield findings, _shared(hits, items[alike])


def _shared(hits: Hits, items: np.ndarray) -> Remedy:
    """Return remedies that change all of some items with equal values."""
    if len(items) > MANY and hits.shape is not None and hits.partner is not None:
        # One pair for each geom is enough.
        firsts = [
            np.unique(geoms[items], return_index=True)[1]
            for geoms in (hits.shape, hits.partner)
        ]
        items = items[np.unique(np.concatenate(firsts))]
    remedies = [hits.advise(item) for item in items.tolist()]
    shared = []
    for ways in zip(*remedies, strict=True):
        changes = (change for changes, _ in ways for change in changes)
        # Pairs of one shape may need different values, but it can have only one.
        single = {(change.kind, change.subject): change for change in changes}
        shared.append((tuple(single.values()), ways[0][1]))
    return shared


def groups_of(numbers: np.ndarray) -> list[np.ndarray]:
    """Return the indices of each group of equal numbers, lowest number first."""
    return (
        np.split(
            np.argsort(numbers, kind="stable"), np.cumsum(np.bincount(numbers))[:-1]
        )
        if len(numbers)
        else []
    )
