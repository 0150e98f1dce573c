"""What releases have side by side: changes between them, marks, and the two between which changes are told."""

from dataclasses import dataclass

from measured_report.changes.query import Query
from measured_report.editions.release import read_label
from measured_report.files.config import config
from measured_report.findings.chapters import Releases
from report.shared import HOLDS, Outcome, Quantity, Results, beyond


def released(releases: Releases, shown: str) -> Releases:
    """Return what a page compares: no trial with other packages than a release comes with, but for the one shown."""
    return {
        name: chapters
        for name, chapters in releases.items()
        if name == shown or not read_label(name).pins
    }


@dataclass(frozen=True)
class Ends:
    """The oldest and the newest release that has results, between which changes are told."""

    releases: Releases
    old: str
    new: str

    @property
    def names(self) -> dict[str, str]:
        return {"a": config().name_of(self.old), "b": config().name_of(self.new)}

    @property
    def one(self) -> Outcome | None:
        return (
            Outcome("unknown", f"only Newton {self.old} has results")
            if self.old == self.new
            else None
        )

    def cells(self, headline: Query) -> tuple[Quantity, Quantity]:
        return headline.cell(self.releases[self.old], self.old), headline.cell(
            self.releases[self.new], self.new
        )

    def live(self, case: str, column: str) -> tuple[Quantity, Quantity]:
        return self.cells(Query(f"upgrade.{case}.{column}"))


def unchanged(
    results: Results, name: str, before: Quantity, after: Quantity, noise: Quantity
) -> Outcome:
    """Tell whether the change ``name`` is no more than noise and rounding; clearly more is the opposite."""
    moved = results.value(
        name, "later release less earlier one", after - before, across=True
    )
    is_same = (
        None not in (moved.value, noise.value) and abs(moved.number) <= noise.number
    )
    return (HOLDS if is_same else beyond(moved, noise)).having_read(
        before, after, moved, noise
    )


def machines_differ(releases: Releases, section: str) -> Outcome | None:
    """Return unknown where times of the oldest and the newest release do not compare: machines differ."""
    records = [
        chapters[section].results.record
        for chapters in releases.values()
        if section in chapters
    ]
    if records and records[0].machine_for_speed != records[-1].machine_for_speed:
        return Outcome(
            "unknown",
            f"measured on {records[0].machine_in_full} and on {records[-1].machine_in_full}",
        )
    return None
