"""Compare the error with the run time: the gain of each setting, and its cost."""

import math
from functools import partial

import numpy as np

from experiments.facts.case import AS_SHIPPED
from report.sections.error_runtime import runs
from report.sections.error_runtime.figures import draw_numerical
from report.sections.error_runtime.runs import ERROR, GRASP, SHIPPED, Points
from report.shared import (
    HOLDS,
    PERCENT,
    Claim,
    Figure,
    Outcome,
    Results,
    Section,
    all_of,
    at_least,
    at_most,
    cell_count,
    combined,
    constant,
    contiguous,
    decreases,
    gathered,
    greater,
    largest_size,
    negligible,
    quantile,
)

order = 155
page = "error"
first = True
label = "error and run time"
labels = {
    "as-shipped/newton/iterations-1": "shipped pads, Newton's contacts, 1 iteration",
    "as-shipped/newton/iterations-#": "shipped pads, Newton's contacts, {} iterations",
    "stiff/newton/iterations-#": "stiff pads, Newton's contacts, {} iterations",
    "as-shipped/newton/solver-cg": (
        "shipped pads, Newton's contacts, conjugate gradients"
    ),
    "stiff/newton/solver-cg": "stiff pads, Newton's contacts, conjugate gradients",
}

EACH_SUBSTEP = f"newton-each-substep/substeps-{AS_SHIPPED.substeps}"


def derive(results: Results) -> Section:
    points = runs.points_of(results)
    shipped = points[SHIPPED]
    floor = points.floors["as-shipped"]

    # If the model is solved exactly, the grasp error of shipped pads remains, and stiff
    # pads have a smaller one.
    soft, stiff = map(points.converged, runs.PADS)
    stays = results.value(
        "pads_stays",
        "converged grasp error of shipped pads, relative to the error as shipped",
        PERCENT * soft / shipped[GRASP],
    )
    gain = results.value(
        "pads_gain",
        "converged grasp error with shipped pads divided by the error with stiff pads",
        soft / stiff,
    )
    resolution = results.value(
        "pads_seen",
        "largest distance between Warp and C, taken as the error of one cycle",
        floor / constant(1, "cycle"),
        is_noise=True,
    )
    pads_decide = all_of(
        at_least(stays, 80.0, "nearly all of it"),
        at_least(gain, 5.0, "nearly an order of magnitude"),
        decreases([soft, stiff], by=resolution),
    )

    rk4 = points["as-shipped/newton-rk4/substeps-2"]
    doubled = results.value(
        "rk4_warp_doubled", "twice the numerical error of RK4", 2 * rk4[ERROR]
    )
    # Both times are ratios to the shipped settings, because the medians of the times
    # themselves come from different rounds.
    cost = results.value(
        "rk4_warp_cost",
        "run time of RK4 divided by the time as shipped, from both ratios to the shipped"
        " settings in Warp, timed in turn",
        rk4.time_ratio / shipped.time_ratio,
    )
    resolutions = (rk4.ratio_resolution, shipped.ratio_resolution)
    cost_resolution = results.value(
        "rk4_warp_cost_seen",
        "resolution of this ratio, from the resolutions of both run times",
        PERCENT * combined(math.hypot, *resolutions),
        is_noise=True,
    )
    is_as_long = None not in (cost.value, cost_resolution.value)
    is_as_long = is_as_long and abs(cost.value - 1) <= 0.01 * cost_resolution.value
    rk4_pays = all_of(
        decreases([shipped[ERROR], doubled], by=floor),
        at_most(cost, 1.5, "hardly more expensive"),
    )

    coarse = points["stiff/c-rk4/substeps-4"]
    fine = points[runs.with_shipped_steps("stiff", "c")]
    better = decreases([coarse[ERROR], fine[ERROR]], by=points.floors["stiff"])

    worst = results.value(
        "reference_error",
        "largest distance between a reference and the same run with twice the step",
        combined(max, *(row[ERROR] for row in points.references)),
    )
    plotted = [row[ERROR] for row in points.settings if runs.counts(row)]
    least = results.value(
        "low_error",
        "numerical error that nine in ten plotted runs exceed",
        combined(partial(quantile, 0.1), *plotted),
    )
    margin = results.value(
        "reference_margin",
        "this error divided by the error of the reference",
        least / worst,
    )

    # These settings change the effort: solver, iterations, line search, and contacts
    # found in each substep.
    efforts = [
        row
        for row in points.settings
        if row["pads"] == "as-shipped"
        and (
            row.case.endswith(EACH_SUBSTEP)
            or (
                row.method == "newton"
                and row.knob in ("iterations", "ls_iterations", "solver")
            )
        )
    ]
    converged = [
        row
        for row in efforts
        if runs.holds_cube(row) and not runs.uses_all_iterations(row)
    ]
    change = results.value(
        "effort_change",
        "largest absolute change of the numerical error by solver, iterations, line"
        " search or contacts found in each substep",
        largest_size(shipped[ERROR] - row[ERROR] for row in converged),
    )
    share = results.value(
        "effort_share",
        "this change, relative to the numerical error as shipped",
        PERCENT * change / shipped[ERROR],
    )
    count = results.value(
        "effort_count",
        "runs with a different solver effort that hold the cube and converge",
        cell_count([row[ERROR] for row in converged]),
    )
    tried = results.value(
        "effort_tried",
        "runs with a different solver effort",
        cell_count([row.substeps for row in efforts]),
    )
    effort = negligible(share, 10.0, "a gain that is worth the effort")

    numbers = {"rk4_warp": rk4_pays == HOLDS}
    errors = [row[ERROR] for row in points.settings]
    numerical = Figure(lambda: draw_numerical(points), errors, numbers)
    return Section(
        figures={"numerical": numerical},
        claims=[
            Claim(
                "pads_decide",
                pads_decide,
                {"shipped": shipped[GRASP], "soft": soft, "stiff": stiff},
            ),
            Claim(
                "rk4_warp",
                rk4_pays.having_read(cost_resolution),
                {
                    "cost": cost,
                    "error": rk4[ERROR],
                    "before": shipped[ERROR],
                    "few": rk4.substeps,
                    "many": shipped.substeps,
                    "seen": cost_resolution,
                    "is_as_long": is_as_long,
                },
            ),
            Claim(
                "rk4_with_stiff_pads",
                better,
                {
                    "few": coarse[ERROR],
                    "shipped": fine[ERROR],
                    "count": coarse.substeps,
                    "many": fine.substeps,
                },
            ),
            Claim(
                "reference_converged",
                at_least(margin, 10.0, "well below the errors measured with it"),
                {"worst": worst, "least": least, "margin": margin},
            ),
            Claim(
                "solver_effort",
                effort,
                {"change": share, "count": count, "tried": tried},
            ),
            _crossover(results, points),
        ],
    )


