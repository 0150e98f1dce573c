"""Status: which sections of which releases are fresh, and what changed for those that aren't."""

import os
from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

from measured_report.editions.project import Project
from measured_report.editions.release import folder_at
from measured_report.files.atomic import RecordError
from measured_report.files.groups import grouped
from measured_report.records.code import Code
from measured_report.records.identity import (
    EDITED,
    MISSING,
    changes,
    code_in,
    identity_of,
    package_versions,
    sections,
)
from measured_report.records.record import Record, load_record

NOT_SHOWN = "not shown"  # kind of what is whole, and that code or words can't do with


@dataclass(frozen=True)
class State:
    """Compare a section's record with the code that would measure it now."""

    section: str
    kind: str  # `fresh`, `stale`, `missing` or `damaged`; of what is left out of a page also `not shown`
    record: Record | None = None
    notes: tuple[str, ...] = ()

    @property
    def summary(self) -> str:
        """Say the state in a few words: of a stale record, which parts of its identity changed."""
        parts = (
            dict.fromkeys(note.partition(":")[0] for note in self.notes)
            if self.kind == "stale"
            else ()
        )
        return f"{self.kind}: {', '.join(parts)}" if parts else self.kind

    @property
    def words(self) -> str:
        """Write its notes in one line, with each kind, as code, said once."""
        kinds = grouped(note.partition(": ")[::2] for note in self.notes)
        texts = {
            kind: ", ".join(filter(None, subjects)) for kind, subjects in kinds.items()
        }
        return "; ".join(
            f"{kind}: {text}" if text else kind for kind, text in texts.items()
        )


def states_of(project: Project, code: Code | None = None) -> list[State]:
    """Return the state of each section of an edition; ``code`` saves reading the files once more for each edition."""
    states = []
    code = code or Code(project.root)
    for section in sections(project.root):
        path = project.record_path(section)
        try:
            record = load_record(path) if os.path.lexists(path) else None
            states.append(State(section, "fresh" if record else "missing", record))
        except RecordError as error:
            states.append(State(section, "damaged", notes=(str(error),)))
    packages = expected_packages(
        project, [state.record for state in states if state.record]
    )
    for index, state in enumerate(states):
        if state.record:
            now = identity_of(
                state.section, project.profile, project.root, packages, code
            )
            if changed := changes(state.record.identity, now):
                states[index] = replace(state, kind="stale", notes=tuple(changed))
    return states


def expected_packages(
    project: Project, records: Sequence[Record] = ()
) -> Mapping[str, str]:
    """Find the versions that an edition's records should have been measured with: of one not here, its newest's."""
    release, installed = project.named, package_versions(project.settings)
    if release.is_installed_with(installed):
        return installed
    readable = [*(records or records_of(project))] or [
        *records_of(project.of(str(replace(release, machine=""))))
    ]
    newest = max(readable, key=lambda record: record.time, default=None)
    packages = newest.identity.packages if newest else dict.fromkeys(installed, MISSING)
    return {
        **packages,
        **dict(release.pins),
        project.settings.edition: package_version(project),
    }


def package_version(project: Project) -> str:
    """Return the version that an edition is of; of an edited checkout with its digest, without what git may run."""
    release, manifest = project.named, project.manifest
    if (
        release.source.endswith(EDITED)
        and manifest
        and (folder := folder_at(manifest.asked, project.report.root)).is_dir()
    ):
        return f"{release.package_version}.{code_in(folder, project.settings.edition)}"
    return release.package_version


def records_of(project: Project) -> Iterator[Record]:
    """Yield the records of an edition that can be read."""
    for section in sections(project.root):
        with suppress(RecordError):
            yield load_record(project.record_path(section))


def status_matrix(project: Project) -> str:
    code = Code(project.root)
    states = {
        release: states_of(project.of(release), code) for release in project.releases
    }
    rows = zip(
        *(
            [state.summary for state in release_states]
            for release_states in states.values()
        ),
        strict=True,
    )
    lines = [
        (name, *row) for name, row in zip(sections(project.root), rows, strict=True)
    ]
    return aligned(
        [
            (
                "section",
                *(f"{project.settings.edition} {release}" for release in states),
            ),
            *lines,
        ]
    )


def changes_text(states: Sequence[State]) -> str:
    """Say each change since a measurement once, with the sections that it is of."""
    sections_of = grouped(
        (note, state.section) for state in states for note in state.notes
    )
    return "\n".join(
        f"{note} ({', '.join(names)})" for note, names in sorted(sections_of.items())
    )


def aligned(lines: Sequence[Sequence[str]]) -> str:
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    return "\n".join("  ".join(map(str.ljust, line, widths)).rstrip() for line in lines)
