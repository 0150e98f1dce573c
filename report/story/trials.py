"""Decide from pairs of runs whether a piece of public advice helps."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from enum import Enum

from markupsafe import Markup

from report.shared import (
    FAILS,
    HOLDS,
    OPPOSITE,
    PERCENT,
    TIMED_WORLDS,
    Outcome,
    Quantity,
    Row,
    Sections,
    at_least,
    case_html,
)

UNMEASURED = Outcome("unknown", "it was not measured with this release")
KEPT = ("creeping", "holding")  # classes of runs that keep the cube
SETTINGS = {
    "impratio": "impratio",
    "condim": "condim",
    "noslip_iterations": "NoSlip iterations:",
    "timeconst_s": "time constant",
    "timeconst_steps": "time constant in steps:",
    "substep_ms": "step",
    "step_ms": "step",
    "pad_ke": "ke",
    "pad_kd": "kd",
    "pad_mu": "friction",
    "grip_ratio": "grip ratio",
    "contact_max": "room for contacts:",
    "overlap_mm": "overlap",
}
"""Short names of parameter columns in the tables of advice."""


class Symptom(Enum):
    """A fault that the advice is meant to cure; the value names its table."""

    SLIPS = "slips_slowly"
    DROPS = "drops_at_once"
    JITTERS = "jitters"
    SINKS = "sinks"
    EXPLODES = "explodes"


@dataclass(frozen=True)
class Source:
    """A public text, the version in which it was read, and its address."""

    name: str
    version: str
    url: str

    def __html__(self) -> Markup:
        link = Markup('<a href="{}">{}</a>, {}')
        return link.format(self.url, self.name, self.version)


@dataclass(frozen=True)
class Trial:
    """Two runs of a section that differ by a piece of advice."""

    section: str
    before: str
    after: str
    where: str = "in the shake"  # the condition under which both runs were made
    column: str = "slip_mm"  # less of it is better
    setting: str = ""  # the column that differs; without it, the labels name the runs
    names: tuple[str, str] = ("", "")  # names of the two runs in place of labels

    def rows(self, sections: Sections) -> list[Row]:
        """Return the two rows, or none if one of them was not measured."""
        if self.section not in sections.results:
            return []
        rows = sections.results[self.section].row
        pair = [rows[self.before], rows[self.after]]
        are_there = all(is_lost(row) or _is_there(row, self.column) for row in pair)
        return pair if are_there else []

    def outcome(self, sections: Sections, bound: Quantity) -> Outcome:
        """Test whether the advice reduces the column by more than the bound."""
        rows = self.rows(sections)
        if not rows:
            return UNMEASURED
        before, after = rows
        if is_lost(before) or is_lost(after):
            cells = [row[self.column] for row in rows if not is_lost(row)]
            outcome = FAILS if not cells else HOLDS if is_lost(before) else OPPOSITE
            return outcome.having_read(*cells)
        return self._compared(before[self.column], after[self.column], bound)

    @staticmethod
    def _compared(before: Quantity, after: Quantity, bound: Quantity) -> Outcome:
        fall = PERCENT * (1 - after / before)
        if fall.value is None or fall.value >= 0:
            return at_least(fall, bound)
        rise = at_least(PERCENT * (after / before - 1), bound)
        if rise.name == "unknown":
            return rise
        return (OPPOSITE if rise == HOLDS else FAILS).having_read(before, after, bound)

    def effect(self, sections: Sections) -> Markup:
        """Return the condition, the settings of both runs, and their numbers."""
        rows = self.rows(sections)
        names = map(self._name, rows, self.names)
        numbers = map(self._number, rows)
        arrow = Markup(" → ")
        parts = (self.where, arrow.join(names), arrow.join(numbers))
        return Markup("{}: {}<br>{}").format(*parts)

    def effect_in_words(self, sections: Sections) -> Markup:
        """Return the condition, and both numbers with their settings, for a sentence."""
        quoted = Markup("“{}”")
        before, after = (
            Markup("{} ({})").format(
                quoted.format(self._number(row)) if is_lost(row) else self._number(row),
                self._name(row, name),
            )
            for row, name in zip(self.rows(sections), self.names, strict=True)
        )
        return Markup("from {} to {} {}").format(before, after, self.where)

    def _name(self, row: Row, name: str) -> Markup:
        if self.setting and self.setting in row:
            return Markup("{} {}").format(SETTINGS[self.setting], row[self.setting])
        return Markup.escape(name) or case_html(row)

    def _number(self, row: Row) -> Markup:
        if is_lost(row):
            return Markup.escape(row.plain.get("class") or "the cube was lost")
        return row[self.column].interval


@dataclass(frozen=True)
class Advice:
    """A piece of public advice, its source, and the runs that follow it."""

    name: str
    symptom: Symptom
    words: str
    source: str
    trials: tuple[Trial, ...] = ()
    cost: str = ""  # section and case of its run time, relative to the shipped scene

    def run_times(self, sections: Sections) -> list[Quantity]:
        """Return the run time of one world, and that of the largest batch."""
        section, _, case = self.cost.partition("/")
        times = {}
        for row in sections.rows(section) if section else ():
            worlds = row.plain.get("worlds", TIMED_WORLDS[0])
            for column in ("frame_ratio", "time_ratio"):
                if row.case == case and _is_there(row, column):
                    times[worlds] = row[column]
        ends = (TIMED_WORLDS[0], TIMED_WORLDS[-1])
        return [times[worlds] for worlds in ends if worlds in times]


@dataclass(frozen=True)
class Verdict:
    """The outcome of a piece of advice, and of each of its trials."""

    advice: Advice
    outcomes: Mapping[Trial, Outcome]

    @property
    def measured(self) -> dict[Trial, Outcome]:
        return {
            trial: outcome
            for trial, outcome in self.outcomes.items()
            if outcome.name != "unknown" or outcome.is_inconclusive
        }

    @property
    def is_mixed(self) -> bool:
        answers = {outcome.answer for outcome in self.measured.values()}
        return len(answers - {"cannot tell"}) > 1

    @property
    def outcome(self) -> Outcome:
        """Return whether it helps in all trials; the opposite is that it harms in all."""
        outcomes = list(self.measured.values())
        if not outcomes:
            return UNMEASURED
        open_ones = [outcome for outcome in outcomes if outcome.is_inconclusive]
        outcome = FAILS if self.is_mixed else (open_ones or outcomes)[0]
        reads = outcome.reads.union(*(test.reads for test in outcomes))
        return replace(outcome, reads=reads)

    @property
    def word(self) -> str:
        if not self.measured:
            return "not measured here"
        return "depends" if self.is_mixed else VERDICTS[self.outcome.answer]

    def html(self) -> Markup:
        """Return the verdict as one element, with the conditions if it depends on them."""
        if not self.is_mixed:
            return Markup("<b>{}</b>" if self.measured else "<i>{}</i>").format(
                self.word
            )
        places: dict[str, list[str]] = {}
        for trial, outcome in self.measured.items():
            places.setdefault(VERDICTS[outcome.answer], []).append(trial.where)
        parts = [
            f"{word} ({', '.join(conditions)})" for word, conditions in places.items()
        ]
        html = Markup("<span><b>{}</b>: {}</span>")
        return html.format(self.word, "; ".join(parts))


VERDICTS = {
    "holds": "helps",
    "fails": "does nothing",
    "the opposite": "makes it worse",
    "cannot tell": "cannot tell",
}


def is_lost(row: Row) -> bool:
    """Return whether a run lost the cube, exploded or failed."""
    run = row.plain
    is_kept = run.get("class", KEPT[0]) in KEPT
    return bool(run.get("dropped") or run.get("failure") or not is_kept)


def _is_there(row: Row, column: str) -> bool:
    return bool(row) and column in row and row[column].value is not None
