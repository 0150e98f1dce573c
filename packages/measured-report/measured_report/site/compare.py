"""Write the page that compares editions: their headlines, and each pair of them."""

import gzip
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

from markupsafe import Markup

from measured_report.changes.alarm import (
    diff_text,
    false_alarm_counts,
    rate_text,
    summary,
)
from measured_report.changes.compare import Comparison, compare
from measured_report.changes.moves import Move
from measured_report.changes.query import Query, points
from measured_report.files.columns import Schema
from measured_report.files.config import Config, Page
from measured_report.files.groups import grouped
from measured_report.findings.chapters import Releases
from measured_report.findings.editions import Edition
from measured_report.pages.prose import Templates
from measured_report.parts.macros import macros
from measured_report.parts.prose import Prose
from measured_report.values.format import format_number, unit_label

PAGE = Page("compare")
SHOWN = 3  # chosen: the largest number of changes that a table lists for each column


@dataclass(frozen=True)
class Pair:
    """Two editions, the older one first."""

    before: Edition
    after: Edition
    is_next: bool  # whether no other edition is between them

    @property
    def name(self) -> str:
        return f"{self.before.project.release}..{self.after.project.release}"

    @property
    def file(self) -> str:
        """Return the file of the list that ``make diff FORMAT=json`` prints."""
        return f"data/compare/{self.name}.json.gz"

    @cached_property
    def comparison(self) -> Comparison:
        # As in ``make diff``, claims that compare releases are left out.
        before, after = (
            replace(side, chapters=side.uncompared)
            for side in (self.before, self.after)
        )
        return compare(before, after)

    @property
    def lines(self) -> Iterator[tuple[Move, int, str]]:
        """Yield the most relevant changes of each column, the most relevant first.

        A change is followed by the number of changes that are left out after it, and by
        its relevance as text. All settings are listed.
        """
        columns = grouped(
            (move.name if move.is_setting else move.column.name, move)
            for move in self.comparison.moves
        )
        for column_moves in columns.values():
            largest = column_moves[:SHOWN]
            for number, move in enumerate(largest, 1):
                hidden_count = len(column_moves) - number if number == SHOWN else 0
                is_finite = math.isfinite(move.relevance)
                relevance = format_number(move.relevance) if is_finite else "new"
                yield move, hidden_count, relevance if move.relevance else ""

    @property
    def summary(self) -> str:
        return summary(self.comparison)

    def page_of(self, move: Move) -> Page:
        return self.before.chapters[move.section].page

    def content(self, settings: Config) -> tuple[Markup, bytes]:
        """Return its HTML and its file, from the cache if nothing changed."""
        inputs = [*_inputs(self.before), *_inputs(self.after), str(self.is_next)]
        return self.after.cache.value(
            f"{self.after.project.profile}.{self.name}",
            Path(__file__),
            inputs,
            lambda: (macros().pair(self, settings), self.json),
        )

    @property
    def json(self) -> bytes:
        """Return the list that ``make diff FORMAT=json`` prints, compressed."""
        rate = false_alarm_counts(self.before) + false_alarm_counts(self.after)
        # The claims have their wording already, so no template is read again.
        text = diff_text(
            self.comparison, rate_text(rate), "json", lambda _, claim: claim.text
        )
        return gzip.compress(f"{text}\n".encode(), mtime=0)


def _inputs(edition: Edition) -> Iterator[str]:
    """Yield everything on which a comparison with an edition depends."""
    yield f"{edition.folder} {edition.project.manifest} {edition.left_out}"
    for chapter in edition.chapters.values():
        yield chapter.key
        yield from (claim.text for claim in chapter.section.claims)


def compare_page(
    editions: Mapping[str, Edition], templates: Templates
) -> tuple[Prose, dict[str, bytes]] | None:
    """Return the page and its files, or None without two editions to compare."""
    measured = [edition for edition in editions.values() if edition.chapters]
    if len(measured) < 2:
        return None
    columns = measured[0].report.columns
    settings = columns.settings
    # A page of the report with this name has the same file, and replaces this one.
    if PAGE.name in {page.name for page in settings.pages}:
        return None
    pairs = [
        Pair(before, after, is_next=place == 0)
        for index, before in enumerate(measured)
        for place, after in enumerate(measured[index + 1 :])
    ]
    # The script shows the first pair: the two newest releases, without trials.
    pairs.reverse()
    pairs.sort(key=lambda pair: pair.after.project.release in settings.trials)
    contents = {pair.file: pair.content(settings) for pair in pairs}
    names = {
        "headlines": _headlines(
            {name: edition.chapters for name, edition in editions.items()}, columns
        ),
        "pairs": [html for html, _ in contents.values()],
    }
    page = templates.prose("compare.md.j2", PAGE.name, names, level=1)
    return page, {file: content for file, (_, content) in contents.items()}


def _headlines(releases: Releases, columns: Schema) -> Any:
    """Return a table of the headlines that at least two editions have, or None."""
    rows = []
    for label, value in columns.settings.changes.headlines.items():
        query = Query(value)
        marks = {point.release: point.mark for point in points(releases, query)}
        if len(marks) > 1:
            quantities = {name: query.quantity(releases[name]) for name in marks}
            # The row has the unit, so the numbers are printed without it.
            numbers = {
                name: getattr(quantity, "bare", quantity)
                for name, quantity in quantities.items()
            }
            name = f"{label} [{unit_label(columns[query.column].unit)}]"
            rows.append((name, numbers, marks))
    return macros().series(rows, columns.settings, list(releases)) if rows else None
