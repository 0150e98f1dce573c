"""The points of the diagram of error against run time, sorted, and what is derived from all of them."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from markupsafe import Markup

from experiments.facts.case import AS_SHIPPED
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.sections.error_runtime.counting import ERROR, TIME, counts
from report.sections.error_runtime.fronts import front
from report.shared.arithmetic import log_slope
from report.shared.timing import cell, widest

PADS = {"as-shipped": "shipped pads", "stiff": "stiff pads"}
LABELS = {
    "newton": "Warp, Newton's contacts",
    "newton-each-substep": "the same, contacts anew in each substep",
    "mujoco": "Warp, MuJoCo's contacts",
    "newton-rk4": "Warp, Newton's contacts, RK4",
    "mujoco-rk4": "Warp, MuJoCo's contacts, RK4",
    "cpu": "Warp on the CPU",
    "c": "MuJoCo C, one core",
    "c-rk4": "MuJoCo C, one core, RK4",
}
ENGINES = {"warp-cuda": "MuJoCo Warp on the GPU", "warp-cpu": "MuJoCo Warp on the CPU", "mujoco-c": "MuJoCo C"}
MODEL_KNOBS = ("cone", "impratio")
GRASP = "grasp_error_mm_per_cycle"


def with_shipped_steps(pads: str, method: str) -> str:
    """Name the case with the substeps as shipped."""
    return f"{pads}/{method}/substeps-{AS_SHIPPED.substeps}"


SHIPPED = with_shipped_steps("as-shipped", "newton")


@dataclass(frozen=True)
class Points:
    """The rows of the section by what they are."""

    results: Results
    settings: Sequence[Row]
    references: Sequence[Row]
    worlds: Sequence[Row]
    """Many worlds at once, fewest first."""
    floors: dict[str, Value]
    """By pads: how far Warp is from C with the same steps [mm]."""
    front: frozenset[str]
    """Cases that no other setting of the same pads and model beats in numerical error and run time."""
    backend_front: frozenset[str]
    """The same among those of one backend."""

    @property
    def warp(self) -> str:
        """The backend that Warp was measured with first of all: the GPU where there is one."""
        return self.results.row[SHIPPED].backend

    def ladder(self, pads: str, method: str) -> list[Row]:
        """Select a method's points, coarsest first."""
        mine = (row for row in self.settings if (row["pads"], row.method, row.knob) == (pads, method, "substeps"))
        return sorted(mine, key=lambda row: row.substeps.value)

    def knobs(self, pads: str) -> list[Row]:
        """Select the points where something else than the substeps is varied."""
        return [row for row in self.settings if row["pads"] == pads and row.knob != "substeps"]

    def cell(self, case: str, column: str) -> Quantity:
        return cell(self.results, self.results.row.get(case), column, case)

    @property
    def engines(self) -> tuple[str, str]:
        """The two backends to compare."""
        return self.warp, "mujoco-c"

    def shipped(self, pads: str, backend: str) -> Row | None:
        """Look up the settings as shipped on a backend, where they count."""
        method = {"mujoco-c": "c", "warp-cpu": "cpu"}.get(backend, "newton")
        row = self.results.row.get(with_shipped_steps(pads, method))
        return row if row and counts(row) and row.backend == backend else None

    def recommended(self, pads: str, backend: str) -> Row | None:
        """Find what to set in place of the shipped settings on a backend; None where these are best or do not count."""
        shipped = self.shipped(pads, backend)
        rows = [row for row in self.settings if counts(row) and (row["pads"], row.backend) == (pads, backend)]
        return shipped and no_worse(rows, shipped)

    def reference(self, pads: str) -> Row | None:
        """Look up the converged solution with the cone and impratio as shipped."""
        return next((row for row in self.references if row["pads"] == pads and is_own_model(row)), None)


def no_worse(rows: Sequence[Row], shipped: Row) -> Row | None:
    """Find the fastest row of the same model that is no farther from its solution than ``shipped``, if not itself.

    Where the contacts' timeconst is raised, or cone or impratio are others, it is another model.
    """
    own = [row for row in rows if is_own_model(row) and not is_clamped(row)]
    closer = [row for row in own if row[ERROR].value <= shipped[ERROR].value]
    fastest = min(closer, key=lambda row: row[TIME].value, default=shipped)
    return None if fastest.case == shipped.case else fastest


