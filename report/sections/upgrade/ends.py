"""Choose the two releases between which changes are reported."""

from dataclasses import dataclass

from measured_report.changes.query import Query
from measured_report.editions.release import read_label
from measured_report.findings.chapters import Releases
from report.shared import Outcome, Quantity, settings_of


def released(releases: Releases, edition: str) -> Releases:
    """Return all releases except the given edition and trials of other packages."""
    return {
        name: chapters
        for name, chapters in releases.items()
        if name == edition or not read_label(name).pins
    }


@dataclass(frozen=True)
class Ends:
    """The oldest and the newest release that has results."""

    releases: Releases
    old: str
    new: str

    @property
    def names(self) -> dict[str, str]:
        settings = settings_of(self.releases)
        return {"a": settings.name_of(self.old), "b": settings.name_of(self.new)}

    @property
    def alone(self) -> Outcome | None:
        """Return unknown if only one release has results."""
        if self.old != self.new:
            return None
        return Outcome("unknown", f"only Newton {self.old} has results")

    def cells(self, query: Query) -> tuple[Quantity, Quantity]:
        old = self.releases[self.old]
        new = self.releases[self.new]
        return query.cell(old, self.old), query.cell(new, self.new)

    def live(self, case: str, column: str) -> tuple[Quantity, Quantity]:
        return self.cells(Query(f"upgrade.{case}.{column}"))


def machines_differ(releases: Releases, section: str) -> Outcome | None:
    """Return unknown if the times of the two releases cannot be compared."""
    timed = [chapters[section] for chapters in releases.values() if section in chapters]
    records = [chapter.results.record for chapter in timed]
    if not records or records[0].machine_for_speed == records[-1].machine_for_speed:
        return None
    first = records[0].machine_in_full
    last = records[-1].machine_in_full
    return Outcome("unknown", f"the releases were measured on {first} and on {last}")
