"""Show the defaults of a release, and the slip with these defaults.

The scene uses the defaults of 1.4.0.
"""

from report.shared import Claim, Results, Section, all_of, cell_or_absent, decided

order = 205
page = "releases"
label = "own defaults"

RUN = ("frame_count", "device")  # parameters that are not defaults of the release
MUJOCO = {  # options with which MuJoCo finds the contacts, with a pyramidal cone
    "run_collision_detection": 1.0,
    "cone": 0.0,
}


def derive(results: Results) -> Section:
    row = results.row["own-defaults"]
    columns = results.columns
    changed = [
        name for name in columns.changed_parameters(row.plain) if name not in RUN
    ]
    by_mujoco = []
    for name, value in MUJOCO.items():
        cell = cell_or_absent(results.row[f"solver-{name}"], "value")
        by_mujoco.append(decided(cell.value == value, cell))
    release = columns.settings.name_of(results.edition)
    return Section(
        claims=[
            Claim(
                "as_the_scene",
                decided(not changed, cell_or_absent(row, "slip_mm")),
                {"release": release, "changed": ", ".join(changed)},
            ),
            Claim("leaves_it_to_mujoco", all_of(*by_mujoco)),
        ]
    )
