"""Find the release, commit or package that changed a claim or a value."""

import argparse
import math
from dataclasses import replace

from measured_report.changes.bisect import (
    CLONE,
    Alike,
    Bisection,
    bisect_commits,
    bisect_releases,
    commit_count,
    common_repository,
    said,
)
from measured_report.changes.upgrade import seconds_expected
from measured_report.commands.history import query_of
from measured_report.commands.options import refuse_lacking_ends, shared
from measured_report.commands.page import build_site
from measured_report.editions.devices import measuring_device
from measured_report.editions.project import Project
from measured_report.editions.release import release_of, releases_between
from measured_report.files.config import config
from measured_report.files.errors import UsageError
from measured_report.files.suggestion import suggestion
from measured_report.pages.prose import Templates
from measured_report.records.identity import sections

OPTIONS = {
    **shared("claim", "value", "a", "b", "device"),
    "yes": {"action": "store_true", "help": "1: begin what takes hours on a CPU"},
}


def run(project: Project, arguments: argparse.Namespace) -> int:
    """Find the first edition between A and B that the answer changes in, and which package did it."""
    refuse_lacking_ends(arguments, f"make bisect CLAIM={config().changes.example_claim} A=1.4.0 B=1.8.0")
    device = measuring_device(arguments.device, "quick") or "cpu"
    query = query_of(arguments)
    if query.section not in sections() or query.section == query.text:
        hint = suggestion(query.section, sections())
        raise UsageError(f"{query.given} is in no section{hint}; {query.example} is")
    search = Bisection(replace(project, profile="quick"), query, device, Templates(project.templates))
    repository = common_repository(arguments.a, arguments.b)
    count = commit_count(*repository) if repository else len(releases_between(arguments.a, arguments.b)) + 1
    print(_cost(search, count), flush=True)
    try:
        search.ends(arguments.a, arguments.b)
    except Alike as error:
        search = replace(search, project=project)
        told = f"{error} in a quick run; it takes full ones: {_cost(search, count)}"
        if device == "cpu" and not arguments.yes:
            raise UsageError(f"{told}; YES=1 begins") from None
        print(told, flush=True)
    ends = search.ends(arguments.a, arguments.b)
    if repository:
        clone = project.root / CLONE

        def is_first() -> bool | None:
            release_of.cache_clear()  # there is another commit in the clone now
            return search.is_first(ends, release_of(str(clone)))

        found = bisect_commits(*repository, clone, is_first)
    else:
        found = bisect_releases(search, arguments.a, arguments.b)
    print(f"{found}\n{query.text}: {said(ends[0])} → {said(ends[1])}")
    build_site(search.side(arguments.b))
    return 0


def _cost(search: Bisection, count: int) -> str:
    """Say how many steps a search among so many editions takes, and how long they may."""
    steps = 2 + math.ceil(math.log2(max(1, count)))
    minutes = seconds_expected(search.project, search.device, [search.query.section]) / 60
    kind = f"{search.project.profile} run of {search.query.section}"
    return f"about {steps} steps, each a {kind} of {max(1, round(minutes))} min where it was not measured before"
