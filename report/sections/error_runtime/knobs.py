"""What the points say of the knobs, and of what only the model changes."""

from experiments.facts.case import AS_SHIPPED
from measured_report.claims.claims import Claim, all_of, at_least, at_most, decided, greater, within
from measured_report.values.quantities import Quantity
from measured_report.values.results import Row
from report.sections.error_runtime.counting import counts, hit_iteration_limit
from report.sections.error_runtime.runs import ERROR, GRASP, PADS, SHIPPED, TIME, Points, named, with_shipped_steps
from report.shared.arithmetic import departure, difference, noise_floor, other_cell, ratio, share


def knob_claims(points: Points) -> list[Claim]:
    return [
        _more_substeps(points),
        _solver_effort(points),
        _contact_source(points),
        _too_little(points),
        _pyramid(points),
    ]


def model_claims(points: Points) -> list[Claim]:
    return [
        _pads_decide(points),
        _coarse_steps_flatter(points),
        _rest_is_step_error(points),
        _impratio(points),
        _low_impratio(points),
        _cone_not_left(points),
    ]


def _more_substeps(points: Points) -> Claim:
    most = points.ladder("as-shipped", "newton")[-1]
    error, before = most[ERROR], points.cell(SHIPPED, ERROR)
    gain = ratio(
        points.results, "substeps_gain", "numerical error as shipped over that with most substeps", before, error
    )
    cost = ratio(
        points.results, "substeps_cost", "run time over that as shipped", most[TIME], points.cell(SHIPPED, TIME)
    )
    formula = "how many times less the error is, over how many times longer it takes"
    worth = ratio(points.results, "substeps_worth", formula, gain, cost)
    nearly = points.results.chosen("substeps_worth_bound", "what they cost, nearly", 0.8)
    return Claim(
        "more_substeps",
        all_of(greater(before, error, noise=points.floors["as-shipped"]), at_least(worth, nearly)),
        numbers={
            "count": most.substeps,
            "shipped": points.cell(SHIPPED, "substeps"),
            "cost": cost,
            "gain": gain,
            "error": error,
            "before": before,
        },
    )


def _solver_effort(points: Points) -> Claim:
    """More or other solver effort than shipped, with contacts as shipped or anew in each substep."""
    rows = [
        row
        for row in points.settings
        if row["pads"] == "as-shipped" and counts(row) and (_is_solver_knob(row) or _is_refresh(row))
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
        within(change, points.floors["as-shipped"]),
        numbers={"change": change, "floor": points.floors["as-shipped"]},
    )


def _is_solver_knob(row: Row) -> bool:
    return row.method == "newton" and row.knob in ("iterations", "ls_iterations", "solver")


def _is_refresh(row: Row) -> bool:
    return row.method == "newton-each-substep" and row.substeps.value == AS_SHIPPED.substeps


def _contact_source(points: Points) -> Claim:
    """Whether Newton's contacts keep closer to C than those of MuJoCo Warp, from the shipped substeps on.

    How far Warp is from C is what is compared, so that the noise is that of identical runs.
    """
    worst = {}
    for method in ("newton", "mujoco"):
        rows = [row for row in points.ladder("as-shipped", method) if row.substeps.value >= AS_SHIPPED.substeps]
        worst[method] = points.results.value(
            f"c_difference_{method}",
            f"largest distance from C with the same steps, {method} contacts, from the shipped number of substeps on",
            lambda *distance: max(distance),
            *(row.c_difference_mm for row in rows),
            unit="mm",
        )
    return Claim(
        "contact_source",
        greater(worst["mujoco"], worst["newton"], noise=noise_floor(points.results, "slip_floor")),
        numbers=worst,
    )


def _too_little(points: Points) -> Claim:
    """Which settings fail."""
    failed = [row for row in points.settings if not counts(row)]
    lost = [row for row in failed if row[ERROR].value is None or not hit_iteration_limit(row)]
    twins = [points.results.row.get(row.case.replace("/c/", "/newton/")) for row in lost]
    measured = [row.iteration_peak_count for row in points.settings if row.iteration_peak_count.value is not None]
    kept = all(twin and twin not in lost and twin[ERROR].value is not None for twin in twins)
    return Claim("too_little", decided(bool(lost), *measured), numbers={"lost": named(lost), "warp_keeps": kept})


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
    return Claim("pyramid", greater(before, time, noise=spread), numbers={"time": time, "before": before})


def _pads_decide(points: Points) -> Claim:
    """Whether the grasp error as shipped stays when the model is solved to the end, and is far less with stiff pads."""
    shipped = points.cell(SHIPPED, GRASP)
    soft, stiff = (_reference_cell(points, pads) for pads in PADS)
    stays = share(
        points.results, "pads_stays", "converged grasp error, of that as shipped, shipped pads", soft, shipped
    )
    least = points.results.chosen("pads_stays_bound", "nearly all of it", 80.0, unit="%")
    gain = ratio(points.results, "pads_gain", "converged grasp error as shipped over that with stiff pads", soft, stiff)
    formula = "grasp error in C with the shipped step, as shipped over that with stiff pads"
    at_step = [points.cell(with_shipped_steps(pads, "c"), GRASP) for pads in PADS]
    ratio(points.results, "pads_gain_shipped_step", formula, *at_step)
    points.results.chosen("pads_gain_same", "the same gain", 1.0)
    bound = points.results.chosen("pads_bound", "an order of magnitude, nearly", 5.0)
    return Claim(
        "pads_decide",
        all_of(at_least(stays, least), at_least(gain, bound), greater(soft, stiff, noise=points.floors["as-shipped"])),
        numbers={"shipped": shipped, "soft": soft, "stiff": stiff},
    )


