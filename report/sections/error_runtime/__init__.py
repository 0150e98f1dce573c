"""Error against run time: the cheapest setting for an error, and what the expensive knobs buy."""

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
    gathered,
    greater,
    largest_size,
    quantile,
    resolved,
    within,
)

order = 155
page = "error"
first = True
label = "error and run time"
labels = {
    "as-shipped/newton/iterations-1": "shipped pads, Newton's contacts, 1 iteration",
    "as-shipped/newton/iterations-#": "shipped pads, Newton's contacts, {} iterations",
    "stiff/newton/iterations-#": "stiff pads, Newton's contacts, {} iterations",
    "as-shipped/newton/solver-cg": "shipped pads, Newton's contacts, conjugate gradients",
    "stiff/newton/solver-cg": "stiff pads, Newton's contacts, conjugate gradients",
}


def derive(results: Results) -> Section:
    points = runs.points_of(results)
    rk4 = _rk4_in_warp(points)
    tests = [_pads_decide(points), rk4, _rk4_with_stiff_pads(points)]
    tests += [_reference_converged(points), _solver_effort(points), _crossover(points)]
    errors = [row[ERROR] for row in points.settings]
    numerical = Figure(
        lambda: draw_numerical(points), errors, {"rk4_warp": rk4.outcome == HOLDS}
    )
    return Section(figures={"numerical": numerical}, claims=tests)


def _pads_decide(points: Points) -> Claim:
    """Tell whether shipped pads keep their grasp error where the model is solved to the end; stiff pads have less."""
    results, shipped = points.results, points[SHIPPED][GRASP]
    soft, stiff = map(points.converged, runs.PADS)
    stays = results.value(
        "pads_stays",
        "converged grasp error, of that as shipped, shipped pads",
        PERCENT * soft / shipped,
    )
    gain = results.value(
        "pads_gain",
        "converged grasp error as shipped over that with stiff pads",
        soft / stiff,
    )
    formula, floor = (
        "largest distance between Warp and C, as if one cycle made it",
        points.floors["as-shipped"],
    )
    seen = results.value(
        "pads_seen", formula, floor / constant(1, "cycle"), is_noise=True
    )
    tests = [at_least(stays, 80.0, why="nearly all of it")]
    outcome = all_of(
        *tests,
        at_least(gain, 5.0, why="an order of magnitude, nearly"),
        greater(soft, stiff, noise=seen),
    )
    return Claim(
        "pads_decide", outcome, {"shipped": shipped, "soft": soft, "stiff": stiff}
    )


def _rk4_in_warp(points: Points) -> Claim:
    results, cases = points.results, ("as-shipped/newton-rk4/substeps-2", SHIPPED)
    error, before = (points[case][ERROR] for case in cases)
    time, time_before = (
        points[case].time_ratio for case in cases
    )  # medians are of their own rounds
    few, many = (points[case].substeps for case in cases)
    doubled = results.value(
        "rk4_warp_doubled", "twice the numerical error of RK4", 2 * error
    )
    cost = results.value(
        "rk4_warp_cost",
        "run time of RK4 over that as shipped, by what both take of the shipped settings in Warp, timed in turn",
        time / time_before,
    )
    both = PERCENT * combined(
        math.hypot, *(points[case].ratio_resolution for case in cases)
    )
    seen = results.value(
        "rk4_warp_cost_seen",
        "to within what share the ratio of these run times is known, by the resolutions of both together",
        both,
        is_noise=True,
    )
    is_as_long = (
        None not in (cost.value, seen.value)
        and abs(cost.value - 1) <= 0.01 * seen.value
    )
    pays = greater(
        before, doubled, noise=points.floors["as-shipped"], why="worth a change"
    )
    outcome = all_of(pays, at_most(cost, 1.5, why="hardly dearer"))
    numbers = {"cost": cost, "error": error, "before": before, "few": few, "many": many}
    return Claim(
        "rk4_warp",
        outcome.having_read(seen),
        numbers | {"seen": seen, "is_as_long": is_as_long},
    )


def _rk4_with_stiff_pads(points: Points) -> Claim:
    coarse, with_steps = "stiff/c-rk4/substeps-4", runs.with_shipped_steps("stiff", "c")
    few, shipped = points[coarse][ERROR], points[with_steps][ERROR]
    numbers = {
        "few": few,
        "shipped": shipped,
        "count": points[coarse].substeps,
        "many": points[with_steps].substeps,
    }
    return Claim(
        "rk4_with_stiff_pads",
        greater(few, shipped, noise=points.floors["stiff"]),
        numbers,
    )


