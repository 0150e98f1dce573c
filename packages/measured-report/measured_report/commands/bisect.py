"""Find the release, commit or package that changed a claim or a value."""

import argparse
import math
from dataclasses import replace

from measured_report.changes.bisect import Alike, Bisection, bisect, points_between
from measured_report.commands.history import query_of
from measured_report.commands.options import shared
from measured_report.editions.project import Project
from measured_report.files.errors import UsageError, suggestion
from measured_report.measuring.machine import measuring_device
from measured_report.pages.prose import Templates
from measured_report.records.identity import sections

OPTIONS = {
    **shared("claim", "value", "a", "b", "device"),
    "yes": {"action": "store_true", "help": "1: begin what takes hours on a CPU"},
}


def run(project: Project, arguments: argparse.Namespace) -> int:
    """Find the first edition between A and B that the answer changes in, and which package did it."""
    device = measuring_device(arguments.device, "quick") or "cpu"
    query, ends = query_of(arguments), (arguments.a, arguments.b)
    if query.section not in sections() or query.section == query.text:
        raise UsageError(f"{query.text} is in no section{suggestion(query.section, sections())}")
    quick, full = (
        Bisection(replace(project, profile=profile), query, device, Templates(project.templates))
        for profile in ("quick", "full")
    )
    steps = 2 + math.ceil(math.log2(len(points_between(*ends)) - 1))
    print(f"about {steps} steps, each a quick run of {query.section} where it was not measured before", flush=True)
    try:
        print(bisect(quick, *ends))
    except Alike as error:
        told = f"{error} in a quick run; it takes {steps} full ones"
        if device == "cpu" and not arguments.yes:
            raise UsageError(f"{told}; YES=1 begins") from None
        print(told, flush=True)
        print(bisect(full, *ends))
    return 0