def points_of(results: Results) -> Points:
    settings = [row for row in results.rows if row.method in LABELS and row.knob and row["pads"] in PADS]
    own_model = [row for row in settings if counts(row) and is_own_model(row)]
    return Points(
        results=results,
        settings=settings,
        references=[row for row in results.rows if row.method == "reference"],
        worlds=[row for row in results.rows if row.case.startswith("worlds-")],
        floors={pads: _floor(results, settings, pads) for pads in PADS},
        front=front(own_model, ERROR, ("pads",)),
        backend_front=front(own_model, ERROR, ("pads", "backend")),
    )


def _floor(results: Results, settings: Sequence[Row], pads: str) -> Value:
    cells = [
        row.c_difference_mm
        for row in settings
        if (row["pads"], row.knob) == (pads, "substeps")
        and row.method in ("newton", "newton-each-substep", "mujoco")
        and row.substeps.value >= AS_SHIPPED.substeps
    ]
    formula = "largest distance between a run in Warp and the same in C, from the shipped number of substeps on"
    return results.value(f"floor_{pads}", formula, max, *cells, unit="mm")


def time_range(points: Points, name: str, *cases: str) -> Value:
    """Derive how far apart the times of one run are, of these cases the one where it is most."""
    edges = [points.cell(case, f"{TIME}_{edge}") for case in cases for edge in ("p5", "p95")]
    formula = "largest of the ranges from the 5th to the 95th percentile of the run time"
    return points.results.value(name, formula, widest, *edges, unit="ms/s")


def is_own_model(row: Row) -> bool:
    """Tell whether cone and impratio are as shipped, so that the errors of two rows are from one solution."""
    return not any(name in row for name in MODEL_KNOBS)


def is_clamped(row: Row) -> bool:
    """Tell whether MuJoCo raises the contacts' timeconst to two substeps."""
    cells = row.timeconst_ms.value, row.substep_ms.value
    return None in cells or cells[0] < 2.0 * cells[1]


def order_of(points: Points, pads: str, method: str) -> Value:
    """Derive the order of convergence over the points whose model is the same, well above what Warp resolves."""
    floor = points.floors[pads].value or 0.0
    above = 5.0 * floor if method.startswith(("newton", "mujoco", "cpu")) else 0.0
    used = [
        row
        for row in points.ladder(pads, method)
        if counts(row) and not is_clamped(row) and (row.numerical_error_mm.value or 0.0) > above
    ]
    return points.results.value(
        f"order_{pads}_{method}",
        "slope of log error against log step, over the points that count, leave the timeconst alone and are above five "
        "times the floor of Warp",
        lambda *cells: log_slope(cells[::2], cells[1::2]) if len(cells) >= 4 else math.nan,
        *(quantity for row in used for quantity in (row.substep_ms, row.numerical_error_mm)),
    )


def front_rows(points: Points, cases: frozenset[str]) -> list[Row]:
    """Select the rows on a front of numerical error and run time, by pads and rising time."""
    rows = [row for row in points.settings if row.case in cases]
    return sorted(rows, key=lambda row: (list(PADS).index(row["pads"]), row.ms_per_s.value or 0.0))


def distinct(points: Points, front: Sequence[Row]) -> list[Row]:
    """Leave out of a front rows of Warp that gain less on the row before than Warp's floor: no one can tell that."""
    kept: list[Row] = []
    for row in front:
        before = [other[ERROR].value for other in kept if other["pads"] == row["pads"]]
        floor = 0.0 if row.backend == "mujoco-c" else points.floors[row["pads"]].value or 0.0
        if not before or row[ERROR].value < before[-1] - floor:
            kept.append(row)
    return kept


def assignment(row: Row, name: str) -> Markup:
    """Write a parameter as one sets it in the scene."""
    value = row[name]
    return Markup("{}={}").format(name, value.code if isinstance(value, Quantity) else value)


def named(rows: Sequence[Row]) -> Markup:
    """Name settings in words, without saying of the pads."""
    by_method: dict[str, dict[str, Markup]] = {}
    for row in rows:
        text = Markup("<code>{}</code>").format(assignment(row, row.knob))
        by_method.setdefault(row.method, {}).setdefault(f"{row.knob} {row[row.knob]}", text)
    phrases = [
        Markup("{} with {}").format(LABELS[method], Markup(", ").join(knobs.values()))
        for method, knobs in by_method.items()
    ]
    return Markup("; ").join(phrases)
