"""Compare the backends of Newton's solver Kamino with each other."""

from report.shared import (
    Claim,
    Results,
    RowsBy,
    Section,
    Sections,
    all_of,
    at_most,
    greater,
    measurable_creep,
    table_of,
    worlds_name,
)

order = 189
page = "scenes"
reads = ("newton_solvers",)
label = "Kamino's backends"

BACKENDS = {"padmm": "PADMM, the default", "dvi": "DVI", "lox": "LOX"}
NEW = ("dvi", "lox")
SHAKES = ("3cm", "weight", "10cm")
WORLDS = (1, 64)
COARSE = "4-substeps"


def derive(results: Results) -> Section:
    """Derive the section. Section newton_solvers measured most shakes of the default."""
    rows = RowsBy(results, results.rows, "variant", "shake")
    times = RowsBy(results, results.rows, "variant", "worlds")
    for row in Sections(results.others).rows("newton_solvers"):
        if row.plain.get("variant") == "kamino" and row.plain.get("shake") in SHAKES:
            rows["padmm", row.plain["shake"]] = row
    near, weight, far = (
        {name: rows[name, shake] for name in BACKENDS} for shake in SHAKES
    )
    coarse = {name: rows[name, COARSE] for name in BACKENDS}
    columns = {
        "slip": [row.slip_mm for row in near.values()],
        "creep": map(measurable_creep, near.values()),
        "slip with weight": [row.slip_mm for row in weight.values()],
        "slip, shaken 100 mm": [row.slip_mm for row in far.values()],
        "slip with few substeps": [row.slip_mm for row in coarse.values()],
        "fingers off their joints, few substeps": [
            row.joint_error_mm for row in coarse.values()
        ],
    }
    ratios = {}
    for count in WORLDS:
        ratios[count] = {name: times[name, count].frame_ratio for name in BACKENDS}
        title = f"time of a frame, {worlds_name(count)}"
        columns[title] = list(ratios[count].values())
    substeps = coarse["padmm"].substeps
    table = table_of("backend", BACKENDS.values(), columns, few=substeps)

    bound = results.chosen("bound", "a tenth of a slip that can be seen", 0.1, "mm")
    slips = {name: weight[name].slip_mm for name in BACKENDS}
    hold = all_of(*(at_most(slips[name], bound) for name in NEW))
    errors = {name: row.joint_error_mm for name, row in coarse.items()}
    closer = all_of(*(greater(errors["padmm"], errors[name]) for name in NEW))
    one = ratios[WORLDS[0]]
    faster = all_of(*(greater(one["padmm"], one[name]) for name in NEW))
    return Section(
        {"backends": table},
        claims=[
            Claim(
                "new_hold", hold.having_read(*slips.values()), slips | {"bound": bound}
            ),
            Claim("fingers_stay", closer, errors | {"substeps": substeps}),
            Claim("new_faster", faster, one),
        ],
    )
