"""Error against run time: the cheapest setting for an error, and what the expensive knobs buy."""

from collections.abc import Mapping, Sequence
from typing import Any

import pandas as pd
from markupsafe import Markup

from measured_report.claims.claims import HOLDS
from measured_report.parts.parts import Figure, Section, Table
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results, Row
from report.sections.error_runtime.claims import accuracy_claims
from report.sections.error_runtime.counting import counts, hit_iteration_limit
from report.sections.error_runtime.figures import draw_grasp, draw_numerical
from report.sections.error_runtime.knobs import knob_claims, model_claims
from report.sections.error_runtime.runs import (
    ENGINES,
    ERROR,
    GRASP,
    LABELS,
    PADS,
    TIME,
    Points,
    assignment,
    distinct,
    front_rows,
    is_clamped,
    order_of,
    points_of,
    with_shipped_steps,
)
from report.sections.error_runtime.worlds import derive_worlds
from report.shared.arithmetic import cell_or_absent

order = 155
page = "error"
label = "error and run time"

PARAMETERS = ("iterations", "ls_iterations", "solver", "cone", "impratio", "integrator", "contacts", "collide_count")
"""Parameters that a setting may change beside its pads and substeps, as they are called in the scene."""


def derive(results: Results) -> Section:
    points = points_of(results)
    orders = {(pads, method): order_of(points, pads, method) for pads in PADS for method in LABELS}
    front = front_rows(points, points.front)
    warp_front = [row for row in front_rows(points, points.backend_front) if row.backend == points.warp]
    worlds_figure, worlds_claim = derive_worlds(points)
    references = [points.reference(pads) for pads in PADS]
    converged = [cell_or_absent(reference, GRASP, "mm/cycle") for reference in references]
    of_models = model_claims(points)
    pads_decide = any(claim.name == "pads_decide" and claim.outcome == HOLDS for claim in of_models)
    return Section(
        tables={
            "marked": _marked_table(points),
            "front": _front_table(distinct(points, front)),
            "warp_front": _front_table(distinct(points, warp_front)),
            "knobs": _knob_table(points),
            "failures": _failure_table(points),
        },
        figures={
            "numerical": Figure(
                draw=lambda: draw_numerical(points),
                sources=[row.numerical_error_mm for row in points.settings],
                numbers=_as_shipped(points, ERROR),
            ),
            "grasp": Figure(
                draw=lambda: draw_grasp(points),
                sources=[row.grasp_error_mm_per_cycle for row in points.settings],
                numbers=_as_shipped(points, GRASP)
                | {"soft": converged[0], "stiff": converged[1], "pads_decide": pads_decide},
            ),
            "worlds": worlds_figure,
        },
        claims=[*accuracy_claims(points, orders), *knob_claims(points), *of_models, worlds_claim],
    )


def _as_shipped(points: Points, error: str) -> dict[str, Markup]:
    """By engine: the errors as shipped with either pads, and the run time with the first."""
    found = {}
    for name, backend in zip(("warp", "c"), points.engines, strict=True):
        rows = [row for row in (points.shipped(pads, backend) for pads in PADS) if row]
        errors = Markup(" and ").join(Markup("{}").format(row[error]) for row in rows) or Markup("nothing that counts")
        found[name] = errors + (Markup(" in {}").format(rows[0][TIME]) if rows else "")
    return found


def _front_table(rows: Sequence[Row]) -> Table:
    engines = [ENGINES.get(row.backend, "") for row in rows]
    alone = engines[0] if len(set(engines)) == 1 else ""
    columns = {
        "pads": [PADS[row["pads"]] for row in rows],
        **({} if alone else {"engine": engines}),
        "settings": [_settings(row) for row in rows],
        "numerical error": [row.numerical_error_mm for row in rows],
        "grasp error": [row.grasp_error_mm_per_cycle for row in rows],
        "clamped": [is_clamped(row) for row in rows],
        "friction used": [row.cone_use_max for row in rows],
        "time": [row.ms_per_s for row in rows],
        "from": [row.ms_per_s_p5 for row in rows],
        "to": [row.ms_per_s_p95 for row in rows],
    }
    has_warp = any(row.backend != "mujoco-c" for row in rows)
    return Table(_numbered(columns), {"engine": alone, "has_warp": has_warp})


def _marked_table(points: Points) -> Table:
    """What the figures mark: the shipped settings, and what is recommended in their place."""
    found = [
        (pads, backend, name, row)
        for pads in PADS
        for backend in points.engines
        for name, row in (
            ("shipped", points.shipped(pads, backend)),
            ("recommended", points.recommended(pads, backend)),
        )
        if row
    ]
    columns = {
        "engine": [ENGINES[backend] for _, backend, _, _ in found],
        "setting": [name for _, _, name, _ in found],
        "to copy": [_settings(row) for *_, row in found],
        "numerical error": [row[ERROR] for *_, row in found],
        "grasp error": [row[GRASP] for *_, row in found],
        "time": [row[TIME] for *_, row in found],
    }
    frame = pd.DataFrame(columns, index=pd.Index([PADS[pads] for pads, *_ in found], name="pads"), dtype=object)
    return Table(frame)


def _settings(row: Row) -> Markup:
    """What to set, as the parameters are called in the scene."""
    parts = [assignment(row, name) for name in ("substeps", *PARAMETERS) if name in row]
    return Markup("<code>{}</code>").format(Markup(", ").join(parts))


def _numbered(columns: Mapping[str, Any]) -> pd.DataFrame:
    count = len(next(iter(columns.values())))
    return pd.DataFrame(
        columns, index=pd.Index([str(number) for number in range(1, count + 1)], name="#"), dtype=object
    )


def _knob_table(points: Points) -> Table:
    """Each knob beside the setting as shipped from which it is turned."""
    rows = []
    for pads in PADS:
        base = points.results.row.get(with_shipped_steps(pads, "newton"))
        rows += ([base] if base else []) + [row for row in points.knobs(pads) if row.method == "newton"]
    columns = {
        "pads": [PADS[row["pads"]] for row in rows],
        "changed": [_changed(row) for row in rows],
        "numerical error": [row.numerical_error_mm for row in rows],
        "grasp error": [row.grasp_error_mm_per_cycle for row in rows],
        "time": [row.ms_per_s for row in rows],
        "most iterations": [row.iteration_peak_count for row in rows],
    }
    return Table(_numbered(columns))


def _changed(row: Row) -> Markup | str:
    return "nothing" if row.knob == "substeps" else Markup("<code>{}</code>").format(assignment(row, row.knob))


def _failure_table(points: Points) -> Table:
    rows = [row for row in points.settings if not counts(row)]
    columns = {
        "pads": [PADS[row["pads"]] for row in rows],
        "method": [LABELS[row.method] for row in rows],
        "settings": [_settings(row) for row in rows],
        "why it does not count": [row.invalid_reason for row in rows],
        "numerical error": [_shown(row) for row in rows],
    }
    return Table(_numbered(columns))


def _shown(row: Row) -> Quantity | str:
    """How far away a cube lies that has left the grasp is no error."""
    return row.numerical_error_mm if hit_iteration_limit(row) else "gone"
