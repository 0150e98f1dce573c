"""The measurements of an edition: its tracked records and its replicas."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from measured_report.editions.project import Project
from measured_report.editions.status import records_of
from measured_report.files.atomic import RecordError, files_in, short_path
from measured_report.files.config import Report
from measured_report.files.errors import ReportError
from measured_report.files.groups import grouped
from measured_report.findings.cache import DerivedCache
from measured_report.records.identity import files_digest
from measured_report.records.record import Record
from measured_report.records.replicas import FOLDER, Records, mismatch, read_replica
from measured_report.values.evidence import Evidence


@dataclass(frozen=True)
class Measurements:
    """The evidence of an edition from all its measurements."""

    evidence: Mapping[str, Evidence] = field(default_factory=dict)
    words: Mapping[str, str] = field(default_factory=dict)
    """The count of measurements in words, for each section that has several."""
    damaged: Sequence[str] = ()  # a message for each replica that cannot be read
    names: Sequence[str] = ()  # of the readable replicas
    calibration: Mapping[str, tuple[int, int]] = field(default_factory=dict)


def measurements_of(project: Project, cache: DerivedCache) -> Measurements:
    """Return the evidence of an edition, from the cache if its inputs did not change."""
    by_edition = cache.value(
        f"{project.aside}{project.profile}.evidence",
        None,
        [measured_digest(project)],
        lambda: _measurements(project),
    )
    return by_edition.get(project.aside + project.release, Measurements())


def measured_digest(project: Project) -> str:
    """Return a digest of the records and replicas of all editions that are evaluated."""
    files: list[Path] = []
    for edition in _compared(project):
        files += replica_files(edition)
        files += files_in(edition.results, "*.json")
    digest = files_digest(files, project.root)
    # A replica that is a folder has no digest, but it is listed as damaged by its name.
    return f"{digest} {' '.join(sorted(path.name for path in files))}"


def _compared(project: Project) -> list[Project]:
    """Return the editions whose measurements show how numbers scatter.

    Results in a separate folder scatter like the tracked ones, so both are evaluated.
    If such results were measured several times, one machine measured them in turn. They
    then scatter less than measurements on several machines, and are evaluated
    separately.
    """
    sides = [project]
    is_repeated = any(replica_files(project.of(name)) for name in project.releases)
    if project.aside and not is_repeated:
        sides.append(replace(project, aside="", profile="full"))
    return [side.of(release) for side in sides for release in side.releases]


def _measurements(project: Project) -> dict[str, Measurements]:
    """Return the evidence of each edition."""
    # Slow to import, and not needed if the evidence is in the cache.
    from measured_report.values.body import body_of

    measured: dict[tuple[str, str], list[Record | None]] = {}
    by_edition = {}
    for edition in _compared(project):
        label = edition.aside + edition.release
        tracked = {record.section: record for record in records_of(edition)}
        named_replicas, damaged = read_replicas(edition)
        replicas = [alike(tracked, records) for records in named_replicas.values()]
        for name, record in tracked.items():
            repeated = [records.get(name) for records in replicas]
            measured[label, name] = [record, *repeated]
        by_edition[label] = Measurements(damaged=damaged, names=[*named_replicas])
    body = body_of(measured, project.report.columns)
    for label, measurements in by_edition.items():
        evidence = {}
        words = {}
        for (of_edition, name), records in measured.items():
            if of_edition != label:
                continue
            evidence[name] = body.sections[label, name]
            present = [record for record in records if record]
            if len(present) > 1:
                kinds = _kinds(present, project.report)
                words[name] = f"by {len(present)} measurements{kinds}"
        by_edition[label] = replace(
            measurements, evidence=evidence, words=words, calibration=body.calibration
        )
    return by_edition


def _kinds(records: Sequence[Record], report: Report) -> str:
    """Return the number of processor types as a phrase, or an empty string if there is
    only one.
    """
    processors = {record.processor for record in records}
    devices = {record.machine["device"] for record in records}
    is_accelerated = devices == {report.accelerator.KIND}
    noun = report.accelerator.NOUN if is_accelerated else "processor"
    return f", on {len(processors)} kinds of {noun}" if len(processors) > 1 else ""


def replica_files(project: Project) -> list[Path]:
    """Return the files of an edition's replicas."""
    return files_in(project.results / FOLDER, "*.tgz")


def read_replicas(project: Project) -> tuple[dict[str, Records], list[str]]:
    """Read an edition's replicas by name.

    Also return a message for each one that is damaged or a copy of another one.
    """
    replicas: dict[str, Records] = {}
    damaged = []
    for path in replica_files(project):
        try:
            records = read_replica(path)
            if records in replicas.values():
                raise RecordError(f"{short_path(path)} is a copy of another: remove it")
            replicas[path.stem] = records
        except RecordError as error:
            damaged.append(str(error))
    return replicas, damaged


def replicas_text(project: Project) -> list[str]:
    """Return a line for each replica with the number of its sections that have the
    current code.
    """
    tracked = {record.section: record for record in records_of(project)}
    lines = []
    for name, records in read_replicas(project)[0].items():
        fresh = alike(tracked, records)
        lines.append(f"replica {name}: {len(fresh)} of {len(records)} sections fresh")
    return lines


def alike(tracked: Records, records: Records) -> Records:
    """Return the records of a replica that can be compared with the tracked ones."""
    return {
        name: record
        for name, record in records.items()
        if name in tracked and not mismatch(tracked[name], record)
    }


def refused(project: Project, records: Records) -> Mapping[str, str]:
    """Return the sections that are not measurements of this edition, with the reason.

    Raise ReportError if all sections belong to other editions.
    """
    tracked = {record.section: record for record in records_of(project)}
    reasons = {}
    for name, record in records.items():
        reason = (
            mismatch(tracked[name], record) if name in tracked else "not measured here"
        )
        if reason:
            reasons[name] = reason
    if len(reasons) == len(records):
        raise ReportError(
            f"its sections do not belong to this edition: {reasons_text(reasons)}"
        )
    return reasons


def reasons_text(reasons: Mapping[str, str]) -> str:
    """Return the reasons in words, each with the sections that it applies to."""
    names = grouped((reason, name) for name, reason in reasons.items())
    return "; ".join(
        f"{reason} ({', '.join(sections)})" for reason, sections in names.items()
    )
