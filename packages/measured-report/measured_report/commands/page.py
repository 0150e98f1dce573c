"""Build site/ from what is measured; measure nothing."""

import argparse
import sys
from collections.abc import Iterable
from dataclasses import replace

from measured_report.commands.options import refuse_unmeasured, shared
from measured_report.editions.devices import has_cuda, needs_gpu
from measured_report.editions.project import Project
from measured_report.editions.status import State
from measured_report.measuring.measure import machines_besides
from measured_report.records.identity import sections
from measured_report.site.build import build

OPTIONS = shared("edition", "profile", "address")


def run(project: Project, arguments: argparse.Namespace) -> int:
    """Build the site; 1 where a record is damaged."""
    refuse_unmeasured(project, arguments.release.asked)
    return int(build_site(project, arguments.address)[0])


def build_site(project: Project, address: str = "") -> tuple[bool, bool]:
    """Build the site and say what it lacks; return whether a record is damaged, and whether any is to be renewed."""
    releases = build(project, address)
    built = releases[project.release]
    missing = [state.section for state in built.left_out if state.kind == "missing"]
    others = [state.section for state in built.left_out if state.kind != "missing"]
    measurable = sections(project.root)
    lacking = [name for name in (*missing, *others, *built.stale) if name in measurable]
    for words, names in (("not measured", missing), ("stale", built.stale)):
        if names:
            print(f"{words}: {', '.join(names)}")
    if lacking:
        print(_hint(project, lacking[0]))
    print(f"built {project.site / 'index.html'}")
    return say_damage(state for release in releases.values() for state in release.left_out), bool(lacking)


def say_damage(states: Iterable[State]) -> bool:
    """Name each record that can't be trusted; return whether there is one."""
    damaged = [state for state in states if state.kind == "damaged"]
    for state in damaged:
        print(f"damaged: {state.words}", file=sys.stderr)
    return bool(damaged)


def _hint(project: Project, section: str) -> str:
    """Say which command measures a section for this report; a CPU's results never stand with those of a GPU."""
    if has_cuda():
        return f"{project.rerun(section)} measures one of them"
    if not needs_gpu(section, project.root) or not any(machines_besides(project, "cpu")):
        return f"{project.rerun(section, 'cpu')} measures one of them"
    own = f"; with DEVICE=cpu it becomes an edition of its own, {replace(project.named, machine='cpu')}"
    return f"{project.rerun(section)} measures one of them on a GPU{'' if project.named.machine else own}"
