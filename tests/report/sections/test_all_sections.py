"""Test all sections of a release with the tracked records."""

import pytest
from deriving import results_with, shown_numbers

from measured_report.editions.project import Project
from measured_report.findings.sections import derive_section
from measured_report.values.quantities import Quantity

TRACKED = sorted(path.stem for path in Project("1.4.0").results.glob("*.json"))
SECTIONS = [(name, "1.4.0") for name in TRACKED if name not in ("clips", "upgrade")]


@pytest.mark.usefixtures("unchanged")
@pytest.mark.parametrize(
    ("section", "release"), [*SECTIONS, ("newton_solvers", "1.8.0")]
)
def test_no_case_is_named_that_has_no_row(section, release):
    results = results_with(section, release=release)
    derived = derive_section(results, {})
    numbers = [
        *results.derived.values(),
        *(number for _, number in shown_numbers(derived)),
    ]
    numbers += [number for claim in derived.claims for number in claim.numbers.values()]
    for table in derived.tables.values():
        numbers += [*table.frame.to_numpy().ravel()]
    reasons = {each.reason for each in numbers if isinstance(each, Quantity)}
    lost = {reason for reason in reasons if "no single row" in reason}
    assert lost <= {"there is no single row of case discrete-20ms-pinch-2ms"}