def _reference_cell(points: Points, pads: str) -> Quantity:
    row = points.reference(pads)
    return row[GRASP] if row else points.cell(f"{pads}/reference", GRASP)


def _coarse_steps_flatter(points: Points) -> Claim:
    coarse, converged = points.cell(with_shipped_steps("stiff", "newton"), GRASP), _reference_cell(points, "stiff")
    return Claim(
        "coarse_steps_flatter",
        greater(converged, coarse, noise=points.floors["stiff"]),
        numbers={"coarse": coarse, "converged": converged},
    )


def _rest_is_step_error(points: Points) -> Claim:
    """Whether what stays of the drift when nothing slides is what the shipped step adds to the converged solution."""
    results, departures = points.results, []
    numbers: dict[str, Quantity] = {}
    frequency = other_cell(results, "reproduction", "as-shipped", "shake_frequency_hz", unit="Hz")
    for name, pads, case in (("shipped", "as-shipped", "as-shipped"), ("stiff", "stiff", "stiff-pads")):
        rest = results.value(
            f"rest_{name}",
            "drift with the left-out acceleration put back, in a cycle",
            lambda drift, cycles: drift / cycles,
            other_cell(results, "contacts", f"{case}-term-restored", "drift_mm_s", unit="mm/s"),
            frequency,
            unit="mm/cycle",
        )
        formula = "grasp error in C with the shipped step, less that of the converged solution"
        shipped, converged = points.cell(with_shipped_steps(pads, "c"), GRASP), _reference_cell(points, pads)
        step = difference(results, f"step_part_{name}", formula, shipped, converged)
        formula = "size of the difference between the two, of the motion that stays"
        departures.append(departure(results, f"rest_departure_{name}", formula, step, rest))
        numbers |= {f"rest_{name}": rest, f"step_{name}": step}
    largest = results.value("rest_departure", "larger of both departures", max, *departures, unit="%")
    bound = results.chosen("rest_departure_bound", "the same motion", 25.0, unit="%")
    return Claim("rest_is_step_error", at_most(largest, bound), numbers=numbers)


def _impratio(points: Points) -> Claim:
    """With the pads whose grasp is worth saving; where these were not measured, with those as shipped."""
    pads = "stiff" if "stiff/newton/impratio-1" in points.results.row else "as-shipped"
    low, shipped = f"{pads}/newton/impratio-1", with_shipped_steps(pads, "newton")
    grasp, before = points.cell(low, GRASP), points.cell(shipped, GRASP)
    times = ratio(points.results, "impratio_gain", "grasp error with the low impratio over that as set", grasp, before)
    return Claim(
        "impratio",
        greater(grasp, before, noise=points.floors[pads]),
        numbers={
            "pads": PADS[pads],
            "low": points.cell(low, "impratio"),
            "grasp": grasp,
            "before": before,
            "times": times,
        },
    )


def _low_impratio(points: Points) -> Claim:
    """Whether with shipped pads, too, the grasp drifts more with a low impratio than as set."""
    low = "as-shipped/newton/impratio-1"
    grasp, before = points.cell(low, GRASP), points.cell(with_shipped_steps("as-shipped", "newton"), GRASP)
    formula = "grasp error with the low impratio over that as set, less one, shipped pads"
    more = points.results.value("low_impratio_more", formula, lambda a, b: 100 * (a / b - 1), grasp, before, unit="%")
    outcome = greater(grasp, before, noise=points.floors["as-shipped"]).having_read(more)
    return Claim(
        "low_impratio", outcome, {"before": before, "grasp": grasp, "low": points.cell(low, "impratio"), "more": more}
    )


def _cone_not_left(points: Points) -> Claim:
    """The margin of the friction cone with the shipped substeps and finer, and who came to its edge."""
    fine = [row for row in points.settings if counts(row) and row.substeps.value >= AS_SHIPPED.substeps]
    at_edge = [row for row in points.settings if counts(row) and (row.cone_use_max.value or 0.0) >= 1.0]
    margin = points.results.value(
        "cone_margin",
        "one less the largest share of the friction cone that a contact used, shipped substeps and finer, in percent",
        lambda *use: 100 * (1 - max(use)),
        *(row.cone_use_max for row in fine),
        unit="%",
    )
    bound = points.results.chosen("cone_bound", "a clear margin", 10.0, unit="%")
    return Claim("cone_not_left", at_least(margin, bound), numbers={"margin": margin, "edge": named(at_edge)})
