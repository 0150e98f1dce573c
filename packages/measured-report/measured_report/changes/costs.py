"""Costs: what says how long something takes or how much room, and what must be the same for two of them to compare."""

from collections.abc import Collection, Iterable, Mapping
from datetime import timedelta
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


def is_timed(record: Record) -> bool:
    """Tell whether it says how long something takes, in numbers that are compared."""
    kinds = (column_of(name).kinds for name in record.units)
    return any("cost" in each and "chance" not in each for each in kinds)


def beside(record: Record, others: Iterable[Record]) -> list[Record]:
    """Return those that were measured on the same host while this one was timed; none where no host is known.

    Where they may have taken turns they don't count: they overlap for no longer than this one was not timed and the
    other not measured.
    """
    host = record.machine.get("host")
    there = [other for other in others if other is not record and host and other.machine.get("host") == host]
    timed = _seconds(record, "alone") or [_measured_s(record)]
    untimed = _rest(record, sum(timed))
    return [other for other in there if _overlap(record, other) > untimed + _rest(other, _measured_s(other))]


def _overlap(record: Record, other: Record) -> timedelta:
    (started, ended), (other_started, other_ended) = record.span, other.span
    return min(ended, other_ended) - max(started, other_started)


def _rest(record: Record, seconds: float) -> timedelta:
    """Return what is left of the time between its beginning and its end, which are told to the second."""
    started, ended = record.span
    return max(timedelta(seconds=1), ended - started - timedelta(seconds=seconds))


def _measured_s(record: Record) -> float:
    """Sum for how long it was measured at least: its batches that were not alone may have been beside each other."""
    alone, shared = _seconds(record, "alone"), _seconds(record, "batch")
    return sum(alone) + max(shared, default=0.0) if alone or shared else record.measured["seconds"]


def _seconds(record: Record, kind: str) -> list[float]:
    return [value for name, value in record.measured.items() if name.startswith(f"{kind}_")]


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
