"""Fronts of error and run time: the settings that no other one beats in both."""

from collections.abc import Iterable, Sequence

import numpy as np

from measured_report.values.results import Row


def front(rows: Iterable[Row], error: str, groups: Sequence[str] = ()) -> frozenset[str]:
    """The cases of the rows that have both and that no other has a smaller ``error`` in less time than.

    Only rows that are alike in the columns ``groups`` compete.
    """
    competing: dict[tuple, list[Row]] = {}
    for row in rows:
        if None not in (row[error].value, row.ms_per_s.value):
            competing.setdefault(tuple(row[name] for name in groups), []).append(row)
    cases: set[str] = set()
    for group in competing.values():
        best = pareto_front(*(np.array([row[column].value for row in group]) for column in (error, "ms_per_s")))
        cases |= {row.case for row, is_best in zip(group, best, strict=True) if is_best}
    return frozenset(cases)


def pareto_front(error: np.ndarray, cost: np.ndarray) -> np.ndarray:
    """Which points no other point beats: none is at most as far off at most as dear, and better in one; shape [n]."""
    no_worse = (error[None, :] <= error[:, None]) & (cost[None, :] <= cost[:, None])
    better = (error[None, :] < error[:, None]) | (cost[None, :] < cost[:, None])
    return ~(no_worse & better).any(axis=1)
