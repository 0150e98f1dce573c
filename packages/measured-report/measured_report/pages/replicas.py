"""Measurements of an edition: how far replicas are from what is shown, and what each says to every claim."""

from collections.abc import Callable, Collection, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from inspect import getfile
from pathlib import Path
from typing import Any

from measured_report.editions.project import Project
from measured_report.editions.status import records_of
from measured_report.files.atomic import RecordError
from measured_report.files.errors import ReportError
from measured_report.pages.cache import DerivedCache
from measured_report.pages.sections import Read, derive_section, outline_of
from measured_report.parts.claim import Claim, Outcome
from measured_report.parts.section import Section
from measured_report.records.identity import files_digest
from measured_report.records.record import Record
from measured_report.records.replicas import FOLDER, Records, is_copy, read_replica, unlike
from measured_report.values.noise import NOISE, Floor, floors_of
from measured_report.values.results import Results
from measured_report.values.scatter import Apart, apart

Derived = Mapping[str, tuple[Results, Section]]


@dataclass(frozen=True)
class Measurements:
    """Hold what replicas tell of an edition."""

    apart: Mapping[str, Apart] = field(default_factory=dict)
    """By section, of those that were measured more than once."""
    said: Mapping[str, Mapping[str, Sequence[Outcome]]] = field(default_factory=dict)
    kinds: Mapping[str, str] = field(default_factory=dict)
    """By section on how many kinds of processor it was measured, in words; empty for one."""
    digest: str = ""
    """Covers the replicas."""

    def confirmed(self, name: str, section: Section) -> Section:
        """Return a section whose claims can't tell where measurements differ, and say how many agree where not."""
        said = self.said.get(name, {})
        claims = [self._confirmed(name, claim, said.get(claim.name, ())) for claim in section.claims]
        return replace(section, claims=claims)

    def _confirmed(self, name: str, claim: Claim, others: Sequence[Outcome]) -> Claim:
        if not others or any(".csv.gz" in pointer for pointer in claim.outcome.reads):  # replicas have no traces
            return claim
        said = [claim.outcome.said, *(other.said for other in others)]
        count = len(said)
        if len(set(said)) > 1:
            told = ", ".join(f"{word} in {said.count(word)}" for word in dict.fromkeys(said))
            reason = f"its {count} measurements differ: {told}"
            unknown = replace(claim.outcome, name="unknown", reason=reason, is_inconclusive=True, is_opposite=False)
            return replace(claim, outcome=unknown)
        if claim.outcome.name == "unknown":
            return claim
        return replace(claim, confirmed=f"confirmed in {count} of {count} measurements{self.kinds[name]}")


def measurements_of(project: Project, tracked: Records, cache: DerivedCache) -> Measurements:
    """Return what replicas tell of an edition, kept from before or found now; RecordError for a damaged one."""

    def find() -> Measurements:
        found = compared(project, tracked, list(replicas_of(project, tracked).values()))
        return replace(found, digest=files_digest(replica_files(project), project.results))

    return kept(project, tracked, cache, "replicas", find) if replica_files(project) else Measurements()


def kept(project: Project, tracked: Records, cache: DerivedCache, what: str, make: Callable[[], Any]) -> Any:
    """Return what ``make`` makes of an edition's measurements, or has made of the same before."""
    files = [*replica_files(project), *(project.record_path(name) for name in tracked)]
    modules = [outline_of(name).file for name in tracked]
    cache = cache if cache.root else DerivedCache(project.root)  # it takes as long as all sections take
    codes = [cache.code(module) for module in modules]
    codes.append(Path(getfile(make)).read_text(encoding="utf-8"))  # no section imports it
    name = f"{project.profile}.{project.release}.{what}"
    return cache.value(name, modules[0], [files_digest(files, project.results), *codes], make)


