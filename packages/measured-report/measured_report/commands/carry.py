"""Renew stale records if quick runs show that no number has changed."""

from measured_report.changes.carry import carried
from measured_report.commands.options import Arguments, read_section, shared
from measured_report.commands.status import print_damage_of
from measured_report.editions.project import Project
from measured_report.editions.status import Kind, states_of

SECTION = {"default": "", "help": "section to carry (default: all stale sections)"}
OPTIONS = {"section": SECTION, **shared("edition")}


def run(project: Project, arguments: Arguments) -> int:
    """Print for each section whether it was carried, or the reason why it was not.

    Return 1 if any section was not carried, or if a record cannot be read.
    """
    is_refused = print_damage_of(project)
    names = [state.section for state in states_of(project) if state.kind == Kind.STALE]
    if arguments.section:
        names = [read_section(arguments.section)]
    if not names:
        print("no section is stale, so there is nothing to carry")
        return int(is_refused)
    for name, reason in carried(project, arguments.release, names):
        print(
            f"{name}: not carried: {reason}" if reason else f"{name}: carried",
            flush=True,
        )
        is_refused |= bool(reason)
    return int(is_refused)
