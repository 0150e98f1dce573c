"""Carry records over a change of code that changes no number: old and new code run quick, on a CPU."""

from measured_report.changes.carry import carried
from measured_report.commands.options import Arguments, read_section, shared
from measured_report.editions.project import Project
from measured_report.editions.status import Kind, states_of

SECTION = {"default": "", "help": "section to carry; without one all that are stale"}
OPTIONS = {"section": SECTION, **shared("edition")}


def run(project: Project, arguments: Arguments) -> int:
    """Print of each section whether it was carried, and if not why; 1 when one was not."""
    stale = [state.section for state in states_of(project) if state.kind == Kind.STALE]
    chosen = [read_section(arguments.section)] if arguments.section else stale
    if not chosen:
        print("there is nothing to carry: no section is stale")
        return 0
    is_refused = False
    for name, reason in carried(project, arguments.release, chosen):
        print(
            f"{name}: not carried: {reason}" if reason else f"{name}: carried",
            flush=True,
        )
        is_refused |= bool(reason)
    return int(is_refused)
