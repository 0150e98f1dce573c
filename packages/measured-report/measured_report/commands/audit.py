"""The command ``measured-report audit``: number-audit, which gets the noise of records from here."""

import sys
from functools import cache
from pathlib import Path

from measured_report.files.config import report
from measured_report.files.errors import ReportError
from measured_report.site.check_numbers import Data

data_of = cache(lambda folder: Data(folder, report()))


def main() -> int:
    """Run the package number-audit, if it is installed."""
    try:
        from number_audit.command import main as number_audit
    except ImportError:
        install = "pip install ./packages/number-audit"
        print(
            f"measured-report audit needs the package number-audit: {install}",
            file=sys.stderr,
        )
        return 2
    sys.path.insert(0, str(report().root))  # a report names modules of its own
    return number_audit(
        sys.argv[2:], prog="measured-report audit", noise_of_record=noise_of_record
    )


def noise_of_record(path: Path, row: int, column: str) -> float | None:
    """Return the noise of a number in a record, computed from all that was measured of it."""
    edition, file = path.parts[-2:]
    try:
        return data_of(path.parents[1]).number(
            f"{edition}/{file}#/rows/{row}/{column}"
        )[1]
    except ReportError as error:
        raise ValueError(f"the noise of {column} is not known: {error}") from None
