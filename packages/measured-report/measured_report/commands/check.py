"""Print the faults of an edition and the outcome of each claim."""

from measured_report.changes.alarm import check_text
from measured_report.changes.compare import faults_of
from measured_report.commands.options import Arguments, refuse_unmeasured, shared
from measured_report.commands.status import print_left_out
from measured_report.editions.project import Project
from measured_report.findings.editions import editions_of
from measured_report.pages.wording import sentences_of

STRICT = {
    "action": "store_true",
    "help": "1: end with status 1 if there are faults",
}
OPTIONS = {**shared("edition", "profile", "format"), "strict": STRICT}


def run(project: Project, arguments: Arguments) -> int:
    """Print faults and claims, and return 1 if a record cannot be read or shown."""
    refuse_unmeasured(project, arguments.release.spec)
    editions = editions_of(project)
    edition = editions[project.release]
    print(check_text(edition, arguments.format, sentences_of(project)))
    is_damaged = print_left_out(editions)
    return int(is_damaged or (arguments.strict and bool(faults_of(edition))))
