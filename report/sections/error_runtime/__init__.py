"""Error against run time: the cheapest setting for an error, and what the expensive knobs buy."""

from collections.abc import Mapping, Sequence
from typing import Any

from markupsafe import Markup

from measured_report.claims.claim import HOLDS
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.results import Results, Row
from report.sections.error_runtime.claims import accuracy_claims, knob_claims, model_claims
from report.sections.error_runtime.figures import draw_grasp, draw_numerical
from report.sections.error_runtime.runs import (
    ENGINES,
    ERROR,
    GRASP,
    LABELS,
    PADS,
    TIME,
    Points,
    assignment,
    counts,
    hit_iteration_limit,
    is_clamped,
    points_of,
    with_shipped_steps,
)
from report.sections.error_runtime.worlds import derive_worlds
from report.shared.arithmetic import Column, table_of

order = 155
page = "error"
label = "error and run time"

PARAMETERS = ("iterations", "ls_iterations", "solver", "cone", "impratio", "integrator", "contacts", "collide_count")
"""Parameters that a setting may change beside its pads and substeps, as they are called in the scene."""
SHOWN: dict[str, Column] = {"numerical error": ERROR, "grasp error": GRASP}


def derive(results: Results) -> Section:
    points = points_of(results)
    worlds_figure, worlds_claim = derive_worlds(points)
    soft, stiff = map(points.converged, PADS)
    of_models = model_claims(points)
    pads_decide = any(claim.name == "pads_decide" and claim.outcome == HOLDS for claim in of_models)
    grasp_numbers = _as_shipped(points, GRASP) | {"soft": soft, "stiff": stiff, "pads_decide": pads_decide}
    errors, grasp_errors = ([row[column] for row in points.settings] for column in (ERROR, GRASP))
    return Section(
        tables={
            "marked": _marked_table(points),
            "front": _front_table(points.best(points.front)),
            "warp_front": _front_table(points.best(points.backend_front, points.engines[:1])),
            "knobs": _knob_table(points),
            "failures": _failure_table(points),
        },
        figures={
            "numerical": Figure(lambda: draw_numerical(points), errors, _as_shipped(points, ERROR)),
            "grasp": Figure(lambda: draw_grasp(points), grasp_errors, grasp_numbers),
            "worlds": worlds_figure,
        },
        claims=[*accuracy_claims(points), *knob_claims(points), *of_models, worlds_claim],
    )


def _as_shipped(points: Points, error: str) -> dict[str, Any]:
    """Write by engine the errors as shipped with either pads, and the run time with the first."""
    found = {}
    for name, backend in zip(("warp", "c"), points.engines, strict=True):
        rows = [row for row in (points.shipped(pads, backend) for pads in PADS) if row]
        errors = Markup(" and ").join(Markup("{}").format(row[error]) for row in rows) or Markup("nothing that counts")
        found[name] = errors + (Markup(" in {}").format(rows[0][TIME]) if rows else "")
    return found


def _front_table(rows: Sequence[Row]) -> Table:
    engines = set(map(_engine, rows))
    alone = engines.pop() if len(engines) == 1 else ""
    columns = {
        **({} if alone else {"engine": _engine}),
        "settings": _settings,
        **SHOWN,
        "clamped": is_clamped,
        "friction used": "cone_use_max",
        "time": TIME,
        "from": f"{TIME}_p5",
        "to": f"{TIME}_p95",
    }
    has_warp = any(row.backend != "mujoco-c" for row in rows)
    return _numbered(rows, columns, engine=alone, has_warp=has_warp)


def _marked_table(points: Points) -> Table:
    """Show what the figures mark: the shipped settings, and what is recommended in their place."""
    found = [
        (name, row)
        for pads in PADS
        for backend in points.engines
        for name, find in (("shipped", points.shipped), ("recommended", points.recommended))
        if (row := find(pads, backend))
    ]
    columns = {"engine": _engine, "setting": [name for name, _ in found], "to copy": _settings, **SHOWN, "time": TIME}
    rows = [row for _, row in found]
    return table_of("pads", map(_pads, rows), columns, rows)


def _pads(row: Row) -> str:
    return PADS[row["pads"]]


def _engine(row: Row) -> str:
    return ENGINES.get(row.backend, "")


def _settings(row: Row) -> Markup:
    """Write what to set, as the parameters are called in the scene."""
    parts = [assignment(row, name) for name in ("substeps", *PARAMETERS) if name in row]
    return Markup("<code>{}</code>").format(Markup(", ").join(parts))


def _numbered(rows: Sequence[Row], columns: Mapping[str, Column], **numbers) -> Table:
    """Make a table of numbered settings, with their pads first."""
    return table_of("#", map(str, range(1, len(rows) + 1)), {"pads": _pads, **columns}, rows, **numbers)


def _knob_table(points: Points) -> Table:
    """Show each knob beside the setting as shipped from which it is turned."""
    shipped = [with_shipped_steps(pads, "newton") for pads in PADS]
    rows = [row for row in points.settings if row.method == "newton"]
    rows = [row for row in rows if row.knob != "substeps" or row.case in shipped]
    rows.sort(key=lambda row: (list(PADS).index(row["pads"]), row.knob != "substeps"))
    columns = {"changed": _changed, **SHOWN, "time": TIME, "most iterations": "iteration_peak_count"}
    return _numbered(rows, columns)


def _changed(row: Row) -> Markup | str:
    return "nothing" if row.knob == "substeps" else Markup("<code>{}</code>").format(assignment(row, row.knob))


def _failure_table(points: Points) -> Table:
    rows = [row for row in points.settings if not counts(row)]
    columns: dict[str, Column] = {
        "method": lambda row: LABELS[row.method],
        "settings": _settings,
        "why it does not count": "invalid_reason",
        # How far away a cube lies that has left the grasp is no error.
        "numerical error": lambda row: row[ERROR] if hit_iteration_limit(row) else "gone",
    }
    return _numbered(rows, columns)
