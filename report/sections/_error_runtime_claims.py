"""What the points say: how exact they are, what the knobs buy, and what only the model changes."""

from collections.abc import Mapping, Sequence

from markupsafe import Markup

from report.claims import FAILS, HOLDS, Claim, Outcome, at_least, at_most, greater
from report.quantities import Quantity, Value
from report.results import Row
from report.sections._common import all_of
from report.sections._error_runtime import ENGINES, LABELS, PADS, SHIPPED_SUBSTEPS, Points, is_clamped
from report.sections._timing import ratio

SHIPPED = "as-shipped/newton/substeps-16"
SHIPPED_C = "as-shipped/c/substeps-16"
ERROR, GRASP, TIME = "numerical_error_mm", "grasp_error_mm_per_cycle", "ms_per_s"


def accuracy_claims(points: Points, orders: Mapping[tuple[str, str], Value]) -> list[Claim]:
    return [
        _c_is_cheapest(points),
        _rk4(points, "rk4", "c", "MuJoCo C", "The knob that pays is the integrator: in"),
        _rk4(points, "rk4_warp", "newton", "Warp", "In"),
        _rk4_with_stiff_pads(points),
        _first_order(points, orders["as-shipped", "newton"]),
        _reference_converged(points),
        _single_precision(points),
        _clamped(points),
    ]


def knob_claims(points: Points) -> list[Claim]:
    return [
        _more_substeps(points),
        _solver_effort(points),
        _contact_source(points),
        _too_little(points),
        _pyramid(points),
    ]


def model_claims(points: Points) -> list[Claim]:
    return [_pads_decide(points), _coarse_steps_flatter(points), _impratio(points), _cone_not_left(points)]


def _ratio(points: Points, name: str, above: Quantity, below: Quantity, what: str) -> Value:
    return ratio(points.results, name, what, above, below)


def _c_is_cheapest(points: Points) -> Claim:
    """Whether every point of the fronts over all engines is C's."""
    front = [row for row in points.settings if row.on_front]
    others = [row for row in front if row.backend != "mujoco-c"]
    warp, c = points.cell(SHIPPED, TIME), points.cell(SHIPPED_C, TIME)
    gain = _ratio(points, "c_gain", warp, c, "run time in Warp over that in C, settings as shipped")
    known = at_most(c, c) if front else Outcome("unknown", "no run counts")
    return Claim(
        "c_is_cheapest",
        known if known.name == "unknown" else (FAILS if others else HOLDS),
        holds="For a single world MuJoCo C on one core is the cheapest at every error: with the settings as shipped it "
        "takes {c}, milliseconds of run time per simulated second, and {engine} {warp}, {gain} times as much.",
        fails="For a single world MuJoCo C on one core is not always the cheapest; there are also {others}. With the "
        "settings as shipped it takes {c}, milliseconds of run time per simulated second, and {engine} {warp}.",
        unknown="Which engine is the cheapest for a single world cannot be told.",
        numbers={"c": c, "warp": warp, "gain": gain, "engine": _engine(points), "others": _named(others)},
    )


def _engine(points: Points) -> str:
    row = points.results.row.get(SHIPPED)
    return ENGINES[row.backend] if row else "Warp"


def _named(rows: Sequence[Row]) -> Markup:
    """Which settings, in words, without saying of the pads."""
    by_method: dict[str, dict[Markup, None]] = {}
    for row in rows:
        knob = Markup("<code>{}={}</code>").format(row.knob, row[row.knob])
        by_method.setdefault(row.method, {})[knob] = None
    phrases = (
        Markup("{} with {}").format(LABELS[method], Markup(", ").join(knobs)) for method, knobs in by_method.items()
    )
    return Markup("; ").join(phrases)


