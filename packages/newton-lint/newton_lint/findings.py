"""Findings of the rules, with advice and changes, and their sentences."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from string import Template

import numpy as np

from newton_lint.source import Element

SEVERITIES = ("note", "warning", "error")
SHOWN = 3
"""Names that a list has before it counts the rest."""


@dataclass(frozen=True)
class Change:
    """A change of a file: new attributes of one element."""

    subject: str
    """The owner of the attributes: the name of a geom, ``option`` or ``exclude``."""
    attributes: tuple[tuple[str, str], ...]
    element: Element | None = None
    """The element to change, or None if no file defines it."""

    def __str__(self) -> str:
        attributes = " ".join(f'{name}="{value}"' for name, value in self.attributes)
        if self.subject == "exclude":
            return f"<exclude {attributes}/> in <contact>"
        place = (
            f" ({self.element.file.name}:{self.element.line})" if self.element else ""
        )
        return f"{attributes} on {self.subject}{place}"


@dataclass(frozen=True)
class Advice:
    """Changes with their effect, and alternatives to them, the mildest one first."""

    gain: str
    """Effect of the changes, as a predicate, or a whole sentence if there are none."""
    changes: tuple[Change, ...] = ()
    alternatives: tuple["Advice", ...] = ()
    """An alternative without a gain is tried, but not printed."""

    def __str__(self) -> str:
        sentences: list[str] = []
        for way in (self, *(way for way in self.alternatives if way.gain)):
            changes = ", ".join(map(str, way.changes))
            text = f"Set {changes}: this {way.gain}" if changes else way.gain
            sentences.append(f"Or {text[0].lower()}{text[1:]}" if sentences else text)
        return ". ".join(sentences)


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
    """A sentence with $shape or $shapes, $against, $value and $used in it.

    $shape is the subject of a verb in the singular; $shapes is a list.
    """
    against: tuple[str, ...] = ()
    """The other shapes of the pairs, or () if the finding is about the shape alone."""
    used: float | None = None
    """The value that is used instead, or None; for a dampratio, the critical one."""
    unit: str = "1"
    severity: str = "warning"
    element: Element | None = field(default=None, compare=False)
    advice: Advice | None = field(default=None, compare=False)


def distinct(changes: Iterable[Change]) -> tuple[Change, ...]:
    """Return changes without duplicates, which arise from defaults of several geoms."""
    return tuple(
        {
            (change.element or change.subject, change.attributes): change
            for change in changes
        }.values()
    )


def grouped(findings: Iterable[Finding]) -> list[list[Finding]]:
    """Return the findings in groups that only differ in their shapes."""
    groups: dict[Finding, list[Finding]] = {}
    for finding in findings:
        groups.setdefault(replace(finding, shape="", against=()), []).append(finding)
    return list(groups.values())


def sentence(group: Sequence[Finding]) -> str:
    """Return one sentence for findings that only differ in their shapes."""
    finding = group[0]
    unit = f" {finding.unit}" if finding.unit != "1" else ""
    shapes = named(member.shape for member in group)
    partners = [partner for member in group for partner in member.against]
    count = f" ({len(partners)} pairs)" if len(partners) > 1 else ""
    return Template(finding.message).safe_substitute(
        shape=shapes if shapes == finding.shape else f"each of {shapes}",
        shapes=shapes,
        against=f"{named(partners)}{count}",
        value=f"{finding.value:.4g}{unit}",
        used="" if finding.used is None else f"{finding.used:.3g}{unit}",
    )


def named(names: Iterable[str]) -> str:
    """Return a list of names, shortened if there are many."""
    different = list(dict.fromkeys(names))
    if len(different) > SHOWN + 1:
        return f"{', '.join(different[:SHOWN])} and {len(different) - SHOWN} more"
    return ", ".join(different)


@dataclass(frozen=True)
class Wording:
    """The message of a rule on one parameter."""

    rule: str
    parameter: str
    message: str
    unit: str = "1"
    severity: str = "warning"


@dataclass(frozen=True)
class Hits:
    """Geoms or pairs that a rule hits; the arrays are of all geoms or pairs."""

    wording: Wording
    items: np.ndarray
    """Indices of the geoms or pairs that are hit."""
    value: np.ndarray
    used: np.ndarray | float = np.nan
    """The value that is used, one for all or one for each; NaN if there is none."""
    shape: np.ndarray | None = None
    """The geom of each pair, or None if the items are geoms."""
    partner: np.ndarray | None = None
    """The other geom of each pair, or None if the items are geoms."""
    element: Callable[[int], Element | None] = lambda _: None
    advise: Callable[[int], Advice | None] = lambda _: None


def findings_of(hits: Hits, names: Sequence[str]) -> Iterator[Finding]:
    """Yield a finding for each shape and each of its values, in order of the hits."""
    items = hits.items
    all_used = np.broadcast_to(hits.used, hits.value.shape)[items]
    shapes = items if hits.shape is None else hits.shape[items]
    # NaN does not equal itself, so each hit without a used value would stay alone.
    used_keys = np.nan_to_num(all_used, nan=np.inf)
    numbers = row_numbers(shapes, hits.value[items], used_keys)
    for members in sorted(groups_of(numbers), key=lambda members: members[0]):
        first = members[0]
        entry = int(items[first])
        used = float(all_used[first])
        partners = () if hits.partner is None else hits.partner[items[members]].tolist()
        yield Finding(
            **vars(hits.wording),
            shape=names[shapes[first]],
            value=float(hits.value[entry]),
            against=tuple(names[geom] for geom in partners),
            used=None if np.isnan(used) else used,
            element=hits.element(entry),
            advice=hits.advise(entry),
        )


def row_numbers(*columns: np.ndarray) -> np.ndarray:
    """Number rows so that equal rows have equal numbers, faster than sorting rows."""
    key = np.zeros(len(columns[0]), dtype=np.int64)
    for column in columns:
        values, number = np.unique(column, return_inverse=True)
        # Numbering anew in each step keeps the products from overflowing.
        _, key = np.unique(key * len(values) + number, return_inverse=True)
    return key


def groups_of(numbers: np.ndarray) -> list[np.ndarray]:
    """Return the indices of each group of equal numbers, lowest number first."""
    return (
        np.split(
            np.argsort(numbers, kind="stable"), np.cumsum(np.bincount(numbers))[:-1]
        )
        if len(numbers)
        else []
    )
