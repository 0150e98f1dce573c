"""Which runs count, told by what was measured of them: they were timed, hold the cube, and their solver converged."""

from experiments.facts.case import AS_SHIPPED
from measured_report.values.results import Row

ERROR, TIME = "numerical_error_mm", "ms_per_s"
LOST_MM = 1e3 * AS_SHIPPED.cube_edge_m
"""Chosen: farther than its edge from where the converged solution has it, the cube has left the grasp."""


def counts(row: Row) -> bool:
    return row[TIME].value is not None and holds_cube(row) and not uses_all_iterations(row)


def holds_cube(row: Row) -> bool:
    return row[ERROR].value is not None and abs(row[ERROR].value) < LOST_MM


def uses_all_iterations(row: Row) -> bool:
    limit = row.iterations.value if "iterations" in row else AS_SHIPPED.iterations
    return None in (limit, row.iteration_peak_count.value) or row.iteration_peak_count.value >= limit


def hit_iteration_limit(row: Row) -> bool:
    """Whether a run does not count because the solver used all of its iterations, and for no other reason."""
    return holds_cube(row) and uses_all_iterations(row)
