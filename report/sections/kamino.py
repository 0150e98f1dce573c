"""Compare the backends of Newton's solver Kamino with each other."""

from report.shared import (
    Claim,
    Results,
    RowsBy,
    Section,
    Sections,
    all_of,
    at_most,
    departure,
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
    measured = {variant for variant, _ in rows}
    offered = [name for name in BACKENDS if name in measured]
    near, weight, far = (
        {name: rows[name, shake] for name in offered} for shake in SHAKES
    )
    coarse = {name: rows[name, COARSE] for name in offered}
    columns = {
        "slip": [row.slip_mm for row in near.values()],
        "creep": map(measurable_creep, near.values()),
        "slip with weight": [row.slip_mm for row in weight.values()],
        "slip in a shake of 100 mm": [row.slip_mm for row in far.values()],
        "slip with few substeps": [row.slip_mm for row in coarse.values()],
        "distance of a finger from its joint, few substeps": [
            row.joint_error_mm for row in coarse.values()
        ],
    }
    for count in WORLDS:
        if ("padmm", count) in times:  # the record of a CPU has one world only
            columns[f"time of a frame, {worlds_name(count)}"] = [
                times[name, count].frame_ratio for name in offered
            ]
    substeps = rows["padmm", COARSE].substeps
    table = table_of(
        "backend", [BACKENDS[name] for name in offered], columns, few=substeps
    )
    if not set(NEW) <= set(offered):
        return Section({"backends": table}, unmeasured=("new_hold", "new_faster"))

    commanded = Sections(results.others).cell(
        "newton_solvers", "warp-3cm", "hand_amplitude_mm"
    )
    results.chosen("as_far", "as in section newton_solvers", 10.0, "%")
    for name in NEW:
        results.value(
            f"{name}_hand",
            "absolute difference between the amplitude of the hand and its amplitude in MuJoCo"
            " Warp, relative to the latter",
            departure(near[name].hand_amplitude_mm, commanded),
            across=True,
        )
    bound = results.chosen("bound", "a tenth of a slip that can be seen", 0.1, "mm")
    slips = {name: row.slip_mm for name, row in weight.items()}
    hold = all_of(*(at_most(slips[name], bound) for name in NEW))
    one = {name: times[name, WORLDS[0]].frame_ratio for name in offered}
    faster = all_of(*(greater(one["padmm"], one[name]) for name in NEW))
    return Section(
        {"backends": table},
        claims=[
            Claim(
                "new_hold", hold.having_read(*slips.values()), slips | {"bound": bound}
            ),
            Claim("new_faster", faster, one),
        ],
    )
