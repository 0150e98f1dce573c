"""Replicas of an edition: those that are there, and which of another's records may become one."""

from collections.abc import Mapping
from pathlib import Path

from measured_report.editions.project import Project
from measured_report.editions.status import records_of
from measured_report.files.atomic import RecordError
from measured_report.files.errors import ReportError
from measured_report.records.replicas import FOLDER, Records, is_copy, read_replica, unlike


def replica_files(project: Project) -> list[Path]:
    return sorted((project.results / FOLDER).glob("*.tgz"))


def replicas_of(project: Project, tracked: Records) -> dict[str, Records]:
    """Read an edition's replicas by name, as far as their sections are those that are tracked; what is left may be
    empty. RecordError for a damaged one."""
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
