"""What the points say of the knobs, and of what only the model changes."""

from collections.abc import Iterator

from experiments.facts.case import AS_SHIPPED
from measured_report.claims.claim import Claim, all_of, at_least, at_most, decided, greater, within
from measured_report.values.quantities import Quantity
from measured_report.values.results import Row
from report.sections.error_runtime.counting import counts, hit_iteration_limit
from report.sections.error_runtime.runs import ERROR, GRASP, PADS, SHIPPED, TIME, Points, named, with_shipped_steps
from report.shared.arithmetic import departure, difference, noise_floor, other_cell, ratio, share, size_difference


def knob_claims(points: Points) -> list[Claim]:
    return [
        _more_substeps(points),
        _solver_effort(points),
        _contact_source(points),
        _too_little(points),
        _pyramid(points),
    ]


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
    errors = [row[ERROR] for row in rows if counts(row) and _is_effort(row)]
    change = points.results.value(
        "effort_change",
        "largest change of the numerical error by iterations, line search or contacts in each substep, either way",
        lambda base, *error: max(abs(each - base) for each in error),
        *(points.cell(SHIPPED, ERROR), *errors),
        unit="mm",
    )
    return Claim("solver_effort", within(change, floor), {"change": change, "floor": floor})


def _is_effort(row: Row) -> bool:
    is_refresh = row.method == "newton-each-substep" and row.substeps.value == AS_SHIPPED.substeps
    return is_refresh or (row.method == "newton" and row.knob in ("iterations", "ls_iterations", "solver"))


def _contact_source(points: Points) -> Claim:
    """Tell whether Newton's contacts keep closer to C than those of MuJoCo Warp, from the shipped substeps on.

    How far Warp is from C is what is compared, so that the noise is that of identical runs.
    """
    worst, formula = (
        {},
        "largest distance from C with the same steps, {} contacts, from the shipped number of substeps on",
    )
    for method in ("newton", "mujoco"):
        rows = [row for row in points.ladder("as-shipped", method) if row.substeps.value >= AS_SHIPPED.substeps]
        formula = (
            f"largest distance from C with the same steps, {method} contacts, from the shipped number of substeps on"
        )
        cells = [row.c_difference_mm for row in rows]
        worst[method] = points.results.value(f"c_difference_{method}", formula, max, *cells, unit="mm")
    noise = noise_floor(points.results, "slip_floor")
    return Claim("contact_source", greater(worst["mujoco"], worst["newton"], noise=noise), worst)


def _too_little(points: Points) -> Claim:
    """Tell which settings fail."""
    failed = [row for row in points.settings if not counts(row)]
    lost = [row for row in failed if row[ERROR].value is None or not hit_iteration_limit(row)]
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
    soft, stiff = (_reference_cell(points, pads) for pads in PADS)
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


def _reference_cell(points: Points, pads: str) -> Quantity:
    row = points.reference(pads)
    return row[GRASP] if row else points.cell(f"{pads}/reference", GRASP)


def _rest_is_step_error(points: Points) -> Claim:
    """Tell whether what stays of the drift when nothing slides is what the step adds to the converged solution."""
    results, departures = points.results, []
    numbers: dict[str, Quantity] = {}
    frequency = other_cell(results, "reproduction", "as-shipped", "shake_frequency_hz", unit="Hz")
    for name, pads, case in (("shipped", "as-shipped", "as-shipped"), ("stiff", "stiff", "stiff-pads")):
        drift = other_cell(results, "contacts", f"{case}-term-restored", "drift_mm_s", unit="mm/s")
        formula = "drift with the left-out acceleration put back, in a cycle"
        rest = results.value(
            f"rest_{name}", formula, lambda drift, cycles: drift / cycles, drift, frequency, unit="mm/cycle"
        )
        formula = "grasp error in C with the shipped step, less that of the converged solution"
        shipped, converged = points.cell(with_shipped_steps(pads, "c"), GRASP), _reference_cell(points, pads)
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
    more = results.value("low_impratio_more", formula, lambda a, b: 100 * (a / b - 1), grasp, before, unit="%")
    outcome = greater(grasp, before, noise=points.floors[soft]).having_read(more)
    yield Claim("low_impratio", outcome, {"before": before, "grasp": grasp, "low": low, "more": more})


def _with_low_impratio(points: Points, pads: str) -> tuple[Quantity, Quantity, Quantity]:
    """Look up the grasp errors with a low impratio and as set, and how low it is."""
    low = f"{pads}/newton/impratio-1"
    before = points.cell(with_shipped_steps(pads, "newton"), GRASP)
    return points.cell(low, GRASP), before, points.cell(low, "impratio")


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
