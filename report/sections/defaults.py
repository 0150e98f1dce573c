"""What a release sets where nobody does, and the slip with that: the scene writes what 1.4.0 had."""

from measured_report.files.config import config
from measured_report.records.columns import changed_parameters
from report.shared import Claim, Results, Section, all_of, cell_or_absent, decided

order = 205
page = "releases"
label = "own defaults"

CASE, RUN = (
    "own-defaults",
    ("frame_count", "device"),
)  # the case, and what it has for being a run of its own
MUJOCO = {
    "run_collision_detection": 1.0,
    "cone": 0.0,
}  # the engine finds the contacts; a pyramid


def derive(results: Results) -> Section:
    row = results.row[CASE]
    changed = [name for name in changed_parameters(row.plain) if name not in RUN]
    numbers = {
        "release": config().name_of(results.edition),
        "changed": ", ".join(changed),
    }
    cells = {
        name: cell_or_absent(results.row[f"solver-{name}"], "value") for name in MUJOCO
    }
    by_mujoco = all_of(
        *(decided(cell.value == MUJOCO[name], cell) for name, cell in cells.items())
    )
    as_scene = Claim("as_the_scene", decided(not changed, row.slip_mm), numbers)
    return Section(claims=[as_scene, Claim("leaves_it_to_mujoco", by_mujoco)])
