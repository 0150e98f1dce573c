"""Print the claims that flipped and the numbers that moved between two editions."""

from measured_report.changes.alarm import diff_text, false_alarm_counts, rate_text
from measured_report.changes.compare import compare
from measured_report.commands.options import (
    Arguments,
    refuse_itself,
    refuse_unmeasured,
    shared,
)
from measured_report.commands.status import print_damage_of
from measured_report.commands.upgrade import in_turn
from measured_report.editions.project import Project
from measured_report.findings.editions import derive_edition
from measured_report.pages.wording import sentences_of

OPTIONS = shared("a", "b", "profile", "format")


def run(project: Project, arguments: Arguments) -> int:
    """Print the differences and return 1 for an alarm.

    An alarm is a claim that flipped, a number that moved, or an edition with faults. The
    status is also 1 if a record of any edition cannot be read, because all of them show
    how numbers scatter.
    """
    refuse_itself(project, str(arguments.a), str(arguments.b))
    for release in (arguments.a, arguments.b):
        refuse_unmeasured(project.of(str(release)), release.spec)
    names = [str(arguments.a), str(arguments.b)]
    # Each edition is derived by itself, so that the evidence of the other one does not
    # count.
    before, after = (derive_edition(project.of(name)) for name in names)
    timed = in_turn([before.project, after.project])
    comparison = compare(before, after, list(map(derive_edition, timed)))
    rate = false_alarm_counts(before) + false_alarm_counts(after)
    print(
        diff_text(comparison, rate_text(rate), arguments.format, sentences_of(project))
    )
    return int(print_damage_of(project) or comparison.is_alarm)
