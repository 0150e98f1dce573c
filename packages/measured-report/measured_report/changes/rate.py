"""The rate of false alarms: each measurement of an edition is left out in turn, and compared with the others."""

from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import chain

from measured_report.changes.compare import Comparison, compare
from measured_report.editions.project import Project
from measured_report.editions.status import State
from measured_report.files.config import config
from measured_report.pages.editions import Chapter, Edition
from measured_report.pages.replicas import compared, derive_bare, kept, replicas_of
from measured_report.pages.sections import outline_of
from measured_report.records.replicas import FOLDER, Records
from measured_report.values.quantities import VALUES_FILE, Value

LEAST = 3
"""Measurements that it takes: the noise of those that stay comes from two of them."""


COUNTED = ("comparisons", "rang", "claims", "flips", "numbers", "moves")
"""Comparisons in which nothing had changed, a section each, those that rang, and what was told of what they compare."""
Rate = Counter[str]


def rate_values(rate: Rate, project: Project) -> dict[str, Value]:
    """Return the counts for a page, by name; none where there was nothing to compare."""
    place = f"{config().edition_folder(project.release)}/{VALUES_FILE}#/{FOLDER}"
    formula = "each measurement left out in turn and compared with the others: "
    return {
        name: Value(rate[name], "1", f"{place}/{name}", noise=0.0, formula=formula + name) for name in COUNTED if rate
    }


def rate_text(rate: Rate) -> str:
    """Say how often nothing had changed and something was told."""
    if not rate:
        return "not known: no section has been measured three times"
    words = "of {comparisons} comparisons in which nothing changed {rang} rang "
    words += "({flips} of {claims} claims flipped, {moves} of {numbers} numbers moved)"
    return words.format_map(rate)


def rate_of(edition: Edition) -> Rate:
    """Return the rate of an edition's replicas, kept from before or found now."""
    tracked = {name: chapter.results.record for name, chapter in edition.chapters.items()}
    several = [name for name, of in edition.measurements.apart.items() if of.count >= LEAST and name in tracked]

    def find() -> Rate:
        replicas = [*replicas_of(edition.project, tracked).values()]
        outs = (_rates(edition.project, [tracked, *replicas], out, several) for out in range(len(replicas) + 1))
        return sum(chain.from_iterable(outs), Rate())

    return kept(edition.project, tracked, edition.cache, "rate", find) if several else Rate()


def _rates(project: Project, measured: Sequence[Records], out: int, several: Sequence[str]) -> Iterator[Rate]:
    """Compare one measurement with the others, in the sections that it has and that were measured often enough."""
    shown, single = measured[0], {**measured[0], **measured[out]}
    rest = [each for place, each in enumerate(measured) if place != out]
    first = {name: record for each in reversed(rest) for name, record in each.items()}
    before, after = _edition(project, {**shown, **first}, _others(first, rest)), _edition(project, single, [])
    found = compare(before, after)
    return _counted(found, [name for name in several if name in measured[out]], before)


def _others(first: Records, rest: Sequence[Records]) -> list[Records]:
    left = ({name: record for name, record in each.items() if first.get(name) is not record} for each in rest)
    return [each for each in left if each]


def _edition(project: Project, records: Records, replicas: Sequence[Records]) -> Edition:
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
        claims = len(before.chapters[name].section.claims) if name in before.chapters else 0
        counts = 1, bool(flips) or name in told, claims, flips, len(cells), sum(cell.is_real for cell in cells)
        yield Rate(dict(zip(COUNTED, counts, strict=True)))
