"""The cause, named; what ke and kd become in the contact that the solver has; and which of them holds the cube."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from statistics import median
from typing import Any

from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from experiments.facts.case import AS_SHIPPED
from measured_report.parts.claim import FAILS, HOLDS, Claim, Outcome, all_of, at_least, at_most, greater, within
from measured_report.parts.figures import INK, SERIES, new_figure, tick_125
from measured_report.parts.section import Figure, Section
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results, Row
from report.shared import drawing as colours
from report.shared.arithmetic import (
    SETTLES,
    extreme,
    is_held,
    noise_floor,
    other_cell,
    other_value,
    ratio,
    resolved,
    share,
    spread,
    told,
)
from report.shared.drawing import mark_points

order = 90
page = "cause"
reads = ("contacts", "hold", "noise", "reproduction")
leads = True
label = "pads' ke and kd"


def derive(results: Results) -> Section:
    plain = sorted((row for row in results.rows if "pad_dmax" not in row), key=lambda row: row.pad_ke.value)
    runs = Runs(
        named=[row for row in results.rows if not row.case.startswith("sweep-")],
        ke_alone=[row for row in plain if row.pad_kd.value == AS_SHIPPED.pad_kd],
        together=[row for row in plain if row.pad_kd.value != AS_SHIPPED.pad_kd or row.case == SHIPPED],
    )
    formula = "given by the scene: frame time over substeps"
    substep = results.value("substep", formula, lambda: 1 / 60 / AS_SHIPPED.substeps, unit="s")
    least = results.value("least_timeconst", "two substeps", lambda step: 2 * step, substep, unit="s")
    clamp = results.value("clamp_kd", "kd at which 2 / kd is two substeps", lambda shortest: 2 / shortest, least)
    proportional = drift_follows_timeconst(results, runs, least)
    alone, together = ke_alone_does_not_help(results, runs), together_they_hold(results)
    numbers: dict[str, Any]
    numbers = {"shipped": results.row[SHIPPED].slip_mm, "fix": results.row[FIX].slip_mm, "clamp": clamp}
    numbers["is_so"] = all_of(alone.outcome, together.outcome) == HOLDS
    sweep = Figure(lambda: draw_sweep(runs, clamp.value), [row.slip_mm for row in runs.held], numbers)
    return Section(
        figures={"sweep": sweep},
        claims=[
            cause(results, proportional),
            proportional,
            not_creep_under_load(results),
            ke_is_no_spring(results),
            alone,
            together,
            flat_below_clamp(results, runs, clamp),
        ],
    )


SHIPPED, FIX = "pad-ke-2.5e3", "pad-ke-2.5e5"


@dataclass(frozen=True)
class Runs:
    """The runs, sorted by what changed and by how they ended."""

    named: Sequence[Row]
    """Those that are no part of the fine sweep."""
    ke_alone: Sequence[Row]
    """kd at its import default."""
    together: Sequence[Row]
    """ke and kd raised together."""

    @property
    def held(self) -> list[Row]:
        """Return those that keep the cube; the scene as shipped is in both series and counts once."""
        return list({row.case: row for row in (*self.ke_alone, *self.together) if is_held(row)}.values())


def has_slip(results: Results) -> Outcome:
    return at_least(results.row[SHIPPED].slip_mm, other_value(results, "reproduction", "slip_bound", unit="mm"))


def drift_without_slide(results: Results) -> Quantity:
    """Return the drift of a shaken cube that does not slide: with the left-out acceleration put back into the contact
    rows."""
    return other_cell(results, "contacts", "as-shipped-term-restored", "drift_mm_s", unit="mm/s")


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


NO_HELP = 80.0
"""Chosen: a slip of so much of that as shipped, in percent, is no help."""
STIFFEST = "pad-ke-2.5e6"

NO_SLIP = "with shipped pads there is no slip to bring down"
NO_GAIN = Outcome("unknown", "raising both gains too little for its end to be seen")


def ke_is_no_spring(results: Results) -> Claim:
    soft, stiff = results.row[SHIPPED], results.row[STIFFEST]
    formula = "largest over smallest authored ke of the named cases"
    authored = ratio(results, "ke_ratio", formula, stiff.pad_ke, soft.pad_ke)
    formula = "measured stiffness at that largest ke over that at the smallest"
    measured = ratio(results, "stiffness_ratio", formula, stiff.stiffness_n_m, soft.stiffness_n_m)
    follows = share(results, "stiffness_follows", "measured ratio, of the authored", measured, authored)
    numbers = {"ke": soft.pad_ke, "k": soft.stiffness_n_m, "times": authored, "more": measured}
    return Claim("ke_is_no_spring", at_most(follows, 50.0, why="does not follow"), numbers)


def _with_slip(name: str, results: Results, outcome: Outcome, numbers: Mapping[str, Quantity]) -> Claim:
    """Return a claim about what brings the slip down; where there is none as shipped, it can't tell and names no
    numbers."""
    slip = has_slip(results)
    if slip != FAILS:
        return Claim(name, outcome, numbers)
    return Claim(name, Outcome("unknown", NO_SLIP, reads=slip.reads), told(absent("mm", NO_SLIP), numbers))


def ke_alone_does_not_help(results: Results, runs: Runs) -> Claim:
    held = list(filter(is_held, runs.ke_alone))
    slips, stiffnesses = [row.slip_mm for row in held], [row.pad_ke for row in held]
    low = extreme(results, "ke_alone_least", "least slip of the runs with kd at its default", min, slips)
    formula = "least slip with kd at its default, of the slip as shipped"
    of_shipped = share(results, "ke_alone_share", formula, low, results.row[SHIPPED].slip_mm)
    first = extreme(results, "ke_alone_first", "least ke of these runs", min, stiffnesses)
    last = extreme(results, "ke_alone_last", "largest ke of these runs", max, stiffnesses)
    numbers = {"kd": results.row[SHIPPED].pad_kd, "share": of_shipped, "low": low, "first": first, "last": last}
    return _with_slip("ke_alone_does_not_help", results, at_least(of_shipped, NO_HELP, why="no help"), numbers)


def together_they_hold(results: Results) -> Claim:
    shipped, fix = results.row[SHIPPED], results.row[FIX]
    gain = ratio(results, "improvement", "slip as shipped over slip with the fix", shipped.slip_mm, fix.slip_mm)
    bound = results.chosen("improvement_bound", *SETTLES)
    numbers = {"ke": fix.pad_ke, "kd": fix.pad_kd, "slipped": shipped.slip_mm, "slip": fix.slip_mm, "gain": gain}
    return Claim("together_they_hold", at_least(gain, bound), numbers)


def flat_below_clamp(results: Results, runs: Runs, clamp: Value) -> Claim:
    slips = [row.slip_mm for row in runs.together if is_held(row) and row.pad_kd.value >= clamp.value]
    formula = "largest less smallest slip of the runs with both raised and kd beyond the clamp"
    difference = spread(results, "clamped_spread", formula, slips, unit="mm")
    floor = noise_floor(results, "slip_floor")
    numbers: Mapping[str, Quantity] = {"spread": difference, "floor": floor}
    outcome = within(difference, floor)
    gain, bound = results.derived["improvement"], results.derived["improvement_bound"]
    if at_least(gain, bound) != HOLDS:
        outcome = NO_GAIN.having_read(gain, bound, difference, floor)
        numbers = told(absent("mm", NO_GAIN.reason), numbers)
    return Claim("flat_below_clamp", outcome, {"clamp": clamp, **numbers})


ENDS = {"dropped": "v", "not finite": "x", "overflow": "P", "shaken too late": "s"}
"""How a run can end with no slip to show, and its mark."""
LINES = SERIES[5], SERIES[4]
"""Of kd at its default, and raised with ke."""


def draw_sweep(runs: Runs, clamp_kd: float) -> Drawing:
    drawing, axes = new_figure(7.2, 4.2)
    fine = [row for row in runs.together if row.case.startswith("sweep-")]
    series = (("kd at its default", runs.ke_alone), ("kd = 2√ke, damping ratio 1", fine))
    held = [row.slip_mm.value for _, rows in series for row in rows if is_held(row)]
    top = 3.0 * max(held)
    for (label, rows), colour in zip(series, LINES, strict=True):
        kept = [row for row in rows if is_held(row)]
        axes.plot(
            [r.pad_ke.value for r in kept], [r.slip_mm.value for r in kept], label=label, color=colour, markevery=1
        )
    for case, colour, label in ((SHIPPED, colours.SHIPPED, "shipped pads"), (FIX, colours.STIFF, "stiff pads")):
        points = [(row.pad_ke.value, row.slip_mm.value) for row in runs.held if row.case == case]
        mark_points(axes, points, marker="D", markersize=9, color=colour, label=label, zorder=5)
    for end, mark in ENDS.items():
        for number, (_, rows) in enumerate(series):
            found = [(row.pad_ke.value, top) for row in rows if _end(row) == end]
            mark_points(axes, found, marker=mark, color=LINES[number], clip_on=False, markersize=7)
        if any(_end(row) == end for _, rows in series for row in rows):
            axes.plot([], [], mark, color=INK, markersize=7, markevery=1, label=end)
    axes.set(xscale="log", yscale="log", xlabel="pad ke", ylabel="slip [mm]", ylim=(0.6 * min(held), top))
    clamp_ke = (clamp_kd / 2) ** 2
    axes.axvline(clamp_ke, color=INK, linewidth=1.0, linestyle=":")
    place: dict[str, Any] = {"xycoords": ("data", "axes fraction"), "xytext": (6, 0), "textcoords": "offset points"}
    axes.annotate("2/kd = 2·dt\n(kd = 2√ke)", (clamp_ke, 0.42), **place)
    tick_125(axes.yaxis)
    drawing.legend(loc="outside upper left", ncols=3)
    return drawing


def _end(row: Row) -> str:
    if is_held(row):
        return ""
    if row.slip_mm.value is not None:
        return "dropped" if row.dropped else "shaken too late"
    return "overflow" if "overflow" in (row.failure or "") else "not finite"
