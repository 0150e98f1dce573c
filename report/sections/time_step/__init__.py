"""Show the pads for each time step, the predicted slip and the run time."""

from experiments.facts.case import AS_SHIPPED
from report.sections import step_cost
from report.sections.time_step import claims
from report.sections.time_step.figures import slip_figure
from report.sections.time_step.ladder import COMPARED, ELLIPTIC, NEWTON, RULE, Ladder
from report.shared import (
    MS_PER_S,
    TIMED_WORLDS,
    Quantity,
    Results,
    Row,
    RowsBy,
    Section,
    Sections,
    Table,
    Value,
    absent,
    combined,
    is_held,
    table_of,
    worlds_name,
)

order = 128
page = "step"
reads = ("drift_law", "step_cost")
first = True
label = "time step"

SHARES = {
    "kd-0.125": "⅛/step",
    "kd-0.25": "¼/step",
    "kd-0.5": "½/step",
    RULE: "1/step",
    "kd-2": "2/step",
}
"""Pads with a damping ratio of 1, and their kd."""


def derive(results: Results) -> Section:
    """Derive the rule, its claims, and the tables of slips and run times."""
    rows = RowsBy(results, results.rows, "setting", "pads", "substeps")
    ladder = Ladder(results, rows)
    laws = {
        key: _predicted(results, rows[key], "_".join(map(str, key)))
        for key in rows
        if key[0] in ELLIPTIC and key[1] in COMPARED
    }
    shipped = claims.shipped(results, ladder)
    return Section(
        tables={"rule": _table(results, ladder, laws), "grid": _grid(ladder)},
        figures={"steps": slip_figure(ladder)},
        claims=[
            shipped,
            claims.is_best(results, ladder),
            claims.halves(results, ladder),
            claims.finest(ladder),
            claims.pyramid(ladder),
            claims.fixed_pads(ladder),
            claims.follows(results, ladder, laws),
            claims.margin(results, ladder),
            claims.fine(results, ladder, shipped),
        ],
    )


def _predicted(results: Results, row: Row, name: str) -> Value | Quantity:
    """Derive the slip of a run that the law of the drift predicts."""
    if not is_held(row) or "timeconst_s" not in row:
        return absent("mm", "the cube is lost")
    others = Sections(results.others)
    own = row.plain["friction_timeconst_s"] or 0.0
    timeconst = row.friction_timeconst_s if own > 0.0 else row.timeconst_s
    step = row.substep_ms / MS_PER_S
    response = row.dmax * combined(max, timeconst, 2 * step)
    return results.value(
        f"law_{name}",
        "duration of the shake times the drift that the law predicts: half of the mean of"
        " J̇q̇ times the response time minus the step",
        0.5 * others.value("drift_law", "g") * (response - step) * row.shake_duration_s,
    )


def _table(results: Results, ladder: Ladder, laws: dict) -> Table:
    """Make a table of the pads, slips and run times for each step."""
    others = Sections(results.others)
    counts = ladder.substeps()
    rows = [ladder.row(NEWTON, RULE, count) for count in counts]
    columns: dict[str, list] = {
        "substeps": [row.substeps for row in rows],
        "kd": [row.pad_kd for row in rows],
        "ke": [row.pad_ke for row in rows],
        "slip": [_slip_or_lost(row) for row in rows],
        "predicted by the law": [laws[NEWTON, RULE, count] for count in counts],
    }
    for pads in ("stiff", "shipped"):
        columns[f"{pads} pads"] = [
            _slip_or_lost(ladder.row(NEWTON, pads, count)) for count in counts
        ]
    for worlds in (TIMED_WORLDS[0], TIMED_WORLDS[-1]):
        ratios = step_cost.ratios(others, worlds=worlds)
        columns[f"run time relative to shipped, {worlds_name(worlds)}"] = [
            ratios.get(count, "") for count in counts
        ]
    steps = [row.substep_ms for row in rows]
    shipped = ladder.row(NEWTON, RULE, AS_SHIPPED.substeps).substeps
    return table_of("step", steps, columns, substeps=shipped)


def _grid(ladder: Ladder) -> Table:
    """Make a table of the slip for each step and kd, with a damping ratio of 1."""
    counts = ladder.substeps()
    steps = [ladder.row(NEWTON, RULE, count).substep_ms for count in counts]
    columns = {
        f"kd = {name}": [
            _slip_or_lost(ladder.row(NEWTON, pads, count)) for count in counts
        ]
        for pads, name in SHARES.items()
    }
    return table_of("step", steps, columns)


def _slip_or_lost(row: Row) -> Quantity | str:
    return "lost" if row.plain.get("dropped") else row.slip_mm
