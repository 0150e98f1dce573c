"""List which sections are fresh, and what changed for the others."""

from collections.abc import Sequence
from importlib import import_module

from measured_report.commands.command_line import OWN, commands
from measured_report.commands.options import Arguments, refuse_unmeasured, shared
from measured_report.editions.project import Project, read_manifest
from measured_report.editions.status import Kind, State, aligned, states_of
from measured_report.files.atomic import RecordError
from measured_report.files.groups import grouped
from measured_report.findings.replicas import replicas_text
from measured_report.records.code import Code
from measured_report.records.identity import sections

OPTIONS = shared("edition", "profile")


def run(project: Project, arguments: Arguments) -> int:
    """Print the state of each section of each edition; return 1 if a record is damaged."""
    refuse_unmeasured(project, arguments.release.asked)
    code = Code(project.root)
    states = {
        release: states_of(project.of(release), code) for release in project.releases
    }
    print(_matrix(project, states))
    replicas = replicas_text(project)
    is_damaged = any(line.startswith("damaged: ") for line in replicas)
    try:
        read_manifest(project.results)
    except RecordError as error:
        replicas.append(f"damaged: {error}")
        is_damaged = True
    print(*replicas, sep="\n", end="\n" if replicas else "")
    own = []
    for name in commands(project.root).values():
        if name.startswith(OWN) and hasattr(module := import_module(name), "state"):
            own.append(module.state(project))
            print(f"{own[-1].section}: {own[-1].summary}")
    own += states[project.release]
    if changed := changes_text(own):
        print(f"\n{project.settings.edition} {project.release}\n{changed}")
    return int(is_damaged or any(state.kind == Kind.DAMAGED for state in own))


def _matrix(project: Project, states: dict[str, list[State]]) -> str:
    """Return a table of sections by editions."""
    package = project.settings.edition
    columns = [["section", *sections(project.root)]]
    for release, of_release in states.items():
        summaries = (state.summary for state in of_release)
        columns.append([f"{package} {release}", *summaries])
    return aligned(list(zip(*columns, strict=True)))


def changes_text(states: Sequence[State]) -> str:
    """Return each change since a measurement once, with the sections that it concerns."""
    sections_of = grouped(
        (note, state.section) for state in states for note in state.notes
    )
    lines = [f"{note} ({', '.join(each)})" for note, each in sections_of.items()]
    return "\n".join(sorted(lines))
