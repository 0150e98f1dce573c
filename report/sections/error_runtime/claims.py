"""What the points say of engines, integrators, steps and knobs, of the model, and of the measurement."""

import math
from collections.abc import Iterator

from experiments.facts.case import AS_SHIPPED
from measured_report.claims.claim import Claim, Outcome, all_of, at_least, at_most, decided, greater, within
from measured_report.values.quantities import Quantity, Value
from report.sections.error_runtime.runs import (
    ENGINES,
    ERROR,
    GRASP,
    LABELS,
    PADS,
    SHIPPED,
    TIME,
    Points,
    counts,
    hit_iteration_limit,
    is_clamped,
    named,
    with_shipped_steps,
)
from report.shared.arithmetic import (
    departure,
    difference,
    excess,
    log_slope,
    noise_floor,
    other_cell,
    ratio,
    share,
    size_difference,
)
from report.shared.timing import widest

SHIPPED_C = with_shipped_steps("as-shipped", "c")


def accuracy_claims(points: Points) -> Iterator[Claim]:
    yield _c_is_cheapest(points)
    yield _rk4(points, "rk4", "c")
    yield _rk4(points, "rk4_warp", "newton")
    yield _rk4_with_stiff_pads(points)

    results, orders = points.results, {(pads, way): _order(points, pads, way) for pads in PADS for way in LABELS}
    observed = orders["as-shipped", "newton"]
    away = results.value("order_away", "distance of the observed order from one", lambda o: abs(o - 1), observed)
    yield Claim("first_order", at_most(away, 0.15, why="counts as one"), {"observed": observed})

    yield _reference_converged(points)
    floor, error = points.floors["as-shipped"], points.cell(SHIPPED, ERROR)
    yield Claim("single_precision", at_most(floor, error), {"floor": floor, "error": error})
    yield _clamped(points)


def _c_is_cheapest(points: Points) -> Claim:
    """Tell whether every point of the fronts over all engines is C's."""
    front = points.best(points.front)
    others = [row for row in front if row.backend != "mujoco-c"]
    warp, c = points.cell(SHIPPED, TIME), points.cell(SHIPPED_C, TIME)
    gain = ratio(points.results, "c_gain", "run time in Warp over that in C, settings as shipped", warp, c)
    compared = [row[column] for row in points.settings if row.case in points.backend_front for column in (ERROR, TIME)]
    edges = [points.cell(case, f"{TIME}_{edge}") for case in (SHIPPED, SHIPPED_C) for edge in ("p5", "p95")]
    formula = "largest of the ranges from the 5th to the 95th percentile of the run time"
    is_faster = greater(warp, c, noise=points.results.value("engine_time_range", formula, widest, *edges, unit="ms/s"))
    outcome = all_of(decided(not others, *compared), is_faster)
    if not front:
        outcome = Outcome("unknown", "no run counts").having_read(*compared)
    shipped = points.results.row.get(SHIPPED)
    numbers = {"c": c, "warp": warp, "gain": gain, "engine": ENGINES[shipped.backend] if shipped else "Warp"}
    return Claim("c_is_cheapest", outcome, numbers | {"others": named(others)})


def _rk4(points: Points, name: str, method: str) -> Claim:
    """Compare few steps of RK4 with the shipped steps of the shipped integrator, in one engine."""
    results, cases = points.results, (f"as-shipped/{method}-rk4/substeps-4", with_shipped_steps("as-shipped", method))
    error, before = (points.cell(case, ERROR) for case in cases)
    time, time_before = (points.cell(case, TIME) for case in cases)
    few, many = (points.cell(case, "substeps") for case in cases)
    gain = ratio(results, f"{name}_gain", "numerical error as shipped over that of RK4", before, error)
    cost = ratio(results, f"{name}_cost", "run time of RK4 over that as shipped", time, time_before)
    resolved = [greater(before, error, noise=points.floors["as-shipped"])] if method != "c" else []
    outcome = all_of(at_least(gain, 2.0, why="worth a change"), at_most(cost, 1.5, why="hardly dearer"), *resolved)
    return Claim(name, outcome, {"cost": cost, "error": error, "before": before, "few": few, "many": many})


