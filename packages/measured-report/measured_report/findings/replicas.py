"""Measurements of an edition: what its replicas are, and what they say together with what is tracked."""

from collections.abc import Mapping, Sequence
from pathlib import Path

from measured_report.editions.project import Project
from measured_report.editions.status import records_of
from measured_report.files.atomic import RecordError
from measured_report.files.config import Report
from measured_report.files.errors import ReportError
from measured_report.files.groups import grouped
from measured_report.findings.cache import DerivedCache
from measured_report.findings.sections import outline_of
from measured_report.records.identity import files_digest
from measured_report.records.record import Record
from measured_report.records.replicas import FOLDER, Records, mismatch, read_replica
from measured_report.values.cells import evidence_of
from measured_report.values.evidence import Evidence, repeats_of

Measurements = tuple[
    Mapping[str, Evidence], Mapping[str, str], Sequence[str], Sequence[str]
]
"""By section: the evidence, and words that say by how many measurements; what is wrong
with each replica that can't be read; and the names of the others."""


def measurements_of(
    project: Project, tracked: Records, cache: DerivedCache
) -> Measurements:
    """Return what all measurements of an edition say, kept from before."""
    columns = project.report.columns

    def find() -> Measurements:
        read, damaged = read_replicas(project)
        replicas = [alike(tracked, records) for records in read.values()]
        noise = tracked.get(columns.settings.noise_section)
        repeats = repeats_of(noise.rows if noise else (), columns)
        measured: dict[str, list[Record | None]] = {
            name: [record, *(records.get(name) for records in replicas)]
            for name, record in tracked.items()
        }
        evidence = evidence_of(measured, repeats, columns)
        words = {}
        for name, records in measured.items():
            if (count := evidence[name].count) > 1:
                kinds = _kinds([each for each in records if each], project.report)
                words[name] = f"by {count} measurements{kinds}"
        return evidence, words, damaged, [*read]

    if not tracked:
        return {}, {}, (), ()
    files = [*replica_files(project), *(project.record_path(name) for name in tracked)]
    name = f"{project.profile}.{project.release}.evidence"
    module = outline_of(next(iter(tracked))).file
    # What is no file has a name and no digest, and is named as damaged while it is there.
    inputs = [files_digest(files, project.results), *(path.name for path in files)]
    return cache.value(name, module, inputs, find)


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
