"""The cause, named: what the drift goes with, and what it does not."""

from collections.abc import Mapping
from statistics import median

from report.claims import FAILS, HOLDS, Claim, Outcome, all_of, at_most, greater
from report.deriving.arithmetic import noise_floor, other_value, ratio
from report.quantities import Value
from report.results import Results
from report.sections.stiffness.runs import SHIPPED, Runs, drift_without_slide, has_slip, is_held

HARDEST = "solimp-dmax-0.9999"


def cause(results: Results, proportional: Claim) -> Claim:
    residual = other_value(results, "contacts", "friction_residual", unit="mm")
    departure = other_value(results, "contacts", "slide_departure_as-shipped", unit="%")
    share = other_value(results, "hold", "hold_share", unit="%")
    missing = other_value(results, "contacts", "missing_term_departure", unit="%")
    slip = results.row[SHIPPED].slip_mm
    outcomes = [
        has_slip(results),
        at_most(missing, other_value(results, "contacts", "missing_term_bound", unit="%")),
        at_most(residual, other_value(results, "contacts", "friction_residual_bound", unit="mm")),
        at_most(departure, other_value(results, "contacts", "slide_departure_bound", unit="%")),
        at_most(share, other_value(results, "hold", "hold_share_bound", unit="%")),
        proportional.outcome,
    ]
    return Claim(
        "cause",
        all_of(*outcomes),
        # Without a slip the others need not be known, and a number that is not there is no finding.
        numbers={
            "has_slip": outcomes[0] != FAILS,
            "slip": slip,
            "residual": residual,
            "departure": departure,
            "share": share,
            "missing": missing,
        },
    )


def drift_follows_timeconst(results: Results, runs: Runs, least: Value) -> Claim:
    rest = drift_without_slide(results)
    rows = [*runs.held, *(row for row in runs.named if "pad_dmax" in row and is_held(row))]
    times = [
        results.value(
            f"response_{row.case}",
            "dmax times the timeconst of the friction rows, their own where they have one, and two substeps where it "
            "is less than that",
            lambda dmax, normal, own, shortest: dmax * max(own or normal, shortest),
            row.dmax,
            row.timeconst_s,
            row.friction_timeconst_s,
            least,
            unit="s",
        )
        for row in rows
    ]
    rates = [
        results.value(
            f"rate_{row.case}",
            "drift less that with the left-out acceleration put back, over dmax times timeconst",
            lambda drift, still, time: (drift - still) / time,
            row.drift_mm_s,
            rest,
            time,
            unit="mm/s²",
        )
        for row, time in zip(rows, times, strict=True)
    ]
    spread = results.value(
        "rate_spread",
        "largest departure of these rates from their median, of the median",
        lambda *found: 100 * max(abs(rate / median(found) - 1) for rate in found),
        *rates,
        unit="%",
    )
    width = results.value(
        "response_range", "longest over shortest dmax times timeconst", lambda *found: max(found) / min(found), *times
    )
    bound = results.chosen("rate_spread_bound", "one law", 15.0, unit="%")
    wide = results.chosen("response_range_bound", "enough to see a law", 3.0)
    outcome = at_most(spread, bound)
    is_narrow = None not in (width.value, spread.value) and width.value < wide.value
    if is_narrow:
        outcome = Outcome("unknown", "to see whether it is proportional would take a wider range")
    return Claim(
        "drift_follows_timeconst",
        outcome,
        numbers={"spread": spread, "ratio": width, "is_narrow": is_narrow},
    )


def not_creep_under_load(
    results: Results, proportional: Claim, give: Mapping[str, Value], stiffness: Mapping[str, Value]
) -> Claim:
    """``give`` is 1 - dmax and ``stiffness`` [N/m] what is measured, by case."""
    shipped, hardest = results.row[SHIPPED], results.row[HARDEST]
    formula = "measured stiffness with dmax raised, over that as shipped"
    stiffer = ratio(results, "dmax_stiffness_ratio", formula, stiffness[HARDEST], stiffness[SHIPPED])
    return Claim(
        "not_creep_under_load",
        greater(hardest.drift_mm_s, shipped.drift_mm_s, noise=noise_floor(results, "drift_floor")),
        numbers={
            "soft": give[SHIPPED],
            "hard": give[HARDEST],
            "stiffer": stiffer,
            "before": shipped.drift_mm_s,
            "after": hardest.drift_mm_s,
            "is_proportional": proportional.outcome == HOLDS,
        },
    )
