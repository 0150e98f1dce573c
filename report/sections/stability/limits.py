"""Find the range in which each setting holds, and the nearest setting that breaks."""

from itertools import filterfalse
from typing import NamedTuple

from experiments.facts.case import AS_SHIPPED
from report.sections.reproduction import MASS_KG
from report.sections.stability.claims import family, least, most
from report.sections.stability.passing import is_stable
from report.shared import FRAME_RATE, Quantity, Results, Row, absent, extreme

NONE = absent("1", "no tested setting breaks")


class Limit(NamedTuple):
    """The limits of a setting. All numbers have the same unit."""

    name: str
    low: Quantity  # smallest value that holds
    high: Quantity  # largest value that holds
    broken: Quantity  # nearest value that breaks
    shipped: float
    over: tuple[Quantity, Quantity] | None = None
    """Largest value that holds and smallest that drops, in percent over a limit."""


def limits(results: Results, critical: list[Row], default_kd: list[Row]) -> list[Limit]:
    """Return the limits, from values of the claims and from the rows of families."""
    value = results.derived
    ranges = []

    def add(label: str, rows: list[Row], column: str, *rest, **more) -> None:
        held = [row[column] for row in rows if is_stable(row)]
        ends = (extreme(min, held), extreme(max, held))
        ranges.append(Limit(label, *ends, *rest, **more))

    stiff = [row for row in family(results, "steps") if row.pads == "stiff"]
    step_ms = 1e3 / (FRAME_RATE * AS_SHIPPED.substeps)
    add("time step [ms]", stiff, "step_ms", NONE, step_ms)

    first = value["safe_ke"].value
    limit = value["kd_100_ke"].value
    known = critical if first is not None else ()
    safe = [row for row in known if row.pad_ke.value >= first]
    soft = [row for row in known if row.pad_ke.value < first]
    lost = filterfalse(is_stable, soft)
    sunk = most(
        results,
        "ke_critical_lost",
        "largest ke below safe_ke that fails",
        lost,
        "pad_ke",
    )
    add("ke, kd with it", safe, "pad_ke", sunk, AS_SHIPPED.pad_ke)
    alone = [
        row
        for row in default_kd
        if row.substeps.value == AS_SHIPPED.substeps
        and limit is not None
        and row.pad_ke.value <= limit
    ]
    breaks = value["kd_100_breaks"]
    add("ke alone", alone, "pad_ke", breaks, AS_SHIPPED.pad_ke)

    for label, name in (
        ("shake, relative to Coulomb's limit", "shake"),
        ("weaker grip, relative to it", "grip"),
    ):
        rows = [row for row in family(results, name) if row.load.value is not None]
        over = value[f"{name}_kept_over"], value[f"{name}_lost_over"]
        drops = value[f"{name}_lost"]
        add(label, rows, "load", drops, 1.0, over=over)

    low = value["friction_kept"]
    high = value["friction_most"]
    slides = value["friction_lost"]
    ranges.append(Limit("pads' friction", low, high, slides, AS_SHIPPED.pad_mu))

    sizes = [row for row in family(results, "size") if row.grip == "as-shipped"]
    lost = filterfalse(is_stable, sizes)
    small = most(
        results, "edge_lost", "largest edge that is lost", lost, "cube_edge_mm"
    )
    edge_mm = 1e3 * AS_SHIPPED.cube_edge_m
    add("cube's edge [mm]", sizes, "cube_edge_mm", small, edge_mm)

    low = value["mass_least"]
    high = value["mass_most"]
    ranges.append(Limit("mass, grip to match [kg]", low, high, NONE, MASS_KG))

    pulls = [row for row in family(results, "gravity") if row.gravity_m_s2.value > 0.0]
    formula = "smallest gravity that loses the cube"
    lost = filterfalse(is_stable, pulls)
    heavy = least(results, "gravity_lost", formula, lost, "gravity_m_s2")
    add("gravity [m/s²]", pulls, "gravity_m_s2", heavy, 9.81)

    starts = family(results, "overlap")
    add("overlap at the start [mm]", starts, "overlap_mm", NONE, 1.0)
    return [
        limit for limit in ranges if None not in (limit.low.value, limit.high.value)
    ]
