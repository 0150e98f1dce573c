"""List which sections are fresh, and what changed for the others."""

import sys
from collections.abc import Iterable, Iterator, Sequence
from importlib import import_module

from measured_report.commands.command_line import OWN, commands
from measured_report.commands.options import Arguments, refuse_unmeasured, shared
from measured_report.editions.project import Project
from measured_report.editions.status import Kind, State, aligned, states_of
from measured_report.files.groups import grouped
from measured_report.findings.replicas import damage_of, replicas_text
from measured_report.records.code import Code
from measured_report.records.identity import sections

OPTIONS = shared("edition", "profile")


def run(project: Project, arguments: Arguments) -> int:
    """Print the state of each section of each edition; 1 if anything cannot be read."""
    refuse_unmeasured(project, arguments.release.spec)
    states = states_by_release(project)
    print(_matrix(project, states))
    for line in replicas_text(project):
        print(line)
    own = [*_states_of_commands(project)]
    for state in own:
        print(f"{state.section}: {state.summary}")
    own += states[project.release]
    if changed := changes_text(own):
        print(f"\n{project.settings.edition} {project.release}\n{changed}")
    return int(say_damage(damage(project, states)))


States = dict[str, list[State]]  # by release


def states_by_release(project: Project) -> States:
    code = Code(project.root)
    return {
        release: states_of(project.of(release), code) for release in project.releases
    }


def _states_of_commands(project: Project) -> Iterator[State]:
    """Yield the states of what the report's own commands measure of an edition."""
    for name in commands(project.root).values():
        if name.startswith(OWN) and hasattr(module := import_module(name), "state"):
            yield module.state(project)


def damage(project: Project, states: States) -> Iterator[State]:
    """Yield all that cannot be read, in any edition."""
    for release, of_release in states.items():
        edition = project.of(release)
        yield from damage_of(edition, [*of_release, *_states_of_commands(edition)])


def say_damage(states: Iterable[State]) -> bool:
    """Name all that cannot be read, or not be shown; return whether there is anything."""
    faulty = [state for state in states if state.kind in (Kind.DAMAGED, Kind.NOT_SHOWN)]
    for state in faulty:
        print(f"{state.kind}: {state.words}", file=sys.stderr)
    return bool(faulty)


def _matrix(project: Project, states: States) -> str:
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
