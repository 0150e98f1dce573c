"""Carry records over a change of code that changes no number: old and new code run quick, on a CPU."""

import shutil
import sys
from dataclasses import replace

from measured_report.changes.carry import ASIDE, carried
from measured_report.commands.options import Arguments, shared
from measured_report.editions.project import Project
from measured_report.editions.status import states_of
from measured_report.files.errors import UsageError, suggestion
from measured_report.records.identity import sections

SECTION = {"default": "", "help": "section to carry; without one all that are stale by their code alone"}
OPTIONS = {"section": SECTION, **shared("edition", "device")}


def run(project: Project, arguments: Arguments) -> int:
    """Say of each section whether it was carried, and if not what differs; 1 when one was not."""
    if sys.version_info < (3, 11):
        raise UsageError("make carry takes Python 3.11 or newer, which knows where each instruction stands")
    names = sections(project.root)
    if arguments.section and arguments.section not in names:
        raise UsageError(f"SECTION={arguments.section} is no section{suggestion(arguments.section, names)}")
    stale = [state.section for state in states_of(project) if state.kind == "stale"]
    chosen, reasons = [arguments.section] if arguments.section else stale, {}
    for name, reason in carried(project, arguments.release, chosen, arguments.device or "cpu"):
        reasons[name] = reason
        print(f"{name}: {f'not carried: {reason}' if reason else 'carried'}", flush=True)
    if not reasons:
        print("there is nothing to carry: no section is stale")
    shutil.rmtree(replace(project, profile="quick", aside=ASIDE).results, ignore_errors=True)
    return int(any(reasons.values()))
