"""Is it the solver? Its convergence, its treatment of friction, and the time step."""

from report.claims import Claim, within
from report.parts import Section
from report.quantities import Value
from report.results import Results, Row
from report.sections._variants import Variants, not_the_cause, variant_figure, variant_table, variants_of, within_noise

order = 50

LABELS = {
    "iterations": "iterations",
    "tolerance": "both tolerances",
    "impratio": "impratio",
    "cone": "friction cone",
    "substeps": "substeps a frame",
}


def derive(results: Results) -> Section:
    variants = variants_of(results, "iterations-15")
    answer = not_the_cause(
        results,
        variants,
        holds="No setting of the solver explains the slip: none changes the {baseline} by more than {share}.",
        fails="The solver's settings matter: they change the slip of {baseline} by up to {largest}, for {most}.",
        unknown="Whether a setting of the solver explains the slip cannot be told.",
    )
    caption = "One setting changed at a time. Drift is along the shake's main axis."
    return Section(
        tables={"cases": variant_table(variants, LABELS, caption)},
        figures={"cases": variant_figure(variants)},
        claims=[
            answer,
            within_noise(variants),
            _converged(results, variants),
            _impratio(results, variants),
            _smaller_steps(results, variants),
        ],
    )


def _converged(results: Results, variants: Variants) -> Claim:
    more, tighter = results.row["iterations-200"], results.row["tolerance-1e-10"]
    largest = results.value(
        "convergence_difference",
        "larger difference in slip from the baseline, of more iterations and of a tighter tolerance",
        lambda *difference: max(map(abs, difference)),
        variants.difference[more.case],
        variants.difference[tighter.case],
        unit="mm",
    )
    return Claim(
        "solver_has_converged",
        within(largest, variants.floor),
        holds="The solver has converged: {iterations} iterations, or a tolerance of {tolerance}, change the slip by "
        "{change} at most, which is within the noise.",
        fails="The solver has not quite converged: {iterations} iterations, or a tolerance of {tolerance}, change the "
        "slip by up to {change}, more than the noise of {floor}.",
        unknown="Whether the solver has converged cannot be told.",
        numbers=variants.numbers | {"iterations": more.iterations, "tolerance": tighter.tolerance, "change": largest},
        explanation="The slip is in the contact problem that the solver is given, not in an error of solving it.",
    )


def _impratio(results: Results, variants: Variants) -> Claim:
    row = results.row["impratio-1000"]
    reduction = _reduction(results, variants, row)
    return Claim(
        "impratio_does_not_help",
        within(reduction, variants.floor),
        holds="Raising <code>impratio</code>, which makes friction rows harder than normal ones and is the usual "
        "advice against slipping, does not help: at {impratio} the slip is {slip} and the drift {drift}, where the "
        "baseline has {baseline} and {baseline_drift}.",
        fails="Raising <code>impratio</code> helps: at {impratio} the slip is {slip}, {reduction} less.",
        unknown="Whether raising <code>impratio</code> helps cannot be told.",
        numbers=variants.numbers
        | {
            "impratio": row.impratio,
            "slip": row.slip_mm,
            "drift": row.drift_mm_s,
            "baseline_drift": variants.baseline.drift_mm_s,
            "reduction": reduction,
        },
    )


def _smaller_steps(results: Results, variants: Variants) -> Claim:
    row = results.row["substeps-64"]
    reduction = _reduction(results, variants, row)
    return Claim(
        "smaller_steps_do_not_help",
        within(reduction, variants.floor),
        holds="Smaller steps do not help: with {substeps} substeps a frame the slip is {slip}, against {baseline}.",
        fails="Smaller steps help: with {substeps} substeps a frame the slip is {slip}, {reduction} less.",
        unknown="Whether smaller steps help cannot be told.",
        numbers=variants.numbers | {"substeps": row.substeps, "slip": row.slip_mm, "reduction": reduction},
        explanation="A slip that came from the time integration would shrink with the step.",
    )


def _reduction(results: Results, variants: Variants, row: Row) -> Value:
    return results.value(
        f"{row.case}_reduction",
        f"slip of the baseline less that of {row.case}",
        lambda difference: -difference,
        variants.difference[row.case],
        unit="mm",
    )
