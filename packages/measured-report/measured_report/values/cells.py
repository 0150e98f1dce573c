"""Cells: the numbers of an edition in all of its measurements, and how they scatter."""

import math
from collections.abc import Mapping, Sequence
from statistics import fmean, median
from typing import Any, NamedTuple

from measured_report.files.groups import single
from measured_report.records.columns import REASON, Column, Schema
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


class Samples(NamedTuple):
    """Hold the numbers of a section that were measured several times."""

    groups: dict[Key, dict[Number, tuple[list[Any], float]]]
    """Numbers that scatter alike, each with its cells by measurement, None for one that
    is missing, and the scale of its noise. A group's key begins with its column."""
    edges: set[Key]  # rows that ended in one of two ways
    row_count: int  # of the other rows
    cards: Sequence[str]  # by measurement; empty for one without this section
    timed: frozenset[str]  # cards whose times stand beside each other


class Scatter(NamedTuple):
    """Hold how the numbers of a group scatter, in arrays by number."""

    variances: Any  # NaN for a number that has none
    freedoms: Any
    counts: Any  # of measurements, or of cards
    means: Any = None  # over cards, where the scatter is that of cards
    off: Any = None  # else normal deviations of each measurement from the others


def evidence_of(
    measured: Mapping[str, Sequence[Record | None]], repeats: Repeated, columns: Schema
) -> dict[str, Evidence]:
    """Return the evidence of each section of an edition.

    ``measured`` has the records of each section: first the one that is shown, then its
    replicas, None where a replica lacks the section.
    """
    samples_by_section = {
        section: _samples(records[0], records, columns)
        for section, records in measured.items()
        if records[0] and any(records[1:])
    }
    scatters_by_section = {
        section: _scatters(samples, columns)
        for section, samples in samples_by_section.items()
    }
    _share_cards(samples_by_section, scatters_by_section)
    evidence = dict.fromkeys(measured, Evidence(repeats=repeats))
    for section, samples in samples_by_section.items():
        evidence[section] = _evidence(samples, scatters_by_section[section], repeats)
    return evidence


def _samples(
    tracked: Record, records: Sequence[Record | None], columns: Schema
) -> Samples:
    """Gather the numbers of a section that two measurements have, or more."""
    machine = tracked.machine_for_speed
    alike = [each is not None and each.machine_for_speed == machine for each in records]
    cards = [record.card if record else "" for record in records]
    timed = frozenset(card for card, is_so in zip(cards, alike, strict=True) if is_so)
    rows_by_key = [_rows_by_key(each.rows if each else (), columns) for each in records]
    runs = repeats_of(tracked.rows, columns)
    groups: dict[Key, dict[Number, tuple[list[Any], float]]] = {}
    edges = set()
    row_count = 0
    for key, row in rows_by_key[0].items():
        rows = [of_record.get(key, {}) for of_record in rows_by_key]
        if len({_ending(each, columns) for each in rows if each}) > 1:
            edges.add(key)
            continue
        if is_lost(row, columns):
            continue
        is_mean = key[0] == MEAN
        row_count += not is_mean
        engine = [row.get(name) for name in columns.settings.repeating]
        for name in row:
            column = columns[name]
            if isinstance(row[name], str | bool) or not scatters(column):
                continue
            cells = [each.get(name) for each in rows]
            if column.is_cost:
                pairs = zip(cells, alike, strict=True)
                cells = [cell if is_same else None for cell, is_same in pairs]
            if len(cells) - cells.count(None) < 2:
                continue
            group: Key = (name, *engine)
            scale = 1.0
            if is_mean:
                group = (name, MEAN) if is_absolute(column) else (MEAN,)
                spread = runs[key[1]][name]
                scale = math.sqrt(spread.variance / spread.run_count)
            groups.setdefault(group, {})[key, name] = cells, scale
    return Samples(groups, edges, row_count, cards, timed)


