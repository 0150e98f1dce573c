"""Evaluate the measurements of all editions together.

``body_of`` gathers the measurements of each number, estimates from all editions how the
numbers of a column scatter, and returns the evidence of each section in each edition.
It also checks its own noise: each measurement is left out in turn and predicted from
the others.
"""

from collections import Counter, defaultdict
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from statistics import fmean
from typing import Any

import numpy as np

from measured_report.files.columns import Column, Schema, is_number
from measured_report.files.groups import grouped, single
from measured_report.records.record import Record
from measured_report.values.evidence import (
    HOST_FREEDOM,
    HOST_SHARE,
    MEAN,
    CellKey,
    Cells,
    ColumnKey,
    Evidence,
    RowKey,
    Several,
    column_key_of,
    ending_of,
    is_absolute,
    is_lost,
    key_of,
    repeats_of,
    scatters,
    split_repeats,
)
from measured_report.values.noise import (
    FALSE_SHARE,
    SURE,
    Scatter,
    chance_of,
    discoveries,
    exceeds_chance,
    fenced,
    rounding_variance,
)
from measured_report.values.scatter import (
    SLOPES,
    USUAL_FREEDOM,
    Fit,
    fit_of,
    left_out,
)

MOST_DISSENT = 1 / 3
"""Chosen: if a larger share of a row's measurements ends differently, the end of the
row is random, and none of its measurements is an outlier.
"""
ODD_ROWS = 0.02
"""Chosen: the number of rows that is added to the count of differently ended rows in
all measurements of a section. Without it, one odd row would count as a change if all
earlier ones agreed.
"""
KINDS = (
    "physics",
    "times",
    "ratios",
)  # kinds of numbers that are calibrated separately

SectionKey = tuple[str, str]  # an edition, and the name of a section
NumberKey = tuple[
    str, RowKey, str
]  # an edition, and the row and the column of a number
Samples = Mapping[NumberKey, Sequence[float | None]]  # each number by measurement
SamplesByColumn = Mapping[tuple[str, ColumnKey], Samples]  # by section and column
Fits = Mapping[tuple[str, ColumnKey], Fit]
Chances = Mapping[
    tuple[str, ColumnKey], Mapping[NumberKey, Any]
]  # arrays of probabilities


@dataclass(frozen=True)
class Body:
    """The evidence of each section in each edition, and the quality of its predictions."""

    sections: Mapping[SectionKey, Evidence] = field(default_factory=dict)
    calibration: Mapping[str, tuple[int, int]] = field(default_factory=dict)
    """For each kind of number: the count of measurements within the noise that the
    others predict, and the count of all measurements.
    """


def body_of(
    measured: Mapping[SectionKey, Sequence[Record | None]], columns: Schema
) -> Body:
    """Return the evidence of all sections in all editions.

    ``measured`` contains the records of each section: first the tracked one, then its
    replicas; None for a replica that lacks the section.
    """
    gathered = {
        key: _Gathered(key[1], records, columns) for key, records in measured.items()
    }
    # Times on a CPU that others use differ by more than times on an accelerator.
    devices = {
        section: records[0].machine["device"]
        for (_, section), records in measured.items()
        if records[0]
    }
    samples: dict[tuple[str, ColumnKey], dict[NumberKey, list[float | None]]]
    samples = defaultdict(dict)
    for (edition, section), measurements in gathered.items():
        for column_key, row_key, name, numbers in measurements.numbers:
            samples[section, column_key][edition, row_key, name] = numbers
    fits = _fits(samples, columns)
    several, outliers = _several(samples, fits)
    odd_rows = _odd_rows(gathered, outliers)
    chances = _chances(samples, fits)
    hosts = {
        device: _host_scatter(
            {key: each for key, each in samples.items() if devices[key[0]] == device},
            fits,
            columns,
        )
        for device in set(devices.values())
    }
    within = _within(gathered, columns, fits, several)
    repeats = {
        edition: repeats_of(measurements.rows, columns)
        for (edition, section), measurements in gathered.items()
        if section == columns.settings.noise_section
    }
    sections = {}
    for (edition, section), measurements in gathered.items():
        sections[edition, section] = Evidence(
            count=measurements.count,
            numbers=several[edition, section],
            scatters=within.get(section, {})
            | {
                column_key: fit.scatter
                for (name, column_key), fit in fits.items()
                if name == section
            },
            repeats=repeats.get(edition, {}),
            edges=frozenset(measurements.edges),
            odd_rows=odd_rows.get(section),
            host=hosts[devices[section]],
            changed=_changed(
                _row_chances(chances, edition, section), odd_rows.get(section, 0.0)
            ),
        )
    return Body(sections, _calibration(chances, columns))


