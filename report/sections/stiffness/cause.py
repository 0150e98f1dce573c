"""The cause, named: what the drift goes with, and what it does not."""

from statistics import median

from markupsafe import Markup

from measured_report.parts.claim import FAILS, HOLDS, Claim, Outcome, all_of, at_least, at_most, greater
from measured_report.values.quantities import Value
from measured_report.values.results import Results
from report.sections.stiffness.runs import SHIPPED, Runs, drift_without_slide, has_slip, is_held
from report.shared.arithmetic import noise_floor, other_value, ratio, resolved, told

HARDEST = "solimp-dmax-0.9999"
CONDITIONS = {
    "that the left-out acceleration gives the slide": ("contacts", "missing_term_departure", "missing_term_bound", "%"),
    "that the slide ends when it is put back": ("contacts", "restored_share", "restored_share_bound", "%"),
    "that friction rows have no position residual": ("contacts", "friction_residual", "friction_residual_bound", "mm"),
    "that sliding is the motion": ("contacts", "slide_departure_as-shipped", "slide_departure_bound", "%"),
    "that it takes the load cycle": ("hold", "hold_share", "hold_share_bound", "%"),
}
"""What the cause takes, in words: section, value, the bound that it keeps, and their unit."""


def cause(results: Results, proportional: Claim) -> Claim:
    slip = has_slip(results)
    outcomes = {
        words: at_most(other_value(results, section, name, unit=unit), other_value(results, section, bound, unit=unit))
        for words, (section, name, bound, unit) in CONDITIONS.items()
    } | {"that the drift goes with the timeconst": proportional.outcome}
    lacking = Markup(", ").join(words for words, outcome in outcomes.items() if outcome != HOLDS)
    # Without a slip the others need not be known.
    bound = other_value(results, "reproduction", "slip_bound", unit="mm")
    numbers = {"has_slip": slip != FAILS, "slip": results.row[SHIPPED].slip_mm, "lacking": lacking, "bound": bound}
    return Claim("cause", all_of(slip, *outcomes.values()), numbers)


def drift_follows_timeconst(results: Results, runs: Runs, least: Value) -> Claim:
    rest = drift_without_slide(results)
    rows = [*runs.held, *(row for row in runs.named if "pad_dmax" in row and is_held(row))]
    times = [
        results.value(
            f"response_{row.case}",
            "dmax times the timeconst of the friction rows, their own where they have one, and two substeps where it "
            "is less than that",
            lambda dmax, normal, own, shortest: dmax * max(own or normal, shortest),
            *(row.dmax, row.timeconst_s, row.friction_timeconst_s, least),
            unit="s",
        )
        for row in rows
    ]
    formula = "drift less that with the left-out acceleration put back, over dmax times timeconst"
    rates = [
        results.value(
            f"rate_{row.case}", formula, lambda a, b, time: (a - b) / time, row.drift_mm_s, rest, time, unit="mm/s²"
        )
        for row, time in zip(rows, times, strict=True)
    ]

    def departure(*found: float) -> float:
        return 100 * max(abs(rate / median(found) - 1) for rate in found)

    formula = "largest departure of these rates from their median, of the median"
    spread = results.value("rate_spread", formula, departure, *rates, unit="%")
    formula = "longest over shortest dmax times timeconst"
    width = results.value("response_range", formula, lambda *found: max(found) / min(found), *times)
    bound = results.chosen("rate_spread_bound", "one law", 15.0, unit="%")

    def of_least(floor: float, still: float, *drifts: float) -> float:
        return 100 * floor / min(abs(drift - still) for drift in drifts)

    formula = "noise of the drift, of the least drift less that with the left-out acceleration put back, in size"
    cells = noise_floor(results, "drift_floor"), rest, *(row.drift_mm_s for row in rows)
    noise = results.value("rate_noise", formula, of_least, *cells, unit="%")
    outcome = all_of(at_most(spread, bound), resolved(noise, bound))
    is_wide = at_least(width, 3.0, why="enough to see a law")
    if is_wide == FAILS and spread.value is not None:
        outcome = Outcome("unknown", "to see whether it is proportional would take a wider range")
    numbers = {"bound": bound, **told(spread, {"spread": spread, "ratio": width})}
    return Claim("drift_follows_timeconst", outcome.having_read(spread, bound, width), numbers)


def not_creep_under_load(results: Results) -> Claim:
    shipped, hardest = results.row[SHIPPED], results.row[HARDEST]
    formula = "measured stiffness with dmax raised, over that as shipped"
    stiffer = ratio(results, "dmax_stiffness_ratio", formula, hardest.stiffness_n_m, shipped.stiffness_n_m)
    before, after = (
        results.value(f"drift_size_{row.case}", "size of the drift", abs, row.drift_mm_s, unit="mm/s")
        for row in (shipped, hardest)
    )
    moves_more = greater(after, before, noise=noise_floor(results, "drift_floor"))
    outcome = all_of(at_least(stiffer, 2.0, why="clearly stiffer"), moves_more)
    numbers = {"dmax": hardest.pad_dmax, "stiffer": stiffer, "before": before, "after": after}
    return Claim("not_creep_under_load", outcome, numbers)
