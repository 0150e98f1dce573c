"""List the state of each section, and the changes that made sections stale."""

import sys
from collections.abc import Iterable, Iterator, Mapping, Sequence
from importlib import import_module

from measured_report.commands.command_line import OWN, commands
from measured_report.commands.options import Arguments, refuse_unmeasured, shared
from measured_report.editions.project import Project
from measured_report.editions.status import (
    Kind,
    State,
    aligned,
    other_damage,
    states_of,
)
from measured_report.files.groups import grouped
from measured_report.findings.editions import Edition
from measured_report.findings.replicas import read_replicas, replicas_text
from measured_report.records.code import Code
from measured_report.records.identity import sections
from measured_report.records.replicas import FOLDER

OPTIONS = shared("edition", "profile")


def run(project: Project, arguments: Arguments) -> int:
    """Print the state of each section in each edition.

    Return 1 if a record or a replica cannot be read.
    """
    refuse_unmeasured(project, arguments.release.spec)
    states = states_by_release(project)
    print(_matrix(project, states))
    for line in replicas_text(project):
        print(line)
    states_of_edition = [*_states_of_commands(project)]
    for state in states_of_edition:
        print(f"{state.section}: {state.summary}")
    states_of_edition += states[project.release]
    if changes := changes_text(states_of_edition):
        print(f"\n{project.settings.edition} {project.release}\n{changes}")
    return int(print_damage(damage(project, states)))


States = dict[str, list[State]]  # by release


def states_by_release(project: Project) -> States:
    code = Code(project.root)
    return {
        release: states_of(project.of(release), code) for release in project.releases
    }


def _states_of_commands(project: Project) -> Iterator[State]:
    """Yield the states of the results that the report's own commands measure."""
    for name in commands(project.root).values():
        if name.startswith(OWN) and hasattr(module := import_module(name), "state"):
            yield module.state(project)


def print_damage_of(project: Project) -> bool:
    """Print which results of any edition cannot be read."""
    return print_damage(damage(project, states_by_release(project)))


def damage(project: Project, states: States) -> Iterator[State]:
    """Yield the states of all results of all editions.

    ``print_damage`` prints those that cannot be read.
    """
    for release, section_states in states.items():
        edition = project.of(release)
        yield from [*section_states, *_states_of_commands(edition)]
        yield from other_damage(edition)
        for fault in read_replicas(edition)[1]:
            yield State(FOLDER, Kind.DAMAGED, notes=(fault,))


def print_damage(states: Iterable[State]) -> bool:
    """Print which results cannot be read or shown, and return whether there are any."""
    faulty = [state for state in states if state.kind in (Kind.DAMAGED, Kind.NOT_SHOWN)]
    # Several editions can have the same fault: they share a folder.
    for line in dict.fromkeys(f"{state.kind}: {state.words}" for state in faulty):
        print(line, file=sys.stderr)
    return bool(faulty)


def print_left_out(editions: Mapping[str, Edition]) -> bool:
    """Print which results of some editions cannot be read or shown."""
    return print_damage(
        state
        for edition in editions.values()
        for state in (*edition.left_out, *edition.plugins.left_out)
    )


def _matrix(project: Project, states: States) -> str:
    """Return a table of sections by editions."""
    package = project.settings.edition
    columns = [["section", *sections(project.root)]]
    for release, section_states in states.items():
        summaries = (state.summary for state in section_states)
        columns.append([f"{package} {release}", *summaries])
    return aligned(list(zip(*columns, strict=True)))


def changes_text(states: Sequence[State]) -> str:
    """Return a line for each change since a measurement, with the stale sections."""
    sections_of = grouped(
        (note, state.section) for state in states for note in state.notes
    )
    lines = [f"{note} ({', '.join(names)})" for note, names in sections_of.items()]
    return "\n".join(sorted(lines))
