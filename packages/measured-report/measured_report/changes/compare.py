"""Comparison of two editions: what can't be trusted, which claims flipped, and which values moved beyond the noise."""

from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property

from measured_report.changes.costs import is_cost
from measured_report.changes.faults import Fault, faults_between, faults_of
from measured_report.changes.flips import Flip, flips_between
from measured_report.changes.moves import Move, cells_between, rows_by_key, unlike
from measured_report.files.config import config
from measured_report.pages.chapters import Chapters
from measured_report.pages.editions import Edition
from measured_report.values.noise import NOISE, Repeats, repeats_of


@dataclass(frozen=True)
class Comparison:
    """All differences between two editions."""

    releases: tuple[str, str]
    faults: list[Fault]
    flips: list[Flip]
    cells: list[Move]
    """Values that compare, moved or not."""
    notes: list[str]
    """Said of what could not be compared, and why."""

    @cached_property
    def moves(self) -> list[Move]:
        """Return the cells that moved beyond the noise."""
        return [cell for cell in self.cells if cell.is_real]

    @cached_property
    def settings(self) -> list[Move]:
        """Return defaults and options that are not the same."""
        return [move for move in self.moves if move.is_setting]

    @cached_property
    def alarms(self) -> list[Move]:
        """Return settings and named numbers that moved by more than their threshold."""
        return [move for move in self.moves if move.exceeds_threshold]

    @property
    def missing(self) -> list[str]:
        """Name the numbers with a threshold that are not in both: they can raise no alarm."""
        return [name for name in config().changes.thresholds if name not in {cell.name for cell in self.cells}]

    @property
    def is_alarm(self) -> bool:
        """Tell whether somebody has to look at it."""
        return bool(self.faults or self.flips or self.alarms)


def compare(before: Edition, after: Edition) -> Comparison:
    """Compare the results of two editions."""
    sides = before.chapters, after.chapters
    known = [repeats_of(side[NOISE].results.record) if NOISE in side else None for side in sides]
    repeats = [each or next(filter(None, known), Repeats({})) for each in known]
    shared = [name for name in before.chapters if name in after.chapters]
    return Comparison(
        releases=(before.project.release, after.project.release),
        faults=list(dict.fromkeys([*faults_between(before, after), *faults_of(before), *faults_of(after)])),
        flips=flips_between(*sides),
        cells=[each for name in shared for each in cells_between(sides[0][name], sides[1][name], repeats)],
        notes=[*_unshared(before, after), *_costs_apart(*sides), *_unlike_runs(*sides), *_inconclusive_claims(*sides)],
    )


def _unshared(*sides: Edition) -> list[str]:
    """Name the sections that only one has; that the other's are gone is a fault, and is said as one."""
    names = dict.fromkeys(section for side in sides for section in side.chapters)
    return [
        f"{section}: {config().package} {side.project.release} has no results of it"
        for section in names
        for side in sides
        if any(state.section == section and state.kind == "missing" for state in side.left_out)
    ]


def _costs_apart(before: Chapters, after: Chapters) -> list[str]:
    """Say where costs are not compared, once for each pair of machines, with the sections."""
    sections: dict[tuple[str, str], list[str]] = {}
    for section in before:
        if section in after and any(map(is_cost, before[section].results.record.units)):
            sides = before[section].results.record, after[section].results.record
            if sides[0].machine_for_speed != sides[1].machine_for_speed:
                machines = sides[0].machine_in_full, sides[1].machine_in_full
                sections.setdefault(machines, []).append(section)
    return [
        f"speed and cost in {', '.join(names)}: measured on {' and on '.join(machines)}"
        for machines, names in sections.items()
    ]


def _unlike_runs(before: Chapters, after: Chapters) -> Iterable[str]:
    """Say of which runs rates alone are compared, or nothing, for what was not alike."""
    for section in (name for name in before if name in after):
        old, new = rows_by_key(before[section]), rows_by_key(after[section])
        found = {key: unlike(old[key].plain, new[key].plain) for key in old if key in new}
        if names := list(dict.fromkeys(name for names in found.values() for name in names)):
            count = sum(map(bool, found.values()))
            yield f"{section}: all but rates of {count} runs, for another {' or '.join(names)}"


def _inconclusive_claims(*sides: Chapters) -> Iterable[str]:
    """Name the claims that are no flips only because one of the editions has them near the noise."""
    return dict.fromkeys(
        f"{section}.{claim.name}: near the noise"
        for side in sides
        for section, chapter in side.items()
        for claim in chapter.section.claims
        if claim.outcome.is_inconclusive
    )
