"""Cells: the numbers of an edition in all of its measurements, and how they scatter."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from statistics import fmean, median
from typing import Any

from measured_report.files.columns import REASON, Column, Schema
from measured_report.files.groups import single
from measured_report.records.record import Record
from measured_report.values.evidence import (
    MEAN,
    Cells,
    Evidence,
    Key,
    Number,
    Repeated,
    is_absolute,
    is_lost,
    key_of,
    repeats_of,
    scatters,
)
from measured_report.values.noise import ROUNDED_SHARE, Estimate, discoveries

AT_EDGE = 4.4  # chosen: a number so many deviations from all others, 1 in 100,000
CARDS_APART = 0.02  # chosen: the least scatter of cards that sections share


@dataclass
class Group:
    """Holds numbers of a section that scatter alike, and how: a line for each number."""

    column: Column
    numbers: list[Number] = field(default_factory=list)
    samples: list[list[Any]] = field(default_factory=list)
    """By measurement, None where a number is missing."""
    scales: list[float] = field(default_factory=list)  # of the noise of each
    variances: Any = None  # an array, as the next; NaN for a number that has none
    freedoms: Any = None
    counts: Any = None  # of measurements, or of cards
    means: Any = None  # over cards, if the scatter is that of cards
    off: Any = None  # else the deviations of each measurement from the others


@dataclass
class Samples:
    """Holds the numbers of a section that were measured several times."""

    cards: Sequence[str]  # by measurement; empty for one without this section
    timed: frozenset[str]  # cards whose times stand beside each other
    groups: dict[Key, Group] = field(default_factory=dict)
    edges: set[Key] = field(default_factory=set)  # rows that end in one of two ways
    row_count: int = 0  # of the other rows


def evidence_of(
    measured: Mapping[str, Sequence[Record | None]], repeats: Repeated, columns: Schema
) -> dict[str, Evidence]:
    """Return the evidence of each section of an edition.

    ``measured`` has the records of each section: first the one that is shown, then its
    replicas, None where a replica lacks the section.
    """
    evidence = dict.fromkeys(measured, Evidence(repeats=repeats))
    again = {
        section: _samples(records[0], records, columns)
        for section, records in measured.items()
        if records[0] and any(records[1:])
    }
    for samples in again.values():
        for group in samples.groups.values():
            if not (is_absolute(group.column) and _fit_cards(group, samples.cards)):
                _fit_measurements(group)
    _share_cards(list(again.values()))
    for section, samples in again.items():
        evidence[section] = _evidence(samples, repeats)
    return evidence


def _samples(
    tracked: Record, records: Sequence[Record | None], columns: Schema
) -> Samples:
    """Gather the numbers of a section that two measurements have, or more."""
    machine = tracked.machine_for_speed
    alike = [each is not None and each.machine_for_speed == machine for each in records]
    cards = [record.card if record else "" for record in records]
    timed = frozenset(card for card, is_so in zip(cards, alike, strict=True) if is_so)
    found = Samples(cards, timed)
    rows_by_key = [_rows_by_key(each.rows if each else (), columns) for each in records]
    runs = repeats_of(tracked.rows, columns)
    for key, row in rows_by_key[0].items():
        rows = [of_record.get(key, {}) for of_record in rows_by_key]
        if len({_ending(each, columns) for each in rows if each}) > 1:
            found.edges.add(key)
            continue
        if is_lost(row, columns):
            continue
        is_mean = key[0] == MEAN
        found.row_count += not is_mean
        engine = [row.get(name) for name in columns.settings.repeating]
        for name in row:
            column = columns[name]
            if isinstance(row[name], str | bool) or not scatters(column):
                continue
            samples = [each.get(name) for each in rows]
            if column.is_cost:
                pairs = zip(samples, alike, strict=True)
                samples = [sample if is_same else None for sample, is_same in pairs]
            if len(samples) - samples.count(None) < 2:
                continue
            place: Key = (name, *engine)
            scale = 1.0
            if is_mean:
                place = (name, MEAN) if is_absolute(column) else (MEAN,)
                spread = runs[key[1]][name]
                scale = math.sqrt(spread.variance / spread.run_count) or 1.0
            group = found.groups.setdefault(place, Group(columns[place[0]]))
            group.numbers.append((key, name))
            group.samples.append(samples)
            group.scales.append(scale)
    return found


def _rows_by_key(rows: Sequence[Cells], columns: Schema) -> dict[Key, Cells]:
    """Return the rows of a record by their keys, without those that share one; the mean
    of the runs of one case is a row of its own for each column."""
    singles = [row for row in rows if "of" not in row]
    rows_by_key = single((key_of(row, columns), row) for row in singles)
    for case, runs in repeats_of(rows, columns).items():
        rows_by_key |= {(MEAN, case, name): {name: runs[name].mean} for name in runs}
    return rows_by_key


def _ending(row: Cells, columns: Schema) -> tuple[Any, ...]:
    """Return how the run of a row ended: whether it failed, and what it says in words."""
    texts = frozenset(
        (name, cell)
        for name, cell in row.items()
        if isinstance(cell, str | bool) and name != "case" and not name.endswith(REASON)
    )
    return is_lost(row, columns), texts


def _fit_measurements(group: Group) -> None:
    """Fit the scatter of numbers, shrunk towards what they have in common."""
    import numpy as np

    from measured_report.values.shrinkage import left_out, moderated

    samples = np.array(group.samples, float)
    scales = np.array(group.scales)
    scaled = samples / scales[:, None]
    group.counts = (~np.isnan(samples)).sum(axis=1)
    is_mean = group.column.name == MEAN
    sizes = np.maximum(abs(np.nanmean(scaled, axis=1)), 1e-12)
    if is_mean:
        sizes = np.ones(len(samples))
    variances = np.nanvar(scaled, axis=1, ddof=1)
    fit = moderated(variances, group.counts - 1.0, sizes, usual=float(is_mean))
    group.variances = fit.variances * scales**2
    group.freedoms = fit.freedoms
    rounding = ROUNDED_SHARE * abs(np.nanmean(samples, axis=1))
    least = np.maximum(group.column.resolution, rounding) / scales
    group.off = left_out(scaled, fit.lent, fit.common, least)


def _fit_cards(group: Group, cards: Sequence[str]) -> bool:
    """Fit how far cards are apart, which is known by as many as there are; return False
    for one card. A number that one of the cards lacks has no variance."""
    import numpy as np

    samples = np.array(group.samples, float)
    means_by_card = []
    for card in dict.fromkeys(cards):
        of_card = samples[:, [name == card for name in cards]]
        if not np.isnan(of_card).all():
            is_one = of_card.shape[1] == 1
            means_by_card.append(
                of_card[:, 0] if is_one else np.nanmean(of_card, axis=1)
            )
    by_card = np.stack(means_by_card, axis=1)
    means = by_card.mean(axis=1)
    whole = ~np.isnan(means)
    count = len(means_by_card)
    if count < 2 or not whole.any():
        return False
    group.means = means
    share = np.median(by_card[whole].var(axis=1, ddof=1) / means[whole] ** 2)
    group.variances = share * means**2
    group.counts = np.full(len(samples), float(count))
    group.freedoms = group.counts - 1
    return True


def _share_cards(sections: Sequence[Samples]) -> None:
    """Let sections tell each other how far cards are apart, of which each knows few.

    Few cards may be alike by chance, so no section takes less than all of them together
    show. What all show is known by so many cards: a card that several sections were
    measured on counts once. So the truth is within at least 95 % of the intervals, drawn
    with a card that is off by the same in all sections, by another amount in each, or by
    both.
    """
    import numpy as np

    total = 0.0
    weight = 0
    taught = []
    linked: list[frozenset[str]] = []  # cards that sections have in common
    for samples in sections:
        groups = [each for each in samples.groups.values() if each.means is not None]
        if groups:
            shares = [group.variances / group.means**2 for group in groups]
            freedom = len(samples.timed) - 1
            total += float(np.nanmedian(np.concatenate(shares))) * freedom
            weight += freedom
            near = [cards for cards in linked if cards & samples.timed]
            linked = [cards for cards in linked if cards not in near]
            linked.append(samples.timed.union(*near))
            taught += [(freedom, group) for group in groups]
    most = sum(len(cards) - 1 for cards in linked)
    pooled = max(total / max(1, weight), CARDS_APART**2)
    for freedom, group in taught:
        if freedom < most:
            group.variances = np.maximum(group.variances, pooled * group.means**2)
            group.freedoms = np.full(len(group.means), float(most))


def _evidence(samples: Samples, repeats: Repeated) -> Evidence:
    """Return the evidence of a section that was measured several times."""
    off: dict[Number, list[float]] = {}
    for group in samples.groups.values():
        if group.off is not None:
            off |= zip(group.numbers, group.off.tolist(), strict=True)
    # A measurement so far from all others is no chance: its row ended otherwise.
    events = {
        (key, index)
        for (key, _), deviations in off.items()
        for index, deviation in enumerate(deviations)
        if deviation > AT_EDGE
    }
    edges = samples.edges | {key for key, _ in events}
    estimates = {}
    for group in samples.groups.values():
        scatter = (
            group.variances.tolist(),
            group.freedoms.tolist(),
            group.counts.tolist(),
        )
        lines = zip(group.numbers, group.samples, *scatter, strict=True)
        is_of_cards = group.means is not None
        for number, of_number, variance, freedom, count in lines:
            if variance == variance:
                known = Estimate(
                    0.0, variance, freedom, count, 0.0, of_number, is_of_cards
                )
                estimates[number] = _estimate(known, number[0] in edges)
    count = len(samples.cards) - samples.cards.count("")
    changed = []
    for index in range(len(samples.cards)) if count > 2 else ():
        elsewhere = {event for event in events if event[1] != index}
        share = len(elsewhere) / max(1, samples.row_count * (count - 1))
        changed.append(_changed(off, {key for key, _ in elsewhere}, share, index))
    edge_share = len(events) / max(1, samples.row_count * count)
    return Evidence(count, estimates, repeats, frozenset(edges), edge_share, changed)


def _estimate(known: Estimate, is_edge: bool) -> Estimate:
    """Return an estimate, of which samples and scatter are known, with its value."""
    present = [sample for sample in known.samples if sample is not None]
    least = min(present)
    largest = max(present)
    if is_edge and least < largest:
        middle = float(median(present))
        reach = max(largest - middle, middle - least)
        return Estimate(middle, least=reach, samples=known.samples, is_edge=True)
    if least < largest:
        return known._replace(value=fmean(present), is_again=True)
    # Measurements agree on a count, or on nothing at all: it has no noise.
    value = present[0]
    is_exact = not (isinstance(value, float) and value)
    variance = 0.0 if is_exact else known.variance
    return known._replace(value=value, variance=variance, is_again=True)


def _changed(
    off: Mapping[Number, Sequence[float]],
    edges: set[Key],
    edge_share: float,
    index: int,
) -> tuple[int, int]:
    """Return how many numbers a measurement has, and how many differ from the others."""
    chances = [
        max(math.erfc(deviations[index] / math.sqrt(2)), edge_share)
        for (key, _), deviations in off.items()
        if deviations[index] == deviations[index] and key not in edges
    ]
    limit = discoveries(chances)
    return len(chances), sum(chance <= limit for chance in chances) if limit else 0
