"""Cases that each change one thing, against the baseline that was measured with them."""

from collections.abc import Collection, Sequence

from measured_report.parts.claim import Claim, Outcome, greater
from measured_report.parts.section import Section
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results
from report.shared.arithmetic import by_case, case_html, difference, largest_size, noise_floor, share


def variant_section(
    results: Results, baseline: str, *, apart: Collection[str] = (), claims: Sequence[Claim] = ()
) -> Section:
    """Compare the slip of every row, but for the cases ``apart``, with that of the case ``baseline``: their table,
    whether one is the cause, and more claims."""
    reference, rows = results.row[baseline], [row for row in results.rows if row.case not in (baseline, *apart)]
    slip, floor, changes = reference.slip_mm, noise_floor(results, "slip_floor"), {}
    for row in rows:
        formula = f"slip of {row.case} less that of {reference.case}"
        changes[row.case] = difference(results, f"{row.case}_difference", formula, row.slip_mm, slip)
    formula = "largest difference in slip from the baseline, either way"
    largest = largest_size(results, "largest_difference", formula, changes.values(), unit="mm")
    formula = "largest difference in slip from the baseline, of the baseline's slip"
    of_slip = share(results, "largest_share", formula, largest, slip)
    farthest = max(rows, key=lambda row: abs(changes[row.case].value or 0.0), default=reference)
    bound = results.chosen("cause_bound", "a cause would change the slip by more", 10.0, unit="%")
    cause = is_small(results, "cause", largest, bound, slip, floor)
    numbers = {"largest": largest, "share": of_slip, "most": case_html(farthest), "baseline": slip}
    readings = [reading(change, floor, results.derived["cause_limit"]) for change in changes.values()]
    columns = {"slip": "slip_mm", "change": ["", *changes.values()], "reading": ["as shipped", *readings]}
    table = by_case([reference, *rows], columns)
    return Section(tables={"cases": table}, claims=[Claim("not_the_cause", cause, numbers), *claims])


def reading(change: Quantity, floor: Quantity, limit: Quantity) -> str:
    """Say what a change of slip is, beside the noise and what a cause would change."""
    if None in (change.value, floor.value, limit.value):
        return ""
    if abs(change.number) <= max(floor.number, change.noise or 0.0):
        return "no difference"
    if abs(change.number) < limit.number:
        return "too little for a cause"
    return "slips less" if change.number < 0 else "slips farther"


def is_small(results: Results, name: str, change: Quantity, bound: Value, slip: Quantity, noise: Quantity) -> Outcome:
    """Tell whether a change of slip [mm] is less than ``bound`` percent of a slip, by more than the noise; more is the
    opposite."""
    formula = f"{bound.written} % of the slip, signs left out"
    limit = results.value(f"{name}_limit", formula, lambda a, b: a / 100 * abs(b), bound, slip, unit="mm")
    return greater(limit, change, noise=noise)
