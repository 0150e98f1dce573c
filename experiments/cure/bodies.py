"""Measure whether bodies other than a grasped cube move correctly with the term.

On a plane, a body is dropped, slides or rolls. If a ball rolls and spins at the same
time, its material point accelerates sideways, but its contact does not. On a rotating
table, as in ``turntable``, a body stands on feet of different shapes. It rotates with
the table from the start, or it slides until it does.
"""

from dataclasses import dataclass
from functools import partial

import numpy as np
from tqdm import tqdm

import contact_bias_c
import contact_place
from experiments.cure.turntable import RADIUS_M as PLACE_M
from experiments.cure.turntable import TURN_RAD_S, growth_per_s, run
from experiments.drivers.mjcf import numbers
from experiments.simulation.c_warnings import RunFailed
from experiments.simulation.measurement import Conditions, absent

IN_C = (("plain", "c"), ("term", "c"))
EXACT = (("plain", "warp"), ("exact", "warp"))
"""Variants and engines with which a motion is run.

The exact term is also applied to the normal rows, and includes the motion of the
contact. On the table it is centred, because the error of the time step would otherwise
hide the remaining error.
"""
SPEED_M_S, SPIN_RAD_S, RADIUS_M, FRICTION = 1.0, 20.0, 0.03, 0.5
HEIGHT_M = 0.1
TABLE_M = 0.5
SECONDS = {"plane": {"full": 1.0, "quick": 0.5}, "table": {"full": 4.0, "quick": 3.0}}
COLUMNS = {"plane": ("travel_mm", "sideways_mm", "rise_mm"), "table": ("growth_per_s",)}
# Time after which a body that starts at rest rotates with the table [s]. The growth is
# measured after this time.
CAUGHT_S = 2.0
CUBE = " ".join(
    f"{x} {y} {z}"
    for x in (-RADIUS_M, RADIUS_M)
    for y in (-RADIUS_M, RADIUS_M)
    for z in (-RADIUS_M, RADIUS_M)
)
FOOT = "0 0 -0.01  0.01 0 0.01  -0.005 0.008 0.01  -0.005 -0.008 0.01"
"""Corners of a tetrahedron that stands on one of them."""
GEOMS = {
    "sphere": f'type="sphere" size="{RADIUS_M}"',
    "cylinder": f'type="cylinder" size="{RADIUS_M} {RADIUS_M}" euler="90 0 0"',
    "mesh": 'type="mesh" mesh="cube"',
    "capsule": f'type="capsule" size="{RADIUS_M} {RADIUS_M}" euler="90 0 0"',
}
FEET = {
    "sphere": 'type="sphere" size="0.01"',
    "cylinder": 'type="cylinder" size="0.01 0.01"',
    "mesh": 'type="mesh" mesh="foot"',
}
SCENE = """<mujoco><option timestep="0.002" cone="elliptic" integrator="implicitfast" impratio="{}"/>
  <asset><mesh name="cube" vertex="{}"/><mesh name="foot" vertex="{}"/></asset>
  <worldbody>{}</worldbody><keyframe><key qpos="{}" qvel="{}"/></keyframe></mujoco>"""


@dataclass(frozen=True)
class Motion:
    """Describe a body and its initial state."""

    name: str
    body: str
    place: str  # ``plane`` or ``table``
    mjcf: str
    runs: tuple[tuple[str, str], ...]


def on_plane(
    name: str,
    body: str,
    *,
    height_m: float = 0.0,
    roll: bool = False,
    spin: float = 0.0,
    runs=IN_C,
) -> Motion:
    """Return the motion of a body along x, starting ``height_m`` above the plane.

    It can roll, and spin about z [rad/s].
    """
    scene = f"""<geom type="plane" size="5 5 1" friction="{FRICTION}"/>
      <body><freejoint/><geom {GEOMS[body]} mass="0.2" friction="{FRICTION}"/></body>"""
    positions = numbers([0.0, 0.0, RADIUS_M + height_m, 1.0, 0.0, 0.0, 0.0])
    velocity = numbers(
        [SPEED_M_S, 0.0, 0.0, 0.0, SPEED_M_S / RADIUS_M if roll else 0.0, spin]
    )
    return Motion(
        name,
        body,
        "plane",
        SCENE.format(10.0, CUBE, FOOT, scene, positions, velocity),
        runs,
    )


