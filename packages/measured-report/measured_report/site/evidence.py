"""Collect the evidence of the numbers on a page: their rows and measurements."""

import re
from collections.abc import Iterable, Mapping
from functools import cached_property
from itertools import islice
from typing import Any

from measured_report.findings.chapters import Chapter
from measured_report.findings.editions import Edition
from measured_report.values.results import MEANS

FEW = 6  # chosen: the largest number of rows that are listed for a derived number
ROW = re.compile(
    rf"""
    (?P<folder>[^/]+)/
    (?: (?P<record>\w+)\.json\#/rows/(?P<index>\d+)/
      | values\.json\#/(?P<section>\w+)/{MEANS}\.(?P<of_mean>\d+)\. )
    """,
    re.VERBOSE,
)
"""Matches a pointer to a cell of a row, or to the mean of its measurements."""


class Evidence:
    """The rows and records of all editions, by their pointers below ``data/``."""

    def __init__(self, editions: Mapping[str, Edition]):
        self.chapters = {
            chapter.results.source: (edition, chapter)
            for edition in editions.values()
            for chapter in edition.chapters.values()
        }

    @cached_property
    def values(self) -> dict[str, Any]:
        return {
            value.source: value
            for _, chapter in self.chapters.values()
            for value in chapter.results.derived.values()
        }

    def describe(self, pointers: Iterable[str]) -> dict[str, Any]:
        """Return the rows that each derived number depends on, and describe all rows.

        A derived number has the count of its rows and the positions of the first few.
        """
        derived: dict[str, list[int]] = {}
        rows: dict[str, list[str]] = {}
        records: dict[str, dict[str, str]] = {}
        for pointer in dict.fromkeys(pointers):
            value = self.values.get(pointer)
            matches = map(ROW.match, sorted(value.roots) if value else [pointer])
            cells = dict.fromkeys(map(_cell, filter(None, matches)))
            cells_by_name = {
                f"{file}#/rows/{index}": (file, index)
                for file, index in cells
                if file in self.chapters
            }
            listed = dict(islice(cells_by_name.items(), FEW))
            for name, (file, index) in listed.items():
                edition, chapter = self.chapters[file]
                rows.setdefault(name, _description(chapter, index))
                if file not in records:
                    records[file] = _measurement(edition, chapter)
            if value:
                # Positions instead of names, because many numbers share their rows.
                derived[pointer] = [len(cells_by_name), *map(list(rows).index, listed)]
        return {"derived": derived, "rows": rows, "records": records}


def _cell(match: re.Match[str]) -> tuple[str, int]:
    """Return the record and the index of the row to which a pointer leads."""
    file = f"{match['folder']}/{match['record'] or match['section']}.json"
    return file, int(match["index"] or match["of_mean"])


def _description(chapter: Chapter, index: int) -> list[str]:
    """Return the case of a row, and the parameters in which it differs."""
    columns = chapter.results.columns
    row = chapter.results.record.rows[index]
    return [row["case"], columns.changes_text(row) or columns.settings.baseline]


def _measurement(edition: Edition, chapter: Chapter) -> dict[str, str]:
    """Return the release, machine, time, command and code of a record, by label."""
    record = chapter.results.record
    commit = record.measured["commit"]
    device = record.machine["device"]
    return {
        "Release": edition.report.settings.name_of(record.origin.release),
        "Machine": record.machine_in_full,
        "Measured": record.time_text + (f", commit {commit}" if commit else ""),
        "Measure again": edition.project.rerun(chapter.name, device),
        "Code": ", ".join(f"{path}:{line}" for path, line in chapter.code),
    }