def _crossover(results: Results, points: Points) -> Claim:
    """Test whether C is faster with one world, and Warp with many."""
    rows = points.worlds
    if not rows or rows[0].worlds.value != 1:
        names = ("advantage", "engine", "crossover", "gain", "most")
        untimed = Outcome("unknown", "one world was not timed")
        return Claim("crossover", untimed, dict.fromkeys(names, ""))
    second = constant(1e3, "ms·world-s/s²")  # of one world, in ms per s
    # The speed of C is taken from its comparisons with each number of worlds, because a
    # core may have another clock rate in a run by itself.
    paces = (second * row.time_ratio / row.ms_per_s for row in rows)
    core = results.value(
        "one_core_rate",
        "simulated seconds of one world per second, MuJoCo C on one core, median of all"
        " comparisons",
        gathered(np.median, paces),
    )
    rates = [
        results.value(
            f"rate_{row.case}",
            "simulated seconds of all worlds together per second",
            second * row.worlds / row.ms_per_s,
        )
        for row in rows
    ]
    pairs = zip(rows, rates, strict=True)
    crossover = results.value(
        "crossover_worlds",
        "smallest number of worlds with which Warp is as fast as C, interpolated"
        " logarithmically between measured numbers",
        _crossing,
        core,
        *(cell for row, rate in pairs for cell in (row.worlds, rate)),
    )
    lead = results.value(
        "one_core_advantage",
        "speed of C on one core divided by the speed of Warp with one world",
        core / rates[0],
    )
    gain = results.value(
        "worlds_gain",
        "speed of Warp with the most worlds divided by the speed of C on one core",
        rates[-1] / core,
    )
    is_ahead = [
        None not in (rate.value, core.value) and rate.value >= core.value
        for rate in rates
    ]
    outcome = all_of(
        greater(core, rates[0]),
        greater(rates[-1], core),
        contiguous(is_ahead, *rates, core),
    )
    return Claim(
        "crossover",
        outcome,
        {
            "advantage": lead,
            "engine": runs.ENGINES[rows[0].backend],
            # There is no crossover if one engine is always faster.
            "crossover": "" if crossover.value is None else crossover,
            "gain": gain,
            "most": rows[-1].worlds,
        },
    )


def _crossing(level: float, *cells: float) -> float:
    """Return the number of worlds at which the rates first reach ``level``, or NaN.

    The cells alternate between numbers of worlds and rates.
    """
    worlds = cells[::2]
    rates = cells[1::2]
    is_reached = [rate >= level for rate in rates]
    if True not in is_reached or is_reached[0] or min(rates) <= 0.0:
        return float("nan")
    first = is_reached.index(True)
    ends = slice(first - 1, first + 1)
    logs = np.interp(np.log(level), np.log(rates[ends]), np.log(worlds[ends]))
    return int(np.ceil(np.exp(logs) - 1e-9))