def _reference_converged(points: Points) -> Claim:
    results, references = points.results, [row[ERROR] for row in points.references]
    plotted = [row[ERROR] for row in points.settings if runs.counts(row)]
    worst = results.value(
        "reference_error",
        "largest distance between a reference and the same with twice the step",
        combined(max, *references),
    )
    least = results.value(
        "low_error",
        "numerical error that nine in ten runs that count exceed",
        combined(partial(quantile, 0.1), *plotted),
    )
    margin = results.value(
        "reference_margin", "this error over the reference's own", least / worst
    )
    bound = results.chosen(
        "reference_bound", "well below what is measured with it", 10.0
    )
    return Claim(
        "reference_converged",
        at_least(margin, bound),
        {"worst": worst, "least": least, "margin": margin},
    )


def _solver_effort(points: Points) -> Claim:
    """Compare solver, iterations and line search with those shipped, and contacts made anew in each substep."""
    floor, rows = (
        points.floors["as-shipped"],
        [row for row in points.settings if row["pads"] == "as-shipped"],
    )
    mine = [
        row
        for row in rows
        if row.method == "newton"
        and row.knob in ("iterations", "ls_iterations", "solver")
    ]
    mine += [
        row
        for row in rows
        if row.case.endswith(f"newton-each-substep/substeps-{AS_SHIPPED.substeps}")
    ]
    errors = [
        row[ERROR]
        for row in mine
        if runs.holds_cube(row) and not runs.uses_all_iterations(row)
    ]
    base = points[SHIPPED][ERROR]
    change = points.results.value(
        "effort_change",
        "largest change of the numerical error by solver, iterations, line search or contacts in each substep",
        largest_size(base - error for error in errors),
    )
    count = points.results.value(
        "effort_count",
        "runs with other solver effort that hold the cube and converge",
        cell_count(errors),
    )
    cells = [row.substeps for row in mine]
    tried = points.results.value(
        "effort_tried", "runs with other solver effort", cell_count(cells)
    )
    outcome = all_of(within(change, floor), resolved(floor, base))
    return Claim(
        "solver_effort",
        outcome,
        {"change": change, "floor": floor, "count": count, "tried": tried},
    )


def _crossover(points: Points) -> Claim:
    results, rows = points.results, points.worlds
    if not rows or rows[0].worlds.value != 1:
        lost = Outcome("unknown", "one world was not timed")
        return Claim(
            "crossover",
            lost,
            dict.fromkeys(("advantage", "engine", "crossover", "gain", "most"), ""),
        )
    # From the times that it took in turn with each number of worlds: alone a core may run at another pace.
    second = constant(1e3, "ms·world-s/s²")  # of one world, in ms per s
    median = gathered(
        np.median, (second * row.time_ratio / row.ms_per_s for row in rows)
    )
    core = results.value(
        "one_core_rate",
        "simulated seconds of one world per second, MuJoCo C on one core, median of all comparisons",
        median,
    )
    rates = [
        results.value(
            f"rate_{row.case}",
            "simulated seconds of all worlds together per second",
            second * row.worlds / row.ms_per_s,
        )
        for row in rows
    ]
    pairs = [
        quantity
        for row, rate in zip(rows, rates, strict=True)
        for quantity in (row.worlds, rate)
    ]
    crossover = results.value(
        "crossover_worlds",
        "least number of worlds with which Warp is as fast as C, interpolated in logarithms between measured ones",
        _crossing,
        core,
        *pairs,
    )
    engine = runs.ENGINES[rows[0].backend]
    first, last = rates[0], rates[-1]
    lead = results.value(
        "one_core_advantage",
        "speed of C on one core over that of Warp with one world",
        core / first,
    )
    gain = results.value(
        "worlds_gain",
        "speed of Warp with the most worlds over that of C on one core",
        last / core,
    )
    is_ahead = [
        None not in (rate.value, core.value) and rate.value >= core.value
        for rate in rates
    ]
    ends = greater(core, first), greater(last, core)
    outcome = all_of(*ends, contiguous(is_ahead, *rates, core))
    at = (
        "" if crossover.value is None else crossover
    )  # which is nowhere where one engine is ahead throughout
    numbers = {"advantage": lead, "engine": engine, "crossover": at, "gain": gain}
    return Claim("crossover", outcome, numbers | {"most": points.worlds[-1].worlds})


def _crossing(level: float, *cells: float) -> float:
    """Find the worlds with which a rising line first reaches ``level``; NaN when it does not, or starts above it."""
    worlds, rates = cells[::2], cells[1::2]
    above = [rate >= level for rate in rates]
    if True not in above or above[0] or min(rates) <= 0.0:
        return float("nan")
    after = above.index(True)
    pair = slice(after - 1, after + 1)
    return int(
        np.ceil(
            np.exp(np.interp(np.log(level), np.log(rates[pair]), np.log(worlds[pair])))
            - 1e-9
        )
    )
