"""Run number-audit with the noise from the records of this report.

This is the command ``measured-report audit``.
"""

import sys
from functools import cache
from pathlib import Path

from measured_report.commands.status import print_damage_of
from measured_report.editions.project import Project, own_release
from measured_report.files.config import report
from measured_report.files.errors import ReportError
from measured_report.findings.cache import DerivedCache
from measured_report.findings.replicas import measurements_of
from measured_report.records.record import load_record
from measured_report.values.evidence import Evidence


def main() -> int:
    """Run the package number-audit if it is installed, and return the exit status.

    The status is also 1 if a record or replica of this report cannot be read.
    """
    try:
        from number_audit.command import main as number_audit
    except ImportError:
        install = "pip install ./packages/number-audit"
        print(
            "number-audit is not installed, and measured-report audit needs it: "
            f"{install}",
            file=sys.stderr,
        )
        return 2
    # The package number-audit imports modules of the report.
    sys.path.insert(0, str(report().root))
    status = number_audit(
        sys.argv[2:], prog="measured-report audit", noise_of_record=noise_of_record
    )
    own = own_release()
    project = Project(own, root=report().root, own_release=own)
    return status or int(print_damage_of(project))


def noise_of_record(path: Path, row: int, column: str) -> float | None:
    """Return the noise of a number in a record, computed from all its measurements."""
    try:
        cells = load_record(path).rows[row]
        evidence = evidence_of(path.parent.name).get(path.stem, Evidence())
        estimate = evidence.estimate(column, cells, report().columns)
    except (ReportError, LookupError) as error:
        raise ValueError(f"cannot compute the noise of {column}: {error}") from None
    return estimate.written_noise if estimate else None


@cache
def evidence_of(folder: str) -> dict[str, Evidence]:
    """Return the evidence of each section in the edition that a folder of results
    contains.
    """
    settings = report().settings
    project = Project(settings.edition_in(folder), root=report().root)
    derived_cache = DerivedCache(project.root, project.report)
    return dict(measurements_of(project, derived_cache).evidence)
