"""One body of evidence: the measurements of all editions, read together.

``body_of`` gathers each number's measurements, fits how the numbers of a column in a
section scatter in all editions, and returns what that says of each edition's numbers. It
also checks itself: each measurement is left out in turn and predicted from the others.
"""

from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from statistics import fmean
from typing import Any

import numpy as np

from measured_report.files.columns import Column, Schema
from measured_report.files.groups import single
from measured_report.records.record import Record
from measured_report.values.evidence import (
    HOST_FREEDOM,
    HOST_SHARE,
    MEAN,
    Cells,
    Evidence,
    Key,
    Number,
    Place,
    Several,
    ending_of,
    is_absolute,
    is_lost,
    key_of,
    place_of,
    repeats_of,
    scatters,
)
from measured_report.values.noise import SURE, chance_of, discoveries, exceeds_chance
from measured_report.values.scatter import SLOPES, Fit, fit_of, left_out

MOST_DISSENT = (
    1 / 3
)  # chosen: a larger share of other endings makes a row one of chance
ODD_ROWS = 0.02
"""Chosen: how many rows of a section end otherwise by chance in one measurement, where all
measurements of it agree."""
KINDS = ("physics", "times", "ratios")  # numbers whose calibration is counted apart

Section = tuple[str, str]  # an edition, and the name of a section
Line = tuple[str, Key, str]  # an edition, and the row and the column of a number
Samples = dict[Line, list[float | None]]  # of each number, by measurement
Columns = dict[tuple[str, Place], Samples]  # by section
Fits = dict[tuple[str, Place], Fit]


@dataclass(frozen=True)
class Body:
    """Holds the evidence of each section of each edition, and how well it predicts."""

    sections: Mapping[Section, Evidence] = field(default_factory=dict)
    calibration: Mapping[str, tuple[int, int]] = field(default_factory=dict)
    """By kind of number: how many measurements lie within the noise that the others
    predict, and of how many."""


def body_of(
    measured: Mapping[Section, Sequence[Record | None]], columns: Schema
) -> Body:
    """Return the evidence of all sections of all editions.

    ``measured`` has the records of each section: first the one that is shown, then its
    replicas, None where a replica lacks the section.
    """
    gathered = {place: _Gathered(each, columns) for place, each in measured.items()}
    samples: Columns = defaultdict(dict)
    for (edition, section), found in gathered.items():
        for place, key, name, line in found.numbers:
            samples[section, place][edition, key, name] = line
    fits = _fits(samples, columns)
    numbers, apart = _numbers(samples, fits)
    odd_rows = _odd_rows(gathered, apart)
    chances = _predict(samples, fits)
    host = _host_scatter(samples, fits, columns)
    sections = {}
    for (edition, section), found in gathered.items():
        noise = measured.get((edition, columns.settings.noise_section), [None])[0]
        of_section = [
            (line[1], of_line)
            for (name, _), lines in chances.items()
            if name == section
            for line, of_line in lines.items()
            if line[0] == edition
        ]
        sections[edition, section] = Evidence(
            count=found.count,
            numbers=numbers[edition, section],
            scatters={
                place: fit.scatter
                for (name, place), fit in fits.items()
                if name == section
            },
            repeats=repeats_of(noise.rows if noise else (), columns),
            edges=frozenset(found.edges),
            odd_rows=odd_rows.get(section),
            host=host,
            changed=_changed(of_section, odd_rows.get(section, 0.0)),
        )
    return Body(sections, _calibration(chances, columns))


