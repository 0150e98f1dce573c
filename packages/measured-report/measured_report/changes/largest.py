"""Largest moves of a comparison, a line each: those that one cause makes alike are told together."""

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field

from measured_report.changes.compare import Comparison
from measured_report.changes.moves import Move
from measured_report.files.config import config
from measured_report.parts.claim import NEAR_NOISE
from measured_report.records.columns import column_of
from measured_report.values.noise import ROUNDING_SHARE

LINES = 5
"""Chosen: so many are told."""
NAMED = 4
"""Chosen: so many claims, and twice as many settings, are named in a line."""
ALIKE = 0.25
"""Chosen: columns of one row whose changes are no farther apart, as a share of the larger one, moved by one cause."""


@dataclass(frozen=True)
class Group:
    """Moves of one column that go the same way."""

    lead: Move
    """The largest of those that exceed their thresholds, or else of all."""
    shares: Sequence[float | None]
    """Changes from the least to the largest; None where there is a number in one edition alone."""
    row_count: int
    """Count of the rows in which the column compares."""
    others: list[str] = field(default_factory=list)
    """Columns that moved as much in the leading row."""

    @property
    def text(self) -> str:
        """Say in a line what it was before and after, by how much, and where."""
        lead, count = self.lead, len(self.shares)
        ends = list(dict.fromkeys(percent(share) for share in (self.shares[0], self.shares[-1]) if share is not None))
        places = [f"{lead.section} {lead.place.get('case', '')}".strip()]
        if self.row_count > 1:
            rows = f"all {count} rows" if count == self.row_count else f"{count} of {self.row_count} rows"
            places.append(f"{rows}{', ' if ends[1:] else ''}{' to '.join(ends) if ends[1:] else ''}")
        places += [f"alike: {', '.join(self.others)}"] if self.others else []
        said = f"{column_of(lead.column).words} {lead.ends}"
        said += "" if lead.share is None else f", {percent(lead.share)}"
        alarm = "alarm: " if lead.exceeds_threshold else ""
        return f"{alarm}{said}{f' {lead.direction}'.rstrip()} ({'; '.join(places)})"


def largest(found: Comparison) -> list[Group]:
    """Return the groups that lead, alarms first; the others by what of the change is surely no noise.

    What the deciding sections measured goes before the rest: they have the scene that the report is about.
    """
    moves: dict[tuple[str, bool | None], list[Move]] = {}
    for move in found.moves:
        if _is_told(move):
            moves.setdefault((move.column, None if move.share is None else move.share > 0), []).append(move)
    counts = Counter(cell.column for cell in found.cells if cell.share is not None or _is_told(cell))
    groups: list[Group] = []
    for (column, _), alike in moves.items():
        shares = sorted(move.share for move in alike if move.share is not None)
        groups.append(Group(max(alike, key=_rank), shares or [None] * len(alike), counts[column]))
    told: list[Group] = []
    for group in sorted(groups, key=lambda group: _rank(group.lead), reverse=True):
        same = next((each for each in told if _one_cause(each.lead, group.lead)), None)
        if same:
            same.others.append(column_of(group.lead.column).words)
        else:
            told.append(group)
    return told[:LINES]


def _is_told(move: Move) -> bool:
    """Tell whether it may lead: a number that changed or is gone, or an alarm; settings are told by themselves."""
    is_setting, is_lost = move.is_setting or column_of(move.column).is_setting, move.is_gone and move.values[1] is None
    is_alarm = move.is_real and move.exceeds_threshold
    return not (is_setting or move.is_inconclusive) and bool(move.share or is_lost or is_alarm)


def _rank(move: Move) -> tuple[bool, bool, float]:
    return move.exceeds_threshold, move.section in config().changes.deciding, move.sure_share


def _one_cause(a: Move, b: Move) -> bool:
    if b.exceeds_threshold or (a.section, a.place) != (b.section, b.place):
        return False
    if a.share is None or b.share is None:
        return a.share is b.share
    return math.isfinite(a.share + b.share) and abs(a.share - b.share) <= ALIKE * max(abs(a.share), abs(b.share))


def settings_text(settings: Sequence[Move]) -> str:
    """Name the settings that changed, alarms first, and those that only one edition has."""
    changed = [move for move in settings if None not in move.values]
    changed.sort(key=lambda move: not move.exceeds_threshold)
    told = [few([move.setting for move in changed], 2 * NAMED)] if changed else []
    for word, index in (("new", 0), ("gone", 1)):
        if names := [move.place["case"] for move in settings if move.values[index] is None]:
            told.append(f"{word}: {', '.join(names)}")
    notes = config().changes.setting_notes
    told += dict.fromkeys(notes[move.place["kind"]] for move in changed if move.place["kind"] in notes)
    return "; ".join(told) or "all as they were"


def few(names: Sequence[str], count: int = NAMED) -> str:
    more = f"; and {len(names) - count} more" if len(names) > count else ""
    return "; ".join(names[:count]) + more


def power(found: Comparison) -> str:
    """Say the least change of each named number that would have shown, and which were not measured in both."""
    named = config().changes.thresholds
    least: dict[str, float] = {}
    for cell in found.cells:
        if cell.name in named and cell.share is not None and cell.values[0]:
            seen = max(NEAR_NOISE * cell.least / abs(cell.values[0]), ROUNDING_SHARE)
            words = column_of(cell.column).words
            least[words] = max(least.get(words, 0.0), seen)
    unseen = {column_of(name.rpartition(".")[2]).words for name in named} - least.keys()
    told = [", ".join(f"{words} from {100 * share:.2g} %" for words, share in least.items()) or "nothing that is named"]
    return "; ".join(told + ([f"not measured in both: {', '.join(sorted(unseen))}"] if unseen else []))


def percent(share: float) -> str:
    """Write a change in percent, with its sign; of what was nothing before there is none."""
    if not math.isfinite(share):
        return "from nothing"
    return f"{100 * share:+.{0 if abs(share) >= 0.1 else 1}f} %".replace("-", "−")
