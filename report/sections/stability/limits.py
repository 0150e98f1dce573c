"""Find the range of each setting in which the grasp holds, and where it fails next."""

from collections.abc import Iterable
from typing import NamedTuple

from experiments.facts.case import AS_SHIPPED
from report.sections.reproduction import MASS_KG
from report.sections.stability.claims import family
from report.sections.stability.passing import is_stable
from report.shared import FRAME_RATE, Quantity, Results, Row, absent

NONE = absent("1", "the grasp holds with every tested setting")


class Limit(NamedTuple):
    """The limits of a setting. All numbers have the same unit."""

    name: str
    low: Quantity  # smallest value that holds
    high: Quantity  # largest value that holds
    broken: Quantity  # nearest value that breaks
    shipped: float | None  # value of the scene as shipped, if it is on the same scale


def limits(results: Results, critical: list[Row], default_kd: list[Row]) -> list[Limit]:
    """Return the limits at the shipped step, from the rows of the families."""
    ranges = []

    def add(
        label: str, rows: Iterable[Row], column: str, shipped: float | None
    ) -> None:
        rows = [row for row in rows if row[column].value is not None]
        held = [row[column] for row in rows if is_stable(row)]
        lost = [row[column] for row in rows if not is_stable(row)]
        if held:
            low = min(held, key=number_of)
            high = max(held, key=number_of)
            ranges.append(Limit(label, low, high, _nearest(lost, low, high), shipped))

    def at_shipped_step(rows: Iterable[Row]) -> list[Row]:
        return [row for row in rows if row.substeps.value == AS_SHIPPED.substeps]

    stiff = [row for row in family(results, "steps") if row.pads == "stiff"]
    step_ms = 1e3 / (FRAME_RATE * AS_SHIPPED.substeps)
    add("time step [ms], stiff pads", stiff, "step_ms", step_ms)
    ke = AS_SHIPPED.pad_ke
    add("ke, with kd = 2√ke", at_shipped_step(critical), "pad_ke", ke)
    add("ke alone", at_shipped_step(default_kd), "pad_ke", ke)
    shipped = results.row[f"steps-as-shipped-{AS_SHIPPED.substeps}"]
    shakes = [*family(results, "shake"), *([shipped] if shipped else [])]
    add("harder shake: force ÷ Coulomb's limit", shakes, "load", shipped.load.value)
    add(
        "weaker grip: force ÷ force that is needed",
        family(results, "grip"),
        "grip_ratio",
        None,
    )
    add(
        "pads' friction coefficient",
        family(results, "friction"),
        "pad_mu",
        AS_SHIPPED.pad_mu,
    )
    sizes = [row for row in family(results, "size") if row.grip == "as-shipped"]
    add("cube's edge [mm]", sizes, "cube_edge_mm", 1e3 * AS_SHIPPED.cube_edge_m)
    add(
        "cube's mass [kg], grip to match",
        family(results, "mass"),
        "cube_mass_kg",
        MASS_KG,
    )
    gravity = AS_SHIPPED.gravity_m_s2
    add("downward gravity [m/s²]", family(results, "gravity"), "gravity_m_s2", gravity)
    add("overlap at the start [mm]", family(results, "overlap"), "overlap_mm", None)
    return ranges


def number_of(cell: Quantity) -> float:
    return cell.number


def _nearest(lost: list[Quantity], low: Quantity, high: Quantity) -> Quantity:
    """Return the failing value that is nearest to a range."""
    above = [cell for cell in lost if cell.number > high.number]
    below = [cell for cell in lost if cell.number < low.number]
    if above:
        return min(above, key=number_of)
    return max(below, key=number_of) if below else NONE
