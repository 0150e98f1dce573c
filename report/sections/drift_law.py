"""Compare the drift that the law predicts with the measured drift in section stiffness."""

from functools import partial

from report.sections.poses import MOTION
from report.shared import (
    FAILS,
    HOLDS,
    MM_PER_M,
    MS_PER_S,
    Claim,
    Figure,
    Outcome,
    Quantity,
    Results,
    Row,
    Section,
    Sections,
    Value,
    absent,
    all_of,
    at_least,
    at_most,
    cell_count,
    combined,
    departure,
    drawing,
    is_held,
    quantile,
)
from report.shared.drawing import INK, SERIES, Drawing, new_figure, tick_125

order = 126  # after section poses, which shows the runs in motion
page = "cause"
reads = ("poses", "stiffness")
label = "law of the drift"
labels = {
    "pad-ke-2.5e3": "shipped pads",
    "pad-ke-2.5e5": "stiff pads",
    "pad-ke-#": "pads' ke {}, kd raised as well",
    "sweep-ke-#": "pads' ke {}, kd raised as well",
    "solimp-dmax-#": "dmax {}",
}

SHIPPED = "pad-ke-2.5e3"
FIX = "pad-ke-2.5e5"
MOST = 0.9  # chosen: the share of the runs that have to follow the law


def derive(results: Results) -> Section:
    runs = list(filter(is_held, results.rows))
    laws = {row.case: _law(results, row) for row in runs}
    cells = [*laws.values(), *(row.drift_mm_s for row in runs)]
    follows = _follows(results, runs, laws)
    by_hand = _by_hand(results, laws.get(SHIPPED))

    # The same acceleration follows from the speed and the curvature of the recorded
    # motion.
    others = Sections(results.others)
    motion: dict[str, Quantity] = {name: others.value("poses", name) for name in MOTION}
    swing = results.value(
        "g_swing",
        "mean squared speed of the hand over the radius of its arc",
        MM_PER_M * motion["speed_squared"] / motion["arc"],
    )
    off = results.value(
        "g_off",
        "absolute difference between this and the acceleration in the law, relative to"
        " the latter",
        departure(swing, results.derived["g"]),
    )
    outcome = at_most(off, 5.0, "the same acceleration")
    outcome = outcome.having_read(swing, *motion.values())
    arc = Claim("arc", outcome, motion | {"swing": swing})

    numbers = {"follows": follows.outcome == HOLDS}
    figure = Figure(partial(_draw, runs, laws), cells, numbers)
    return Section(figures={"law": figure}, claims=[by_hand, arc, follows])


def _law(results: Results, row: Row) -> Value:
    """Derive the drift that the law predicts.

    The time step reduces the contribution of the left-out term.
    """
    drift = row.left_out_mm_s + row.step_mm_s
    return results.value(f"law_{row.case}", "sum of the two parts of the law", drift)


def _by_hand(results: Results, law: Value | None) -> Claim:
    """Compare the law with the measured drift of shipped pads."""
    row = results.row[SHIPPED]
    others = Sections(results.others)
    dmax = others.cell("stiffness", SHIPPED, "dmax")
    substep = others.value("stiffness", "substep")
    step = results.value("step_ms", "substep", MS_PER_S * substep)
    timeconst = results.value(
        "timeconst_ms", "response time over dmax", MS_PER_S * row.response_s / dmax
    )
    g = results.value(
        "g",
        "mean of J̇q̇ along the shake, computed from the motion of the arm",
        2 * row.left_out_mm_s / row.response_s,
    )
    back = results.value(
        "back", "reduction of the drift by the time step", -row.step_mm_s
    )
    rough = law or _law(results, row)
    off = results.value(
        "rough_off",
        "absolute difference between this and the drift, relative to the latter",
        departure(rough, row.drift_mm_s),
    )
    outcome = at_most(off, 5.0, "nearly all of it")
    return Claim(
        "by_hand",
        outcome.having_read(g, dmax, timeconst, step),
        {
            "g": g,
            "dmax": dmax,
            "timeconst": timeconst,
            "step": step,
            "drift": row.drift_mm_s,
            "trailing": row.left_out_mm_s,
            "back": back,
            "rough": rough,
        },
    )


def _follows(results: Results, runs: list[Row], laws: dict[str, Value]) -> Claim:
    """Test whether most runs follow the law.

    The claim leaves out the farthest runs, because chance decides which runs at the
    limit of the grasp keep the cube.
    """
    offs = [
        results.value(
            f"off_kept_{row.case}",
            "absolute difference between the drift measured with compensated positions"
            " and the drift that the law predicts, relative to the latter",
            departure(row.drift_mm_s, laws[row.case]),
        )
        for row in runs
    ]
    half = results.value(
        "half_kept",
        "largest difference from the law among the closest half of the runs",
        combined(partial(quantile, 0.5), *offs),
    )
    most = results.value(
        "most_kept",
        "largest difference from the law among the closest nine in ten runs",
        combined(partial(quantile, MOST), *offs),
    )
    responses = [row.response_s for row in runs]
    width = results.value(
        "response_range",
        "longest over shortest response time of the friction rows",
        combined(max, *responses) / combined(min, *responses),
    )
    distinct = results.value(
        "response_count",
        "different response times of these runs, rounded to three digits",
        lambda *times: len({f"{time:.3g}" for time in times}),
        *responses,
    )
    tried = results.value(
        "tried_count",
        "runs that were tried",
        cell_count([row.pad_ke for row in results.rows]),
    )
    count = results.value(
        "count_kept",
        "runs that keep the cube, with compensated positions",
        cell_count(offs),
    )
    bound = results.chosen("law_bound", "one law", 1.5, "%")
    outcome = at_most(most, bound).having_read(width, distinct)
    numbers: dict[str, Quantity] = {
        "half": half,
        "most": most,
        "bound": bound,
        "width": width,
        "distinct": distinct,
        "count": count,
        "tried": tried,
    }
    wide = all_of(
        at_least(width, 3.0, "a range that is wide enough for a law"),
        at_least(distinct, 5, "more points than a fitted line needs"),
    )
    if outcome != FAILS and wide != HOLDS:
        reason = "no run keeps the cube"
        if width.value:
            reason = "the friction rows of all runs have nearly the same response time"
        outcome = Outcome("unknown", reason).having_read(width)
        numbers = {name: absent(cell.unit, reason) for name, cell in numbers.items()}
    return Claim("follows", outcome, numbers | {"is_wide": wide == HOLDS})


def _draw(runs: list[Row], laws: dict[str, Value]) -> Drawing:
    figure, axes = new_figure(7.2, 3.2)
    runs = sorted(runs, key=lambda row: row.response_s.value)
    times_ms = [1e3 * row.response_s.value for row in runs]
    law = [laws[row.case].value for row in runs]
    drawing.draw_line(axes, times_ms, law, color=INK, linewidth=1.0, label="the law")
    others = {row.case for row in runs} - {SHIPPED, FIX}
    for cases, label, colour, marker, size in (
        (others, "other pads", SERIES[5], "o", 5),
        ({SHIPPED}, "shipped pads", drawing.SHIPPED, "D", 9),
        ({FIX}, "stiff pads", drawing.STIFF, "D", 9),
    ):
        points = [
            (time_ms, row.drift_mm_s.value)
            for time_ms, row in zip(times_ms, runs, strict=True)
            if row.case in cases
        ]
        drawing.mark_points(
            axes, points, label=label, color=colour, marker=marker, markersize=size
        )
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
