"""Status: which sections are fresh, and what changed for those that aren't."""

from collections.abc import Iterable
from dataclasses import dataclass

from report.format import format_time
from report.identity import changes, identity_of
from report.project import Project
from report.records import Record, RecordError, load_record

HEADINGS = ("section", "state", "measured on", "date", "profile", "what changed")


@dataclass(frozen=True)
class State:
    """How a section's record stands against the code that would measure it now."""

    section: str
    name: str
    """``fresh``, ``stale``, ``missing`` or ``damaged``."""
    record: Record | None = None
    notes: tuple[str, ...] = ()
    """What changed since the measurement, or what is wrong with the record."""

    def rerun(self, profile: str) -> str:
        """The command that measures the section."""
        return f"make rerun SECTION={self.section}" + ("" if profile == "full" else f" PROFILE={profile}")


def state_of(project: Project, section: str) -> State:
    path = project.record_path(section)
    if not path.exists():
        return State(section, "missing")
    try:
        record = load_record(path)
    except RecordError as error:
        return State(section, "damaged", notes=(str(error),))
    changed = changes(record.identity, identity_of(section, project.profile, project.root))
    return State(section, "stale" if changed else "fresh", record, tuple(changed))


def machine_name(record: Record) -> str:
    """The processor that the numbers were measured on."""
    device = "gpu" if record.machine.get("device") == "cuda" else "cpu"
    return record.machine.get(device) or device.upper()


def status_table(states: Iterable[State], profile: str) -> str:
    lines = [HEADINGS]
    for state in states:
        record = state.record
        where, when = (machine_name(record), format_time(record.measured["date"])) if record else ("–", "–")
        lines.append((state.section, state.name, where, when, profile, "; ".join(state.notes)))
    widths = [max(map(len, column)) for column in zip(*lines, strict=True)]
    return "\n".join("  ".join(map(str.ljust, line, widths)).rstrip() for line in lines)
