"""Compare the slips with other solver settings: iterations, impratio, step and noslip."""

from report.shared import (
    PERCENT,
    SLIP_BOUND,
    Claim,
    Results,
    Section,
    at_least,
    at_most,
    change_of,
    largest_size,
    negligible,
    relevance,
    variants_claim,
)

order = 50
folded = True
reads = ("reproduction",)
label = "solver and time step"
labels = {
    "iterations-15": "shipped settings",
    "iterations-#": "{} iterations",
    "tolerance-#": "tolerance {}",
    "cone-pyramidal": "pyramidal cone",
    "as-shipped-warp-noslip": "shipped pads, MuJoCo Warp, noslip",
    "stiff-pads-warp-noslip": "stiff pads, MuJoCo Warp, noslip",
}

ENGINES = {"mujoco-c": "MuJoCo's C engine", "warp": "MuJoCo Warp"}


def derive(results: Results) -> Section:
    noslip = [_noslip_does_not_help(results, engine) for engine in ENGINES]
    pads = [
        f"{pads}-{engine}"
        for engine in ENGINES
        for pads in ("as-shipped", "stiff-pads")
    ]
    apart = [*pads, *(f"{case}-noslip" for case in pads)]
    not_the_cause = variants_claim(results, "iterations-15", apart)
    slip = results.row["iterations-15"].slip_mm
    slips = at_least(slip, results.chosen("slip_bound", *SLIP_BOUND))
    bound = relevance(results, slip)

    converged = ("iterations-200", "tolerance-1e-10")
    largest = results.value(
        "convergence_difference",
        "larger absolute difference in slip from the baseline, with more iterations"
        " and with a tighter tolerance",
        largest_size(change_of(results, case) for case in converged),
    )
    share = results.value(
        "convergence_share",
        "this difference, relative to the slip of the baseline",
        PERCENT * largest / abs(slip),
    )
    more, tighter = (results.row[case] for case in converged)
    claims = [
        not_the_cause,
        Claim(
            "solver_has_converged",
            negligible(share, bound),
            {
                "iterations": more.iterations,
                "tolerance": tighter.tolerance,
                "change": share,
                "bound": bound,
            },
            effect=slips,
        ),
    ]
    for name, case, column in (
        ("impratio_does_not_help", "impratio-1000", "impratio"),
        ("smaller_steps_do_not_help", "substeps-64", "substeps"),
    ):
        row = results.row[case]
        reduction = results.value(
            f"{case}_reduction",
            f"slip of the baseline minus the slip of {case}",
            -change_of(results, case),
        )
        share = results.value(
            f"{case}_reduction_share",
            "this reduction, relative to the slip of the baseline",
            PERCENT * reduction / abs(slip),
        )
        numbers = {column: row[column], "slip": row.slip_mm, "reduction": share}
        claims.append(Claim(name, negligible(share, bound), numbers, effect=slips))
    return Section(claims=[*claims, *noslip])


def _noslip_does_not_help(results: Results, engine: str) -> Claim:
    drifts = {}
    changes = []
    for pads, end in (("as-shipped", ""), ("stiff-pads", "_stiff")):
        case = f"{pads}-{engine}"
        plain = drifts[f"without{end}"] = results.row[case].drift_mm_s
        treated = drifts[f"treated{end}"] = results.row[f"{case}-noslip"].drift_mm_s
        change = results.value(
            f"{case}_change",
            f"change of the drift of {case} by noslip, relative to the drift without"
            " it",
            PERCENT * (treated / plain - 1),
        )
        changes.append(change)
    largest = results.value(
        f"{engine}_change",
        f"larger absolute change of a drift by noslip in {ENGINES[engine]}",
        largest_size(changes),
    )
    iterations = results.row[f"as-shipped-{engine}-noslip"].noslip_iterations
    return Claim(
        f"noslip_does_not_help_in_{engine.replace('-', '_')}",
        at_most(largest, 10.0, "the same drift"),
        {"iterations": iterations, **drifts},
    )