def _rk4(points: Points, name: str, method: str, engine: str, opening: str) -> Claim:
    """Few steps of RK4 against the shipped steps of the shipped integrator, in one engine."""
    coarse, shipped = f"as-shipped/{method}-rk4/substeps-4", f"as-shipped/{method}/substeps-16"
    error, before = points.cell(coarse, ERROR), points.cell(shipped, ERROR)
    time, time_before = points.cell(coarse, TIME), points.cell(shipped, TIME)
    gain = _ratio(points, f"{name}_gain", before, error, "numerical error as shipped over that of RK4")
    cost = _ratio(points, f"{name}_cost", time, time_before, "run time of RK4 over that as shipped")
    enough = points.results.value(f"{name}_bound", "chosen: worth a change", lambda: 2.0)
    dear = points.results.value(f"{name}_cost_bound", "chosen: hardly dearer", lambda: 1.5)
    numbers = {"engine": engine, "gain": gain, "cost": cost, "error": error, "before": before}
    numbers |= {"few": points.cell(coarse, "substeps"), "many": points.cell(shipped, "substeps")}
    return Claim(
        name,
        all_of(at_least(gain, enough), at_most(cost, dear)),
        holds=opening + " {engine}, RK4 with {few} substeps a frame is {error} from the "
        "converged solution, the shipped integrator with {many} is {before}, and RK4 takes {cost} times as long.",
        fails="In {engine}, RK4 with {few} substeps a frame is no bargain: {error} from the converged solution against "
        "{before} for the shipped integrator with {many}, at {cost} times its run time.",
        unknown="What RK4 buys in {engine} cannot be told.",
        numbers=numbers,
    )


def _rk4_with_stiff_pads(points: Points) -> Claim:
    few, shipped = points.cell("stiff/c-rk4/substeps-4", ERROR), points.cell("stiff/c/substeps-16", ERROR)
    return Claim(
        "rk4_with_stiff_pads",
        greater(few, shipped, noise=points.floors["stiff"]),
        holds="That is for the pads as shipped. With stiff pads, RK4 with {count} substeps is {few} away, the shipped "
        "integrator with its {many} only {shipped}.",
        fails="The same is true with stiff pads: {few} away against {shipped}.",
        unknown="Whether that is so with stiff pads as well cannot be told.",
        numbers={
            "few": few,
            "shipped": shipped,
            "count": points.cell("stiff/c-rk4/substeps-4", "substeps"),
            "many": points.cell("stiff/c/substeps-16", "substeps"),
        },
        explanation="Their timeconst is too short for so long a step, and MuJoCo raises it: the model is another one, "
        "whichever the integrator.",
    )