def compared(project: Project, shown: Records, replicas: Sequence[Records]) -> Measurements:
    """Compare the measurement that is shown with its replicas, and ask each for every claim."""
    of = {name: [record, *(each[name] for each in replicas if name in each)] for name, record in shown.items()}
    several = {name: records for name, records in of.items() if len(records) > 1}
    parts = {name: apart(records) for name, records in several.items()}
    said: dict[str, dict[str, list[Outcome]]] = {}
    for each in replicas:
        for name, (_, section) in derive_bare(project, {**shown, **each}, parts, each).items():
            for claim in section.claims:
                bare = replace(claim.outcome, reads=frozenset(), bounds=())
                said.setdefault(name, {}).setdefault(claim.name, []).append(bare)
    return Measurements(parts, said, {name: _kinds(records) for name, records in several.items()})


def _kinds(records: Sequence[Record]) -> str:
    processors, devices = {each.processor for each in records}, {each.machine["device"] for each in records}
    noun = "GPU" if devices == {"cuda"} else "processor"
    return f", on {len(processors)} kinds of {noun}" if len(processors) > 1 else ""


def floors_in(records: Records) -> Mapping[str, Floor]:
    """Return the noise of runs of one case, where it was measured."""
    return floors_of(records[NOISE].rows, records[NOISE].units) if NOISE in records else {}


def derive_bare(project: Project, records: Records, parts: Mapping[str, Apart], asked: Collection[str]) -> Derived:
    """Derive these sections, without words; what compares editions, or can't be derived, is left out."""
    floors = floors_in(records)
    found: dict[str, tuple[Results, Section]] = {}
    needed, ordered = set(asked), sorted(records, key=lambda name: outline_of(name).order)
    for name in reversed(ordered):  # what a section reads stands before it
        needed.update(outline_of(name).reads if name in needed else ())
    for name in filter(needed.__contains__, ordered):
        outline = outline_of(name)
        others = {other: found[other][0] for other in outline.reads if other in found}
        path, record = project.record_path(name), records[name]
        results = Results(
            record, path, Read(outline, others), {}, floors, parts.get(name, Apart()), outline.label, outline.labels
        )
        with suppress(ReportError):
            if not outline.compares:
                found[name] = results, derive_section(results, {})
    return {name: each for name, each in found.items() if name in asked}


def replica_files(project: Project) -> list[Path]:
    return sorted((project.results / FOLDER).glob("*.tgz"))


def replicas_of(project: Project, tracked: Records) -> dict[str, Records]:
    """Read an edition's replicas by name, as far as they are like what is tracked; RecordError for a damaged one."""
    found = {path.stem: read_replica(path) for path in replica_files(project)}
    return {name: _alike(tracked, records) for name, records in found.items()}


def replicas_text(project: Project) -> list[str]:
    """Write a line for each replica: how many of its sections are as they are tracked."""
    tracked, lines = {record.section: record for record in records_of(project)}, []
    for path in replica_files(project):
        try:
            records = read_replica(path)
        except RecordError as error:
            lines.append(f"damaged: {error}")
        else:
            lines.append(f"replica {path.stem}: {len(_alike(tracked, records))} of {len(records)} sections fresh")
    return lines


def _alike(tracked: Records, records: Records) -> Records:
    return {name: each for name, each in records.items() if name in tracked and not unlike(tracked[name], each)}


def refused(project: Project, records: Records) -> Mapping[str, str]:
    """Say by section why it is no measurement of this edition; ReportError, one line, for copies and when none is."""
    tracked = {record.section: record for record in records_of(project)}
    there, found = [tracked, *replicas_of(project, tracked).values()], {}
    for name, each in records.items():
        if reason := unlike(tracked[name], each) if name in tracked else "not measured here":
            found[name] = reason
        elif any(is_copy(other[name], each) for other in there if name in other):
            raise ReportError(f"its section {name} is a copy of one that is there")
    if len(found) == len(records):
        raise ReportError(f"it has no section of this edition: {reasons_text(found)}")
    return found


def reasons_text(reasons: Mapping[str, str]) -> str:
    """Name sections by why they are left out."""
    names: dict[str, list[str]] = {}
    for name, reason in reasons.items():
        names.setdefault(reason, []).append(name)
    return "; ".join(f"{reason} ({', '.join(each)})" for reason, each in names.items())
