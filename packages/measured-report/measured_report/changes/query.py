"""Look up claims and values by name and compare their answers between editions."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches
from itertools import pairwise
from statistics import fmean, median
from typing import Any

from measured_report.changes.moves import direction
from measured_report.editions.status import aligned
from measured_report.files.columns import PLAIN, Schema
from measured_report.findings.chapters import Chapters, Releases
from measured_report.parts.claim import Claim
from measured_report.values.noise import FALSE_SHARE, NORMAL, Z
from measured_report.values.quantities import Quantity, absent
from measured_report.values.results import Results, Row

Answer = str | float
LEAST_STEPS = 3  # chosen: fewer differences between neighbours do not show the noise


@dataclass(frozen=True)
class Query:
    """Holds the name of a claim or a value, and looks it up in editions."""

    text: str
    """The name in CLAIM= or VALUE=.

    It is ``section.claim``, ``section.value`` or ``section.case.column``.
    """
    is_claim: bool = False

    @property
    def section(self) -> str:
        return self.text.partition(".")[0]

    @property
    def case(self) -> str:
        """Return the case if this names a number of a row, or else an empty string."""
        return self.text.partition(".")[2].rpartition(".")[0]

    @property
    def column(self) -> str:
        return self.text.rpartition(".")[2]

    def answer(self, chapters: Chapters) -> Answer | None:
        """Return the answer of an edition, or None if the claim is undecided."""
        if self.is_claim:
            claim = self.claim(chapters)
            is_known = claim and claim.outcome.name != "unknown"
            return claim.outcome.name if claim and is_known else None
        quantity = self.quantity(chapters)
        value: Any = getattr(quantity, "value", quantity)
        return None if isinstance(value, str) else value

    def quantity(self, chapters: Chapters) -> Quantity | bool | str | None:
        """Return the number, text or flag with this name, or None if it does not exist."""
        if self.case:
            return self.cell(chapters)
        chapter = chapters.get(self.section)
        return chapter.results.derived.get(self.column) if chapter else None

    def cell(self, chapters: Chapters, release: str = "") -> Quantity:
        """Return a cell of a row in the edition ``release``, or an absent number."""
        columns = schema_of(chapters)
        equivalent = columns.settings.changes.equivalent_sections if columns else ()
        sections = (self.section, *(equivalent if self.section in equivalent else ()))
        rows = [
            self.row_of(chapters[name].results) for name in sections if name in chapters
        ]
        row = next(filter(None, rows), None)
        if row and self.column in row:
            return row[self.column]
        edition = (
            f" with {columns.settings.name_of(release)}" if columns and release else ""
        )
        unit = columns[self.column].unit if columns else PLAIN
        return absent(
            unit, f"section {self.section} has not been measured in this way{edition}"
        )

    def row_of(self, results: Results) -> Row | None:
        """Return the row of its case; a report can choose one among several."""
        return results.row[self.case]

    def claim(self, chapters: Chapters) -> Claim | None:
        chapter = chapters.get(self.section)
        claims = chapter.section.claims if chapter else ()
        names = [f"{self.section}.{claim.name}" for claim in claims]
        return claims[names.index(self.text)] if self.text in names else None

    def names(self, chapters: Chapters) -> Iterator[str]:
        """Yield the names that exist.

        For a claim, these are all claims. Otherwise they are all values, and the numbers of
        the rows in the query's section.
        """
        for name, chapter in chapters.items():
            claims = [claim.name for claim in chapter.section.claims]
            labels = claims if self.is_claim else chapter.results.derived
            yield from (f"{name}.{label}" for label in labels)
        if self.is_claim:
            return
        for name in get_close_matches(self.section, chapters, n=1):
            for case, row in chapters[name].results.row.items():
                numbers = [
                    column for column in row.plain if isinstance(row[column], Quantity)
                ]
                yield from (f"{name}.{case}.{column}" for column in numbers)

    def is_first(self, answer: Answer, first: Answer, last: Answer) -> bool:
        """Return whether an answer equals the first one.

        For a number, return whether it is nearer to the first than to the last.
        """
        if self.is_claim:
            return answer == first
        return abs(float(answer) - float(first)) < abs(float(answer) - float(last))


def schema_of(chapters: Chapters) -> Schema | None:
    """Return the schema of an edition's columns, or None if it has no results."""
    return next((chapter.results.columns for chapter in chapters.values()), None)


