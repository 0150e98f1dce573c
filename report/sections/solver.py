"""Is it the solver? Its convergence, its treatment of friction, and the time step."""

from measured_report.claims.claims import Claim, within
from measured_report.parts.parts import Section
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.shared.variants import Variants, not_the_cause, variant_figure, variant_table, variants_of, within_noise

order = 50
label = "solver and time step"

LABELS = {
    "iterations": "iterations",
    "tolerance": "both tolerances",
    "impratio": "impratio",
    "cone": "friction cone",
    "substeps": "substeps a frame",
}


def derive(results: Results) -> Section:
    variants = variants_of(results, "iterations-15")
    return Section(
        tables={"cases": variant_table(variants, LABELS)},
        figures={"cases": variant_figure(variants)},
        claims=[
            not_the_cause(results, variants),
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
        numbers=variants.numbers | {"iterations": more.iterations, "tolerance": tighter.tolerance, "change": largest},
    )


def _impratio(results: Results, variants: Variants) -> Claim:
    row = results.row["impratio-1000"]
    reduction = _reduction(results, variants, row)
    return Claim(
        "impratio_does_not_help",
        within(reduction, variants.floor),
        numbers=variants.numbers | {"impratio": row.impratio, "slip": row.slip_mm, "reduction": reduction},
    )


def _smaller_steps(results: Results, variants: Variants) -> Claim:
    row = results.row["substeps-64"]
    reduction = _reduction(results, variants, row)
    return Claim(
        "smaller_steps_do_not_help",
        within(reduction, variants.floor),
        numbers=variants.numbers | {"substeps": row.substeps, "slip": row.slip_mm, "reduction": reduction},
    )


def _reduction(results: Results, variants: Variants, row: Row) -> Value:
    return results.value(
        f"{row.case}_reduction",
        f"slip of the baseline less that of {row.case}",
        lambda difference: -difference,
        variants.difference[row.case],
        unit="mm",
    )