class _Gathered:
    """Gathers the measurements of one section of one edition."""

    def __init__(self, records: Sequence[Record | None], columns: Schema):
        shown = records[0]
        assert shown, "the record that is shown comes first"
        self.columns = columns
        self.count = sum(record is not None for record in records)
        self.edges: set[Key] = set()  # rows of which chance decides how they end
        self.dissenting = 0  # rows of a measurement that end unlike all others
        self.is_alike = [
            record is not None and record.machine_for_speed == shown.machine_for_speed
            for record in records
        ]
        rows = [
            rows_by_key(record.rows if record else (), columns) for record in records
        ]
        self.numbers = list(self._numbers(rows))

    def _numbers(
        self, rows: Sequence[Mapping[Key, Cells]]
    ) -> Iterator[tuple[Place, Key, str, list[float | None]]]:
        """Yield each number of the record that is shown, with all its measurements."""
        for key, row in rows[0].items():
            of_row = self._agreeing(key, [each.get(key) for each in rows])
            is_mean = key[0] == MEAN
            if is_lost(row, self.columns):
                continue
            for name, cell in row.items():
                column = self.columns[name]
                if cell is None or isinstance(cell, str | bool) or not scatters(column):
                    continue
                place = (MEAN, name) if is_mean else place_of(name, row, self.columns)
                samples = [each.get(name) if each else None for each in of_row]
                if is_absolute(column):
                    pairs = zip(samples, self.is_alike, strict=True)
                    samples = [
                        sample if is_alike else None for sample, is_alike in pairs
                    ]
                yield place, key, name, samples

    def _agreeing(self, key: Key, rows: list[Cells | None]) -> list[Cells | None]:
        """Return the measurements of a row without the few that end otherwise.

        If more than a third do, or the one that is shown does, the row is at an edge.
        """
        endings = [ending_of(row, self.columns) if row else None for row in rows]
        others = [ending not in (None, endings[0]) for ending in endings]
        if not any(others):
            return rows
        if sum(others) > MOST_DISSENT * sum(row is not None for row in rows):
            self.edges.add(key)
            return rows
        self.dissenting += sum(others)
        return [
            None if is_other else row
            for row, is_other in zip(rows, others, strict=True)
        ]


def rows_by_key(rows: Sequence[Cells], columns: Schema) -> dict[Key, Cells]:
    """Return the rows of a record by their keys, without those that share one.

    The mean of the runs of one case is a row of its own for each column.
    """
    singles = [row for row in rows if "of" not in row]
    by_key = single((key_of(row, columns), row) for row in singles)
    for case, runs in repeats_of(rows, columns).items():
        by_key |= {(MEAN, case, name): {name: runs[name].mean} for name in runs}
    return by_key


def kind_of(column: Column) -> str:
    """Return the kind of a number, one of ``KINDS``."""
    if not column.is_cost:
        return "physics"
    return "times" if is_absolute(column) else "ratios"


def _column(place: Place, columns: Schema) -> Column:
    return columns[place[1] if place[0] == MEAN else place[0]]


def _array(lines: Samples) -> Any:
    """Return samples by number and measurement, NaN where there is none."""
    width = max(map(len, lines.values()))
    array = np.full((len(lines), width), np.nan)
    for index, line in enumerate(lines.values()):
        array[index, : len(line)] = [np.nan if x is None else x for x in line]
    return array


def _fits(samples: Columns, columns: Schema) -> Fits:
    """Fit the numbers of each column in each section.

    A column with few numbers in one section scatters as it does in all sections.
    """
    together: dict[Place, Samples] = defaultdict(dict)
    for (section, place), lines in samples.items():
        for (edition, key, name), line in lines.items():
            together[place][edition, (section, *key), name] = line
    general = {}
    for place, lines in together.items():
        slopes = _slopes(place, columns)
        rows: list[Any] = [line[1] for line in lines]
        if fit := fit_of(_array(lines), rows, slopes=slopes):
            general[place] = fit.scatter
    fits = {}
    for (section, place), lines in samples.items():
        rows = [line[1] for line in lines]
        slopes = _slopes(place, columns)
        if fit := fit_of(_array(lines), rows, general.get(place), slopes):
            fits[section, place] = fit
    return fits


def _slopes(place: Place, columns: Schema) -> Sequence[float]:
    """Return how the noise of a column may go with its numbers: costs are in proportion."""
    return SLOPES[:1] if _column(place, columns).is_cost else SLOPES


def _numbers(
    samples: Columns, fits: Fits
) -> tuple[dict[Section, dict[Number, Several]], dict[Section, set[tuple[Key, int]]]]:
    """Return the numbers that were measured several times, by section, and which of their
    measurements lie far from all others: the row, and which measurement."""
    numbers: dict[Section, dict[Number, Several]] = defaultdict(dict)
    apart: dict[Section, set[tuple[Key, int]]] = defaultdict(set)
    for (section, place), lines in samples.items():
        fit = fits.get((section, place))
        for index, ((edition, key, name), line) in enumerate(lines.items()):
            present = [sample for sample in line if sample is not None]
            if len(present) < 2:
                continue
            odd = np.flatnonzero(fit.apart[index, : len(line)]).tolist() if fit else []
            apart[edition, section] |= {(key, measurement) for measurement in odd}
            value = float(fit.values[index]) if fit else fmean(present)
            if len({*present}) == 1:
                value = present[0]  # not moved by rounding
            entry = Several(value, line, len(present), len(odd))
            numbers[edition, section][key, name] = entry
    return numbers, apart


