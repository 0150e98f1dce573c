"""Build site/ from the existing results without measuring."""

import gc

from measured_report.commands.options import Arguments, refuse_unmeasured, shared
from measured_report.commands.status import print_damage
from measured_report.editions.project import Project
from measured_report.editions.status import Kind
from measured_report.files.groups import grouped
from measured_report.records.identity import sections
from measured_report.site.build import build

OPTIONS = shared("edition", "profile", "address")


def run(project: Project, arguments: Arguments) -> int:
    """Build the site, and return 1 if a record cannot be read or shown."""
    refuse_unmeasured(project, arguments.release.spec)
    return int(build_site(project, arguments.address)[0])


def build_site(project: Project, address: str = "") -> tuple[bool, bool]:
    """Build the site, and print the sections that it lacks.

    Return whether a record cannot be read or shown, and whether a section should be
    measured.
    """
    # A build keeps nearly all of its objects, and is 10 % faster without collecting.
    gc.disable()
    releases, notes = build(project, address)
    by_kind = grouped(
        (state.kind, state.section) for state in releases[project.release]
    )
    measurable = sections(project.root)
    to_measure = [
        name
        for kind in (Kind.MISSING, Kind.DAMAGED, Kind.STALE)
        for name in by_kind.get(kind, ())
        if name in measurable
    ]
    # If the section of another edition can be shown, the record is at fault and not the
    # code.
    to_measure += [
        name
        for name in by_kind.get(Kind.NOT_SHOWN, ())
        if name in measurable
        and any(
            name not in {state.section for state in states}
            for states in releases.values()
        )
    ]
    for label, kind in (("not measured", Kind.MISSING), ("stale", Kind.STALE)):
        if kind in by_kind:
            print(f"{label}: {', '.join(by_kind[kind])}")
    if to_measure:
        print(f"to measure one of them, use {project.rerun(to_measure[0])}")
    for note in notes:
        print(note)
    print(f"built {project.site.name}/index.html")
    is_damaged = print_damage(state for states in releases.values() for state in states)
    return is_damaged, bool(to_measure)
