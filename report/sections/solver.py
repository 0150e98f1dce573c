"""Is it the solver? Its convergence, its treatment of friction, and the time step."""

from measured_report.parts.claim import Claim, within
from measured_report.parts.section import Section
from measured_report.values.results import Results
from report.shared.arithmetic import largest_size
from report.shared.variants import Variants, variant_section, variants_of

order = 50
label = "solver and time step"


def derive(results: Results) -> Section:
    variants = variants_of(results, "iterations-15")
    claims = [
        _converged(results, variants),
        _does_not_help(results, variants, "impratio_does_not_help", "impratio-1000", "impratio"),
        _does_not_help(results, variants, "smaller_steps_do_not_help", "substeps-64", "substeps"),
    ]
    return variant_section(results, variants, *claims)


def _converged(results: Results, variants: Variants) -> Claim:
    more, tighter = results.row["iterations-200"], results.row["tolerance-1e-10"]
    formula = "larger difference in slip from the baseline, of more iterations and of a tighter tolerance"
    differences = [variants.difference[row.case] for row in (more, tighter)]
    largest = largest_size(results, "convergence_difference", formula, differences, unit="mm")
    numbers = {"iterations": more.iterations, "tolerance": tighter.tolerance, "change": largest}
    return Claim(
        "solver_has_converged", within(largest, variants.floor), variants.numbers | numbers, effect=variants.slips
    )


def _does_not_help(results: Results, variants: Variants, claim: str, case: str, column: str) -> Claim:
    """Tell whether the slip of a case is less than the baseline's; its wording can name what ``column`` says."""
    row, formula = results.row[case], f"slip of the baseline less that of {case}"
    reduction = results.value(f"{case}_reduction", formula, lambda a: -a, variants.difference[case], unit="mm")
    numbers = {column: row[column], "slip": row.slip_mm, "reduction": reduction}
    return Claim(claim, within(reduction, variants.floor), variants.numbers | numbers, effect=variants.slips)
