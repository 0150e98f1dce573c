"""Variants of the scene, from as shipped to the cure on stiff pads, and which of them to use."""

from dataclasses import dataclass

from measured_report.parts.claim import Claim, all_of, at_most, greater
from measured_report.parts.section import Table
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import difference, noise_floor, table_of

GRASP_MM = 80.0
"""Distance from where it was beyond which a cube is out of the grasp."""


@dataclass(frozen=True)
class Variant:
    """A combination of parts of the cure."""

    name: str
    case: str
    """Name of its case, with a gap for the shake: contacts, integrator, impratio, pads; term and positions."""
    tested: str = ""
    """Name in section cure_cost and at the limits of the grasp, if it was tried in both."""

    def row(self, results: Results, shake: str) -> Row:
        return results.row[self.case.format(shake)]


SHIPPED = Variant("as shipped", "newton-implicitfast-50-shipped-{}-plain-rounded")
STIFF = Variant("stiff pads, the fix", "newton-implicitfast-50-stiff-{}-plain-rounded")
STIFF_TERM = Variant("stiff pads and the term", "newton-implicitfast-50-stiff-{}-term-rounded")
TERM = Variant("the term", "newton-implicitfast-50-shipped-{}-term-rounded", tested="term")
BEST = Variant("the whole cure, in normal rows too", "newton-euler-400-shipped-{}-full-kept", tested="best")
STEPS = {
    "the term": TERM,
    "centring": Variant("the term centred, Euler", "newton-euler-50-shipped-{}-centred-rounded"),
    "impratio": Variant("the same, high impratio", "newton-euler-400-shipped-{}-centred-rounded"),
    "compensated positions": Variant("the same, positions compensated", "newton-euler-400-shipped-{}-centred-kept"),
    "normal rows": BEST,
}
"""Variants with one part more each time, by its name."""
FIRM = Variant("stiff pads and the cure", "newton-implicitfast-400-stiff-{}-centred-kept", tested="firm")
FIRM_EULER = Variant("the same, Euler", "newton-euler-400-stiff-{}-centred-kept", tested="firm_euler")
VARIANTS = (SHIPPED, STIFF, STIFF_TERM, *STEPS.values(), FIRM, FIRM_EULER)
TESTED = [variant for variant in VARIANTS if variant.tested]
KF_OFF = Variant("as shipped, kf off", "newton-implicitfast-50-shipped-{}-kf-off")
"""Variant of releases that read ``kf``."""


def use_table(results: Results) -> Table:
    variants = [*VARIANTS, *([KF_OFF] if KF_OFF.row(results, "3cm") else [])]
    columns = {
        above: ["lost" if row.dropped else row.slip_mm for row in (variant.row(results, shake) for variant in variants)]
        for above, shake in (("shaken 30 mm", "3cm"), ("shaken 100 mm", "10cm"), ("held still", "held"))
    }
    return table_of("what is done", [variant.name for variant in variants], columns)


def what_to_use(results: Results, amplitude: Value) -> Claim:
    """Tell whether the cure on stiff pads loses no cube that they keep, and no other such variant slips less.

    Only variants that were timed and tried at the limits of the grasp count. It has to keep the cube in its place at
    10 cm as well. What it costs, section cure_cost says.
    """
    noise, slips = (
        noise_floor(results, "slip_floor"),
        {variant: variant.row(results, "3cm").slip_mm for variant in (SHIPPED, *TESTED)},
    )
    far = FIRM.row(results, "10cm").slip_mm
    lost = {variant: results.derived[f"limit_lost_{variant.tested}"] for variant in TESTED}
    more = [
        difference(results, f"use_more_{variant.tested}", "its slip less that of this way", slips[FIRM], slips[variant])
        for variant in TESTED
        if variant != FIRM and lost[variant].value == 0
    ]
    outcome = all_of(
        at_most(lost[FIRM], 0, why="none of them is lost"),
        at_most(far, 0.05, why="hardly more, shaken three times as wide"),
        *(at_most(each, noise) for each in more),
        greater(slips[SHIPPED], slips[FIRM], noise=noise),
    )
    numbers = {"slip": slips[FIRM], "shipped": slips[SHIPPED], "far": far, "amplitude": amplitude}
    numbers |= {"lost": lost[FIRM], "kept": results.derived[f"kept_{FIRM.tested}"]}
    return Claim("what_to_use", outcome.having_read(*lost.values()), numbers)
