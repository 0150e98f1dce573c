"""Group the rows by their role in the diagram of error against run time."""

from dataclasses import dataclass

from experiments.facts.case import AS_SHIPPED
from report.shared import Quantity, Results, Row, Value, combined

PADS = {"as-shipped": "shipped pads", "stiff": "stiff pads"}
IN_WARP = ("newton", "newton-each-substep", "mujoco")
METHODS = (*IN_WARP, "newton-rk4", "mujoco-rk4", "cpu", "c", "c-rk4")
ENGINES = {
    "warp-cuda": "MuJoCo Warp on the GPU",
    "warp-cpu": "MuJoCo Warp on the CPU",
    "mujoco-c": "MuJoCo C",
}
ERROR = "numerical_error_mm"
GRASP = "grasp_error_mm_per_cycle"
TIME = "ms_per_s"
LOST_MM = 1e3 * AS_SHIPPED.cube_edge_m  # a cube with a larger error has left the grasp


def with_shipped_steps(pads: str, method: str) -> str:
    return f"{pads}/{method}/substeps-{AS_SHIPPED.substeps}"


SHIPPED = with_shipped_steps("as-shipped", "newton")


@dataclass(frozen=True)
class Points:
    """Holds the rows of the section, grouped by their role."""

    results: Results
    settings: list[Row]
    references: list[Row]
    worlds: list[Row]  # rows with many worlds, in ascending order
    floors: dict[str, Value]  # largest distance of Warp from C [mm], by pads
    backend_front: frozenset[str]  # cases that no other case of their backend beats

    def __getitem__(self, case: str) -> Row:
        return self.results.row[case]

    @property
    def engines(self) -> tuple[str, str]:
        """Return the backends to compare: Warp, preferably on a GPU, and C."""
        return self[SHIPPED].backend, "mujoco-c"

    def shipped(self, pads: str, backend: str) -> Row | None:
        """Return the run with the shipped settings on a backend, if it counts."""
        method = {"mujoco-c": "c", "warp-cpu": "cpu"}.get(backend, "newton")
        row = self[with_shipped_steps(pads, method)]
        return row if row and counts(row) and row.backend == backend else None

    def converged(self, pads: str) -> Quantity:
        """Return the grasp error of the shipped model after an exact solution."""
        for row in self.references:
            if row["pads"] == pads and is_own_model(row):
                return row[GRASP]
        return self[f"{pads}/reference"][GRASP]


def points_of(results: Results) -> Points:
    settings = [
        row
        for row in results.rows
        if row.method in METHODS and row.knob and row["pads"] in PADS
    ]
    fine = [
        row
        for row in settings
        if row.method in IN_WARP
        and row.knob == "substeps"
        and row.substeps.value >= AS_SHIPPED.substeps
    ]
    floors = {
        pads: results.value(
            f"floor_{pads}",
            "largest distance between a run in Warp and the same in C, with at least"
            " the shipped number of substeps",
            combined(
                max, *(row.c_difference_mm for row in fine if row["pads"] == pads)
            ),
        )
        for pads in PADS
    }
    own_model = [row for row in settings if counts(row) and is_own_model(row)]
    return Points(
        results,
        settings,
        references=[row for row in results.rows if row.method == "reference"],
        worlds=[row for row in results.rows if row.case.startswith("worlds-")],
        floors=floors,
        backend_front=front(own_model, "pads", "backend"),
    )


def front(rows: list[Row], *groups: str) -> frozenset[str]:
    """Return the cases that no other case of their group beats in error and run time."""
    places = {
        row.case: ([row[name] for name in groups], row[ERROR].value, row[TIME].value)
        for row in rows
    }

    def is_beaten(place: tuple) -> bool:
        group, error, time = place
        return any(
            rival != place
            and rival[0] == group
            and rival[1] <= error
            and rival[2] <= time
            for rival in places.values()
        )

    return frozenset(case for case, place in places.items() if not is_beaten(place))


def counts(row: Row) -> bool:
    """Return whether a run was timed and holds the cube, and its solver converged."""
    is_timed = row[TIME].value is not None
    return is_timed and holds_cube(row) and not uses_all_iterations(row)


def holds_cube(row: Row) -> bool:
    return row[ERROR].value is not None and abs(row[ERROR].value) < LOST_MM


def uses_all_iterations(row: Row) -> bool:
    limit = row.iterations.value if "iterations" in row else AS_SHIPPED.iterations
    peak = row.iteration_peak_count.value
    return None in (limit, peak) or peak >= limit


def is_own_model(row: Row) -> bool:
    """Return whether cone and impratio are as shipped, so that the error counts."""
    return not ("cone" in row or "impratio" in row)
