"""Points of the diagram of error against run time, sorted."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import compress

from experiments.facts.case import AS_SHIPPED
from report.shared import Quantity, Results, Row, Value, combined

PADS = {"as-shipped": "shipped pads", "stiff": "stiff pads"}
METHODS = (
    "newton",
    "newton-each-substep",
    "mujoco",
    "newton-rk4",
    "mujoco-rk4",
    "cpu",
    "c",
    "c-rk4",
)
ENGINES = {
    "warp-cuda": "MuJoCo Warp on the GPU",
    "warp-cpu": "MuJoCo Warp on the CPU",
    "mujoco-c": "MuJoCo C",
}
ERROR, GRASP, TIME = "numerical_error_mm", "grasp_error_mm_per_cycle", "ms_per_s"
LOST_MM = (
    1e3 * AS_SHIPPED.cube_edge_m
)  # chosen: farther off than its edge, the cube has left the grasp


def with_shipped_steps(pads: str, method: str) -> str:
    return f"{pads}/{method}/substeps-{AS_SHIPPED.substeps}"


SHIPPED = with_shipped_steps("as-shipped", "newton")


@dataclass(frozen=True)
class Points:
    """Rows of the section, sorted."""

    results: Results
    settings: Sequence[Row]
    references: Sequence[Row]
    worlds: Sequence[Row]  # many worlds at once, fewest first
    floors: Mapping[
        str, Value
    ]  # distance of Warp from C with the same steps, by pads [mm]
    backend_front: frozenset[
        str
    ]  # cases that no other beats in numerical error and run time

    def __getitem__(self, case: str) -> Row:
        return self.results.row[case]

    @property
    def engines(self) -> tuple[str, str]:
        """Return the two backends to compare: Warp's, on the GPU where there is one, and C."""
        return self[SHIPPED].backend, "mujoco-c"

    def shipped(self, pads: str, backend: str) -> Row | None:
        """Look up the settings as shipped on a backend, where they count."""
        method = {"mujoco-c": "c", "warp-cpu": "cpu"}.get(backend, "newton")
        row = self[with_shipped_steps(pads, method)]
        return row if row and counts(row) and row.backend == backend else None

    def converged(self, pads: str) -> Quantity:
        """Look up the grasp error of the converged solution with the cone and impratio as shipped."""
        solutions = (
            row for row in self.references if row["pads"] == pads and is_own_model(row)
        )
        return next(solutions, self[f"{pads}/reference"])[GRASP]


def points_of(results: Results) -> Points:
    settings = [
        row
        for row in results.rows
        if row.method in METHODS and row.knob and row["pads"] in PADS
    ]
    in_warp = [
        row
        for row in settings
        if row.method in ("newton", "newton-each-substep", "mujoco")
    ]
    fine = [
        row
        for row in in_warp
        if row.knob == "substeps" and row.substeps.value >= AS_SHIPPED.substeps
    ]
    floors = {}
    for pads in PADS:
        cells = [row.c_difference_mm for row in fine if row["pads"] == pads]
        floors[pads] = results.value(
            f"floor_{pads}",
            "largest distance between a run in Warp and the same in C, from the shipped number of substeps on",
            combined(max, *cells),
        )
    own_model = [row for row in settings if counts(row) and is_own_model(row)]
    references = [row for row in results.rows if row.method == "reference"]
    worlds = [row for row in results.rows if row.case.startswith("worlds-")]
    return Points(
        results,
        settings,
        references,
        worlds,
        floors,
        front(own_model, "pads", "backend"),
    )


def front(rows: Sequence[Row], *groups: str) -> frozenset[str]:
    """Select the cases that no other in the same ``groups`` beats in numerical error and run time."""
    places = [
        (tuple(row[name] for name in groups), row[ERROR].value, row[TIME].value)
        for row in rows
    ]

    def beats(other: tuple, one: tuple) -> bool:
        return (
            other != one
            and other[0] == one[0]
            and other[1] <= one[1]
            and other[2] <= one[2]
        )

    unbeaten = [not any(beats(other, place) for other in places) for place in places]
    return frozenset(row.case for row in compress(rows, unbeaten))


def counts(row: Row) -> bool:
    """Tell whether a run was timed, holds the cube, and its solver converged."""
    return (
        row[TIME].value is not None and holds_cube(row) and not uses_all_iterations(row)
    )


def holds_cube(row: Row) -> bool:
    return row[ERROR].value is not None and abs(row[ERROR].value) < LOST_MM


def uses_all_iterations(row: Row) -> bool:
    limit = row.iterations.value if "iterations" in row else AS_SHIPPED.iterations
    return (
        None in (limit, row.iteration_peak_count.value)
        or row.iteration_peak_count.value >= limit
    )


def is_own_model(row: Row) -> bool:
    """Tell whether cone and impratio are as shipped, so that the errors of two rows are from one solution."""
    return not ("cone" in row or "impratio" in row)
