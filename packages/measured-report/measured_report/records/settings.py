"""Settings: what was chosen for a case and not measured of it."""

import ast
from collections.abc import Mapping
from functools import cache
from typing import Any

from measured_report import ROOT

CASE = ROOT / "experiments" / "facts" / "case.py"
WORLDS = {"worlds", "world_count"}
COUNTS = {"cycle_count", "repeat_count", "run_count", "frame_count", "seed_count"}
"""How much was run."""
TIMES = {"shake_start_s", "shake_duration_s", "cube_edge_mm", "overlap_mm", "authored", "authored_m", "authored_s"}
"""Parameters of a case in other units, and those that a person types."""
RATIOS = {"step_ms", "timeconst_steps", "cube_mass_kg", "grip_ratio"}
"""What parameters of a case make together."""
GIVEN = {
    *("dampratio", "dmin", "dmax", "friction", "friction_timeconst_s", "friction_dampratio"),
    *("timeconst_s", "timeconst_ms", "friction_damping_per_s", "substep_ms", "timestep", "used_m", "used_s", "value"),
    *("largest_step_ms", "failing_step_ms"),
}
"""What the engine was given, made from settings or chosen among steps: exact, though a section may be about it."""


@cache
def settings() -> frozenset[str]:
    """Columns that hold what was set before a run: parameters of a case, and how much was run."""
    return case_settings() | COUNTS | TIMES | RATIOS


@cache
def case_settings() -> frozenset[str]:
    """Columns that hold parameters of ``experiments.facts.case.Case``, or the number of worlds."""
    return frozenset(_parameters()) | WORLDS


def from_shipped(row: Mapping[str, Any]) -> dict[str, Any]:
    """The settings of a row that differ from those of the scene as shipped."""
    shipped = {name: ast.literal_eval(value) for name, value in _parameters().items() if value}
    return {name: cell for name, cell in row.items() if name in shipped and cell != shipped[name]}


@cache
def _parameters() -> Mapping[str, ast.expr | None]:
    """The parameters of a case and their defaults, one that has a name of its own by its value.

    The module is read and not imported, so that nothing here depends on the experiments.
    """
    tree = ast.parse(CASE.read_text(encoding="utf-8"))
    named = {ast.unparse(node.targets[0]): node.value for node in tree.body if isinstance(node, ast.Assign)}
    case = next(node for node in tree.body if isinstance(node, ast.ClassDef) and node.name == "Case")
    fields = {ast.unparse(node.target): node.value for node in case.body if isinstance(node, ast.AnnAssign)}
    return {name: named[value.id] if isinstance(value, ast.Name) else value for name, value in fields.items()}


def is_exact(column: str, row: Mapping[str, Any]) -> bool:
    """Whether a column of a row holds what was set, or made from nothing but that, and so has no noise."""
    return column in settings() or column in GIVEN or (column == "used" and "authored" in row)


def is_setting(pointer: str) -> bool:
    """Whether a pointer into a record leads to a setting."""
    return pointer.rpartition("/")[2] in settings()
