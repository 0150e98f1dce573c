"""Print every claim with its outcome, what can't be trusted first."""

from measured_report.changes.alarm import check_text
from measured_report.changes.compare import faults_of
from measured_report.commands.options import Arguments, refuse_unmeasured, shared
from measured_report.commands.status import say_damage
from measured_report.editions.project import Project
from measured_report.findings.editions import editions_of
from measured_report.pages.wording import sentences_of

STRICT = {
    "action": "store_true",
    "help": "1: end with status 1 when anything can't be trusted",
}
OPTIONS = {**shared("edition", "profile", "format"), "strict": STRICT}


def run(project: Project, arguments: Arguments) -> int:
    """Print the claims; 1 if anything cannot be read or shown."""
    refuse_unmeasured(project, arguments.release.spec)
    editions = editions_of(project)
    edition = editions[project.release]
    print(check_text(edition, arguments.format, sentences_of(project)))
    is_damaged = say_damage(
        state
        for each in editions.values()
        for state in (*each.left_out, *each.plugins.left_out)
    )
    return int(is_damaged or (arguments.strict and bool(faults_of(edition))))
