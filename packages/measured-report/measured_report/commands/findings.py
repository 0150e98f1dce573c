"""Commands that print what the results say, whether they still do, and where a number comes from."""

import argparse
from importlib import import_module

from measured_report.changes import alarm
from measured_report.changes.compare import compare
from measured_report.commands.building import refuse_unmeasured, say_damage
from measured_report.commands.options import refuse_lacking_ends
from measured_report.commands.trace import Provenance
from measured_report.deriving.editions import derive_edition, editions_of
from measured_report.editions.devices import has_cuda, measuring_device
from measured_report.editions.project import Project
from measured_report.files.config import config
from measured_report.files.errors import UsageError
from measured_report.measuring.measure import measure_headline
from measured_report.pages.prose import Templates


def check(project: Project, arguments: argparse.Namespace) -> int:
    """Print every claim of the report with its outcome, what can't be trusted first; STRICT=1 makes that status 1."""
    refuse_unmeasured(project, arguments.stack)
    edition = editions_of(project, Templates(project.templates))[project.release]
    found = alarm.check(edition)
    print(alarm.check_text(found, arguments.format))
    damaged = say_damage(edition.left_out)
    return int(damaged or (arguments.strict and found.is_alarm))


def diff(project: Project, arguments: argparse.Namespace) -> int:
    """Print what differs between two editions, worst first; 1 when one can't be trusted or a claim flipped."""
    refuse_lacking_ends(arguments, "make diff A=1.4.0 B=1.8.0")
    stacks, templates = (arguments.a, arguments.b), Templates(project.templates)
    sides = [project.of(str(stack.label)) for stack in stacks]
    for side, stack in zip(sides, stacks, strict=True):
        refuse_unmeasured(side, stack)
    editions = editions_of(project, templates, among=[side.release for side in sides])
    comparison = compare(*(editions[side.release] for side in sides))
    print(alarm.diff_text(comparison, arguments.format, all_values=arguments.values == "all"))
    return int(comparison.is_alarm)


def trace(project: Project, arguments: argparse.Namespace) -> int:
    """Print the way of one value, from the page back to rows, cases and command."""
    if not arguments.value:
        rules = config().changes
        forms = f"{rules.example_value}, or a number of a row, VALUE={rules.headline}"
        raise UsageError(f"VALUE is missing: make trace VALUE={forms}")
    refuse_unmeasured(project, arguments.stack)
    templates = Templates(project.templates)
    print(Provenance(project, editions_of(project, templates), templates).text(arguments.value))
    return 0


def verify(project: Project, arguments: argparse.Namespace) -> int:
    """Measure the headline again, keep nothing of it, and compare it with what is tracked; 1 when they differ."""
    if not config().changes.verify:
        raise UsageError("report.toml names no module that verifies the headline")
    module = import_module(config().changes.verify)
    refuse_unmeasured(project, arguments.stack)
    device = measuring_device(arguments.device or ("cuda" if has_cuda() else "cpu"), project.profile)
    found = measure_headline(project, arguments.stack, device, module.PROGRAM)
    edition = derive_edition(project, Templates(project.templates))
    checks = [module.verify(edition, found)] + ([module.verify_lab(edition)] if arguments.lab else [])
    print("\n\n".join(text for text, _ in checks))
    return int(not all(agrees for _, agrees in checks))
