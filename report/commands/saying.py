"""Commands that say what the results hold, and whether it still does."""

import argparse

from report import UsageError
from report.commands.building import refuse_unmeasured, say_damage
from report.commands.options import refuse_lacking_ends
from report.records.devices import has_cuda, measuring_device
from report.records.measure import measure_headline
from report.records.project import Project


def check(project: Project, arguments: argparse.Namespace) -> int:
    """Print every claim of the report with its outcome, what can't be trusted first; STRICT=1 makes that status 1."""
    from report.alarm import check, check_said
    from report.editions import editions_of
    from report.page import Templates

    refuse_unmeasured(project, arguments.stack)
    edition = editions_of(project, Templates(project.templates))[project.release]
    found = check(edition)
    print(check_said(found, arguments.format))
    damaged = say_damage([edition])
    return int(damaged or (arguments.strict and found.is_alarm))


def diff(project: Project, arguments: argparse.Namespace) -> int:
    """Print what differs between two editions, worst first; 1 when one can't be trusted or a claim flipped."""
    from report.alarm import diff_said
    from report.compare import compare
    from report.editions import derive_edition
    from report.page import Templates

    refuse_lacking_ends(arguments, "make diff A=1.4.0 B=1.8.0")
    stacks = arguments.a, arguments.b
    sides = [project.of(str(stack.label)) for stack in stacks]
    for side, stack in zip(sides, stacks, strict=True):
        refuse_unmeasured(side, stack)
    templates = Templates(project.templates)
    comparison = compare(*(derive_edition(side, templates) for side in sides))
    print(diff_said(comparison, arguments.format, all_values=arguments.values == "all"))
    return int(comparison.is_alarm)


def trace(project: Project, arguments: argparse.Namespace) -> int:
    """Print the way of one value, from the page back to rows, cases and command."""
    from report.editions import editions_of
    from report.page import Templates
    from report.way import Ways

    if not arguments.value:
        forms = "stiffness.improvement, or a number of a row, VALUE=reproduction.as-shipped.slip_mm"
        raise UsageError(f"VALUE is missing: make trace VALUE={forms}")
    refuse_unmeasured(project, arguments.stack)
    templates = Templates(project.templates)
    print(Ways(project, editions_of(project, templates), templates).text(arguments.value))
    return 0


def verify(project: Project, arguments: argparse.Namespace) -> int:
    """Measure the headline again, keep nothing of it, and compare it with what is tracked; 1 when they differ."""
    from report.editions import derive_edition
    from report.page import Templates
    from report.verdict import compared, text_of

    refuse_unmeasured(project, arguments.stack)
    device = arguments.device or ("cuda" if has_cuda() else "cpu")
    found = measure_headline(project, arguments.stack, measuring_device(device, project.profile))
    edition = derive_edition(project, Templates(project.templates))
    comparisons = compared(edition, found)
    print(text_of(edition, found, comparisons))
    return int(not all(comparison.agrees for comparison in comparisons))