def _first_order(points: Points, observed: Value) -> Claim:
    away = points.results.value("order_away", "distance of the observed order from one", lambda o: abs(o - 1), observed)
    bound = points.results.value("order_bound", "chosen: counts as one", lambda: 0.15)
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
    margin = _ratio(points, "reference_margin", least, worst, "smallest error over the reference's own")
    bound = points.results.value("reference_bound", "chosen: well below what is measured with it", lambda: 10.0)
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
        greater(least["stiff"], shipped, noise=points.results.value("no_noise", "chosen: a count is exact", lambda: 0)),
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
    row = points.results.row.get(f"{pads}/newton/substeps-16")
    cells = [row.timeconst_ms, row.substep_ms, row.substeps] if row else [points.cell(pads, "timeconst_ms")]
    return points.results.value(
        f"least_substeps_{pads}",
        "least whole number of substeps of which two are no longer than the pads' timeconst",
        lambda timeconst, step, count: int(-(-2 * step * count // timeconst)),
        *cells,
    )


def _more_substeps(points: Points) -> Claim:
    most = points.ladder("as-shipped", "newton")[-1]
    error, before = most[ERROR], points.cell(SHIPPED, ERROR)
    gain = _ratio(points, "substeps_gain", before, error, "numerical error as shipped over that with most substeps")
    cost = _ratio(points, "substeps_cost", most[TIME], points.cell(SHIPPED, TIME), "run time over that as shipped")
    return Claim(
        "more_substeps",
        greater(before, error, noise=points.floors["as-shipped"]),
        holds="More substeps buy what they cost: {count} instead of {shipped} take {cost} times as long and bring the "
        "numerical error down {gain} times, to {error}.",
        fails="More substeps buy nothing: {count} instead of {shipped} take {cost} times as long and leave the "
        "numerical error at {error}.",
        unknown="What more substeps than {shipped} buy cannot be told.",
        numbers={
            "count": most.substeps,
            "shipped": points.cell(SHIPPED, "substeps"),
            "cost": cost,
            "gain": gain,
            "error": error,
        },
    )


def _solver_effort(points: Points) -> Claim:
    """More or other solver effort than shipped, with contacts as shipped or anew in each substep."""
    rows = [
        row
        for row in points.settings
        if row["pads"] == "as-shipped" and row.valid and (_is_solver_knob(row) or _is_refresh(row))
    ]
    change = points.results.value(
        "effort_change",
        "largest change of the numerical error by iterations, line search or contacts in each substep, either way",
        lambda base, *error: max(abs(each - base) for each in error),
        points.cell(SHIPPED, ERROR),
        *(row[ERROR] for row in rows),
        unit="mm",
    )
    return Claim(
        "solver_effort",
        at_most(change, points.floors["as-shipped"]),
        holds="More solver iterations, fewer line search iterations and contacts made anew in each substep buy "
        "nothing, as long as the run counts: they change the numerical error by at most {change}, and Warp itself is "
        "{floor} from C.",
        fails="Iterations, line search or contacts made anew in each substep make a difference: they change the "
        "numerical error by up to {change}, more than Warp is from C ({floor}).",
        unknown="What more solver effort buys cannot be told.",
        numbers={"change": change, "floor": points.floors["as-shipped"]},
    )


def _is_solver_knob(row: Row) -> bool:
    return row.method == "newton" and row.knob in ("iterations", "ls_iterations", "solver")


def _is_refresh(row: Row) -> bool:
    return row.method == "newton-each-substep" and row.substeps.value == SHIPPED_SUBSTEPS


def _contact_source(points: Points) -> Claim:
    """Whether the contacts of MuJoCo Warp keep as close to C as Newton's do, over all substeps."""
    worst = {}
    for method in ("newton", "mujoco"):
        rows = [row for row in points.ladder("as-shipped", method) if row.valid and not is_clamped(row)]
        worst[method] = points.results.value(
            f"c_difference_{method}",
            f"largest distance from C with the same steps, {method} contacts, timeconst as authored",
            lambda *distance: max(distance),
            *(row.c_difference_mm for row in rows),
            unit="mm",
        )
    return Claim(
        "contact_source",
        greater(worst["mujoco"], worst["newton"], noise=points.floors["as-shipped"]),
        holds="Contacts from Newton keep Warp closer to C than MuJoCo Warp's own: over all substeps at most {newton} "
        "away against {mujoco}.",
        fails="MuJoCo Warp's own contacts keep it closer to C than Newton's do: over all substeps at most {mujoco} "
        "away against {newton}.",
        unknown="Whose contacts keep Warp closer to C cannot be told: {newton} with Newton's, {mujoco} with its own.",
        numbers=worst,
    )


def _too_little(points: Points) -> Claim:
    """Which settings fail."""
    failed = [row for row in points.settings if not row.valid]
    lost = [row for row in failed if row[ERROR].value is None or "iterations" not in row.invalid_reason]
    return Claim(
        "too_little",
        HOLDS if lost else FAILS,
        holds="Too little of the solver loses the cube or the run: {lost}.",
        fails="No setting tried loses the cube or the run.",
        unknown="Which settings fail cannot be told.",
        numbers={"lost": _named(lost)},
    )


def _pyramid(points: Points) -> Claim:
    case = "as-shipped/newton/cone-pyramidal"
    time, before = points.cell(case, TIME), points.cell(SHIPPED, TIME)
    spread = points.results.value(
        "elliptic_spread",
        "range from the 5th to the 95th percentile of the run time with the elliptic cone",
        lambda low, high: high - low,
        points.cell(SHIPPED, f"{TIME}_p5"),
        points.cell(SHIPPED, f"{TIME}_p95"),
        unit="ms/s",
    )
    return Claim(
        "pyramid",
        greater(before, time, noise=spread),
        holds="The pyramidal cone is cheaper in Warp, {time} against {before}, at a grasp error of {grasp} against "
        "{grasp_before} with the elliptic one.",
        fails="The pyramidal cone is not cheaper in Warp: {time} against {before} with the elliptic one.",
        unknown="Whether the pyramidal cone is cheaper in Warp cannot be told: {time} against {before}.",
        numbers={
            "time": time,
            "before": before,
            "grasp": points.cell(case, GRASP),
            "grasp_before": points.cell(SHIPPED, GRASP),
        },
    )


def _pads_decide(points: Points) -> Claim:
    """Whether the converged grasp errors are further apart than settings move the one as shipped."""
    soft, stiff = (_reference_cell(points, pads) for pads in PADS)
    gain = _ratio(points, "pads_gain", soft, stiff, "converged grasp error as shipped over that with stiff pads")
    bound = points.results.value("pads_bound", "chosen: an order of magnitude, nearly", lambda: 5.0)
    return Claim(
        "pads_decide",
        at_least(gain, bound),
        holds="What the grasp loses in a cycle is a matter of the model and not of its solution: solved to the end, "
        "the scene as shipped still drifts by {soft}, with stiff pads by {stiff}.",
        fails="Solved to the end, the scene as shipped drifts by {soft} and with stiff pads by {stiff}: the pads make "
        "less than {bound} times the difference.",
        unknown="What the model converges to cannot be told.",
        numbers={"soft": soft, "stiff": stiff, "bound": bound},
    )


def _reference_cell(points: Points, pads: str) -> Quantity:
    row = points.reference(pads)
    return row[GRASP] if row else points.cell(f"{pads}/reference", GRASP)


def _coarse_steps_flatter(points: Points) -> Claim:
    coarse, converged = points.cell("stiff/newton/substeps-16", GRASP), _reference_cell(points, "stiff")
    return Claim(
        "coarse_steps_flatter",
        greater(converged, coarse, noise=points.floors["stiff"]),
        holds="A small grasp error can itself be an error: stiff pads with the substeps as shipped show {coarse}, "
        "their converged solution {converged}.",
        fails="With stiff pads the grasp error with the substeps as shipped, {coarse}, is no smaller than that of the "
        "converged solution, {converged}.",
        unknown="Whether coarse steps flatter the grasp with stiff pads cannot be told: {coarse} as shipped, "
        "{converged} converged.",
        numbers={"coarse": coarse, "converged": converged},
    )


def _impratio(points: Points) -> Claim:
    """With the pads whose grasp is worth saving; where these were not measured, with those as shipped."""
    pads = "stiff" if "stiff/newton/impratio-1" in points.results.row else "as-shipped"
    low, shipped = f"{pads}/newton/impratio-1", f"{pads}/newton/substeps-16"
    grasp, before = points.cell(low, GRASP), points.cell(shipped, GRASP)
    return Claim(
        "impratio",
        greater(grasp, before, noise=points.floors[pads]),
        holds="The impratio of the scene does buy grasp: with {pads} the cube drifts by {before}, with an impratio of "
        "{low} by {grasp}, at {time} of run time against {time_before}.",
        fails="The impratio of the scene does not buy grasp: with {pads} the cube drifts by {before}, with an "
        "impratio of {low} by {grasp}.",
        unknown="What impratio buys cannot be told.",
        numbers={
            "pads": PADS[pads],
            "low": points.cell(low, "impratio"),
            "grasp": grasp,
            "before": before,
            "time": points.cell(low, TIME),
            "time_before": points.cell(shipped, TIME),
        },
    )


def _cone_not_left(points: Points) -> Claim:
    """The margin of the friction cone with the shipped substeps and finer, and who came to its edge."""
    fine = [row for row in points.settings if row.valid and row.substeps.value >= SHIPPED_SUBSTEPS]
    at_edge = [row for row in points.settings if row.valid and (row.cone_use_max.value or 0.0) >= 1.0]
    margin = points.results.value(
        "cone_margin",
        "one less the largest share of the friction cone that a contact used, shipped substeps and finer, in percent",
        lambda *use: 100 * (1 - max(use)),
        *(row.cone_use_max for row in fine),
        unit="%",
    )
    bound = points.results.value("cone_bound", "chosen: a clear margin", lambda: 10.0, unit="%")
    return Claim(
        "cone_not_left",
        at_least(margin, bound),
        holds="No contact slides: with the shipped substeps and finer at least {margin} of the friction cone is left "
        "in "
        "every frame of every run that counts." + (" All of it is used by {edge}." if at_edge else ""),
        fails="Some contact comes near sliding: with the shipped substeps and finer as little as {margin} of the "
        "friction cone is left.",
        unknown="How near the contacts come to sliding cannot be told.",
        numbers={"margin": margin, "edge": _named(at_edge)},
    )