class _Gathered:
    """Gathers the measurements of one section in one edition."""

    def __init__(self, section: str, records: Sequence[Record | None], columns: Schema):
        tracked = records[0]
        assert tracked, "the record that is shown comes first"
        self.columns = columns
        self.rows = tracked.rows
        _, self.repeats = split_repeats(tracked.rows, section, columns)
        self.count = sum(record is not None for record in records)
        self.edges: set[RowKey] = set()  # rows that end in one of two ways, by chance
        self.dissenting = (
            0  # rows of one measurement that end differently from the others
        )
        self.is_alike = [
            record is not None and record.machine_for_speed == tracked.machine_for_speed
            for record in records
        ]
        rows = [
            rows_by_key(record.rows if record else (), section, columns)
            for record in records
        ]
        self.numbers = list(self._numbers(rows))

    def _numbers(
        self, rows: Sequence[Mapping[RowKey, Cells]]
    ) -> Iterator[tuple[ColumnKey, RowKey, str, list[float | None]]]:
        """Yield each number of the tracked record with all its measurements."""
        for row_key, cells in rows[0].items():
            measured_rows = self._agreeing(
                row_key, [by_key.get(row_key) for by_key in rows]
            )
            if is_lost(cells, self.columns):
                continue
            for name in cells:
                column = self.columns[name]
                number = self.columns.number_of(name, cells)
                if not (is_number(number) and scatters(column)):
                    continue
                column_key = column_key_of(name, cells, self.columns)
                if row_key[0] == MEAN:
                    # A mean scatters less than one run, so it has a fit of its own.
                    column_key = MEAN, name
                samples = [
                    self.columns.number_of(name, row) if row and name in row else None
                    for row in measured_rows
                ]
                if is_absolute(column):
                    pairs = zip(samples, self.is_alike, strict=True)
                    samples = [
                        sample if is_alike else None for sample, is_alike in pairs
                    ]
                yield column_key, row_key, name, samples

    def _agreeing(self, key: RowKey, rows: list[Cells | None]) -> list[Cells | None]:
        """Return the measurements of a row without the few that end differently.

        If more than ``MOST_DISSENT`` of them end unlike the tracked one, all of them
        are returned, because the end of the row is random.
        """
        endings = [ending_of(row, self.columns) if row else None for row in rows]
        dissents = [ending not in (None, endings[0]) for ending in endings]
        if not any(dissents):
            return rows
        if sum(dissents) > MOST_DISSENT * sum(row is not None for row in rows):
            self.edges.add(key)
            return rows
        self.dissenting += sum(dissents)
        return [
            None if is_dissent else row
            for row, is_dissent in zip(rows, dissents, strict=True)
        ]


def rows_by_key(
    rows: Sequence[Cells], section: str, columns: Schema
) -> dict[RowKey, Cells]:
    """Return the rows of a record by their keys, except rows that share a key.

    The cost of a case is the mean of all its runs. In the section on noise, the mean of
    the runs of one case is a row of its own for each column, in place of the runs.
    """
    singles, repeats = split_repeats(rows, section, columns)
    runs = grouped((run["of"], run) for run in repeats)
    if section == columns.settings.noise_section:
        by_key = single((key_of(row, columns), row) for row in singles)
        for case, means in repeats_of(repeats, columns).items():
            by_key |= {(MEAN, case, name): {name: means[name].mean} for name in means}
        return by_key
    return single(
        (key_of(row, columns), _with_mean_costs(row, runs, columns)) for row in singles
    )


