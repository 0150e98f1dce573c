"""Status: which sections of which releases are fresh, and what changed for those that aren't."""

import os
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace

from report.records.files import RecordError
from report.records.identity import MISSING, changes, identity_of, package_versions, sections
from report.records.project import Project
from report.records.reading import load_record
from report.records.record import Record

HEADINGS = ("section", "state", "measured on", "date", "profile", "what changed")


@dataclass(frozen=True)
class State:
    """How a section's record stands against the code that would measure it now."""

    section: str
    kind: str
    """``fresh``, ``stale``, ``missing`` or ``damaged``."""
    record: Record | None = None
    notes: tuple[str, ...] = ()
    """What changed since the measurement, or what is wrong with the record."""

    @property
    def summary(self) -> str:
        """The state in a few words: of a stale record, which parts of its identity changed."""
        parts = dict.fromkeys(note.partition(":")[0] for note in self.notes) if self.kind == "stale" else ()
        return f"{self.kind}: {', '.join(parts)}" if parts else self.kind


def states_of(project: Project) -> list[State]:
    """The state of every section of one release."""
    loaded = [_loaded(project, section) for section in sections(project.root)]
    packages = expected_packages(project, [state.record for state in loaded if state.record])
    return [_judged(project, state, packages) for state in loaded]


def state_of(project: Project, section: str) -> State:
    """The state of one section."""
    return _judged(project, _loaded(project, section), expected_packages(project))


def _loaded(project: Project, section: str) -> State:
    """A section with its record, taken for fresh, or why there is none."""
    path = project.record_path(section)
    if not os.path.lexists(path):
        return State(section, "missing")
    try:
        return State(section, "fresh", load_record(path))
    except RecordError as error:
        return State(section, "damaged", notes=(str(error),))


def _judged(project: Project, state: State, packages: Mapping[str, str]) -> State:
    if not state.record:
        return state
    current = identity_of(state.section, project.profile, project.root, packages)
    changed = changes(state.record.identity, current)
    return replace(state, kind="stale" if changed else "fresh", notes=tuple(changed))


def expected_packages(project: Project, records: Iterable[Record] | None = None) -> Mapping[str, str]:
    """The package versions that the records of a release should have been measured with.

    Of the release that is installed here these are the versions that are. Another release need not be installed to
    be judged: its newest record says which versions of the other packages belong to it, so that a section measured
    with others before is stale.
    """
    installed = package_versions()
    if installed["newton"] == project.release:
        return installed
    newest = max(
        _records(project) if records is None else records, key=lambda record: record.measured["date"], default=None
    )
    others = newest.identity.packages if newest else dict.fromkeys(installed, MISSING)
    return {**others, "newton": project.release}


def _records(project: Project) -> Iterable[Record]:
    for section in sections(project.root):
        try:
            yield load_record(project.record_path(section))
        except RecordError:
            continue


def status_matrix(project: Project) -> str:
    """The state of every section, in a column for each release that has results."""
    columns = {release: states_of(project.of(release)) for release in project.releases}
    lines = [("section", *(f"newton {release}" for release in columns))]
    for states in zip(*columns.values(), strict=True):
        lines.append((states[0].section, *(state.summary for state in states)))
    return _aligned(lines)


def status_table(states: Iterable[State], profile: str) -> str:
    """The state of every section of one release, with all that changed."""
    lines = [HEADINGS]
    for state in states:
        record = state.record
        where, when = (record.processor, record.time_text) if record else ("–", "–")
        lines.append((state.section, state.kind, where, when, profile, "; ".join(state.notes)))
    return _aligned(lines)


def _aligned(lines: Sequence[Sequence[str]]) -> str:
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    return "\n".join("  ".join(map(str.ljust, line, widths)).rstrip() for line in lines)
