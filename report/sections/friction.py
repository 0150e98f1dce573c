"""Is it friction? The coefficient of the pads and that of the cube, from far below to far above."""

from measured_report.parts.claim import Claim, within
from measured_report.parts.section import Section
from measured_report.values.results import Results, Row
from report.shared.arithmetic import difference, ratio
from report.shared.variants import Variants, variant_section, variants_of

order = 40
reads = ("noise", "reproduction")
label = "friction coefficient"
labels = {"pad-mu-#": "pads' friction {}", "cube-mu-#": "cube's friction {}"}


def derive(results: Results) -> Section:
    variants = variants_of(results, "pad-mu-1")
    pads = sorted((row for row in variants.rows if "pad_mu" in row), key=lambda row: row.pad_mu.value)
    return variant_section(results, variants, _not_sliding(results, variants, pads[0], pads[-1]))


def _not_sliding(results: Results, variants: Variants, low: Row, high: Row) -> Claim:
    formula = "highest over lowest coefficient of the pads"
    factor = ratio(results, "coefficient_factor", formula, high.pad_mu, low.pad_mu)
    formula = "slip with the lowest coefficient of the pads less that with the highest"
    excess = difference(results, "low_friction_excess", formula, low.slip_mm, high.slip_mm)
    numbers = {"factor": factor, "excess": excess, "at_low": low.slip_mm, "at_high": high.slip_mm}
    numbers |= {"low": low.pad_mu, "high": high.pad_mu}
    return Claim("less_friction_slips_no_more", within(excess, variants.floor), numbers)
