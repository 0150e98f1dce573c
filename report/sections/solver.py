"""Is it the solver? Its convergence, its treatment of friction, the time step, and MuJoCo's own remedy for slip."""

from collections.abc import Mapping
from itertools import product

from report.shared import (
    PERCENT,
    Claim,
    Results,
    Section,
    Value,
    Variants,
    all_of,
    at_most,
    change_of,
    largest_size,
    noise_floor,
    variant_section,
    variants_of,
    within,
)

order = 50
reads = ("noise", "reproduction")
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
PADS = ("as-shipped", "stiff-pads")
CONVERGED = ("iterations-200", "tolerance-1e-10")


def derive(results: Results) -> Section:
    changes = {}
    for case in (f"{pads}-{engine}" for engine in ENGINES for pads in PADS):
        treated, plain = (
            results.row[f"{case}-noslip"].drift_mm_s,
            results.row[case].drift_mm_s,
        )
        changes[case] = results.value(
            f"{case}_change",
            f"drift of {case} with noslip less that without, of that without",
            PERCENT * (treated / plain - 1),
        )
    remedies = (*changes, *(f"{case}-noslip" for case in changes))
    variants = variants_of(results, "iterations-15", apart=remedies)
    claims = [_converged(results, variants)]
    claims += [
        _does_not_help(
            results, variants, "impratio_does_not_help", "impratio-1000", "impratio"
        )
    ]
    claims += [
        _does_not_help(
            results, variants, "smaller_steps_do_not_help", "substeps-64", "substeps"
        )
    ]
    claims += [*(_noslip_does_not_help(results, engine, changes) for engine in ENGINES)]
    return variant_section(results, variants, *claims)


def _converged(results: Results, variants: Variants) -> Claim:
    more, tighter = map(results.row.__getitem__, CONVERGED)
    differences = [change_of(results, case) for case in CONVERGED]
    largest = results.value(
        "convergence_difference",
        "larger difference in slip from the baseline, of more iterations and of a tighter tolerance",
        largest_size(differences),
    )
    numbers = {
        "iterations": more.iterations,
        "tolerance": tighter.tolerance,
        "change": largest,
    }
    outcome = all_of(within(largest, noise_floor(results, "slip_floor")), variants.seen)
    return Claim(
        "solver_has_converged",
        outcome,
        variants.numbers | numbers,
        effect=variants.slips,
    )


def _does_not_help(
    results: Results, variants: Variants, claim: str, case: str, column: str
) -> Claim:
    row, formula = results.row[case], f"slip of the baseline less that of {case}"
    reduction = results.value(f"{case}_reduction", formula, -change_of(results, case))
    numbers = {column: row[column], "slip": row.slip_mm, "reduction": reduction}
    outcome = all_of(
        within(reduction, noise_floor(results, "slip_floor")), variants.seen
    )
    return Claim(claim, outcome, variants.numbers | numbers, effect=variants.slips)


def _noslip_does_not_help(
    results: Results, engine: str, changes: Mapping[str, Value]
) -> Claim:
    of_engine = (changes[f"{pads}-{engine}"] for pads in PADS)
    largest = results.value(
        f"{engine}_change",
        f"larger change that noslip makes in a drift, in size, in {ENGINES[engine]}",
        largest_size(of_engine),
    )
    named = product(
        zip(PADS, ("", "_stiff"), strict=True),
        (("without", ""), ("treated", "-noslip")),
    )
    drifts = {
        name + end: results.row[f"{pads}-{engine}{way}"].drift_mm_s
        for (pads, end), (name, way) in named
    }
    iterations = results.row[f"{PADS[0]}-{engine}-noslip"].noslip_iterations
    name, same = (
        f"noslip_does_not_help_in_{engine.replace('-', '_')}",
        at_most(largest, 10.0, why="the same drift"),
    )
    return Claim(name, same, {"iterations": iterations, **drifts})
