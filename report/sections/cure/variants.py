"""Variants of the scene, from as shipped to the cure on stiff pads, and which of them to use."""

from dataclasses import dataclass

from measured_report.parts.claim import Claim, all_of, at_most
from measured_report.parts.section import Table
from measured_report.values.results import Results, Row
from report.shared.arithmetic import share, table_of

GRASP_MM = 80.0
"""Distance from where it was beyond which a cube is out of the grasp."""


@dataclass(frozen=True)
class Variant:
    """A combination of parts of the cure."""

    name: str
    case: str
    """Name of its case, with a gap for the shake: contacts, integrator, impratio, pads; term and positions."""

    def row(self, results: Results, shake: str) -> Row:
        return results.row[self.case.format(shake)]


SHIPPED = Variant("as shipped", "newton-implicitfast-50-shipped-{}-plain-rounded")
STIFF = Variant("stiff pads, the fix", "newton-implicitfast-50-stiff-{}-plain-rounded")
STIFF_TERM = Variant("stiff pads and the term", "newton-implicitfast-50-stiff-{}-term-rounded")
TERM = Variant("the term", "newton-implicitfast-50-shipped-{}-term-rounded")
BEST = Variant("the root cure, in normal rows too", "newton-euler-400-shipped-{}-full-kept")
STEPS = (
    TERM,
    Variant("the term centred, Euler", "newton-euler-50-shipped-{}-centred-rounded"),
    Variant("the same, high impratio", "newton-euler-400-shipped-{}-centred-rounded"),
    Variant("the same, positions compensated", "newton-euler-400-shipped-{}-centred-kept"),
    BEST,
)
"""Variants with one part more each time."""
FIRM = Variant("stiff pads and the root cure", "newton-implicitfast-400-stiff-{}-centred-kept")
FIRM_EULER = Variant("the same, Euler", "newton-euler-400-stiff-{}-centred-kept")
VARIANTS = (SHIPPED, STIFF, STIFF_TERM, *STEPS, FIRM, FIRM_EULER)
KF_OFF = Variant("as shipped, kf off", "newton-implicitfast-50-shipped-{}-kf-off")
"""Variant of releases that read ``kf``."""


def use_table(results: Results) -> Table:
    variants = [*VARIANTS, *([KF_OFF] if KF_OFF.row(results, "3cm") else [])]
    columns = {
        above: ["lost" if row.dropped else row.slip_mm for row in (variant.row(results, shake) for variant in variants)]
        for above, shake in (("shaken 30 mm", "3cm"), ("shaken 100 mm", "10cm"), ("held still", "held"))
    }
    return table_of("what is done", [variant.name for variant in variants], columns)


def what_to_use(results: Results) -> Claim:
    """Tell whether the cure on stiff pads loses no cube that they keep, at 10 cm as well, and slips less than as
    shipped. What it costs, section cure_cost says."""
    slip, shipped, far = (
        variant.row(results, shake).slip_mm for variant, shake in ((FIRM, "3cm"), (SHIPPED, "3cm"), (FIRM, "10cm"))
    )
    amplitude = FIRM.row(results, "10cm").shake_amplitude_m
    wide = results.value("amplitude_10cm", "in whole mm", lambda m: round(1e3 * m), amplitude, unit="mm")
    lost, kept = results.derived["limit_lost_firm"], results.derived["kept_firm"]
    outcome = all_of(
        at_most(lost, 0, why="none of them is lost"),
        at_most(far, 0.05, why="hardly more, shaken three times as wide"),
        at_most(share(results, "held_share", "of the slip as shipped, that", slip, shipped), 50.0, why="less by half"),
    )
    numbers = {"slip": slip, "shipped": shipped, "far": far, "amplitude": wide, "lost": lost, "kept": kept}
    return Claim("what_to_use", outcome, numbers)
