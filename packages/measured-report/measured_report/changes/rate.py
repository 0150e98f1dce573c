"""The rate of false alarms: each measurement of an edition is left out in turn, and compared with the others."""

from collections.abc import Iterator, Sequence
from dataclasses import astuple, dataclass, fields

from measured_report.changes.compare import Comparison, compare
from measured_report.editions.project import Project
from measured_report.editions.replicas import replicas_of
from measured_report.editions.status import State
from measured_report.files.config import config
from measured_report.pages.editions import Chapter, Edition
from measured_report.pages.replicas import compared, derive_bare, kept
from measured_report.pages.sections import outline_of
from measured_report.records.replicas import FOLDER, Records
from measured_report.values.quantities import VALUES_FILE, Value

LEAST = 3
"""Measurements that it takes: the noise of those that stay comes from two of them."""


@dataclass(frozen=True)
class Rate:
    """Counts comparisons in which nothing had changed, a section each, and what was told all the same."""

    comparisons: int = 0
    rang: int = 0
    claims: int = 0
    flips: int = 0
    numbers: int = 0
    moves: int = 0

    def __add__(self, other: "Rate") -> "Rate":
        return Rate(*map(sum, zip(astuple(self), astuple(other), strict=True)))

    def values(self, project: Project) -> dict[str, Value]:
        """Return its counts for a page, by name; none where there was nothing to compare."""
        place = f"{config().edition_folder(project.release)}/{VALUES_FILE}#/{FOLDER}"
        words = {each.name: each.name.replace("_", " ") for each in fields(self)}
        counts = {name: getattr(self, name) for name in words} if self.comparisons else {}
        formula = "each measurement left out in turn and compared with the others: "
        return {
            name: Value(count, "1", f"{place}/{name}", noise=0.0, formula=formula + words[name])
            for name, count in counts.items()
        }

    @property
    def text(self) -> str:
        if not self.comparisons:
            return "not known: no section has been measured three times"
        told = f"of {self.comparisons} comparisons in which nothing changed {self.rang} rang"
        return f"{told} ({self.flips} of {self.claims} claims flipped, {self.moves} of {self.numbers} numbers moved)"


def rate_of(edition: Edition) -> Rate:
    """Return the rate of an edition's replicas, kept from before or found now."""
    tracked = {name: chapter.results.record for name, chapter in edition.chapters.items()}
    several = [name for name, of in edition.measurements.apart.items() if of.count >= LEAST and name in tracked]

    def find() -> Rate:
        replicas = [*replicas_of(edition.project, tracked).values()]
        return sum(
            (_rates(edition.project, [tracked, *replicas], out, several) for out in range(len(replicas) + 1)), Rate()
        )

    return kept(edition.project, tracked, edition.cache, "rate", find) if several else Rate()


def _rates(project: Project, measured: Sequence[Records], out: int, several: Sequence[str]) -> Rate:
    """Compare one measurement with the others, in the sections that it has and that were measured often enough."""
    shown, single = measured[0], {**measured[0], **measured[out]}
    rest = [each for place, each in enumerate(measured) if place != out]
    first = {
        name: next(each[name] for each in rest if name in each) for name in shown if any(name in each for each in rest)
    }
    before, after = _edition(project, {**shown, **first}, _others(first, rest)), _edition(project, single, [])
    found = compare(before, after)
    return sum(_counted(found, [name for name in several if name in measured[out]], before), Rate())


def _others(first: Records, rest: Sequence[Records]) -> list[Records]:
    """Return what is left of measurements without those that are shown."""
    left = ({name: record for name, record in each.items() if first.get(name) is not record} for each in rest)
    return [each for each in left if each]


def _edition(project: Project, records: Records, replicas: Sequence[Records]) -> Edition:
    """Make an edition, without words, of records and replicas of them."""
    measurements = compared(project, records, replicas)
    chapters: dict[str, Chapter] = {}
    for name, (results, section) in derive_bare(project, records, measurements.apart).items():
        said = measurements.confirmed(name, section)
        chapters[name] = Chapter(State(name, "fresh", results.record), results, said, {}, None, outline_of(name).page)
    return Edition(project, chapters, [], measurements=measurements)


def _counted(found: Comparison, sections: Sequence[str], before: Edition) -> Iterator[Rate]:
    for name in sections:
        flips = sum(flip.section == name for flip in found.flips)
        told = [move.section for move in found.alarms]
        told += [fault.section for fault in found.faults if fault.kind == "broken"]
        cells = [cell for cell in found.cells if cell.section == name]
        rang = bool(flips) or name in told
        claims = len(before.chapters[name].section.claims) if name in before.chapters else 0
        yield Rate(1, rang, claims, flips, len(cells), sum(cell.is_real for cell in cells))
