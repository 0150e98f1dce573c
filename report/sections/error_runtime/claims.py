"""What the points say of engines, integrators and the steps they take, and how exact the measurement is."""

from collections.abc import Mapping

from measured_report.claims.claims import Claim, Outcome, all_of, at_least, at_most, decided, greater
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


def accuracy_claims(points: Points, orders: Mapping[tuple[str, str], Value]) -> list[Claim]:
    return [
        _c_is_cheapest(points),
        _rk4(points, "rk4", "c"),
        _rk4(points, "rk4_warp", "newton"),
        _rk4_with_stiff_pads(points),
        _first_order(points, orders["as-shipped", "newton"]),
        _reference_converged(points),
        _single_precision(points),
        _clamped(points),
    ]


def _c_is_cheapest(points: Points) -> Claim:
    """Whether every point of the fronts over all engines is C's."""
    front = front_rows(points, points.front)
    others = [row for row in distinct(points, front) if row.backend != "mujoco-c"]
    warp, c = points.cell(SHIPPED, TIME), points.cell(SHIPPED_C, TIME)
    gain = ratio(points.results, "c_gain", "run time in Warp over that in C, settings as shipped", warp, c)
    compared = [row[column] for row in points.settings if row.case in points.backend_front for column in (ERROR, TIME)]
    outcome = all_of(
        decided(not others, *compared),
        greater(warp, c, noise=time_range(points, "engine_time_range", SHIPPED, SHIPPED_C)),
    )
    if not front:
        outcome = Outcome("unknown", "no run counts").having_read(*compared)
    return Claim(
        "c_is_cheapest",
        outcome,
        numbers={"c": c, "warp": warp, "gain": gain, "engine": _engine(points), "others": named(others)},
    )


def _engine(points: Points) -> str:
    row = points.results.row.get(SHIPPED)
    return ENGINES[row.backend] if row else "Warp"


def _rk4(points: Points, name: str, method: str) -> Claim:
    """Few steps of RK4 against the shipped steps of the shipped integrator, in one engine."""
    coarse, shipped = f"as-shipped/{method}-rk4/substeps-4", with_shipped_steps("as-shipped", method)
    error, before = points.cell(coarse, ERROR), points.cell(shipped, ERROR)
    time, time_before = points.cell(coarse, TIME), points.cell(shipped, TIME)
    gain = ratio(points.results, f"{name}_gain", "numerical error as shipped over that of RK4", before, error)
    cost = ratio(points.results, f"{name}_cost", "run time of RK4 over that as shipped", time, time_before)
    enough = points.results.chosen(f"{name}_bound", "worth a change", 2.0)
    dear = points.results.chosen(f"{name}_cost_bound", "hardly dearer", 1.5)
    resolved = [greater(before, error, noise=points.floors["as-shipped"])] if method != "c" else []
    numbers = {"cost": cost, "error": error, "before": before}
    numbers |= {"few": points.cell(coarse, "substeps"), "many": points.cell(shipped, "substeps")}
    return Claim(name, all_of(at_least(gain, enough), at_most(cost, dear), *resolved), numbers=numbers)


def _rk4_with_stiff_pads(points: Points) -> Claim:
    coarse = "stiff/c-rk4/substeps-4"
    few, shipped = points.cell(coarse, ERROR), points.cell(with_shipped_steps("stiff", "c"), ERROR)
    row = points.results.row.get(coarse)
    return Claim(
        "rk4_with_stiff_pads",
        greater(few, shipped, noise=points.floors["stiff"]),
        numbers={
            "few": few,
            "shipped": shipped,
            "count": points.cell(coarse, "substeps"),
            "many": points.cell(with_shipped_steps("stiff", "c"), "substeps"),
            "is_clamped": bool(row) and is_clamped(row),
        },
    )


def _first_order(points: Points, observed: Value) -> Claim:
    away = points.results.value("order_away", "distance of the observed order from one", lambda o: abs(o - 1), observed)
    bound = points.results.chosen("order_bound", "counts as one", 0.15)
    return Claim("first_order", at_most(away, bound), numbers={"observed": observed})


def _reference_converged(points: Points) -> Claim:
    references = [row[ERROR] for row in points.references]
    plotted = [row[ERROR] for row in points.settings if counts(row)]
    worst = points.results.value(
        "reference_error",
        "largest distance between a reference and the same with twice the step",
        lambda *error: max(error),
        *references,
        unit="mm",
    )
    least = points.results.value(
        "least_error", "smallest numerical error of a run that counts", lambda *error: min(error), *plotted, unit="mm"
    )
    margin = ratio(points.results, "reference_margin", "smallest error over the reference's own", least, worst)
    bound = points.results.chosen("reference_bound", "well below what is measured with it", 10.0)
    return Claim(
        "reference_converged",
        at_least(margin, bound),
        numbers={"worst": worst, "least": least, "margin": margin, "bound": bound},
    )


def _single_precision(points: Points) -> Claim:
    floor, error = points.floors["as-shipped"], points.cell(SHIPPED, ERROR)
    return Claim("single_precision", at_most(floor, error), numbers={"floor": floor, "error": error})


def _clamped(points: Points) -> Claim:
    """From how many substeps on the model stays the same: those of the scene are enough as shipped alone."""
    least = {pads: _least_substeps(points, pads) for pads in PADS}
    shipped = points.cell(SHIPPED, "substeps")
    return Claim(
        "clamped",
        all_of(
            at_most(least["as-shipped"], shipped),
            greater(least["stiff"], shipped, noise=points.results.chosen("no_noise", "a count is exact", 0)),
        ),
        numbers={"soft": least["as-shipped"], "stiff": least["stiff"], "shipped": shipped},
    )


def _least_substeps(points: Points, pads: str) -> Value:
    row = points.results.row.get(with_shipped_steps(pads, "newton"))
    cells = [row.timeconst_ms, row.substep_ms, row.substeps] if row else [points.cell(pads, "timeconst_ms")]
    return points.results.value(
        f"least_substeps_{pads}",
        "least whole number of substeps of which two are no longer than the pads' timeconst",
        lambda timeconst, step, count: int(-(-2 * step * count // timeconst)),
        *cells,
    )
