"""Carry records over a code change that changes no number (quick runs on a CPU)."""

from measured_report.changes.carry import carried
from measured_report.commands.options import Arguments, read_section, shared
from measured_report.editions.project import Project
from measured_report.editions.status import Kind, states_of

SECTION = {"default": "", "help": "section to carry (default: all stale sections)"}
OPTIONS = {"section": SECTION, **shared("edition")}


def run(project: Project, arguments: Arguments) -> int:
    """Print whether each section was carried, and the reason if it was not.

    Return 1 if any section was not carried.
    """
    stale = [state.section for state in states_of(project) if state.kind == Kind.STALE]
    chosen = [read_section(arguments.section)] if arguments.section else stale
    if not chosen:
        print("no section is stale, so there is nothing to carry")
        return 0
    is_refused = False
    for name, reason in carried(project, arguments.release, chosen):
        print(
            f"{name}: not carried: {reason}" if reason else f"{name}: carried",
            flush=True,
        )
        is_refused |= bool(reason)
    return int(is_refused)
