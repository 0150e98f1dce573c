"""Print every claim with its outcome, what can't be trusted first."""

from measured_report.changes.alarm import check_text
from measured_report.changes.compare import faults_of
from measured_report.commands.options import Arguments, refuse_unmeasured, shared
from measured_report.commands.page import say_damage
from measured_report.editions.project import Project
from measured_report.findings.editions import editions_of
from measured_report.pages.wording import sentences_of

STRICT = {
    "action": "store_true",
    "help": "1: end with status 1 when anything can't be trusted",
}
OPTIONS = {**shared("edition", "profile", "format"), "strict": STRICT}


def run(project: Project, arguments: Arguments) -> int:
    """Print the claims; 1 where a record is damaged."""
    refuse_unmeasured(project, arguments.release.asked)
    edition = editions_of(project)[project.release]
    print(check_text(edition, arguments.format, sentences_of(project)))
    return int(
        say_damage(edition.left_out) or (arguments.strict and bool(faults_of(edition)))
    )
