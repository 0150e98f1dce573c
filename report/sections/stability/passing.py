"""When a run of section stability passes: judged from what was measured of it."""

from experiments.facts import classes
from report.shared import Quantity, Row

CLASSES = classes.CLASSES[::-1]  # how a run ends, from the best to the worst
DEPTH_LARGEST = 1.0  # depth in stiff pads, at most, in percent of the edge
GROWTH_LARGEST = 1.1  # creep per cycle at the end of the long run over that at its beginning, at most
LIMIT_MARGIN = (
    10.0  # so near to what friction can carry, in percent of it, nothing is asked
)
JUDGED_BY = {
    "shake": ("load",),
    "grip": ("load",),
    "size": ("penetration_mm",),
    "overlap": ("exit_speed_mm_s", "exit_bound_mm_s"),
    "long": ("increment_first_mm_per_cycle", "increment_last_mm_per_cycle"),
}


def is_stable(row: Row) -> bool:
    return row["class"] in classes.STABLE


def judged_by(row: Row) -> list[Quantity]:
    """Return the numbers that decide whether a stable run passes."""
    return (
        [row[column] for column in JUDGED_BY.get(row.family, ())]
        if is_stable(row)
        else []
    )


def passes(row: Row) -> bool | None:
    """Tell whether a run passes.

    It is None if nothing is asked, or if a stable run lacks a number.
    """
    if any(cell.value is None for cell in judged_by(row)):
        return None
    match row.family:
        case (
            "shake" | "grip"
        ):  # held well below what friction can carry, dropped well above
            margin = 0.01 * LIMIT_MARGIN
            load = row.load.value
            if load is None or load > 1.0 + margin:
                return load is not None and row["class"] == "dropped"
            return is_stable(row) if load < 1.0 - margin else None
        case "friction":
            return row.finite and (row.pad_mu.value > 0.0 or row["class"] == "dropped")
        case "size":
            return (
                is_stable(row)
                and row.penetration_mm.value
                < 0.01 * DEPTH_LARGEST * row.cube_edge_mm.value
            )
        case "overlap":  # thrown out no faster than by an undamped spring
            return (
                is_stable(row)
                and row.exit_speed_mm_s.value <= row.exit_bound_mm_s.value
            )
        case "long":  # creeps no faster in the end than in the beginning
            first = row.increment_first_mm_per_cycle.value
            last = row.increment_last_mm_per_cycle.value
            return is_stable(row) and abs(last) <= GROWTH_LARGEST * abs(first)
        case "mass" | "gravity":
            return row.finite
    raise LookupError(f"nothing says when a run of {row.family} passes")
