"""Who finds the contacts, how often, on which shape, and which engine solves them."""

from measured_report.parts.parts import Section
from measured_report.values.results import Results
from report.shared.variants import not_the_cause, variant_figure, variant_table, variants_of, within_noise

order = 30
label = "contact points"

LABELS = {
    "collide_count": "collision passes a frame:",
    "contacts": "contacts found by:",
    "pad_shape": "pads collide as:",
    "backend": "engine:",
}


def derive(results: Results) -> Section:
    variants = variants_of(results, "contacts-60hz")
    return Section(
        tables={"cases": variant_table(variants, LABELS)},
        figures={"cases": variant_figure(variants)},
        claims=[not_the_cause(results, variants), within_noise(variants)],
    )