@dataclass(frozen=True)
class Point:
    """The answer of one edition."""

    release: str
    answer: Answer
    noise: float | None  # None if it is not known
    text: str
    mark: str = ""  # the change since the point before: better, worse, moved or flipped


def points(releases: Releases, query: Query) -> list[Point]:
    """Return a point for each edition that has an answer, oldest first."""
    all_points: list[Point] = []
    columns = None
    for release, chapters in releases.items():
        answer = query.answer(chapters)
        columns = columns or schema_of(chapters)
        if answer is None:
            continue
        claim = query.claim(chapters)
        noise = None if claim else getattr(query.quantity(chapters), "noise", None)
        text = claim.outcome.answer if claim else f"{answer:.4g}"
        text += f" ± {noise:.2g}" if noise else ""
        all_points.append(Point(release, answer, noise, text))
    # A trial is not a release, so it is not part of the series.
    trials = columns.settings.trials if columns else {}
    series = [point for point in all_points if point.release not in trials]
    marks = {}
    if query.is_claim:
        for index, (before, after) in enumerate(pairwise(series), 1):
            if before.answer != after.answer:
                marks[index] = "flipped"
    elif columns and series:
        column = columns[query.column]
        numbers = [float(point.answer) for point in series]
        noises = [point.noise for point in series]
        starts = changes_in(numbers, noises, column.resolution)
        ends = [0, *starts, len(numbers)]
        means = [fmean(numbers[start:end]) for start, end in pairwise(ends)]
        for start, (old, new) in zip(starts, pairwise(means), strict=True):
            marks[start] = direction(column, old, new) or "moved"
    by_release = {series[index].release: mark for index, mark in marks.items()}
    return [
        replace(point, mark=by_release.get(point.release, "")) for point in all_points
    ]


def changes_in(
    numbers: Sequence[float], noises: Sequence[float | None], resolution: float
) -> list[int]:
    """Return the positions at which a series of numbers changes.

    The series is split at the position at which its parts differ most, if this
    difference is significant. Each part is then split in the same way. This is the
    method of Scott and Knott (1974), Biometrics 30, 507-512, with a two-sample test
    that uses the noise. If a noise is not known, it is estimated from the differences
    between neighbours, or assumed to be 0 if there are fewer than ``LEAST_STEPS`` of
    them.
    """
    if None in noises:
        steps = [abs(after - before) for before, after in pairwise(numbers)]
        estimate = 0.0
        if len(steps) >= LEAST_STEPS:
            estimate = Z * median(steps) / (math.sqrt(2) * NORMAL.inv_cdf(0.75))
        noises = [estimate if noise is None else noise for noise in noises]
    count = len(numbers)
    known_noises = [noise or 0.0 for noise in noises]
    differences = {
        split: abs(fmean(numbers[split:]) - fmean(numbers[:split]))
        for split in range(1, count)
    }
    # The sum of squares between the two parts grows as the square of these numbers.
    weighted = {
        split: difference * math.sqrt(split * (count - split))
        for split, difference in differences.items()
    }
    best = max(weighted, key=weighted.__getitem__, default=0)
    if not best or differences[best] <= resolution:
        return []
    errors = (
        math.hypot(*known_noises[:best]) / best,
        math.hypot(*known_noises[best:]) / (count - best),
    )
    error = math.hypot(*errors) / Z
    chance = math.erfc(differences[best] / error / math.sqrt(2)) if error else 0.0
    # There are count - 1 possible splits (Bonferroni).
    if (count - 1) * chance > FALSE_SHARE:
        return []
    later = changes_in(numbers[best:], known_noises[best:], resolution)
    earlier = changes_in(numbers[:best], known_noises[:best], resolution)
    return [*earlier, best, *(best + index for index in later)]


def history(releases: Releases, query: Query) -> str:
    """Return a line for each edition with an answer or a reason, oldest first."""
    points_by_release = {point.release: point for point in points(releases, query)}
    lines = []
    for release, chapters in releases.items():
        if point := points_by_release.get(release):
            lines.append((release, point.text, point.mark))
        elif reason := _reason(query, chapters):
            lines.append((release, "cannot tell", reason))
    return "\n".join([query.text, aligned(lines) or "no edition can tell"])


def _reason(query: Query, chapters: Chapters) -> str:
    claim = query.claim(chapters)
    number = query.quantity(chapters)
    if claim:
        return claim.outcome.reason
    return number.reason if isinstance(number, Quantity) and number.source else ""
