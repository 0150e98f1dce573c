"""Settings: what was chosen for a case and not measured of it."""

import ast
from functools import cache

from report import ROOT

CASE = ROOT / "experiments" / "case.py"
WORLDS = {"worlds", "world_count"}
COUNTS = {"cycle_count", "repeat_count", "run_count", "frame_count"}
"""How much was run."""
TIMES = {"shake_start_s", "shake_duration_s", "cube_edge_mm", "overlap_mm", "authored", "authored_m", "authored_s"}
"""Parameters of a case in other units, and those that a person types."""
RATIOS = {"step_ms", "timeconst_steps", "cube_mass_kg", "grip_ratio"}
"""What parameters of a case make together."""
GIVEN = {
    *("dampratio", "dmin", "dmax", "friction", "friction_timeconst_s", "friction_dampratio"),
    *("timeconst_s", "timeconst_ms", "substep_ms", "timestep", "used", "used_m", "used_s"),
    *("largest_step_ms", "failing_step_ms"),
}
"""What the engine was given, made from settings or chosen among steps: exact, though a section may be about it."""


@cache
def settings() -> frozenset[str]:
    """Columns that hold what was set before a run: parameters of a case, and how much was run."""
    return case_settings() | COUNTS | TIMES | RATIOS


@cache
def case_settings() -> frozenset[str]:
    """Columns that hold parameters of ``experiments.case.Case``, or the number of worlds.

    The module is read and not imported, so that nothing here depends on the experiments.
    """
    tree = ast.parse(CASE.read_text(encoding="utf-8"))
    case = next(node for node in tree.body if isinstance(node, ast.ClassDef) and node.name == "Case")
    names = (node.target for node in case.body if isinstance(node, ast.AnnAssign))
    return frozenset(name.id for name in names if isinstance(name, ast.Name)) | WORLDS


def is_exact(column: str) -> bool:
    """Whether a column holds what was set, or made from nothing but that, and so has no noise."""
    return column in settings() or column in GIVEN


def is_setting(pointer: str) -> bool:
    """Whether a pointer into a record leads to a setting."""
    return pointer.rpartition("/")[2] in settings()
