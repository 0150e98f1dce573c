"""Compare the slips with friction coefficients far below and far above the shipped ones."""

from report.shared import Results, Section, variants_claim

order = 40
folded = True
reads = ("reproduction",)
label = "friction coefficient"
labels = {"pad-mu-#": "pads' friction {}", "cube-mu-#": "cube's friction {}"}


def derive(results: Results) -> Section:
    return Section(claims=[variants_claim(results, "pad-mu-1")])
