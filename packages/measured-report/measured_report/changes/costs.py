"""Costs: what says how long something takes or how much room, and what must be the same for two of them to compare."""

from collections.abc import Collection, Mapping
from typing import Any

from measured_report.files.config import config
from measured_report.pages.chapters import Chapters
from measured_report.parts.claim import Claim
from measured_report.records.columns import column_of
from measured_report.records.record import Record
from measured_report.values.noise import NOISE


def is_cost(column: str) -> bool:
    return "cost" in column_of(column).kinds


def cost_terms(record: Record, row: Mapping[str, Any]) -> tuple:
    """Return what two costs must share to be compared: the machine, and how many frames and worlds."""
    return record.machine_for_speed, *(row.get(column) for column in config().cost_terms)


def terms_of(section: str, claim: Claim, chapters: Chapters) -> frozenset[tuple]:
    """Return what a claim turns on that is of the machine and not of the edition.

    Of costs that is what they were measured on and with, of the noise the processor; other claims have nothing of it.
    """
    if section == NOISE:
        return frozenset({(chapters[section].results.record.processor,)})
    costs = [pointer for pointer in claim.outcome.reads if is_cost(pointer.rpartition("/")[2])]
    return frozenset(cost_terms(record, row) for record, row, _ in cells(costs, chapters))


def cells(pointers: Collection[str], chapters: Chapters) -> list[tuple[Record, Mapping[str, Any], str]]:
    """Return record, row and column of each pointer to a cell of the edition's own records."""
    found = []
    for pointer in sorted(pointers):
        source, _, place = pointer.partition("#/rows/")
        index, _, column = place.partition("/")
        chapter = chapters.get(source.rpartition("/")[2].removesuffix(".json"))
        if place and chapter and chapter.results.source == source:
            record = chapter.results.record
            found.append((record, record.rows[int(index)], column))
    return found
