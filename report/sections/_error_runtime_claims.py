"""What the points say of engines, integrators and the steps they take, and how exact the measurement is."""

from collections.abc import Mapping

from report.claims import FAILS, HOLDS, Claim, Outcome, all_of, at_least, at_most, greater
from report.quantities import Value
from report.sections._common import ratio
from report.sections._error_runtime import (
    ENGINES,
    ERROR,
    PADS,
    SHIPPED,
    TIME,
    Points,
    distinct,
    front_of,
    named,
    with_shipped_steps,
)

SHIPPED_C = with_shipped_steps("as-shipped", "c")


def accuracy_claims(points: Points, orders: Mapping[tuple[str, str], Value]) -> list[Claim]:
    return [
        _c_is_cheapest(points),
        _rk4(points, "rk4", "c", "MuJoCo C", "With the pads as shipped, the knob that pays is the integrator: in"),
        _rk4(points, "rk4_warp", "newton", "Warp", "In"),
        _rk4_with_stiff_pads(points),
        _first_order(points, orders["as-shipped", "newton"]),
        _reference_converged(points),
        _single_precision(points),
        _clamped(points),
    ]


def _c_is_cheapest(points: Points) -> Claim:
    """Whether every point of the fronts over all engines is C's."""
    front = front_of(points, "on_front")
    others = [row for row in distinct(points, front) if row.backend != "mujoco-c"]
    warp, c = points.cell(SHIPPED, TIME), points.cell(SHIPPED_C, TIME)
    gain = ratio(points.results, "c_gain", "run time in Warp over that in C, settings as shipped", warp, c)
    outcome = FAILS if others else HOLDS
    if not front:
        outcome = Outcome("unknown", "no run counts")
    return Claim(
        "c_is_cheapest",
        outcome,
        holds="For a single world MuJoCo C on one core is the cheapest at every error: with the settings as shipped it "
        "takes {c}, milliseconds of run time per simulated second, and {engine} {warp}, {gain} times as much. That is "
        "the engine's own loop against whole frames, with targets and inverse kinematics.",
        fails="For a single world MuJoCo C on one core is not always the cheapest; there are also {others}. With the "
        "settings as shipped it takes {c}, milliseconds of run time per simulated second, and {engine} {warp}.",
        unknown="Which engine is the cheapest for a single world cannot be told.",
        numbers={"c": c, "warp": warp, "gain": gain, "engine": _engine(points), "others": named(others)},
    )


def _engine(points: Points) -> str:
    row = points.results.row.get(SHIPPED)
    return ENGINES[row.backend] if row else "Warp"


def _rk4(points: Points, name: str, method: str, engine: str, opening: str) -> Claim:
    """Few steps of RK4 against the shipped steps of the shipped integrator, in one engine."""
    coarse, shipped = f"as-shipped/{method}-rk4/substeps-4", with_shipped_steps("as-shipped", method)
    error, before = points.cell(coarse, ERROR), points.cell(shipped, ERROR)
    time, time_before = points.cell(coarse, TIME), points.cell(shipped, TIME)
    gain = ratio(points.results, f"{name}_gain", "numerical error as shipped over that of RK4", before, error)
    cost = ratio(points.results, f"{name}_cost", "run time of RK4 over that as shipped", time, time_before)
    enough = points.results.chosen(f"{name}_bound", "worth a change", 2.0)
    dear = points.results.chosen(f"{name}_cost_bound", "hardly dearer", 1.5)
    numbers = {"engine": engine, "cost": cost, "error": error, "before": before}
    numbers |= {"few": points.cell(coarse, "substeps"), "many": points.cell(shipped, "substeps")}
    return Claim(
        name,
        all_of(at_least(gain, enough), at_most(cost, dear)),
        holds=opening + " {engine}, RK4 with {few} substeps a frame is {error} from the converged solution, the "
        "shipped integrator with {many} is {before}, and RK4 takes {cost} times as long.",
        fails="In {engine}, RK4 with {few} substeps a frame is no bargain: {error} from the converged solution against "
        "{before} for the shipped integrator with {many}, at {cost} times its run time.",
        unknown="What RK4 buys in {engine} cannot be told.",
        numbers=numbers,
    )


