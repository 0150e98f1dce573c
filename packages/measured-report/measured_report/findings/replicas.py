"""Measurements of an edition: what its replicas are, and what they say together with what is tracked."""

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path

from measured_report.editions.project import Project
from measured_report.editions.status import Kind, State, other_damage, records_of
from measured_report.files.atomic import RecordError
from measured_report.files.config import Report
from measured_report.files.errors import ReportError
from measured_report.files.groups import grouped
from measured_report.findings.cache import DerivedCache
from measured_report.findings.sections import outline_of
from measured_report.records.identity import files_digest
from measured_report.records.record import Record
from measured_report.records.replicas import FOLDER, Records, mismatch, read_replica
from measured_report.values.evidence import Evidence


@dataclass(frozen=True)
class Measurements:
    """Holds what all measurements of an edition say, by section."""

    evidence: Mapping[str, Evidence] = field(default_factory=dict)
    words: Mapping[str, str] = field(default_factory=dict)
    """By how many measurements claims are decided, for sections that have several."""
    damaged: Sequence[str] = ()  # what is wrong with each replica that cannot be read
    names: Sequence[str] = ()  # of the other replicas
    calibration: Mapping[str, tuple[int, int]] = field(default_factory=dict)


def measurements_of(
    project: Project, tracked: Records, cache: DerivedCache
) -> Measurements:
    """Return what all measurements of an edition say, kept from before."""
    if not tracked:
        return Measurements(damaged=read_replicas(project)[1])
    every = cache.value(
        f"{project.aside}{project.profile}.evidence",
        outline_of(next(iter(tracked))).file,
        [measured_digest(project)],
        lambda: _measurements(project),
    )
    return every.get(project.aside + project.release, Measurements())


def measured_digest(project: Project) -> str:
    """Digest the records and replicas of all editions that are compared."""
    files: list[Path] = []
    for each in _compared(project):
        files += replica_files(each)
        files += each.results.glob("*.json")
    digest = files_digest(files, project.root)
    # A replica that is not a file has a name and no digest, and is named as damaged.
    return f"{digest} {' '.join(sorted(path.name for path in files))}"


def _compared(project: Project) -> list[Project]:
    """Return the editions whose measurements show how numbers scatter.

    What was measured aside scatters as what is tracked, which is read with it.
    """
    sides = [project]
    if project.aside:
        sides.append(replace(project, aside="", profile="full"))
    return [side.of(release) for side in sides for release in side.releases]


def _measurements(project: Project) -> dict[str, Measurements]:
    """Return what all measurements of each edition say."""
    # A slow import, which nothing needs while this is kept.
    from measured_report.values.body import body_of

    measured: dict[tuple[str, str], list[Record | None]] = {}
    found = {}
    for each in _compared(project):
        edition = each.aside + each.release
        shown = {record.section: record for record in records_of(each)}
        read, damaged = read_replicas(each)
        replicas = [alike(shown, records) for records in read.values()]
        for name, record in shown.items():
            several = [record, *(records.get(name) for records in replicas)]
            measured[edition, name] = several
        found[edition] = Measurements(damaged=damaged, names=[*read])
    body = body_of(measured, project.report.columns)
    for edition, measurements in found.items():
        evidence = {}
        words = {}
        for (other, name), records in measured.items():
            if other != edition:
                continue
            evidence[name] = body.sections[edition, name]
            present = [record for record in records if record]
            if len(present) > 1:
                kinds = _kinds(present, project.report)
                words[name] = f"by {len(present)} measurements{kinds}"
        found[edition] = replace(
            measurements, evidence=evidence, words=words, calibration=body.calibration
        )
    return found


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


def damage_of(project: Project, states: Iterable[State]) -> Iterator[State]:
    """Yield each record, replica, folder and manifest of an edition that cannot be read.

    ``states`` are those of its records.
    """
    yield from (state for state in states if state.kind == Kind.DAMAGED)
    yield from other_damage(project)
    for fault in read_replicas(project)[1]:
        yield State(FOLDER, Kind.DAMAGED, notes=(fault,))


def replicas_text(project: Project) -> list[str]:
    """Write a line for each replica: how many of its sections are as they are tracked."""
    tracked = {record.section: record for record in records_of(project)}
    lines = []
    for name, records in read_replicas(project)[0].items():
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
