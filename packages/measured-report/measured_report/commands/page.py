"""Build site/ from what is measured; measure nothing."""

import gc

from measured_report.commands.options import Arguments, refuse_unmeasured, shared
from measured_report.commands.status import say_damage
from measured_report.editions.project import Project
from measured_report.editions.status import Kind
from measured_report.files.groups import grouped
from measured_report.records.identity import sections
from measured_report.site.build import build

OPTIONS = shared("edition", "profile", "address")


def run(project: Project, arguments: Arguments) -> int:
    """Build the site; 1 if anything cannot be read or shown."""
    refuse_unmeasured(project, arguments.release.spec)
    return int(build_site(project, arguments.address)[0])


def build_site(project: Project, address: str = "") -> tuple[bool, bool]:
    """Build the site and say what it lacks; return whether anything cannot be read or shown, and whether a record is to be renewed."""
    gc.disable()  # a build keeps what it makes, and is a tenth faster so
    releases, notes = build(project, address)
    by_kind = grouped(
        (state.kind, state.section) for state in releases[project.release]
    )
    measurable = sections(project.root)
    lacking = [
        name
        for kind in (Kind.MISSING, Kind.DAMAGED, Kind.STALE)
        for name in by_kind.get(kind, ())
        if name in measurable
    ]
    # If other editions can be shown, the code is right and the record lacks something.
    lacking += [
        name
        for name in by_kind.get(Kind.NOT_SHOWN, ())
        if name in measurable
        and any(
            name not in {state.section for state in each} for each in releases.values()
        )
    ]
    for label, kind in (("not measured", Kind.MISSING), ("stale", Kind.STALE)):
        if kind in by_kind:
            print(f"{label}: {', '.join(by_kind[kind])}")
    if lacking:
        print(f"{project.rerun(lacking[0])} measures one of them")
    for note in notes:
        print(note)
    print(f"built {project.site.name}/index.html")
    is_damaged = say_damage(state for states in releases.values() for state in states)
    return is_damaged, bool(lacking)
