"""Test the alarm in every section: it lists the changes, and no others.

The tracked results of 1.4.0 are compared with copies in which all numbers of a section
are larger. Repeated measurements are compared with each other.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations, product

import pytest
from toys import IS_WEEKLY

from measured_report.changes.moves import Move, moves_between
from measured_report.editions.status import records_of
from measured_report.files.columns import Schema
from measured_report.files.config import report
from measured_report.findings.chapters import Chapter
from measured_report.findings.replicas import alike, read_replicas
from measured_report.records.record import Record
from measured_report.values.body import body_of
from measured_report.values.evidence import Evidence, repeats_of, scatters

STEP = 1 if IS_WEEKLY else 5
"""Step between the measurements that are compared: all of them in the weekly workflow,
and each fifth in the suite.
"""
SIDES = [(1.05, True), (1.05, False), (1.2, True), (10.0, False)]
"""Factors, each with whether one measurement is compared or all of them."""
pytestmark = pytest.mark.slow
LABEL = "1.4.0"
Measured = Mapping[tuple[str, str], Sequence[Record | None]]


@pytest.fixture(scope="module")
def chapters(editions) -> Mapping[str, Chapter]:
    return editions[LABEL].chapters


@pytest.fixture(scope="module")
def measured(editions) -> Measured:
    """Return all measurements of 1.4.0."""
    project = editions[LABEL].project
    shown = {record.section: record for record in records_of(project)}
    read, _ = read_replicas(project)
    replicas = [alike(shown, records) for records in read.values()]
    return {
        (LABEL, name): [record, *(records.get(name) for records in replicas)]
        for name, record in shown.items()
    }


@pytest.fixture(scope="module")
def evidence(editions) -> Mapping[str, Evidence]:
    return editions[LABEL].measurements.evidence


def evidence_of(measured: Measured) -> Mapping[str, Evidence]:
    """Return the evidence of 1.4.0's sections."""
    sections = body_of(measured, report().columns).sections
    return {
        name: each for (release, name), each in sections.items() if release == LABEL
    }


def side(
    chapter: Chapter, evidence: Evidence, record: Record, *, is_single: bool = True
) -> Chapter:
    """Return the chapter with only this record, or with the mean of all measurements."""
    if is_single:
        columns = chapter.results.columns
        is_noise = chapter.name == columns.settings.noise_section
        evidence = replace(evidence, count=1, numbers={}, edges=frozenset())
        if is_noise:
            evidence = replace(evidence, repeats=repeats_of(record.rows, columns))
    results = replace(chapter.results, record=record, evidence=evidence, derived={})
    return replace(chapter, results=results)


def scaled(record: Record, factor: float, columns: Schema) -> Record:
    """Return the record with all compared numbers multiplied by a factor."""
    rows = [
        {
            name: cell * factor
            if isinstance(cell, float) and scatters(columns[name])
            else cell
            for name, cell in row.items()
        }
        for row in record.rows
    ]
    return replace(record, rows=rows)


def listed(moves: Sequence[Move]) -> list[Move]:
    return [move for move in moves if move.is_real]


def is_timed_once(chapter: Chapter, evidence: Evidence) -> bool:
    """Return whether a section has only times, which were measured once.

    One measurement cannot show a change of 5 %, because hosts differ by more.
    """
    columns = chapter.results.columns
    numbers = {
        name
        for row in chapter.results.record.rows
        for name, cell in row.items()
        if isinstance(cell, float) and scatters(columns[name])
    }
    return evidence.count == 1 and all(columns[name].is_cost for name in numbers)


@pytest.fixture(scope="module")
def compared(chapters) -> list[Chapter]:
    """Return the sections that have numbers to compare."""
    sections = []
    for chapter in chapters.values():
        record = chapter.results.record
        if scaled(record, 2.0, chapter.results.columns) != record:
            sections.append(chapter)
    assert len(sections) >= 28
    return sections


@pytest.mark.parametrize(
    ("factor", "is_single"),
    [*product((1.05, 1.2, 10.0), (True, False))] if IS_WEEKLY else SIDES,
)
def test_a_change_of_a_section_is_listed_and_exceeds_its_threshold(
    compared, evidence, factor, is_single
):
    unlisted = []
    silent = []
    for chapter in compared:
        known = evidence[chapter.name]
        record = chapter.results.record
        larger = scaled(record, factor, chapter.results.columns)
        before = side(chapter, known, record, is_single=is_single)
        moves = listed(moves_between(before, side(chapter, known, larger)))
        if not moves and not (factor < 1.1 and is_timed_once(chapter, known)):
            unlisted.append(chapter.name)
        # Times may change by exactly their threshold.
        if not any(move.exceeds_threshold for move in moves):
            silent.append(chapter.name)
    assert unlisted == []
    if factor > 1.1:
        assert silent == []


def replicas_of(measured: Measured) -> Iterator[Mapping[str, Record]]:
    """Yield each measurement of 1.4.0 by section, first the one that is tracked."""
    of_release = {name: each for (_, name), each in measured.items()}
    count = max(map(len, of_release.values()))
    for index in range(count):
        yield {name: each[index] for name, each in of_release.items() if each[index]}


def test_nothing_is_listed_between_two_measurements_of_one_release(
    compared, evidence, measured
):
    alarms = []
    found = []
    for a, b in [*combinations(replicas_of(measured), 2)][::STEP]:
        moves = []
        for chapter in compared:
            name = chapter.name
            if name in a and name in b:
                sides = [side(chapter, evidence[name], each[name]) for each in (a, b)]
                moves += listed(moves_between(*sides))
        alarms += [move.name for move in moves if move.exceeds_threshold]
        found.append(len(moves))
    assert len(found) >= 50 // STEP
    assert alarms == []
    # FALSE_SHARE of the listed changes may be false.
    assert max(found) <= 1


def test_a_measurement_that_is_left_out_is_the_same_as_the_others(compared, measured):
    tracked, *replicas = replicas_of(measured)
    by_size = sorted(enumerate(replicas, 1), key=lambda pair: -len(pair[1]))
    for index, replica in by_size[::STEP]:
        others = {
            (release, name): [*each[:index], None, *each[index + 1 :]]
            for (release, name), each in measured.items()
            if name in replica
        }
        known = evidence_of(others)
        alarms = []
        for chapter in compared:
            name = chapter.name
            if name in replica:
                before = side(chapter, known[name], tracked[name], is_single=False)
                after = side(chapter, known[name], replica[name])
                moves = listed(moves_between(before, after))
                alarms += [move.name for move in moves if move.exceeds_threshold]
        assert alarms == []