def _with_mean_costs(
    row: Cells, runs: Mapping[str, Sequence[Cells]], columns: Schema
) -> Cells:
    """Return a row in which each cost is the mean over the runs of its case."""
    costs = [name for name in row if columns[name].is_cost and scatters(columns[name])]
    samples = {name: _samples(name, row, runs) for name in costs}
    return {
        **row,
        **{name: fmean(fenced(runs)) for name, runs in samples.items() if runs[1:]},
    }


def _samples(name: str, row: Cells, runs: Mapping[str, Sequence[Cells]]) -> list[float]:
    """Return the numbers of a column in all runs of the case of a row."""
    cells = [run.get(name) for run in (row, *runs.get(row["case"], ()))]
    return [cell for cell in cells if is_number(cell)]


def kind_of(column: Column) -> str:
    """Return the kind of a number, one of ``KINDS``."""
    if not column.is_cost:
        return "physics"
    return "times" if is_absolute(column) else "ratios"


def _column(key: ColumnKey, columns: Schema) -> Column:
    return columns[key[1] if key[0] == MEAN else key[0]]


def _array(samples: Samples) -> Any:
    """Return samples by number and measurement, with NaN for missing ones."""
    width = max(map(len, samples.values()))
    array = np.full((len(samples), width), np.nan)
    for index, numbers in enumerate(samples.values()):
        array[index, : len(numbers)] = [
            np.nan if number is None else number for number in numbers
        ]
    return array


def _row_keys(samples: Samples) -> list[RowKey]:
    """Return the row of each number. A row occurs once for each edition that has it."""
    return [row_key for _, row_key, _ in samples]


def _fits(samples: SamplesByColumn, columns: Schema) -> Fits:
    """Fit the scatter of each column in each section.

    A column with few numbers in one section scatters as it does in all sections.
    """
    pooled: dict[ColumnKey, dict[NumberKey, Sequence[float | None]]] = defaultdict(dict)
    for (section, column_key), of_column in samples.items():
        for (edition, row_key, name), numbers in of_column.items():
            pooled[column_key][edition, (section, *row_key), name] = numbers
    general = {}
    for column_key, of_column in pooled.items():
        slopes = _slopes(column_key, columns)
        if fit := fit_of(_array(of_column), _row_keys(of_column), slopes=slopes):
            general[column_key] = fit.scatter
    fits = {}
    for (section, column_key), of_column in samples.items():
        fit = fit_of(
            _array(of_column),
            _row_keys(of_column),
            general.get(column_key),
            _slopes(column_key, columns),
        )
        if fit:
            fits[section, column_key] = fit
    return fits