def _predict(samples: Columns, fits: Fits) -> dict[tuple[str, Place], dict[Line, Any]]:
    """Return how often chance puts each measurement so far from the others of its number,
    NaN where that is not known."""
    chances = {}
    for place, fit in fits.items():
        lines = samples[place]
        found = left_out(_array(lines), [line[1] for line in lines], fit)
        of_place = np.array(chance_of(found.distances, found.errors, found.freedoms))
        of_place = np.where(np.isnan(found.distances), np.nan, of_place)
        chances[place] = dict(zip(lines, of_place, strict=True))
    return chances


def _calibration(
    chances: Mapping[tuple[str, Place], Mapping[Line, Any]], columns: Schema
) -> dict[str, tuple[int, int]]:
    """Return by kind how many measurements lie within the noise that others predict."""
    counts = dict.fromkeys(KINDS, (0, 0))
    for (_, place), lines in chances.items():
        kind = kind_of(_column(place, columns))
        known = np.concatenate([line[~np.isnan(line)] for line in lines.values()])
        inside, total = counts[kind]
        inside += int((known >= 1 - SURE).sum())
        counts[kind] = inside, total + len(known)
    return counts


def _changed(
    chances: Sequence[tuple[Key, Any]], odd_rows: float
) -> list[tuple[int, int]]:
    """Return how many numbers a measurement has, and how many seem to have changed.

    Nothing changed between measurements, so this is how often the comparison is wrong.
    """
    by_measurement: dict[int, dict[Key, list[float]]] = {}
    for key, line in chances:
        for index in np.flatnonzero(~np.isnan(line)):
            rows = by_measurement.setdefault(int(index), {})
            rows.setdefault(key, []).append(float(line[index]))
    counts = []
    for rows in by_measurement.values():
        known = [chance for of_row in rows.values() for chance in of_row]
        limit = discoveries(known)
        changed = [sum(c <= limit for c in of_row) for of_row in rows.values()]
        row_count = sum(map(bool, changed)) if limit else 0
        is_told = exceeds_chance(row_count, odd_rows)
        counts.append((len(known), sum(changed) if is_told else 0))
    return counts


def _odd_rows(
    gathered: Mapping[Section, _Gathered], apart: Mapping[Section, set[tuple[Key, int]]]
) -> dict[str, float]:
    """Return by section how many rows of one measurement end unlike all others."""
    odd: Counter[str] = Counter()
    measurements: Counter[str] = Counter()
    for (edition, section), found in gathered.items():
        if found.count > 1:
            odd[section] += found.dissenting + len(apart[edition, section])
            odd[section] += len(found.edges)
            measurements[section] += found.count
    return {
        section: (odd[section] + ODD_ROWS) / count
        for section, count in measurements.items()
    }


def _host_scatter(samples: Columns, fits: Fits, columns: Schema) -> tuple[float, float]:
    """Return the relative variance of all times of a measurement together.

    For each section of an edition it is that of the median over all times of their
    logarithm less its mean; sections share it, and its degrees of freedom are those of
    the section that was measured most often.
    """
    shifts: dict[Section, list[Any]] = defaultdict(list)
    for (section, place), lines in samples.items():
        fit = fits.get((section, place))
        if fit is None or not is_absolute(_column(place, columns)):
            continue
        with np.errstate(divide="ignore", invalid="ignore"):
            logs = np.log(_array(lines) / fit.values[:, None])
        for (edition, *_), line in zip(lines, logs, strict=True):
            shifts[edition, section].append(line)
    squares = 0.0
    freedom = 0
    most = 0
    for lines_of_section in shifts.values():
        width = max(map(len, lines_of_section))
        by_measurement = np.stack(
            [line for line in lines_of_section if len(line) == width]
        )
        is_known = ~np.isnan(by_measurement).all(axis=0)
        medians = np.nanmedian(by_measurement[:, is_known], axis=0)
        squares += float(((medians - medians.mean()) ** 2).sum()) if len(medians) else 0
        freedom += max(0, len(medians) - 1)
        most = max(most, len(medians) - 1)
    if not freedom:
        return HOST_SHARE**2, HOST_FREEDOM
    weight = HOST_FREEDOM / (HOST_FREEDOM + freedom)
    return weight * HOST_SHARE**2 + (
        1 - weight
    ) * squares / freedom, HOST_FREEDOM + most
