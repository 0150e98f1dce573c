"""Compare the records of an edition with the code that would measure them now."""

import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from enum import Enum

from measured_report.editions.project import MANIFEST, Project, read_manifest
from measured_report.files.atomic import RecordError, folder_fault
from measured_report.files.groups import grouped
from measured_report.records.code import Code
from measured_report.records.identity import (
    MISSING,
    changes,
    identity_of,
    package_versions,
    sections,
)
from measured_report.records.record import Record, load_record
from measured_report.records.replicas import FOLDER


class Kind(str, Enum):
    """List the states of a section's record; each is printed as its value."""

    FRESH = "fresh"
    STALE = "stale"
    MISSING = "missing"
    DAMAGED = "damaged"
    NOT_SHOWN = "not shown"  # the record is valid, but the section cannot be derived

    __str__ = str.__str__


@dataclass(frozen=True)
class State:
    """The state of a section's record, compared with the current code."""

    section: str
    kind: str  # a `Kind`
    record: Record | None = None
    notes: tuple[str, ...] = ()

    @property
    def summary(self) -> str:
        """Return the state and, if it is stale, the changed parts of its identity."""
        if self.kind != Kind.STALE:
            return self.kind
        parts = dict.fromkeys(note.partition(":")[0] for note in self.notes)
        return f"{self.kind}: {', '.join(parts)}"

    @property
    def words(self) -> str:
        """Return the notes in one line, grouped by their kind, such as ``code``."""
        kinds = grouped(note.partition(": ")[::2] for note in self.notes)
        texts = []
        for kind, subjects in kinds.items():
            text = ", ".join(filter(None, subjects))
            texts.append(f"{kind}: {text}" if text else kind)
        return "; ".join(texts)


def states_of(project: Project, code: Code | None = None) -> list[State]:
    """Return the state of each section of an edition.

    If the same ``code`` is passed for several editions, each file is read only once.
    """
    states = []
    code = code or Code(project.root)
    for section in sections(project.root):
        path = project.record_path(section)
        try:
            record = load_record(path) if os.path.lexists(path) else None
            kind = Kind.FRESH if record else Kind.MISSING
            states.append(State(section, kind, record))
        except RecordError as error:
            states.append(State(section, Kind.DAMAGED, notes=(str(error),)))
    records = [state.record for state in states if state.record]
    packages = expected_packages(project, records)
    for index, state in enumerate(states):
        if state.record:
            identity = identity_of(
                state.section, project.profile, project.root, packages, code
            )
            if notes := changes(state.record.identity, identity):
                states[index] = replace(state, kind=Kind.STALE, notes=tuple(notes))
    return states


def other_damage(project: Project) -> Iterator[State]:
    """Yield the folders and the manifest of an edition if they cannot be read."""
    folders = (project.results.parent, project.results, project.results / FOLDER)
    for folder in folders:
        if fault := folder_fault(folder):
            yield State(folder.name, Kind.DAMAGED, notes=(fault,))
    try:
        read_manifest(project.results)
    except RecordError as error:
        yield State(MANIFEST, Kind.DAMAGED, notes=(str(error),))


def expected_packages(
    project: Project, records: Sequence[Record] = ()
) -> Mapping[str, str]:
    """Return the versions that an edition's records should have been measured with.

    If the edition is not installed here, these are the versions of its newest record.
    """
    release = project.named
    installed = package_versions(project.settings)
    if release.is_installed_with(installed):
        return installed
    readable = list(records) or list(records_of(project))
    if not readable and release.machine:
        readable = list(records_of(project.of(str(replace(release, machine="")))))
    newest = max(readable, key=lambda record: record.time, default=None)
    packages = newest.identity.packages if newest else dict.fromkeys(installed, MISSING)
    own = {project.settings.edition: release.package_version}
    return {**packages, **dict(release.pins), **own}


def records_of(project: Project) -> Iterator[Record]:
    """Yield the records of an edition that can be read."""
    for section in sections(project.root):
        with suppress(RecordError):
            yield load_record(project.record_path(section))


def aligned(lines: Sequence[Sequence[str]]) -> str:
    """Return lines of cells as text in columns."""
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    return "\n".join("  ".join(map(str.ljust, line, widths)).rstrip() for line in lines)