def _rk4_with_stiff_pads(points: Points) -> Claim:
    few, shipped = points.cell("stiff/c-rk4/substeps-4", ERROR), points.cell(with_shipped_steps("stiff", "c"), ERROR)
    return Claim(
        "rk4_with_stiff_pads",
        greater(few, shipped, noise=points.floors["stiff"]),
        holds="With stiff pads it does not pay: in MuJoCo C, RK4 with {count} substeps is {few} away, the shipped "
        "integrator with its {many} only {shipped}.",
        fails="The same is true with stiff pads in MuJoCo C: {few} away against {shipped}.",
        unknown="Whether that is so with stiff pads as well cannot be told.",
        numbers={
            "few": few,
            "shipped": shipped,
            "count": points.cell("stiff/c-rk4/substeps-4", "substeps"),
            "many": points.cell(with_shipped_steps("stiff", "c"), "substeps"),
        },
        explanation="Their timeconst is too short for so long a step, and MuJoCo raises it: the model is another one, "
        "whichever the integrator.",
    )


def _first_order(points: Points, observed: Value) -> Claim:
    away = points.results.value("order_away", "distance of the observed order from one", lambda o: abs(o - 1), observed)
    bound = points.results.chosen("order_bound", "counts as one", 0.15)
    return Claim(
        "first_order",
        at_most(away, bound),
        holds="With the shipped integrator half the step is half the error: the observed order is {observed}.",
        fails="With the shipped integrator the error does not just halve with the step: the observed order is "
        "{observed}.",
        unknown="How the error falls with the step cannot be told.",
        numbers={"observed": observed},
    )


def _reference_converged(points: Points) -> Claim:
    references = [row[ERROR] for row in points.references]
    plotted = [row[ERROR] for row in points.settings if row.valid]
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
        holds="Half the step moves a reference by no more than {worst}; the smallest error measured is {least}, "
        "{margin} times as much.",
        fails="Half the step moves a reference by up to {worst}, while the smallest error measured is {least}: errors "
        "below {bound} times the former say little.",
        unknown="How far the references have converged cannot be told.",
        numbers={"worst": worst, "least": least, "margin": margin, "bound": bound},
    )


def _single_precision(points: Points) -> Claim:
    floor, error = points.floors["as-shipped"], points.cell(SHIPPED, ERROR)
    return Claim(
        "single_precision",
        at_most(floor, error),
        holds="Single precision is not what limits: Warp is within {floor} of C with the same steps, and with the "
        "settings as shipped it is {error} from the converged solution.",
        fails="Warp and C with the same steps are up to {floor} apart, more than the numerical error with the settings "
        "as shipped, {error}.",
        unknown="What single precision costs cannot be told.",
        numbers={"floor": floor, "error": error},
    )


def _clamped(points: Points) -> Claim:
    """From how many substeps on the model stays the same."""
    least = {pads: _least_substeps(points, pads) for pads in PADS}
    shipped = points.cell(SHIPPED, "substeps")
    return Claim(
        "clamped",
        greater(least["stiff"], shipped, noise=points.results.chosen("no_noise", "a count is exact", 0)),
        holds="Too few substeps change the model itself: MuJoCo does not let a contact respond faster than two "
        "substeps. As shipped that takes {soft} substeps a frame, with stiff pads {stiff}, more than the {shipped} of "
        "the scene.",
        fails="Too few substeps change the model itself: MuJoCo does not let a contact respond faster than two "
        "substeps. As shipped that takes {soft} substeps a frame, with stiff pads {stiff}; the {shipped} of the scene "
        "are enough.",
        unknown="From how many substeps on the model stays the same cannot be told.",
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
