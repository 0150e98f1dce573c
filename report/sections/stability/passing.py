"""Define the criteria by which a run of section stability passes."""

from experiments.facts import classes
from report.shared import Quantity, Row

CLASSES = classes.CLASSES[::-1]  # how a run ends, from the best to the worst
# Largest depth in stiff pads that passes, relative to the edge of the cube [%].
DEPTH_LARGEST = 1.0
# Largest creep per cycle at the end of the long run, relative to that at its start,
# that passes.
GROWTH_LARGEST = 1.1
# Runs this close to the limit of friction do not have a criterion, because either
# outcome is right there [%].
LIMIT_MARGIN = 10.0
JUDGED_BY = {  # columns that decide whether a stable run passes, by family
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
    """Return whether a run passes.

    It is None if the run does not have a criterion, or if a stable run lacks a number.
    """
    if any(cell.value is None for cell in judged_by(row)):
        return None
    match row.family:
        # The cube must be held clearly below the limit of friction, and dropped above
        # it.
        case "shake" | "grip":
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
        case "overlap":  # ejected at most as fast as by an undamped spring
            return (
                is_stable(row)
                and row.exit_speed_mm_s.value <= row.exit_bound_mm_s.value
            )
        case "long":  # creeps hardly faster at the end than at the start
            first = row.increment_first_mm_per_cycle.value
            last = row.increment_last_mm_per_cycle.value
            return is_stable(row) and abs(last) <= GROWTH_LARGEST * abs(first)
        case "mass" | "gravity":
            return row.finite
    raise LookupError(f"family {row.family!r} has no criterion: add it to passes()")
