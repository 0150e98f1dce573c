"""Compare the backends of Newton's solver Kamino with each other."""

from report.shared import (
    Claim,
    Results,
    RowsBy,
    Section,
    all_of,
    at_most,
    decided,
    greater,
    measurable_creep,
    table_of,
    worlds_name,
)

order = 189
page = "scenes"
label = "Kamino's backends"

BACKENDS = {"padmm": "PADMM, the default", "dvi": "DVI", "lox": "LOX"}
NEW = ("dvi", "lox")
WORLDS = (1, 64)
COARSE = "4-substeps"
NEW_CLAIMS = ("new_hold", "fingers_stay", "new_faster")


def derive(results: Results) -> Section:
    rows = RowsBy(results, results.rows, "variant", "shake")
    times = RowsBy(results, results.rows, "variant", "worlds")
    backends = [name for name in BACKENDS if (name, "3cm") in rows]
    near = [rows[name, "3cm"] for name in backends]
    coarse = [rows[name, COARSE] for name in backends]
    columns = {
        "slip": "slip_mm",
        "creep": map(measurable_creep, near),
        "slip, shaken 100 mm": [rows[name, "10cm"].slip_mm for name in backends],
        "slip with weight": [rows[name, "weight"].slip_mm for name in backends],
        "slip with few substeps": [row.slip_mm for row in coarse],
        "fingers off their joints": "joint_error_mm",
        "with few substeps": [row.joint_error_mm for row in coarse],
    }
    for count in WORLDS:
        columns[f"time of a frame, {worlds_name(count)}"] = [
            times[name, count].frame_ratio for name in backends
        ]
    names = [BACKENDS[name] for name in backends]
    tables = {
        "backends": table_of(
            "backend", names, columns, near, few=rows["padmm", COARSE].substeps
        )
    }
    held = [name for name in NEW if name in backends]
    offered = decided(len(held) == len(NEW), rows["padmm", "3cm"].slip_mm)
    claims = [Claim("offered", offered)]
    if not held:
        return Section(tables, claims=claims, unmeasured=NEW_CLAIMS)
    bound = results.chosen("bound", "a tenth of a slip that can be seen", 0.1, "mm")
    slips = {name: rows[name, "3cm"].slip_mm for name in NEW}
    claims.append(
        Claim(
            "new_hold",
            all_of(*(at_most(slip, bound) for slip in slips.values())),
            slips | {"bound": bound},
        )
    )
    errors = {name: rows[name, COARSE].joint_error_mm for name in BACKENDS}
    closer = all_of(*(greater(errors["padmm"], errors[name]) for name in NEW))
    substeps = rows["padmm", COARSE].substeps
    claims.append(Claim("fingers_stay", closer, errors | {"substeps": substeps}))
    ratios = {name: times[name, WORLDS[0]].frame_ratio for name in BACKENDS}
    faster = all_of(*(greater(ratios["padmm"], ratios[name]) for name in NEW))
    claims.append(Claim("new_faster", faster, ratios))
    return Section(tables, claims=claims)