def _rk4_with_stiff_pads(points: Points) -> Claim:
    coarse, with_steps = "stiff/c-rk4/substeps-4", with_shipped_steps("stiff", "c")
    few, shipped = points.cell(coarse, ERROR), points.cell(with_steps, ERROR)
    row = points.results.row.get(coarse)
    numbers = {"few": few, "shipped": shipped, "is_clamped": bool(row) and is_clamped(row)}
    numbers |= {"count": points.cell(coarse, "substeps"), "many": points.cell(with_steps, "substeps")}
    return Claim("rk4_with_stiff_pads", greater(few, shipped, noise=points.floors["stiff"]), numbers)


def _reference_converged(points: Points) -> Claim:
    results, references = points.results, [row[ERROR] for row in points.references]
    plotted = [row[ERROR] for row in points.settings if counts(row)]
    formula = "largest distance between a reference and the same with twice the step"
    worst = results.value("reference_error", formula, max, *references, unit="mm")
    formula = "smallest numerical error of a run that counts"
    least = results.value("least_error", formula, min, *plotted, unit="mm")
    margin = ratio(results, "reference_margin", "smallest error over the reference's own", least, worst)
    bound = results.chosen("reference_bound", "well below what is measured with it", 10.0)
    numbers = {"worst": worst, "least": least, "margin": margin, "bound": bound}
    return Claim("reference_converged", at_least(margin, bound), numbers)


def _order(points: Points, pads: str, method: str) -> Value:
    """Derive the order of convergence over the points whose model is the same, well above what Warp resolves."""
    floor = points.floors[pads].value or 0.0
    above = 5.0 * floor if method.startswith(("newton", "mujoco", "cpu")) else 0.0
    used = [
        row
        for row in points.ladder(pads, method)
        if counts(row) and not is_clamped(row) and (row.numerical_error_mm.value or 0.0) > above
    ]
    return points.results.value(
        f"order_{pads}_{method}",
        "slope of log error against log step, over the points that count, leave the timeconst alone and are above five "
        "times the floor of Warp",
        lambda *cells: log_slope(cells[::2], cells[1::2]) if len(cells) >= 4 else math.nan,
        *(quantity for row in used for quantity in (row.substep_ms, row.numerical_error_mm)),
    )


def _clamped(points: Points) -> Claim:
    """From how many substeps on the model stays the same: those of the scene are enough as shipped alone."""
    soft, stiff = (_least_substeps(points, pads) for pads in PADS)
    shipped = points.cell(SHIPPED, "substeps")
    outcome = all_of(at_most(soft, shipped), greater(stiff, shipped, noise=0, why="a count is exact"))
    return Claim("clamped", outcome, {"soft": soft, "stiff": stiff, "shipped": shipped})


