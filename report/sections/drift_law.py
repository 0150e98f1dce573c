"""The law of the drift: what the runs of section stiffness drift, beside what the arm's motion says beforehand."""

from collections.abc import Mapping, Sequence
from functools import partial

from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import INK, SERIES, new_figure, tick_125
from report.sections.poses import MOTION
from report.shared import (
    FAILS,
    HOLDS,
    MM_PER_M,
    MS_PER_S,
    PERCENT,
    Claim,
    Figure,
    Outcome,
    Quantity,
    Results,
    Row,
    Section,
    Value,
    absent,
    all_of,
    arithmetic,
    at_least,
    at_most,
    combined,
    departure,
    drawing,
    largest_size,
    noise_floor,
    quantile,
    resolved,
)

order = 126  # after the runs that are shown moving
page = "cause"
reads = ("noise", "poses", "stiffness")
label = "law of the drift"
labels = {
    "pad-ke-2.5e3": "shipped pads",
    "pad-ke-2.5e5": "stiff pads",
    "pad-ke-#": "pads' ke {}, kd with it",
    "sweep-ke-#": "pads' ke {}, kd with it",
    "solimp-dmax-#": "dmax {}",
}

SHIPPED, FIX = "pad-ke-2.5e3", "pad-ke-2.5e5"
MOST = 0.9  # chosen: the law is asked of so many of the runs


def derive(results: Results) -> Section:
    runs = list(filter(arithmetic.is_held, results.rows))
    laws = {row.case: _law(results, row) for row in runs}
    offs = [
        results.value(
            f"off_kept_{row.case}",
            "drift measured with positions compensated, less that of the law, in size, of the latter",
            departure(row.drift_mm_s, laws[row.case]),
        )
        for row in runs
    ]
    follows, sources = (
        _follows(results, runs, laws, offs),
        [*laws.values(), *(row.drift_mm_s for row in runs)],
    )
    figure = Figure(
        partial(_draw, runs, laws), sources, {"follows": follows.outcome == HOLDS}
    )
    return Section(
        figures={"law": figure},
        claims=[_by_hand(results, laws), _arc(results), follows],
    )


def _law(results: Results, row: Row) -> Value:
    """Derive what is printed: what the left-out acceleration makes, less what the step takes away."""
    return results.value(
        f"law_{row.case}",
        "drift by the law, of both its parts",
        row.left_out_mm_s + row.step_mm_s,
    )


def _by_hand(results: Results, laws: Mapping[str, Value]) -> Claim:
    """Tell both parts for shipped pads: the acceleration is of the arm's motion, and nothing of the cube's."""
    row, stiffness = (
        results.row[SHIPPED],
        partial(arithmetic.Sections(results.others).cell, "stiffness", SHIPPED),
    )
    dmax, substep = (
        stiffness("dmax"),
        arithmetic.other_value(results, "stiffness", "substep"),
    )
    step = results.value("step_ms", "substep in ms", MS_PER_S * substep)
    timeconst = results.value(
        "timeconst_ms", "response over dmax", MS_PER_S * row.response_s / dmax
    )
    g = results.value(
        "g",
        "mean of J̇q̇ along the shake, from the arm's motion",
        2 * row.left_out_mm_s / row.response_s,
    )
    back = results.value("back", "what the step takes away", -row.step_mm_s)
    rough = laws.get(SHIPPED) or _law(results, row)
    off = results.value(
        "rough_off",
        "how far that is from the drift, of the latter",
        departure(rough, row.drift_mm_s),
    )
    numbers = {
        "g": g,
        "dmax": dmax,
        "timeconst": timeconst,
        "step": step,
        "drift": row.drift_mm_s,
    }
    numbers |= {"trailing": row.left_out_mm_s, "back": back, "rough": rough}
    return Claim(
        "by_hand",
        at_most(off, 5.0, why="nearly all of it").having_read(g, dmax, timeconst, step),
        numbers,
    )


def _arc(results: Results) -> Claim:
    """Tell the same acceleration by a speed and an arc, of the joints' record: no contact and no law is in them."""
    numbers: dict[str, Quantity] = {
        name: arithmetic.other_value(results, "poses", name) for name in MOTION
    }
    swing = results.value(
        "g_swing",
        "squared speed over arc",
        MM_PER_M * numbers["speed_squared"] / numbers["arc"],
    )
    off = results.value(
        "g_off",
        "how far that is from what the law takes",
        departure(swing, results.derived["g"]),
    )
    outcome = at_most(off, 5.0, why="the same acceleration").having_read(
        swing, *numbers.values()
    )
    return Claim("arc", outcome, numbers | {"swing": swing})