def _within(
    gathered: Mapping[SectionKey, _Gathered],
    columns: Schema,
    fits: Fits,
    several: dict[SectionKey, dict[CellKey, Several]],
) -> dict[str, dict[ColumnKey, Scatter]]:
    """Return the scatter of the runs of one case, by section and column.

    Each row has the variance of its own runs, shrunk towards that of its column. It is
    used for columns that were never measured twice. Costs that were measured once, but
    in several runs, are added to ``several``. If the scatter between measurements is
    known, all runs count as one measurement.
    """
    samples: dict[tuple[str, ColumnKey], dict[NumberKey, list[float]]]
    samples = defaultdict(dict)
    for (edition, section), measurements in gathered.items():
        repeats = grouped((run["of"], run) for run in measurements.repeats)
        for row in measurements.rows if repeats else ():
            for name in filter(lambda name: scatters(columns[name]), row):
                if (numbers := _samples(name, row, repeats))[1:]:
                    key = section, column_key_of(name, row, columns)
                    samples[key][edition, key_of(row, columns), name] = numbers
    scatters_within: dict[str, dict[ColumnKey, Scatter]] = defaultdict(dict)
    for (section, column_key), of_column in samples.items():
        column = _column(column_key, columns)
        array = _array(of_column)
        sizes = np.maximum(abs(np.nanmean(array, axis=1)), 1e-12)
        shares = np.nanvar(array, axis=1, ddof=1) / sizes**2
        level = max(float(shares.mean()), rounding_variance(1.0))
        # The noise of few rows is assumed to be in proportion to their numbers.
        few = Scatter(level, 2.0, USUAL_FREEDOM)
        slopes = _slopes(column_key, columns)
        fit = fit_of(array, _row_keys(of_column), few, slopes)
        assert fit, "the scatter of few rows is given"
        # All runs were on one host, so their scatter does not contain its error.
        shared = HOST_SHARE**2 if is_absolute(column) else 0.0
        scatters_within[section][column_key] = replace(fit.scatter, shared=shared)
        for (edition, row_key, name), numbers in of_column.items():
            if column.is_cost:
                mean = fmean(fenced(numbers))
                runs = [mean] if (section, column_key) in fits else numbers
                several[edition, section].setdefault(
                    (row_key, name), Several(mean, runs, len(runs))
                )
    return scatters_within


def _slopes(key: ColumnKey, columns: Schema) -> Sequence[float]:
    """Return the exponents by which the variance of a column may grow with its numbers.

    The errors of costs are in proportion to them, so for costs there is only one.
    """
    return SLOPES[:1] if _column(key, columns).is_cost else SLOPES


def _several(
    samples: SamplesByColumn, fits: Fits
) -> tuple[
    dict[SectionKey, dict[CellKey, Several]], dict[SectionKey, set[tuple[RowKey, int]]]
]:
    """Return the numbers that were measured several times, and the outliers among their
    measurements as row and index of the measurement. Both are by section."""
    several: dict[SectionKey, dict[CellKey, Several]] = defaultdict(dict)
    outliers: dict[SectionKey, set[tuple[RowKey, int]]] = defaultdict(set)
    for (section, column_key), of_column in samples.items():
        fit = fits.get((section, column_key))
        for index, ((edition, row_key, name), numbers) in enumerate(of_column.items()):
            present = [number for number in numbers if number is not None]
            if len(present) < 2:
                continue
            odd: list[int] = []
            value = fmean(present)
            if fit:
                odd = np.flatnonzero(fit.is_outlier[index, : len(numbers)]).tolist()
                value = float(fit.values[index])
            if len({*present}) == 1:
                value = present[0]  # exactly, because a mean can be rounded
            outliers[edition, section] |= {
                (row_key, measurement) for measurement in odd
            }
            several[edition, section][row_key, name] = Several(
                value, numbers, len(present), len(odd)
            )
    return several, outliers


def _chances(samples: SamplesByColumn, fits: Fits) -> Chances:
    """Return the probability of the distance between each measurement and the mean of
    the other measurements of its number; NaN if it cannot be tested.
    """
    chances = {}
    for key, fit in fits.items():
        numbers = samples[key]
        predicted = left_out(_array(numbers), _row_keys(numbers), fit)
        of_column = np.where(np.isnan(predicted[0]), np.nan, chance_of(*predicted))
        chances[key] = dict(zip(numbers, of_column, strict=True))
    return chances


def _row_chances(
    chances: Chances, edition: str, section: str
) -> list[tuple[RowKey, Any]]:
    """Return the probabilities of each number in a section, with its row."""
    return [
        (row_key, of_number)
        for (name, _), numbers in chances.items()
        if name == section
        for (release, row_key, _), of_number in numbers.items()
        if release == edition
    ]