def on_table(name: str, feet: str) -> Motion:
    """Return the motion of a body on the rotating table.

    A body that is ``carried`` starts with the table's velocity; one that is ``caught``
    starts at rest.
    """
    corners = [(x, y) for x in (0.04, -0.04) for y in (0.04, -0.04)]
    stand = "".join(
        f'<geom {FEET[feet]} pos="{x} {y} -0.04" mass="0"/>' for x, y in corners
    )
    scene = f"""<body><joint axis="0 0 1" armature="1000"/><geom type="box" size="{TABLE_M} {TABLE_M} 0.05"/></body>
      <body><freejoint/>
        <geom type="box" size="0.05 0.05 0.04" mass="0.2" contype="0" conaffinity="0"/>{stand}
      </body>"""
    positions = numbers([0.0, PLACE_M, 0.0, 0.1, 1.0, 0.0, 0.0, 0.0])
    turn = TURN_RAD_S if name == "carried" else 0.0
    velocity = numbers([TURN_RAD_S, 0.0, turn * PLACE_M, 0.0, 0.0, 0.0, turn])
    return Motion(
        name,
        feet,
        "table",
        SCENE.format(100.0, CUBE, FOOT, scene, positions, velocity),
        EXACT,
    )


MOTIONS = [
    *(
        on_plane("impact", body, height_m=HEIGHT_M)
        for body in ("sphere", "cylinder", "mesh")
    ),
    *(on_plane("roll", body, roll=True) for body in ("sphere", "cylinder", "capsule")),
    on_plane("pivot", "sphere", roll=True, spin=SPIN_RAD_S, runs=(*IN_C, *EXACT)),
    on_plane("slide", "mesh"),
    *(on_table(name, feet) for name in ("carried", "caught") for feet in FEET),
]


def measure(conditions: Conditions) -> list[dict]:
    """Return a row for each motion, variant and engine.

    It contains the final position on the plane, or the growth of the radius on the
    table.
    """
    runs = [(motion, *each) for motion in MOTIONS for each in motion.runs]
    bar = tqdm(runs, desc="cure, bodies", unit="run", delay=3.0)
    return [
        row_of(motion, variant, engine, conditions) for motion, variant, engine in bar
    ]


def row_of(
    motion: Motion, variant: str, engine: str, conditions: Conditions
) -> dict[str, object]:
    row: dict = {
        "case": f"{motion.name}-{motion.body}-{variant}-{engine}",
        "motion": motion.name,
        "body": motion.body,
    }
    row |= {"variant": variant, "backend": engine, "contact_bias": variant != "plain"}
    exact = partial(contact_place.install, centred=motion.place == "table", normal=True)
    term = {"plain": None, "term": contact_bias_c.subtract_bias, "exact": exact}[
        variant
    ]
    try:
        path, _ = run(
            engine,
            motion.mjcf,
            SECONDS[motion.place][conditions.profile],
            conditions.device,
            term,  # type: ignore[arg-type]  # a dict joins functions into objects
        )
        return row | columns_of(motion, path)
    except RunFailed as failed:
        return row | absent(COLUMNS[motion.place], str(failed))


def columns_of(motion: Motion, path: np.ndarray) -> dict[str, float]:
    """Return the displacement of a body on the plane, or the growth of its radius.

    The growth is measured when the body rotates with the table.

    Raises:
        RunFailed: The body leaves the table.
    """
    if motion.place == "plane":
        return dict(
            zip(COLUMNS["plane"], (1e3 * (path[-1] - path[0])).tolist(), strict=True)
        )
    radius_m = np.hypot(*path[:, :2].T)
    if radius_m.max() > TABLE_M:
        raise RunFailed("it leaves the table")
    return {"growth_per_s": growth_per_s(radius_m, CAUGHT_S)}
