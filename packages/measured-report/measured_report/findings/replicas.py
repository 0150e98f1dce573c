"""Measurements of an edition: what its replicas are, and what they say together with what is tracked."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from measured_report.editions.project import Project
from measured_report.editions.status import records_of
from measured_report.files.atomic import RecordError
from measured_report.files.config import Report
from measured_report.files.errors import ReportError
from measured_report.files.groups import grouped
from measured_report.findings.cache import DerivedCache
from measured_report.findings.sections import outline_of
from measured_report.parts.section import Section
from measured_report.records.identity import files_digest
from measured_report.records.record import Record
from measured_report.records.replicas import FOLDER, Records, mismatch, read_replica
from measured_report.values.body import Body, body_of
from measured_report.values.evidence import Evidence
from measured_report.values.quantities import Pointer


@dataclass(frozen=True)
class Measurements:
    """Hold what all measurements of an edition say, by section."""

    evidence: Mapping[str, Evidence] = field(default_factory=dict)
    kinds: Mapping[str, str] = field(
        default_factory=dict
    )  # on how many kinds of processor, in words; empty for one
    digest: str = ""  # covers the replicas
    damaged: Sequence[str] = ()  # what is wrong with each replica that can't be read
    names: Sequence[str] = ()  # of the others
    calibration: Mapping[str, tuple[int, int]] = field(default_factory=dict)
    """By kind of number: how many measurements lie where the others predict, of how many."""

    def confirmed(self, name: str, section: Section) -> Section:
        """Return a section whose claims say by how many measurements they are decided, where there are several."""
        if (count := self.evidence[name].count if name in self.evidence else 1) < 2:
            return section
        text = f"by {count} measurements{self.kinds.get(name, '')}"
        claims = []
        for claim in section.claims:
            pointers = map(Pointer, claim.outcome.reads)
            has_traces = any(
                pointer.is_trace for pointer in pointers
            )  # which replicas lack
            is_decided = claim.outcome.name != "unknown" and not has_traces
            claims.append(replace(claim, confirmed=text) if is_decided else claim)
        return replace(section, claims=claims)


def measurements_of(
    project: Project, tracked: Records, cache: DerivedCache
) -> Measurements:
    """Return what all measurements of an edition say, kept from before."""
    if not tracked:
        return Measurements()
    body = _body_of(project, next(iter(tracked)), cache)
    read, damaged = read_replicas(project)
    replicas = [alike(tracked, records) for records in read.values()]
    kinds = {}
    evidence = {}
    for name, record in tracked.items():
        records = [record, *(each[name] for each in replicas if name in each)]
        kinds[name] = _kinds(records, project.report)
        evidence[name] = body.sections.get(
            (project.aside + project.release, name), Evidence()
        )
    digest = files_digest(replica_files(project), project.results)
    return Measurements(evidence, kinds, digest, damaged, [*read], body.calibration)


def _compared(project: Project) -> list[Project]:
    """Return the editions whose measurements show how numbers scatter.

    What was measured aside scatters as what is tracked, which is read with it.
    """
    sides = [project]
    if project.aside:
        sides.append(replace(project, aside="", profile="full"))
    return [side.of(release) for side in sides for release in side.releases]


def measured_digest(project: Project) -> str:
    """Digest the records and replicas of all editions that are compared."""
    files: list[Path] = []
    for each in _compared(project):
        files += replica_files(each)
        files += each.results.glob("*.json")
    digest = files_digest(files, project.root)
    # A replica that is not a file has a name and no digest, and is named as damaged.
    return f"{digest} {' '.join(sorted(path.name for path in files))}"


def _body_of(project: Project, section: str, cache: DerivedCache) -> Body:
    """Return the evidence of all editions together, kept from before."""

    def find() -> Body:
        measured: dict[tuple[str, str], list[Record | None]] = {}
        for each in _compared(project):
            shown = {record.section: record for record in records_of(each)}
            replicas = [
                alike(shown, found) for found in read_replicas(each)[0].values()
            ]
            for name, record in shown.items():
                several = [record, *(found.get(name) for found in replicas)]
                measured[each.aside + each.release, name] = several
        return body_of(measured, project.report.columns)

    name = f"{project.aside}{project.profile}.evidence"
    module = outline_of(section).file
    return cache.value(name, module, [measured_digest(project)], find)


def _kinds(records: Sequence[Record], report: Report) -> str:
    """Return on how many kinds of processor records were measured, in words."""
    processors = {record.processor for record in records}
    devices = {record.machine["device"] for record in records}
    is_accelerated = devices == {report.accelerator.KIND}
    noun = report.accelerator.NOUN if is_accelerated else "processor"
    return f", on {len(processors)} kinds of {noun}" if len(processors) > 1 else ""


def replica_files(project: Project) -> list[Path]:
    return sorted((project.results / FOLDER).glob("*.tgz"))


def read_replicas(project: Project) -> tuple[dict[str, Records], list[str]]:
    """Read an edition's replicas by name, and what is wrong with each that is damaged."""
    replicas = {}
    damaged = []
    for path in replica_files(project):
        try:
            replicas[path.stem] = read_replica(path)
        except RecordError as error:
            damaged.append(str(error))
    return replicas, damaged


def replicas_text(project: Project) -> list[str]:
    """Write a line for each replica: how many of its sections are as they are tracked."""
    tracked = {record.section: record for record in records_of(project)}
    replicas, damaged = read_replicas(project)
    lines = [f"damaged: {fault}" for fault in damaged]
    for name, records in replicas.items():
        fresh = alike(tracked, records)
        lines.append(f"replica {name}: {len(fresh)} of {len(records)} sections fresh")
    return lines


def alike(tracked: Records, records: Records) -> Records:
    return {
        name: record
        for name, record in records.items()
        if name in tracked and not mismatch(tracked[name], record)
    }


def refused(project: Project, records: Records) -> Mapping[str, str]:
    """Return the sections that are no measurement of this edition, each with the reason; ReportError if all are."""
    tracked = {record.section: record for record in records_of(project)}
    reasons = {}
    for name, record in records.items():
        reason = (
            mismatch(tracked[name], record) if name in tracked else "not measured here"
        )
        if reason:
            reasons[name] = reason
    if len(reasons) == len(records):
        raise ReportError(f"it has no section of this edition: {reasons_text(reasons)}")
    return reasons


def reasons_text(reasons: Mapping[str, str]) -> str:
    """Name sections by why they are left out."""
    names = grouped((reason, name) for name, reason in reasons.items())
    return "; ".join(
        f"{reason} ({', '.join(sections)})" for reason, sections in names.items()
    )
