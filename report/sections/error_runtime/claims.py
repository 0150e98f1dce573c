"""What the points say of engines, integrators and the steps they take, and how exact the measurement is."""

from collections.abc import Iterator, Mapping

from measured_report.claims.claim import Claim, Outcome, all_of, at_least, at_most, decided, greater
from measured_report.values.quantities import Value
from report.sections.error_runtime.counting import counts
from report.sections.error_runtime.runs import (
    ENGINES,
    ERROR,
    PADS,
    SHIPPED,
    TIME,
    Points,
    distinct,
    front_rows,
    is_clamped,
    named,
    time_range,
    with_shipped_steps,
)
from report.shared.arithmetic import ratio

SHIPPED_C = with_shipped_steps("as-shipped", "c")


def accuracy_claims(points: Points, orders: Mapping[tuple[str, str], Value]) -> Iterator[Claim]:
    yield _c_is_cheapest(points)
    yield _rk4(points, "rk4", "c")
    yield _rk4(points, "rk4_warp", "newton")
    yield _rk4_with_stiff_pads(points)

    results, observed = points.results, orders["as-shipped", "newton"]
    away = results.value("order_away", "distance of the observed order from one", lambda o: abs(o - 1), observed)
    yield Claim("first_order", at_most(away, 0.15, why="counts as one"), {"observed": observed})

    yield _reference_converged(points)
    floor, error = points.floors["as-shipped"], points.cell(SHIPPED, ERROR)
    yield Claim("single_precision", at_most(floor, error), {"floor": floor, "error": error})
    yield _clamped(points)


def _c_is_cheapest(points: Points) -> Claim:
    """Tell whether every point of the fronts over all engines is C's."""
    front = front_rows(points, points.front)
    others = [row for row in distinct(points, front) if row.backend != "mujoco-c"]
    warp, c = points.cell(SHIPPED, TIME), points.cell(SHIPPED_C, TIME)
    gain = ratio(points.results, "c_gain", "run time in Warp over that in C, settings as shipped", warp, c)
    compared = [row[column] for row in points.settings if row.case in points.backend_front for column in (ERROR, TIME)]
    is_faster = greater(warp, c, noise=time_range(points, "engine_time_range", SHIPPED, SHIPPED_C))
    outcome = all_of(decided(not others, *compared), is_faster)
    if not front:
        outcome = Outcome("unknown", "no run counts").having_read(*compared)
    shipped = points.results.row.get(SHIPPED)
    engine = ENGINES[shipped.backend] if shipped else "Warp"
    return Claim(
        "c_is_cheapest", outcome, {"c": c, "warp": warp, "gain": gain, "engine": engine, "others": named(others)}
    )


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
