"""Is it friction? The coefficient of the pads and that of the cube, from far below to far above."""

from report.claims import Claim, within
from report.parts import Section
from report.results import Results, Row
from report.sections._common import difference, ratio
from report.sections._variants import Variants, not_the_cause, variant_figure, variant_table, variants_of, within_noise

order = 40

LABELS = {"pad_mu": "pads' coefficient", "cube_mu": "cube's coefficient"}


def derive(results: Results) -> Section:
    variants = variants_of(results, "pad-mu-1")
    pads = sorted((row for row in variants.rows if "pad_mu" in row), key=lambda row: row.pad_mu.value)
    answer = not_the_cause(
        results,
        variants,
        holds="Friction is not too low: no coefficient of the pads or of the cube changes the slip of {baseline} by "
        "more than {share}.",
        fails="The friction coefficient matters: it changes the slip of {baseline} by up to {largest}, for {most}.",
        unknown="Whether the slip depends on the friction coefficient cannot be told.",
    )
    caption = "One coefficient changed at a time. Drift is along the shake's main axis."
    return Section(
        tables={"cases": variant_table(variants, LABELS, caption)},
        figures={"cases": variant_figure(variants)},
        claims=[answer, within_noise(variants), _not_sliding(results, variants, pads[0], pads[-1])],
    )


def _not_sliding(results: Results, variants: Variants, low: Row, high: Row) -> Claim:
    """Sliding friction would let go sooner the lower the coefficient."""
    formula = "highest over lowest coefficient of the pads"
    factor = ratio(results, "coefficient_factor", formula, high.pad_mu, low.pad_mu)
    excess = difference(
        results,
        "low_friction_excess",
        "slip with the lowest coefficient of the pads less that with the highest",
        low.slip_mm,
        high.slip_mm,
    )
    return Claim(
        "less_friction_slips_no_more",
        within(excess, variants.floor),
        holds="With {factor} times less friction the pads let the cube slip no farther: {at_low} at a coefficient of "
        "{low}, {at_high} at {high}.",
        fails="With {factor} times less friction the pads let the cube slip {excess} farther: {at_low} at a "
        "coefficient of {low}, {at_high} at {high}.",
        unknown="Whether less friction lets the cube slip farther cannot be told.",
        numbers={
            "factor": factor,
            "excess": excess,
            "at_low": low.slip_mm,
            "at_high": high.slip_mm,
            "low": low.pad_mu,
            "high": high.pad_mu,
        },
        explanation="A coefficient is a limit: it caps the tangential force that a contact may carry, and does nothing "
        "while the force stays below. That less friction does not matter says that the contacts are below.",
    )
