"""Compare two releases seed by seed, because an episode depends only on its seed and
the release.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from math import comb

import pandas as pd

from measured_report.findings.chapters import Releases
from measured_report.parts.section import Table
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row

LEVEL = 0.05
"""The share of releases without a change that may be listed, over all tasks that are tested."""
OPPOSITES = (("lost", "gained"), ("slower", "faster"))
FAILED = "-"
STATE = re.compile(".{1,4}")  # the digits of an episode's final state


def rows_of(releases: Releases, section: str, task: str) -> dict[str, Row]:
    """Return the row of a task in each release that ran it, oldest first."""
    measured = {
        release: chapters[section].results
        for release, chapters in releases.items()
        if section in chapters
    }
    rows = {release: results.row[task] for release, results in measured.items()}
    return {
        release: row
        for release, row in rows.items()
        if row and row.success_count.value is not None
    }


def sign_test(less: int, more: int) -> float:
    """Return the probability of a split at least as uneven, by the exact McNemar test."""
    count = less + more
    return min(
        1.0,
        2.0
        * sum(comb(count, each) for each in range(min(less, more) + 1))
        / 2.0**count,
    )


@dataclass(frozen=True)
class Step:
    """Compares a task in two consecutive releases."""

    task: str
    releases: tuple[str, str]
    rows: tuple[Row, Row]

    @cached_property
    def counts(self) -> dict[str, int]:
        """Return the number of episodes that differ, for each kind of difference.

        Only seeds that ran in both releases are compared.
        """
        pairs = list(zip(*(row.steps.split() for row in self.rows), strict=False))
        lengths = [
            (int(old), int(new)) for old, new in pairs if FAILED not in (old, new)
        ]
        states = zip(*(STATE.findall(row.states) for row in self.rows), strict=False)
        return {
            "lost": sum(old != FAILED == new for old, new in pairs),
            "gained": sum(old == FAILED != new for old, new in pairs),
            "slower": sum(old < new for old, new in lengths),
            "faster": sum(old > new for old, new in lengths),
            "other_motion": sum(old != new for old, new in states),
        }

    def beyond_chance(self, tests: int) -> set[str]:
        """Return the kinds of difference that are more frequent than chance explains.

        Over all ``tests`` together, chance alone gives such a difference in 5 % of releases.
        """
        counts = self.counts
        pairs = [
            pair
            for pair in OPPOSITES
            if sign_test(counts[pair[0]], counts[pair[1]]) < LEVEL / tests
        ]
        return {max(pair, key=counts.__getitem__) for pair in pairs}


def steps_of(releases: Releases, section: str, tasks: Sequence[str]) -> Iterator[Step]:
    """Yield each task for each two consecutive releases that ran it."""
    for task in tasks:
        for (old, before), (new, after) in pairwise(
            rows_of(releases, section, task).items()
        ):
            yield Step(task, (old, new), (before, after))


def counted(
    results: Results, name: str, difference: str, steps: Sequence[Step]
) -> Value:
    """Return the number of episodes with this kind of difference, as a value of ``results``."""
    count, cells = (
        sum(step.counts[difference] for step in steps),
        [row.success_count for step in steps for row in step.rows],
    )
    formula = f"episodes of the same seeds: {difference.replace('_', ' ')}"
    return results.value(
        f"{difference}_{name}", formula, lambda *_: count, *cells, across=True
    )


def changes(results: Results, steps: Sequence[Step], tests: int) -> Table:
    """Return a table of the steps that differ by more than chance explains."""
    real_steps = [step for step in steps if step.beyond_chance(tests)]
    real_steps.sort(
        key=lambda step: (list(map(int, step.releases[1].split("."))), step.task)
    )
    names = [difference for pair in OPPOSITES for difference in pair]
    lines = [
        {"MuJoCo": " → ".join(step.releases)}
        | {
            difference: counted(
                results, f"{step.task}_{step.releases[1]}", difference, [step]
            )
            for difference in names
        }
        for step in real_steps
    ]
    index = pd.Index([step.task for step in real_steps], name="task")
    return Table(
        pd.DataFrame(lines, index=index, columns=["MuJoCo", *names], dtype=object)
    )