def _rows_by_key(rows: Sequence[Cells], columns: Schema) -> dict[Key, Cells]:
    """Return the rows of a record by their keys, without those that share one; the mean
    of the runs of one case is a row of its own for each column."""
    singles = [row for row in rows if "of" not in row]
    rows_by_key = single((key_of(row, columns), row) for row in singles)
    for case, runs in repeats_of(rows, columns).items():
        for name, of_column in runs.items():
            rows_by_key[MEAN, case, name] = {name: of_column.mean}
    return rows_by_key


def _ending(row: Cells, columns: Schema) -> tuple[Any, ...]:
    """Return how the run of a row ended: whether it failed, and what it says in words."""
    texts = frozenset(
        (name, cell)
        for name, cell in row.items()
        if isinstance(cell, str | bool) and name != "case" and not name.endswith(REASON)
    )
    return is_lost(row, columns), texts


def _scatters(samples: Samples, columns: Schema) -> dict[Key, Scatter]:
    """Return how the numbers of each group scatter: absolute times by cards, if there
    are several, and all others by measurements."""
    scatters = {}
    for name, group in samples.groups.items():
        column = columns[name[0]]
        of_cards = _of_cards(group, samples.cards) if is_absolute(column) else None
        scatters[name] = of_cards or _of_measurements(column, group)
    return scatters


def _of_measurements(column: Column, group: Mapping[Number, tuple[Any, float]]) -> Scatter:
    """Return the scatter of a group's numbers, shrunk towards what they have in common."""
    import numpy as np

    from measured_report.values.shrinkage import left_out, moderated

    samples = np.array([cells for cells, _ in group.values()], float)
    scales = np.array([scale or 1.0 for _, scale in group.values()])
    scaled = samples / scales[:, None]
    counts = (~np.isnan(samples)).sum(axis=1)
    is_mean = column.name == MEAN
    sizes = np.maximum(abs(np.nanmean(scaled, axis=1)), 1e-12)
    if is_mean:
        sizes = np.ones(len(group))
    variances = np.nanvar(scaled, axis=1, ddof=1)
    fit = moderated(variances, counts - 1.0, sizes, usual=float(is_mean))
    rounding = ROUNDED_SHARE * abs(np.nanmean(samples, axis=1))
    least = np.maximum(column.resolution, rounding) / scales
    off = left_out(scaled, fit.lent, fit.common, least)
    return Scatter(fit.variances * scales**2, fit.freedoms, counts, off=off)


def _of_cards(group: Mapping[Number, tuple[Any, float]], cards: Sequence[str]) -> Scatter | None:
    """Return how far cards are apart, which is known by as many as there are; None for
    one card. A number that one of the cards lacks has no variance."""
    import numpy as np

    samples = np.array([cells for cells, _ in group.values()], float)
    means_by_card = []
    for card in dict.fromkeys(cards):
        of_card = samples[:, [name == card for name in cards]]
        if not np.isnan(of_card).all():
            is_one = of_card.shape[1] == 1
            means_by_card.append(of_card[:, 0] if is_one else np.nanmean(of_card, axis=1))
    by_card = np.stack(means_by_card, axis=1)
    means = by_card.mean(axis=1)
    whole = ~np.isnan(means)
    count = len(means_by_card)
    if count < 2 or not whole.any():
        return None
    share = float(np.median(by_card[whole].var(axis=1, ddof=1) / means[whole] ** 2))
    counts = np.full(len(group), float(count))
    return Scatter(share * means**2, counts - 1, counts, means=means)


