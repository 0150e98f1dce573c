"""What a lint finds: of one thing, or of many shapes and pairs at once, which are grouped into findings."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from newton_lint.source import Element

SEVERITIES = ("note", "warning", "error")


@dataclass(frozen=True)
class Change:
    """A change of a file: attributes of one element, and the place."""

    subject: str
    """What has the attributes: a geom's name, or ``option``."""
    attributes: tuple[tuple[str, str], ...]
    element: Element | None = None
    """Where it stands; None where no file is known to say it."""

    def __str__(self) -> str:
        attributes = " ".join(f'{name}="{value}"' for name, value in self.attributes)
        place = (
            f" ({self.element.file.name}:{self.element.line})" if self.element else ""
        )
        return f"{attributes} on {self.subject}{place}"


@dataclass(frozen=True)
class Advice:
    """What changes gain and cost, the changes, and alternatives of which one is enough, the mildest first."""

    gain: str
    changes: tuple[Change, ...] = ()
    alternatives: tuple["Advice", ...] = ()
    """One that tells no gain is not said."""

    def __str__(self) -> str:
        first = (
            f"{', '.join(map(str, self.changes))}: {self.gain}"
            if self.changes
            else self.gain
        )
        return "; or ".join(
            [first, *(str(advice) for advice in self.alternatives if advice.gain)]
        )


@dataclass(frozen=True)
class Finding:
    """A thing that is authored and not what the solver does."""

    rule: str
    shape: str
    """Body and shape that it is about, as ``cube/box``; empty for what is said of the whole scene."""
    parameter: str
    value: float
    """As authored, or as what is authored comes out."""
    message: str
    against: tuple[str, ...] = ()
    """The other shapes of the pairs that it is about; empty where it is about the shape alone."""
    used: float | None = None
    """What is used instead; None where nothing is. Of a dampratio the critical one."""
    unit: str = "1"
    severity: str = "warning"
    element: Element | None = field(default=None, compare=False)
    advice: Advice | None = field(default=None, compare=False)


def distinct(changes: Iterable[Change]) -> tuple[Change, ...]:
    """Return changes without duplicates: a default's tag is the element of all geoms of its class."""
    return tuple(
        {
            (change.element or change.subject, change.attributes): change
            for change in changes
        }.values()
    )


def grouped(findings: Iterable[Finding]) -> list[list[Finding]]:
    """Return the findings that say the same, of whichever shapes, in the order of the first of each."""
    groups: dict[Finding, list[Finding]] = {}
    for finding in findings:
        groups.setdefault(replace(finding, shape="", against=()), []).append(finding)
    return list(groups.values())


@dataclass(frozen=True)
class Wording:
    """What a rule says of one parameter, wherever it hits."""

    rule: str
    parameter: str
    message: str
    unit: str = "1"
    severity: str = "warning"


@dataclass(frozen=True)
class Hits:
    """Hits of a rule, of which all say the same; arrays of one length."""

    wording: Wording
    shape: np.ndarray
    value: np.ndarray
    used: np.ndarray | float = np.nan
    """One of all, or of each; NaN where nothing is used."""
    partner: np.ndarray | None = None
    """The other shape of a pair; None where it is about shapes alone."""
    items: np.ndarray | None = None
    """What is asked for an element and an advice: geoms, or indices of pairs; None where there are none."""
    element: Callable[[int], Element | None] = lambda _: None
    advise: Callable[[int], Advice | None] = lambda _: None


def findings_of(hits: Hits, names: Sequence[str]) -> Iterator[Finding]:
    """Yield a finding for each shape and each value that it has and gets, in the order in which they were hit."""
    all_used = np.broadcast_to(hits.used, len(hits.shape))
    # NaN equals nothing, itself neither: each hit of which nothing is used would be a finding of its own.
    numbers = row_numbers(hits.shape, hits.value, np.nan_to_num(all_used, nan=np.inf))
    for member in sorted(groups_of(numbers), key=lambda member: member[0]):
        index = member[0]
        used = float(all_used[index])
        item = -1 if hits.items is None else int(hits.items[index])
        yield Finding(
            **vars(hits.wording),
            shape=names[hits.shape[index]],
            value=float(hits.value[index]),
            against=()
            if hits.partner is None
            else tuple(names[geom] for geom in hits.partner[member].tolist()),
            used=None if np.isnan(used) else used,
            element=hits.element(item),
            advice=hits.advise(item),
        )


def row_numbers(*columns: np.ndarray) -> np.ndarray:
    """Number rows so that equal ones have the same number; faster than to sort the rows as such."""
    key = np.zeros(len(columns[0]), dtype=np.int64)
    for column in columns:
        values, number = np.unique(column, return_inverse=True)
        _, key = np.unique(
            key * len(values) + number, return_inverse=True
        )  # anew, or the products would overflow
    return key


def groups_of(numbers: np.ndarray) -> list[np.ndarray]:
    """Return the indices of each number, by the numbers."""
    return (
        np.split(
            np.argsort(numbers, kind="stable"), np.cumsum(np.bincount(numbers))[:-1]
        )
        if len(numbers)
        else []
    )
