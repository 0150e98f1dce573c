"""Cases that each change one thing, against the baseline that was measured with them."""

from collections.abc import Collection
from typing import NamedTuple

from measured_report.parts.claim import Claim, Outcome, at_least, greater
from measured_report.parts.section import Section
from measured_report.values.quantities import PERCENT, Quantity, Value, absent
from measured_report.values.results import Results, Row
from report.shared.arithmetic import largest_size, noise_floor, other_value, resolved
from report.shared.tables import case_html


class Variants(NamedTuple):
    """The rows of one section, whose slips are compared."""

    baseline: Row
    slips: Outcome  # whether the baseline slips at all, so that there is something to explain
    seen: Outcome  # whether a change that matters would be seen beside the noise
    numbers: dict[str, Quantity | str]  # what the wording of a claim can name


def change_of(results: Results, case: str) -> Quantity:
    """Return the slip of a case less that of the baseline [mm]."""
    reason = f"there is no single row of case {case}"
    return results.derived.get(f"{case}_difference") or absent("mm", reason)


def variant_section(results: Results, variants: Variants, *claims: Claim) -> Section:
    """Make the section of variants: whether one of them is the cause, and more claims."""
    why = "a cause would change the slip by more"
    bound = results.chosen("cause_bound", why, 10.0, "%")
    largest = results.derived["largest_difference"]
    floor = noise_floor(results, "slip_floor")
    slip = variants.baseline.slip_mm
    cause = is_small(results, "cause", largest, bound, slip, floor)
    return Section(claims=[Claim("not_the_cause", cause, variants.numbers), *claims])


def variants_of(
    results: Results, baseline: str, apart: Collection[str] = ()
) -> Variants:
    """Compare every row of the section with the baseline, but for cases ``apart``."""
    base = results.row[baseline]
    rows = [row for row in results.rows if row.case not in (baseline, *apart)]
    changes = {
        row: results.value(
            f"{row.case}_difference",
            f"slip of {row.case} less that of {base.case}",
            row.slip_mm - base.slip_mm,
        )
        for row in rows
    }
    largest = results.value(
        "largest_difference",
        "largest difference in slip from the baseline, either way",
        largest_size(changes.values()),
    )
    share = results.value(
        "largest_share",
        "largest difference in slip from the baseline, of the baseline's slip",
        PERCENT * largest / base.slip_mm,
    )
    farthest = max(rows, key=lambda row: abs(changes[row].value or 0.0), default=base)
    floor = noise_floor(results, "slip_floor")
    unseen = results.value(
        "floor_share",
        "noise of the slip, of the baseline's slip",
        PERCENT * floor / base.slip_mm,
    )
    bound = other_value(results, "reproduction", "slip_bound")
    numbers: dict[str, Quantity | str] = {
        "largest": largest,
        "share": share,
        "most": case_html(farthest),
        "baseline": base.slip_mm,
        "unseen": unseen_in(largest, floor),
    }
    return Variants(
        base,
        slips=at_least(base.slip_mm, bound),
        seen=resolved(unseen, 5.0, why="no change to speak of"),
        numbers=numbers,
    )


def unseen_in(change: Quantity, floor: Quantity) -> str:
    """Say so of a change that is within the noise."""
    is_known = None not in (change.value, floor.value)
    return ", within the noise" if is_known and change.number <= floor.number else ""


def is_small(
    results: Results,
    name: str,
    change: Quantity,
    bound: Value,
    slip: Quantity,
    noise: Quantity,
) -> Outcome:
    """Tell whether a change [mm] is less than ``bound`` percent of a slip, beyond noise.

    More is the opposite.
    """
    limit = results.value(
        f"{name}_limit",
        f"{bound.written} % of the slip, signs left out",
        bound / PERCENT * abs(slip),
    )
    return greater(limit, change, noise=noise)