def _share_cards(
    samples_by_section: Mapping[str, Samples],
    scatters_by_section: Mapping[str, dict[Key, Scatter]],
) -> None:
    """Let sections tell each other how far cards are apart, of which each knows few.

    Few cards may be alike by chance, so no section takes less than all of them together
    show. What all show is known by so many cards: a card that several sections were
    measured on counts once. So the truth is within at least 95 % of the intervals, drawn
    with a card that is off by the same in all sections, by another amount in each, or by
    both.
    """
    import numpy as np

    shares = {}
    linked: list[frozenset[str]] = []  # cards that sections have in common
    for section, of_groups in scatters_by_section.items():
        of_cards = [each for each in of_groups.values() if each.means is not None]
        if of_cards:
            found = [each.variances / each.means**2 for each in of_cards]
            shares[section] = float(np.nanmedian(np.concatenate(found)))
            cards = samples_by_section[section].timed
            near = [others for others in linked if others & cards]
            linked = [others for others in linked if others not in near]
            linked.append(cards.union(*near))
    freedom = float(sum(len(cards) - 1 for cards in linked))
    own = {section: len(samples_by_section[section].timed) - 1 for section in shares}
    total = sum(share * own[section] for section, share in shares.items())
    pooled = max(total / max(1, sum(own.values())), CARDS_APART**2)
    for section in shares:
        for name, each in scatters_by_section[section].items():
            if own[section] < freedom and each.means is not None:
                variances = np.maximum(each.variances, pooled * each.means**2)
                freedoms = np.full_like(each.freedoms, freedom)
                widened = each._replace(variances=variances, freedoms=freedoms)
                scatters_by_section[section][name] = widened


def _evidence(
    samples: Samples, scatters: Mapping[Key, Scatter], repeats: Repeated
) -> Evidence:
    """Return the evidence of a section that was measured several times."""
    off: dict[Number, list[float]] = {}
    for name, group in samples.groups.items():
        if scatters[name].off is not None:
            off |= zip(group, scatters[name].off.tolist(), strict=True)
    # A measurement so far from all others is no chance: its row ended otherwise.
    events = {
        (key, index)
        for (key, _), deviations in off.items()
        for index, deviation in enumerate(deviations)
        if deviation > AT_EDGE
    }
    edges = samples.edges | {key for key, _ in events}
    estimates = {}
    for name, group in samples.groups.items():
        variances, freedoms, counts, means, _ = scatters[name]
        known = variances.tolist(), freedoms.tolist(), counts.tolist()
        for number, *scatter in zip(group, *known, strict=True):
            if scatter[0] == scatter[0]:
                estimate = _estimate(group[number][0], number[0] in edges, *scatter)
                estimates[number] = estimate._replace(is_of_cards=means is not None)
    count = len(samples.cards) - samples.cards.count("")
    changed = []
    for index in range(len(samples.cards)) if count > 2 else ():
        elsewhere = {event for event in events if event[1] != index}
        share = len(elsewhere) / max(1, samples.row_count * (count - 1))
        changed.append(_changed(off, {key for key, _ in elsewhere}, share, index))
    edge_share = len(events) / max(1, samples.row_count * count)
    return Evidence(count, estimates, repeats, frozenset(edges), edge_share, changed)


def _estimate(
    cells: Sequence[Any], is_edge: bool, variance: float, freedom: float, count: float
) -> Estimate:
    """Return what is known of a number by its measurements and their scatter."""
    present = [cell for cell in cells if cell is not None]
    least = min(present)
    largest = max(present)
    if is_edge and least < largest:
        middle = float(median(present))
        reach = max(largest - middle, middle - least)
        return Estimate(middle, least=reach, samples=cells, is_edge=True)
    value = fmean(present) if least < largest else present[0]
    # Measurements agree on a count, or on nothing at all: it has no noise.
    if least == largest and not (isinstance(value, float) and value):
        variance = 0.0
    return Estimate(value, variance, freedom, count, samples=cells, is_again=True)


def _changed(
    off: Mapping[Number, Sequence[float]], edges: set[Key], edge_share: float, index: int
) -> tuple[int, int]:
    """Return how many numbers a measurement has, and how many differ from the others."""
    chances = [
        max(math.erfc(deviations[index] / math.sqrt(2)), edge_share)
        for (key, _), deviations in off.items()
        if deviations[index] == deviations[index] and key not in edges
    ]
    limit = discoveries(chances)
    return len(chances), sum(chance <= limit for chance in chances) if limit else 0
