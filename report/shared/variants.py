"""Cases that each change one setting, compared with the baseline of the same record."""

from collections.abc import Collection
from typing import NamedTuple

from measured_report.parts.claim import Claim, Outcome, at_least, negligible
from measured_report.parts.section import Section
from measured_report.values.quantities import PERCENT, Quantity, absent
from measured_report.values.results import Results, Row
from report.shared.arithmetic import CAUSE_BOUND, SLIP_BOUND, largest_size
from report.shared.tables import case_html


class Variants(NamedTuple):
    """A comparison of the slips of one section."""

    baseline: Row
    slips: Outcome  # whether the baseline slips; if it does not, no cause is sought
    numbers: dict[
        str, Quantity | str
    ]  # numbers that the wording of the claim can print


def change_of(results: Results, case: str) -> Quantity:
    """Return the slip of a case minus that of the baseline [mm]."""
    reason = f"there is no single row of case {case}"
    return results.derived.get(f"{case}_difference") or absent("mm", reason)


def variant_section(results: Results, variants: Variants, *claims: Claim) -> Section:
    """Make a section with the claim that no variant is the cause, and more claims."""
    bound = results.chosen("cause_bound", *CAUSE_BOUND)
    cause = negligible(results.derived["largest_share"], bound)
    return Section(claims=[Claim("not_the_cause", cause, variants.numbers), *claims])


def variants_of(
    results: Results, baseline: str, apart: Collection[str] = ()
) -> Variants:
    """Compare all rows of the section with the baseline, except the cases ``apart``."""
    base = results.row[baseline]
    rows = [row for row in results.rows if row.case not in (baseline, *apart)]
    changes = {
        row: results.value(
            f"{row.case}_difference",
            f"slip of {row.case} minus that of {base.case}",
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
    bound = results.chosen("slip_bound", *SLIP_BOUND)
    numbers: dict[str, Quantity | str] = {
        "largest": largest,
        "share": share,
        "most": case_html(farthest),
        "baseline": base.slip_mm,
    }
    return Variants(base, at_least(base.slip_mm, bound), numbers)