def _least_substeps(points: Points, pads: str) -> Value:
    row = points.results.row.get(with_shipped_steps(pads, "newton"))
    cells = [row.timeconst_ms, row.substep_ms, row.substeps] if row else [points.cell(pads, "timeconst_ms")]
    formula = "least whole number of substeps of which two are no longer than the pads' timeconst"
    return points.results.value(f"least_substeps_{pads}", formula, lambda t, dt, n: int(-(-2 * dt * n // t)), *cells)


def knob_claims(points: Points) -> list[Claim]:
    found = (_more_substeps, _solver_effort, _contact_source, _too_little, _pyramid)
    return [claim(points) for claim in found]


def model_claims(points: Points) -> list[Claim]:
    return [*_pads_decide(points), _rest_is_step_error(points), *_impratio(points), _cone_not_left(points)]


def _more_substeps(points: Points) -> Claim:
    results, most, floor = points.results, points.ladder("as-shipped", "newton")[-1], points.floors["as-shipped"]
    error, before = most[ERROR], points.cell(SHIPPED, ERROR)
    formula = "numerical error as shipped over that with most substeps"
    gain = ratio(results, "substeps_gain", formula, before, error)
    cost = ratio(results, "substeps_cost", "run time over that as shipped", most[TIME], points.cell(SHIPPED, TIME))
    formula = "how many times less the error is, over how many times longer it takes"
    worth = ratio(results, "substeps_worth", formula, gain, cost)
    outcome = all_of(greater(before, error, noise=floor), at_least(worth, 0.8, why="what they cost, nearly"))
    numbers = {"count": most.substeps, "shipped": points.cell(SHIPPED, "substeps")}
    numbers |= {"cost": cost, "gain": gain, "error": error, "before": before}
    return Claim("more_substeps", outcome, numbers)


def _solver_effort(points: Points) -> Claim:
    """Compare with more or other solver effort than shipped, with contacts as shipped or anew in each substep."""
    floor, rows = points.floors["as-shipped"], [row for row in points.settings if row["pads"] == "as-shipped"]
    shipped = f"newton-each-substep/substeps-{AS_SHIPPED.substeps}"
    knobs = ("iterations", "ls_iterations", "solver")
    effort = [row for row in rows if row.case.endswith(shipped) or (row.method == "newton" and row.knob in knobs)]
    errors = [row[ERROR] for row in effort if counts(row)]
    change = points.results.value(
        "effort_change",
        "largest change of the numerical error by iterations, line search or contacts in each substep, either way",
        lambda base, *error: max(abs(each - base) for each in error),
        *(points.cell(SHIPPED, ERROR), *errors),
        unit="mm",
    )
    return Claim("solver_effort", within(change, floor), {"change": change, "floor": floor})


def _contact_source(points: Points) -> Claim:
    """Tell whether Newton's contacts keep closer to C than those of MuJoCo Warp, from the shipped substeps on.

    How far Warp is from C is what is compared, so that the noise is that of identical runs.
    """
    worst = {}
    for method in ("newton", "mujoco"):
        rows = [row for row in points.ladder("as-shipped", method) if row.substeps.value >= AS_SHIPPED.substeps]
        formula = "largest distance from C with the same steps, {} contacts, from the shipped number of substeps on"
        formula, cells = formula.format(method), [row.c_difference_mm for row in rows]
        worst[method] = points.results.value(f"c_difference_{method}", formula, max, *cells, unit="mm")
    noise = noise_floor(points.results, "slip_floor")
    return Claim("contact_source", greater(worst["mujoco"], worst["newton"], noise=noise), worst)


def _too_little(points: Points) -> Claim:
    """Tell which settings fail."""
    failed = [row for row in points.settings if not counts(row)]
    lost = [row for row in failed if not hit_iteration_limit(row)]
    twins = [points.results.row.get(row.case.replace("/c/", "/newton/")) for row in lost]
    measured = [row.iteration_peak_count for row in points.settings if row.iteration_peak_count.value is not None]
    kept = all(twin and twin not in lost and twin[ERROR].value is not None for twin in twins)
    return Claim("too_little", decided(bool(lost), *measured), {"lost": named(lost), "warp_keeps": kept})


def _pyramid(points: Points) -> Claim:
    time, before = points.cell("as-shipped/newton/cone-pyramidal", TIME), points.cell(SHIPPED, TIME)
    formula = "range from the 5th to the 95th percentile of the run time with the elliptic cone"
    low, high = (points.cell(SHIPPED, f"{TIME}_{edge}") for edge in ("p5", "p95"))
    spread = size_difference(points.results, "elliptic_spread", formula, low, high)
    return Claim("pyramid", greater(before, time, noise=spread), {"time": time, "before": before})


def _pads_decide(points: Points) -> Iterator[Claim]:
    """Tell whether the grasp error as shipped stays when the model is solved to the end and is far less with stiff
    pads, and whether coarse steps make it look less with these."""
    results, shipped = points.results, points.cell(SHIPPED, GRASP)
    soft, stiff = map(points.converged, PADS)
    formula = "converged grasp error, of that as shipped, shipped pads"
    stays = share(results, "pads_stays", formula, soft, shipped)
    gain = ratio(results, "pads_gain", "converged grasp error as shipped over that with stiff pads", soft, stiff)
    formula = "grasp error in C with the shipped step, as shipped over that with stiff pads"
    at_step = [points.cell(with_shipped_steps(pads, "c"), GRASP) for pads in PADS]
    ratio(results, "pads_gain_shipped_step", formula, *at_step)
    results.chosen("pads_gain_same", "the same gain", 1.0)
    outcome = all_of(
        at_least(stays, 80.0, why="nearly all of it"),
        at_least(gain, 5.0, why="an order of magnitude, nearly"),
        greater(soft, stiff, noise=points.floors["as-shipped"]),
    )
    yield Claim("pads_decide", outcome, {"shipped": shipped, "soft": soft, "stiff": stiff})

    coarse = points.cell(with_shipped_steps("stiff", "newton"), GRASP)
    outcome = greater(stiff, coarse, noise=points.floors["stiff"])
    yield Claim("coarse_steps_flatter", outcome, {"coarse": coarse, "converged": stiff})


def _rest_is_step_error(points: Points) -> Claim:
    """Tell whether what stays of the drift when nothing slides is what the step adds to the converged solution."""
    results, departures = points.results, []
    numbers: dict[str, Quantity] = {}
    frequency = other_cell(results, "reproduction", "as-shipped", "shake_frequency_hz", unit="Hz")
    for name, pads, case in (("shipped", "as-shipped", "as-shipped"), ("stiff", "stiff", "stiff-pads")):
        drift = other_cell(results, "contacts", f"{case}-term-restored", "drift_mm_s", unit="mm/s")
        formula, per_cycle = "drift with the left-out acceleration put back, in a cycle", (drift, frequency)
        rest = results.value(f"rest_{name}", formula, lambda drift, hz: drift / hz, *per_cycle, unit="mm/cycle")
        formula = "grasp error in C with the shipped step, less that of the converged solution"
        shipped, converged = points.cell(with_shipped_steps(pads, "c"), GRASP), points.converged(pads)
        step = difference(results, f"step_part_{name}", formula, shipped, converged)
        formula = "size of the difference between the two, of the motion that stays"
        departures.append(departure(results, f"rest_departure_{name}", formula, step, rest))
        numbers |= {f"rest_{name}": rest, f"step_{name}": step}
    largest = results.value("rest_departure", "larger of both departures", max, *departures, unit="%")
    return Claim("rest_is_step_error", at_most(largest, 25.0, why="the same motion"), numbers)


def _impratio(points: Points) -> Iterator[Claim]:
    """Tell whether the grasp drifts more with a low impratio than as set.

    First with the pads whose grasp is worth saving, or where these were not measured with those as shipped; then with
    shipped pads in any case.
    """
    results, (soft, stiff) = points.results, PADS
    pads = stiff if f"{stiff}/newton/impratio-1" in results.row else soft
    grasp, before, low = _with_low_impratio(points, pads)
    times = ratio(results, "impratio_gain", "grasp error with the low impratio over that as set", grasp, before)
    numbers = {"pads": PADS[pads], "low": low, "grasp": grasp, "before": before, "times": times}
    yield Claim("impratio", greater(grasp, before, noise=points.floors[pads]), numbers)

    grasp, before, low = _with_low_impratio(points, soft)
    formula = "grasp error with the low impratio over that as set, less one, shipped pads"
    more = excess(results, "low_impratio_more", formula, grasp, before)
    outcome = greater(grasp, before, noise=points.floors[soft]).having_read(more)
    yield Claim("low_impratio", outcome, {"before": before, "grasp": grasp, "low": low, "more": more})


def _with_low_impratio(points: Points, pads: str) -> tuple[Quantity, Quantity, Quantity]:
    """Look up the grasp errors with a low impratio and as set, and how low it is."""
    low, shipped = f"{pads}/newton/impratio-1", with_shipped_steps(pads, "newton")
    return points.cell(low, GRASP), points.cell(shipped, GRASP), points.cell(low, "impratio")


def _cone_not_left(points: Points) -> Claim:
    """Derive the margin of the friction cone with the shipped substeps and finer, and tell who came to its edge."""
    counted = [row for row in points.settings if counts(row)]
    at_edge = [row for row in counted if (row.cone_use_max.value or 0.0) >= 1.0]
    margin = points.results.value(
        "cone_margin",
        "one less the largest share of the friction cone that a contact used, shipped substeps and finer, in percent",
        lambda *use: 100 * (1 - max(use)),
        *(row.cone_use_max for row in counted if row.substeps.value >= AS_SHIPPED.substeps),
        unit="%",
    )
    outcome = at_least(margin, 10.0, why="a clear margin")
    return Claim("cone_not_left", outcome, {"margin": margin, "edge": named(at_edge)})
