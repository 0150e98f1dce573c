"""Measurements of an edition: what its replicas are, and what they say together with what is tracked."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from measured_report.editions.project import Project
from measured_report.editions.status import records_of
from measured_report.files.atomic import RecordError
from measured_report.files.config import config
from measured_report.files.errors import ReportError
from measured_report.files.groups import grouped
from measured_report.findings.cache import DerivedCache
from measured_report.findings.sections import outline_of
from measured_report.measuring.accelerator import accelerator
from measured_report.parts.section import Section
from measured_report.records.identity import files_digest
from measured_report.records.record import Record
from measured_report.records.replicas import (
    FOLDER,
    Records,
    believed,
    is_copy,
    is_far,
    mismatch,
    read_replica,
)
from measured_report.values.evidence import (
    Evidence,
    evidence_of,
    repeats_of,
    with_cards,
)


@dataclass(frozen=True)
class Measurements:
    """Hold what all measurements of an edition say, by section."""

    evidence: Mapping[str, Evidence] = field(default_factory=dict)
    kinds: Mapping[str, str] = field(default_factory=dict)  # on how many kinds of processor, in words; empty for one
    digest: str = ""  # covers the replicas
    damaged: Sequence[str] = ()  # what is wrong with each replica that can't be read
    names: Sequence[str] = ()  # of the others

    def confirmed(self, name: str, section: Section) -> Section:
        """Return a section whose claims say by how many measurements they are decided, where there are several."""
        if (count := self.evidence[name].count if name in self.evidence else 1) < 2:
            return section
        text, claims = f"by {count} measurements{self.kinds.get(name, '')}", []
        for claim in section.claims:
            has_traces = any(".csv.gz" in pointer for pointer in claim.outcome.reads)  # which replicas lack
            is_decided = claim.outcome.name != "unknown" and not has_traces
            claims.append(replace(claim, confirmed=text) if is_decided else claim)
        return replace(section, claims=claims)


def measurements_of(project: Project, tracked: Records, cache: DerivedCache) -> Measurements:
    """Return what all measurements of an edition say, kept from before."""

    def find() -> Measurements:
        read, damaged = read_replicas(project)
        replicas = [_alike(tracked, records) for records in read.values()]
        noise = tracked.get(config().noise_section)
        repeats = repeats_of(noise.rows) if noise else {}
        of = {name: believed([record, *(side.get(name) for side in replicas)]) for name, record in tracked.items()}
        evidence = with_cards({name: evidence_of(records, repeats) for name, records in of.items()})
        kinds = {name: _kinds([*filter(None, records)]) for name, records in of.items()}
        return Measurements(evidence, kinds, files_digest(replica_files(project), project.results), damaged, [*read])

    if not tracked:
        return Measurements()
    files = [*replica_files(project), *(project.record_path(name) for name in tracked)]
    name, module = f"{project.profile}.{project.release}.evidence", outline_of(next(iter(tracked))).file
    # What is no file has a name and no digest, and is named as damaged while it is there.
    return cache.value(name, module, [files_digest(files, project.results), *(path.name for path in files)], find)


def _kinds(records: Sequence[Record]) -> str:
    processors, devices = {record.processor for record in records}, {record.machine["device"] for record in records}
    noun = accelerator().NOUN if devices == {accelerator().KIND} else "processor"
    return f", on {len(processors)} kinds of {noun}" if len(processors) > 1 else ""


def replica_files(project: Project) -> list[Path]:
    return sorted((project.results / FOLDER).glob("*.tgz"))


def read_replicas(project: Project) -> tuple[dict[str, Records], list[str]]:
    """Read an edition's replicas by name, and what is wrong with each that is damaged."""
    replicas, damaged = {}, []
    for path in replica_files(project):
        try:
            replicas[path.stem] = read_replica(path)
        except RecordError as error:
            damaged.append(str(error))
    return replicas, damaged


def replicas_of(project: Project, tracked: Records) -> dict[str, Records]:
    """Read an edition's replicas by name, as far as they are like what is tracked."""
    return {name: _alike(tracked, records) for name, records in read_replicas(project)[0].items()}


def replicas_text(project: Project) -> list[str]:
    """Write a line for each replica: how many of its sections are as they are tracked, and which move nothing."""
    tracked, (replicas, damaged) = {record.section: record for record in records_of(project)}, read_replicas(project)
    fresh = {name: _alike(tracked, records) for name, records in replicas.items()}
    sides = [tracked, *fresh.values()]
    lines = [f"damaged: {fault}" for fault in damaged]
    for name, records in fresh.items():
        far = [section for section, record in records.items() if is_far(record, [side.get(section) for side in sides])]
        apart = f"; kept apart, far outside what the others say: {', '.join(far)}" if far else ""
        lines.append(f"replica {name}: {len(records)} of {len(replicas[name])} sections fresh{apart}")
    return lines


def _alike(tracked: Records, records: Records) -> Records:
    return {name: record for name, record in records.items() if name in tracked and not mismatch(tracked[name], record)}


def refused(project: Project, records: Records) -> Mapping[str, str]:
    """Say by section why it is no measurement of this edition; ReportError, one line, for copies and when none is."""
    tracked = {record.section: record for record in records_of(project)}
    measurements, reasons = [tracked, *replicas_of(project, tracked).values()], {}
    for name, record in records.items():
        if reason := mismatch(tracked[name], record) if name in tracked else "not measured here":
            reasons[name] = reason
        elif any(is_copy(measurement[name], record) for measurement in measurements if name in measurement):
            raise ReportError(f"its section {name} is a copy of one that is there")
    if len(reasons) == len(records):
        raise ReportError(f"it has no section of this edition: {reasons_text(reasons)}")
    return reasons


def reasons_text(reasons: Mapping[str, str]) -> str:
    """Name sections by why they are left out."""
    names = grouped((reason, name) for name, reason in reasons.items())
    return "; ".join(f"{reason} ({', '.join(sections)})" for reason, sections in names.items())
