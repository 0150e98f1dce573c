"""List which sections are fresh, and what changed for the others."""

from importlib import import_module

from measured_report.commands.command_line import OWN, commands
from measured_report.commands.options import Arguments, refuse_unmeasured, shared
from measured_report.editions.project import Project, read_manifest
from measured_report.editions.status import changes_text, states_of, status_matrix
from measured_report.files.atomic import RecordError
from measured_report.findings.replicas import replicas_text

OPTIONS = shared("edition", "profile")


def run(project: Project, arguments: Arguments) -> int:
    refuse_unmeasured(project, arguments.release.asked)
    modules = (
        import_module(name)
        for name in commands(project.root).values()
        if name.startswith(OWN)
    )
    states = [module.state(project) for module in modules if hasattr(module, "state")]
    replicas = replicas_text(project)
    is_damaged = any(line.startswith("damaged: ") for line in replicas)
    try:
        read_manifest(project.results, project.settings)
    except RecordError as error:
        replicas, is_damaged = [*replicas, f"damaged: {error}"], True
    print(
        "\n".join(
            [
                status_matrix(project),
                *replicas,
                *(f"{state.section}: {state.summary}" for state in states),
            ]
        )
    )
    states += states_of(project)
    if changed := changes_text(states):
        print(f"\n{project.settings.edition} {project.release}\n{changed}")
    return int(is_damaged or any(state.kind == "damaged" for state in states))
