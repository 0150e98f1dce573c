"""How far each extreme can be pushed: from what holds to what breaks, beside the scene as shipped."""

from collections.abc import Mapping, Sequence
from itertools import filterfalse
from typing import NamedTuple

from experiments.facts.case import AS_SHIPPED
from report.sections.reproduction import FRAME_RATE
from report.sections.stability.claims import family, least, most
from report.sections.stability.passing import is_stable
from report.shared import Claim, Quantity, Results, Row, absent

NONE = absent("1", "it was not seen")


class Limit(NamedTuple):
    """One extreme: what holds, what breaks beyond it, and what the scene has as shipped, all in one unit."""

    name: str
    low: Quantity
    high: Quantity
    broken: Quantity
    shipped: float
    over: tuple[Quantity, Quantity] | None = (
        None  # what holds and what breaks, in percent over a limit
    )


def limits(
    results: Results,
    claims: Mapping[str, Claim],
    critical: Sequence[Row],
    alone: Sequence[Row],
) -> list[Limit]:
    """Collect them from the claims on each, and from the rows where a claim has one end alone."""

    def ends(name: str, rows: Sequence[Row], column: str) -> tuple[Quantity, Quantity]:
        formula, held = (
            "{} of the runs of " + name + " that hold",
            list(filter(is_stable, rows)),
        )
        low = least(results, f"{name}_low", formula.format("least"), held, column)
        return low, most(
            results, f"{name}_high", formula.format("largest"), held, column
        )

    def said(claim: str, name: str) -> Quantity:
        number = claims[claim].numbers.get(name)
        return number if isinstance(number, Quantity) else NONE

    def loads(label: str, name: str) -> Limit:
        rows = [row for row in family(results, name) if row.load.value is not None]
        over = said(f"{name}_crossover", "kept"), said(f"{name}_crossover", "lost")
        return Limit(
            label,
            *ends(f"{name}_load", rows, "load"),
            results.derived.get(f"{name}_lost", NONE),
            1.0,
            over,
        )

    steps = [row for row in family(results, "steps") if row.pads == "stiff"]
    sizes = [row for row in family(results, "size") if row.grip == "as-shipped"]
    small = most(
        results,
        "edge_lost",
        "largest that is lost",
        filterfalse(is_stable, sizes),
        "cube_edge_mm",
    )
    pulls = [row for row in family(results, "gravity") if row.gravity_m_s2.value > 0.0]
    heavy = least(
        results,
        "gravity_lost",
        "least that loses it",
        filterfalse(is_stable, pulls),
        "gravity_m_s2",
    )
    first, up_to = said("safe_settings", "least"), said("safe_settings", "limit")
    safe = [
        row
        for row in critical
        if first.value is not None and row.pad_ke.value >= first.value
    ]
    soft = [
        row
        for row in critical
        if first.value is not None and row.pad_ke.value < first.value
    ]
    sunk = most(
        results,
        "ke_critical_lost",
        "largest below these that fails",
        filterfalse(is_stable, soft),
        "pad_ke",
    )
    below = [
        row
        for row in alone
        if row.substeps.value == AS_SHIPPED.substeps and up_to.value is not None
    ]
    below = [row for row in below if row.pad_ke.value <= up_to.value]
    mass = AS_SHIPPED.cube_density_kg_m3 * AS_SHIPPED.cube_edge_m**3
    step = 1e3 / (FRAME_RATE * AS_SHIPPED.substeps)
    found = [
        Limit("time step [ms]", *ends("step", steps, "step_ms"), NONE, step),
        Limit("ke, kd with it", *ends("ke_critical", safe, "pad_ke"), sunk, AS_SHIPPED.pad_ke),
        Limit("ke alone", *ends("ke_alone", below, "pad_ke"), said("safe_settings", "breaks"), AS_SHIPPED.pad_ke),
        loads("shake, of Coulomb's limit", "shake"),
        loads("weaker grip, of that", "grip"),
        Limit("pads' friction", said("friction_extremes", "kept"), said("friction_extremes", "most"),
              said("friction_extremes", "lost"), AS_SHIPPED.pad_mu),
        Limit("cube's edge [mm]", *ends("edge", sizes, "cube_edge_mm"), small, 1e3 * AS_SHIPPED.cube_edge_m),
        Limit("mass, grip to match [kg]", said("masses", "light"), said("masses", "heavy"), NONE, mass),
        Limit("gravity [m/s²]", *ends("pull", pulls, "gravity_m_s2"), heavy, 9.81),
        Limit("overlap at the start [mm]", *ends("start", family(results, "overlap"), "overlap_mm"), NONE, 1.0),
    ]  # fmt: skip
    return [limit for limit in found if None not in (limit.low.value, limit.high.value)]
