"""Compare cases that change one setting with the baseline of the same record."""

from collections.abc import Collection

from measured_report.parts.claim import Claim, negligible
from measured_report.values.quantities import PERCENT, Quantity, absent
from measured_report.values.results import Results
from report.shared.arithmetic import CAUSE_BOUND, largest_size
from report.shared.tables import case_html


def change_of(results: Results, case: str) -> Quantity:
    """Return the slip of a case minus the slip of the baseline [mm]."""
    reason = f"there is no single row of case {case}"
    return results.derived.get(f"{case}_difference") or absent("mm", reason)


def variants_claim(
    results: Results, baseline: str, apart: Collection[str] = ()
) -> Claim:
    """Test whether any variant is the cause of the slip.

    All rows of the section are compared with the baseline, except the cases in
    ``apart``.
    """
    base = results.row[baseline]
    rows = [row for row in results.rows if row.case not in (baseline, *apart)]
    changes = {
        row: results.value(
            f"{row.case}_difference",
            f"slip of {row.case} minus the slip of {base.case}",
            row.slip_mm - base.slip_mm,
        )
        for row in rows
    }
    largest = results.value(
        "largest_difference",
        "largest absolute difference in slip from the baseline",
        largest_size(changes.values()),
    )
    share = results.value(
        "largest_share",
        "largest absolute difference in slip, relative to the slip of the baseline",
        PERCENT * largest / abs(base.slip_mm),
    )
    farthest = max(rows, key=lambda row: abs(changes[row].value or 0.0), default=base)
    numbers = {
        "largest": largest,
        "share": share,
        "most": case_html(farthest),
        "baseline": base.slip_mm,
    }
    bound = results.chosen("cause_bound", *CAUSE_BOUND)
    return Claim("not_the_cause", negligible(share, bound), numbers)
