"""The slip with friction coefficients far below and far above the shipped ones."""

from report.shared import Results, Section, variant_section, variants_of

order = 40
reads = ("reproduction",)
label = "friction coefficient"
labels = {"pad-mu-#": "pads' friction {}", "cube-mu-#": "cube's friction {}"}


def derive(results: Results) -> Section:
    return variant_section(results, variants_of(results, "pad-mu-1"))
