"""Find the release, commit or package that changed a claim or a value."""

import math

from measured_report.changes.bisect import Bisection, bisect, points_between
from measured_report.commands.history import query_of
from measured_report.commands.options import SHARED, Arguments, shared
from measured_report.commands.status import print_damage_of
from measured_report.editions.project import Project
from measured_report.files.errors import UsageError, suggestion
from measured_report.measuring.machine import measuring_device
from measured_report.records.identity import sections

OPTIONS = {
    **shared("claim", "value", "a", "b", "device"),
    "profile": {**SHARED["profile"], "default": "quick"},
}


def run(project: Project, arguments: Arguments) -> int:
    device = measuring_device(arguments.device, "quick") or "cpu"
    query = query_of(arguments)
    names = sections(project.root)
    if query.section not in names or query.section == query.text:
        similar = suggestion(query.section, names)
        raise UsageError(
            f"no section has {query.text}: use SECTION.NAME with an existing "
            f"section{similar}"
        )
    between = points_between(project, arguments.a, arguments.b)
    count = 2 + math.ceil(math.log2(len(between) - 1))
    step = f"{project.profile} run of {query.section}"
    print(f"about {count} steps; a step without a record needs a {step}", flush=True)
    print(bisect(Bisection(project, query, device), arguments.a, arguments.b))
    return int(print_damage_of(project))
