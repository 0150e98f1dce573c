"""Who finds the contacts, how often, on which shape, and which engine solves them."""

from report.parts import Section
from report.results import Results
from report.sections._variants import not_the_cause, variant_figure, variant_table, variants_of, within_noise

order = 30

LABELS = {
    "collide_count": "collision passes a frame:",
    "contacts": "contacts found by:",
    "pad_shape": "pads collide as:",
    "backend": "engine:",
}


def derive(results: Results) -> Section:
    variants = variants_of(results, "contacts-60hz")
    answer = not_the_cause(
        results,
        variants,
        holds="The slip does not come from the contact points. Found more often, found by MuJoCo instead of Newton, "
        "found on convex meshes instead of boxes, or solved by MuJoCo's C engine, they leave the slip of {baseline} "
        "where it is, to within {share}.",
        fails="Not every way to find and solve the contacts leaves the slip of {baseline} where it is: it changes by "
        "up to {largest}, for {most}.",
        unknown="Whether the slip comes from the contact points cannot be told.",
    )
    caption = "One thing changed at a time. Drift is along the shake's main axis."
    return Section(
        tables={"cases": variant_table(variants, LABELS, caption)},
        figures={"cases": variant_figure(variants)},
        claims=[answer, within_noise(variants)],
    )