def _follows(
    results: Results,
    runs: Sequence[Row],
    laws: Mapping[str, Value],
    offs: Sequence[Value],
) -> Claim:
    """Ask it of most runs: which at the edge keep the cube is chance, and so is the farthest of all."""
    bound = results.chosen("law_bound", "one law", 1.5, "%")
    middle, far = (
        combined(partial(quantile, 0.5), *offs),
        combined(partial(quantile, MOST), *offs),
    )
    half = results.value(
        "half_kept", "departure from the law of half of the runs, at most", middle
    )
    most = results.value(
        "most_kept", "departure from the law of nine in ten runs, at most", far
    )
    responses, formula = (
        [row.response_s for row in runs],
        "longest over shortest response of the friction rows",
    )
    width = results.value(
        "response_range", formula, combined(max, *responses) / combined(min, *responses)
    )
    distinct = results.value(
        "response_count",
        "different responses of these runs, to a thousandth of themselves",
        lambda *s: len({f"{each:.3g}" for each in s}),
        *responses,
    )
    fastest = results.value(
        "drift_most",
        "fastest of these drifts",
        largest_size(row.drift_mm_s for row in runs),
    )
    floor = PERCENT * noise_floor(results, "drift_floor")
    noise = results.value(
        "drift_noise", "noise of the drift, of the fastest", floor / fastest
    )
    slow = results.value(
        "law_least",
        "drift that the law gives to nine in ten runs, at least",
        combined(partial(quantile, 1 - MOST), *map(abs, laws.values())),
    )
    scatter = results.value("law_noise", "noise of the drift, of that", floor / slow)
    outcome = all_of(at_most(most, bound), resolved(noise, bound)).having_read(
        width, distinct
    )
    if outcome == FAILS and (unclear := resolved(scatter, most)) != HOLDS:
        outcome = unclear.having_read(width, distinct)
    numbers: dict[str, Quantity] = {
        "half": half,
        "most": most,
        "bound": bound,
        "width": width,
        "distinct": distinct,
    }
    formula, tried = (
        "runs that keep the cube, positions compensated",
        [row.pad_ke for row in results.rows],
    )
    numbers["count"] = results.value("count_kept", formula, arithmetic.cell_count(offs))
    numbers["tried"] = results.value(
        "tried_count", "runs that were tried", arithmetic.cell_count(tried)
    )
    many = at_least(distinct, 5, why="more than a line takes")
    is_wide = all_of(at_least(width, 3.0, why="enough to see a law"), many)
    if outcome != FAILS and is_wide != HOLDS:
        reason = (
            "the friction rows of all runs brake too much alike to tell"
            if width.value
            else "no cube is kept"
        )
        outcome = Outcome("unknown", reason).having_read(width)
        numbers = {
            name: absent(number.unit, reason) for name, number in numbers.items()
        }
    return Claim("follows", outcome, numbers | {"is_wide": is_wide == HOLDS})


def _draw(runs: Sequence[Row], laws: Mapping[str, Value]) -> Drawing:
    figure, axes = new_figure(7.2, 3.2)
    by_response = sorted(runs, key=lambda row: row.response_s.value)
    law = [(1e3 * row.response_s.value, laws[row.case].value) for row in by_response]
    axes.plot(
        *zip(*law, strict=True),
        color=INK,
        linestyle="-",
        linewidth=1.0,
        marker="",
        label="the law",
    )
    for case, colour, label in (
        ("", SERIES[5], "other pads"),
        (SHIPPED, drawing.SHIPPED, "shipped pads"),
        (FIX, drawing.STIFF, "stiff pads"),
    ):
        mine = [
            row
            for row in runs
            if (row.case if row.case in (SHIPPED, FIX) else "") == case
        ]
        points = [(1e3 * row.response_s.value, row.drift_mm_s.value) for row in mine]
        look = (
            {"marker": "D", "markersize": 9}
            if case
            else {"marker": "o", "markersize": 5}
        )
        drawing.mark_points(axes, points, color=colour, label=label, **look)
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="response time T of the friction rows [ms]",
        ylabel="drift [mm/s]",
    )
    tick_125(axes.xaxis)
    tick_125(axes.yaxis)
    axes.legend()
    return figure
