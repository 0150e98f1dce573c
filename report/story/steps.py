"""Show the pads to paste at each time step, and the resulting slip, on the front page."""

from report.sections import step_cost
from report.sections.time_step import ladder
from report.shared import Quantity, Row, Sections, Table, table_of

NAMES = {
    "newton-elliptic": "Newton, elliptic",
    "newton-pyramidal": "Newton, pyramidal",
    "mujoco-elliptic": "MuJoCo, elliptic",
    "mujoco-pyramidal": "MuJoCo, pyramidal",
}
"""Source of the contacts and friction cone, by setting of section ladder."""


def table(sections: Sections) -> Table | None:
    """Make a table with a line for each step, or return None if no step was measured."""
    runs = {
        (row.plain["setting"], row.plain["substeps"]): row
        for row in sections.rows("time_step")
        if row.plain["pads"] == ladder.RULES.get(row.plain["setting"])
    }
    pads = [row for (setting, _), row in runs.items() if setting == ladder.NEWTON]
    if not pads:
        return None
    ratios = step_cost.ratios(sections)
    counts = [row.plain["substeps"] for row in pads]
    gentle = [runs.get((ladder.PYRAMIDAL, count)) for count in counts]
    columns: dict[str, list] = {
        "kd": [row.pad_kd for row in pads],
        "ke, elliptic": [row.pad_ke for row in pads],
        "ke, pyramidal": [row.pad_ke if row else "" for row in gentle],
    }
    for setting, name in NAMES.items():
        columns[f"slip, {name}"] = [
            _slip(runs.get((setting, count))) for count in counts
        ]
    columns["run time, relative to the shipped step"] = [
        ratios.get(count, "") for count in counts
    ]
    return table_of("step", [row.substep_ms for row in pads], columns)


def _slip(row: Row | None) -> Quantity | str:
    """Return the slip of a run, "lost" if the run loses the cube, or an empty text if
    there is no run.
    """
    if row is None:
        return ""
    is_lost = row.plain.get("dropped") or row.slip_mm.value is None
    return "lost" if is_lost else row.slip_mm
