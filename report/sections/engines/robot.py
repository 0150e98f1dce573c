"""Compare the shake in other engines with the shake in MuJoCo."""

from report.shared import (
    Claim,
    Outcome,
    Results,
    RowsBy,
    Section,
    Sections,
    all_of,
    cell_count,
    cell_or_lost,
    decided,
    extreme,
    greater,
    measurable_creep,
    table_of,
)

MUJOCO = "mujoco-c"
ARMATURES = {"own": "own parameter", "links": "in the links"}


def derive(results: Results, labels: dict[str, str]) -> Section:
    """Make the table of the models, with names from ``labels``, and the claims about
    it."""
    rows = RowsBy(results, results.rows, "model", "shake")
    models = list(dict.fromkeys(model for model, _ in rows))
    near = [rows[model, "3cm"] for model in models]
    columns = {
        "slip": "slip_mm",
        "creep": map(measurable_creep, near),
        "slip in a shake of 100 mm": [
            cell_or_lost(rows[model, "10cm"], "slip_mm") for model in models
        ],
        "slip with the arm held still": [
            cell_or_lost(rows[model, "held"], "slip_mm") for model in models
        ],
        "ratio of tangential to normal force": "friction_share",
        "penetration": "penetration_mm",
        "path difference": "path_off_mm",
        "armature": [ARMATURES.get(row.plain.get("armature"), "") for row in near],
    }
    names = [{MUJOCO: "MuJoCo C", **labels}[model] for model in models]
    step = results.chosen(
        "robot_step", "given: the time step of the shake", 1000.0 / 960.0, "ms"
    )
    table = table_of("engine", names, columns, near, step=step)

    # Test whether the cube slips farther in MuJoCo than in any other engine that keeps
    # it.
    others = [model for model in models if model != MUJOCO]
    slip = rows[MUJOCO, "3cm"].slip_mm
    held = rows[MUJOCO, "held"].slip_mm
    slips = [rows[model, "3cm"].slip_mm for model in others]
    slips = [cell for cell in slips if cell.value is not None]
    still = [rows[model, "held"].slip_mm for model in others]
    worst = results.value(
        "robot_worst", "largest slip in another engine", extreme(max, slips)
    )
    count = results.value(
        "robot_count", "other contact models that keep the cube", cell_count(slips)
    )
    still_worst = results.value(
        "robot_worst_held",
        "largest slip in another engine with the arm held still",
        extreme(max, still),
    )
    stiff = Sections(results.others).cell("solver", "stiff-pads-mujoco-c", "slip_mm")
    # This slip was measured on another machine. The comparison is valid because runs of
    # MuJoCo C are bit-identical.
    is_less = None not in (stiff.value, slip.value) and stiff.value < slip.value
    farthest = all_of(
        *(greater(slip, other_slip) for other_slip in (worst, held, still_worst)),
        decided(is_less, stiff),
    )

    wide = [rows[model, "10cm"] for model in (MUJOCO, *others)]
    is_lost, *are_lost = (row.plain.get("dropped") for row in wide)
    amplitudes = [row.shake_amplitude_m for row in wide]
    loses = decided(is_lost is True and not any(are_lost), *amplitudes)
    if None in (is_lost, *are_lost):
        loses = Outcome("unknown", "one of these runs failed, or was not measured")
        loses = loses.having_read(*amplitudes)
    numbers = {
        "mine": slip,
        "held": held,
        "worst": worst,
        "count": count,
        "stiff": stiff,
        "still": still_worst,
    }
    return Section(
        tables={"robots": table},
        claims=[
            Claim("slips_farthest", farthest, numbers),
            Claim("only_it_loses", loses, {"wide": amplitudes[0]}),
        ],
    )