def _calibration(chances: Chances, columns: Schema) -> dict[str, tuple[int, int]]:
    """Return the count of measurements within the predicted noise, and of all
    measurements, by kind.
    """
    counts = dict.fromkeys(KINDS, (0, 0))
    for (_, column_key), numbers in chances.items():
        kind = kind_of(_column(column_key, columns))
        tested = np.concatenate([row[~np.isnan(row)] for row in numbers.values()])
        inside, total = counts[kind]
        inside += int((tested >= 1 - SURE).sum())
        counts[kind] = inside, total + len(tested)
    return counts


def _changed(
    chances: Sequence[tuple[RowKey, Any]], odd_rows: float
) -> list[tuple[int, int]]:
    """Return the count of numbers in each measurement, and the count of those that
    differ from the other measurements beyond noise. Nothing changed between
    measurements, so the second count is the number of false alarms. The rules are the
    same as in a comparison of two editions, see ``changes/moves.py``.
    """
    by_measurement: dict[int, dict[RowKey, list[float]]] = {}
    for row_key, of_number in chances:
        for index in np.flatnonzero(~np.isnan(of_number)):
            rows = by_measurement.setdefault(int(index), {})
            rows.setdefault(row_key, []).append(float(of_number[index]))
    counts = []
    for rows in by_measurement.values():
        tested = [chance for of_row in rows.values() for chance in of_row]
        limit = max(discoveries(tested), FALSE_SHARE / len(tested))
        changed = [
            sum(chance <= limit for chance in of_row) for of_row in rows.values()
        ]
        is_listed = exceeds_chance(sum(map(bool, changed)), odd_rows)
        counts.append((len(tested), sum(changed) if is_listed else 0))
    return counts


def _odd_rows(
    gathered: Mapping[SectionKey, _Gathered],
    outliers: Mapping[SectionKey, set[tuple[RowKey, int]]],
) -> dict[str, float]:
    """Return the mean number of rows in a measurement that end differently from the
    others, by section.
    """
    odd: Counter[str] = Counter()
    measurements: Counter[str] = Counter()
    for (edition, section), rows in gathered.items():
        if rows.count > 1:
            odd[section] += rows.dissenting + len(outliers[edition, section])
            odd[section] += len(rows.edges)
            measurements[section] += rows.count
    return {
        section: (odd[section] + ODD_ROWS) / count
        for section, count in measurements.items()
    }


def _host_scatter(
    samples: SamplesByColumn, fits: Fits, columns: Schema
) -> tuple[float, float]:
    """Return the relative variance that all times of one measurement share, and its
    degrees of freedom. The shift of a measurement is the median of log(time / mean
    time) over all times of a section in an edition. Sections share hosts, so the
    section that was measured most often determines the degrees of freedom. The usual
    variance has the weight ``HOST_FREEDOM``.
    """
    logs_by_section: dict[SectionKey, list[Any]] = defaultdict(list)
    for (section, column_key), of_column in samples.items():
        fit = fits.get((section, column_key))
        if fit is None or not is_absolute(_column(column_key, columns)):
            continue
        with np.errstate(divide="ignore", invalid="ignore"):
            logs = np.log(_array(of_column) / fit.values[:, None])
        for (key, numbers), row in zip(of_column.items(), logs, strict=True):
            # Another edition of the column may have more measurements.
            logs_by_section[key[0], section].append(row[: len(numbers)])
    squares = 0.0
    freedom = 0
    most = 0
    for rows in logs_by_section.values():
        by_measurement = np.stack(rows)
        is_known = ~np.isnan(by_measurement).all(axis=0)
        shifts = np.nanmedian(by_measurement[:, is_known], axis=0)
        squares += float(((shifts - shifts.mean()) ** 2).sum()) if len(shifts) else 0.0
        freedom += max(0, len(shifts) - 1)
        most = max(most, len(shifts) - 1)
    if not freedom:
        return HOST_SHARE**2, HOST_FREEDOM
    weight = HOST_FREEDOM / (HOST_FREEDOM + freedom)
    variance = weight * HOST_SHARE**2 + (1 - weight) * squares / freedom
    return variance, HOST_FREEDOM + most
