"""What two releases do with the same seeds: an episode depends on its seed and the release alone."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import comb

import pandas as pd

from measured_report.pages.editions import Releases
from measured_report.parts.section import Table
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row

LEVEL = 0.05
"""Share of releases without a change that may raise an alarm, over all tasks that are tested."""
FAILED, DIGITS = "-", 4


def rows_of(releases: Releases, section: str, task: str) -> dict[str, Row]:
    """The row of a task in each release that ran it, oldest first."""
    there = {release: chapters[section].results for release, chapters in releases.items() if section in chapters}
    rows = {release: results.row[task] for release, results in there.items()}
    return {release: row for release, row in rows.items() if row and row.success_count.value is not None}


def sign_test(less: int, more: int) -> float:
    """Chance of so uneven a split or a more uneven one, if either side is as likely: the exact McNemar test."""
    count = less + more
    return min(1.0, 2.0 * sum(comb(count, each) for each in range(min(less, more) + 1)) / 2.0**count)


@dataclass(frozen=True)
class Step:
    """A task in two releases, one after the other, and in how many of its episodes they differ."""

    task: str
    releases: tuple[str, str]
    rows: tuple[Row, Row]

    @property
    def pairs(self) -> Sequence[tuple[str, str]]:
        """Steps to success of each seed that both have, or that it failed; all begin with the same."""
        return list(zip(*(row.steps.split() for row in self.rows), strict=False))

    @property
    def lost(self) -> int:
        return sum(old != FAILED == new for old, new in self.pairs)

    @property
    def gained(self) -> int:
        return sum(old == FAILED != new for old, new in self.pairs)

    @property
    def slower(self) -> int:
        return sum(FAILED not in pair and int(pair[1]) > int(pair[0]) for pair in self.pairs)

    @property
    def faster(self) -> int:
        return sum(FAILED not in pair and int(pair[1]) < int(pair[0]) for pair in self.pairs)

    @property
    def other_states(self) -> int:
        """Episodes that do not end in the same state to the last bit."""
        old, new = ([row.states[at : at + DIGITS] for at in range(0, len(row.states), DIGITS)] for row in self.rows)
        return sum(a != b for a, b in zip(old, new, strict=False))

    def is_beyond_chance(self, kind: str, tests: int) -> bool:
        """Whether ``success`` or ``time`` differs beyond what chance does in one of 20 releases, over all ``tests``."""
        split = (self.lost, self.gained) if kind == "success" else (self.slower, self.faster)
        return sign_test(*split) < LEVEL / tests

    def value(self, results: Results, what: str) -> Value:
        """One of its counts as a value of ``results``."""
        count, cells = getattr(self, what), [row.success_count for row in self.rows]
        name, formula = f"{what}_{self.task}_{self.releases[1]}", f"episodes {what}, of the same seeds"
        return results.value(name, formula, lambda *_: count, *cells, across=True)


def steps_of(releases: Releases, section: str, tasks: Sequence[str]) -> Iterator[Step]:
    """Each task in each two neighbouring releases that ran it."""
    for task in tasks:
        for (old, before), (new, after) in pairwise(rows_of(releases, section, task).items()):
            yield Step(task, (old, new), (before, after))


def changes(results: Results, steps: Sequence[Step], tests: int) -> Table:
    """Every step that differs beyond chance, in whether or in when an episode succeeds."""
    found = [step for step in steps if any(step.is_beyond_chance(kind, tests) for kind in ("success", "time"))]
    found.sort(key=lambda step: (list(map(int, step.releases[1].split("."))), step.task))
    counts = ("lost", "gained", "slower", "faster")
    lines = [
        {"MuJoCo": " → ".join(step.releases)} | {what: step.value(results, what) for what in counts} for step in found
    ]
    names = pd.Index([step.task for step in found], name="task")
    return Table(pd.DataFrame(lines, index=names, columns=["MuJoCo", *counts], dtype=object))
