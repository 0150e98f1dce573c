"""Group what a rule says of many shapes or pairs at once into findings."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from newton_lint.findings import Advice, Finding
from newton_lint.source import Element


@dataclass(frozen=True)
class Hits:
    """Hits of a rule on one parameter, of which all say the same; arrays of one length."""

    rule: str
    parameter: str
    shape: np.ndarray
    other: np.ndarray | None
    """The other shape of a pair; None where it is about shapes alone."""
    value: np.ndarray
    used: np.ndarray | float
    """One of all, or of each; NaN where nothing is used."""
    message: str
    unit: str = "1"
    severity: str = "warning"
    element: Callable[[int], Element | None] = lambda _: None
    advise: Callable[[int], Advice | None] = lambda _: None


def findings_of(found: Hits, names: Sequence[str]) -> Iterator[Finding]:
    """Yield a finding for each shape and each value that it has and gets, in the order in which they were hit."""
    if not len(found.shape):
        return
    all_used = np.broadcast_to(found.used, len(found.shape))
    first, which = alike(found.shape, found.value, np.nan_to_num(all_used, nan=np.inf))
    members = np.split(np.argsort(which, kind="stable"), np.cumsum(np.bincount(which))[:-1])
    for index, hit in sorted(zip(first.tolist(), members, strict=True), key=lambda each: each[0]):
        used = float(all_used[index])
        yield Finding(
            rule=found.rule,
            shape=names[found.shape[index]],
            against=() if found.other is None else tuple(names[other] for other in found.other[hit].tolist()),
            parameter=found.parameter,
            value=float(found.value[index]),
            used=None if np.isnan(used) else used,
            unit=found.unit,
            message=found.message,
            severity=found.severity,
            element=found.element(index),
            advice=found.advise(index),
        )


def alike(*columns: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Return first index of each different row, and the number of each row's; faster than to sort the rows as such."""
    key = np.zeros(len(columns[0]), dtype=np.int64)
    for column in columns:
        values, which = np.unique(column, return_inverse=True)
        _, key = np.unique(key * len(values) + which.reshape(-1), return_inverse=True)
        key = key.reshape(-1)
    _, first, which = np.unique(key, return_index=True, return_inverse=True)
    return first, which.reshape(-1)
