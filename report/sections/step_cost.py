"""Compare the run time of a frame at each time step, in one world and in many."""

from experiments.facts.case import AS_SHIPPED
from report.shared import (
    TIMED_WORLDS,
    Claim,
    Quantity,
    Results,
    RowsBy,
    Section,
    Sections,
    at_least,
    resolution,
    table_of,
    worlds_name,
)

order = 127
page = "step"
label = "run time at each step"

STIFF = "stiff"  # the setting whose run time is measured at all steps
SETTINGS = {
    STIFF: "Newton's contacts, elliptic cone",
    "pyramidal": "Newton's contacts, pyramidal cone",
    "mujoco": "MuJoCo's contacts, elliptic cone",
    "mujoco-pyramidal": "MuJoCo's contacts, pyramidal cone",
    "cure": "the root cure, stiff pads",
    "rk4": "RK4",
}


def derive(results: Results) -> Section:
    rows = RowsBy(results, results.rows, "setting", "substeps", "worlds")
    worst = resolution(results, "resolution", results.rows)
    doubled = results.value(
        "doubled",
        "time of a frame with twice the shipped substeps divided by the time with the shipped ones,"
        " in one world",
        1 * rows[STIFF, 2 * AS_SHIPPED.substeps, 1].frame_ratio,
    )
    proportional = at_least(doubled, 1.8, "nearly twice the time")
    numbers = {
        "shipped": rows[STIFF, AS_SHIPPED.substeps, 1].substeps,
        "more": rows[STIFF, 2 * AS_SHIPPED.substeps, 1].substeps,
        "doubled": doubled,
    }
    settings = list(dict.fromkeys(key[:2] for key in rows if key[0] in SETTINGS))
    columns: dict[str, list] = {
        "substeps": [
            next(row.substeps for key, row in rows.items() if key[:2] == setting)
            for setting in settings
        ]
    }
    for count in TIMED_WORLDS:
        columns[worlds_name(count)] = [
            rows[(*setting, count)].frame_ratio if (*setting, count) in rows else ""
            for setting in settings
        ]
    names = [SETTINGS[setting] for setting, _ in settings]
    return Section(
        tables={
            "times": table_of("setting", names, columns, resolution=worst),
        },
        claims=[Claim("proportional", proportional, numbers)],
    )


def ratios(
    sections: Sections, setting: str = STIFF, worlds: int = TIMED_WORLDS[0]
) -> dict[int, Quantity]:
    """Return the run times relative to the scene as shipped, by number of substeps."""
    return {
        row.plain["substeps"]: row.frame_ratio
        for row in sections.rows("step_cost")
        if (row.plain["setting"], row.plain["worlds"]) == (setting, worlds)
        and row.frame_ratio.value is not None
    }
