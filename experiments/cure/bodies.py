"""Other bodies and other contacts than a grasp: do they move as they should with the term put back?

On a plane a body is dropped, slides or rolls. A ball that rolls and spins at once has the material point accelerate
sideways while its contact does not. On a table that turns, as in section turntable, a body stands on feet of different
shapes, from the start or after it has slid into step.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import product
from types import SimpleNamespace

import mujoco
import mujoco_warp as mjw
import numpy as np
import warp as wp
from tqdm import tqdm

from experiments.cure.turntable import RADIUS_M as PLACE_M
from experiments.cure.turntable import SAMPLE_S, TURN_RAD_S, path_in_c
from experiments.simulation import contact_bias, contact_bias_c, contact_place, contact_place_c
from experiments.simulation.c_warnings import RunFailed
from experiments.simulation.measurement import Conditions, absent

VARIANTS = {"plain": None, "term": {}, "exact": {"normal": True}}
"""Options of the term; ``exact`` gives it to the normal rows as well, and counts with ``contact_place`` how the contact
moves. On the table it is centred, since the step's error would hide what is left."""
COMPARED = ("plain", "exact")
IN_WARP = [("pivot", "sphere")]
IN_WARP += [("carried", "sphere"), ("carried", "cylinder"), ("carried", "mesh")]
"""Motions that MuJoCo Warp runs too, in the variants that are COMPARED; MuJoCo C runs all."""
SPEED_M_S, SPIN_RAD_S, RADIUS_M, FRICTION, GRAVITY = 1.0, 20.0, 0.03, 0.5, 9.81
HEIGHT_M = 0.1
TABLE_M = 0.5
SECONDS = {"plane": {"full": 1.0, "quick": 0.5}, "table": {"full": 4.0, "quick": 3.0}}
COLUMNS = {"plane": ("travel_mm", "sideways_mm", "rise_mm"), "table": ("growth_per_s", "end_radius_mm")}
CAUGHT_S = 2.0
"""Time by which a body that was put down at rest turns with the table; its growth is measured after it."""
CUBE = " ".join(
    f"{x} {y} {z}" for x in (-RADIUS_M, RADIUS_M) for y in (-RADIUS_M, RADIUS_M) for z in (-RADIUS_M, RADIUS_M)
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
OPTION = '<option timestep="0.002" cone="elliptic" integrator="implicitfast" impratio="{}"/>'
IMPRATIO = {"plane": 10.0, "table": 100.0}
MESHES = f'<asset><mesh name="cube" vertex="{CUBE}"/><mesh name="foot" vertex="{FOOT}"/></asset>'


@dataclass(frozen=True)
class Motion:
    """A body and how it starts."""

    name: str
    body: str
    place: str
    """``plane`` or ``table``."""
    mjcf: str
    start: Callable[[mujoco.MjData], None]
    """Function that sets positions and velocities."""


def on_plane(body: str) -> str:
    return f"""<mujoco>{OPTION.format(IMPRATIO["plane"])}{MESHES}<worldbody>
      <geom type="plane" size="5 5 1" friction="{FRICTION}"/>
      <body pos="0 0 {RADIUS_M}"><freejoint/><geom {GEOMS[body]} mass="0.2" friction="{FRICTION}"/></body>
    </worldbody></mujoco>"""


def on_table(feet: str) -> str:
    places = [(x, y) for x in (0.04, -0.04) for y in (0.04, -0.04)]
    stand = "".join(f'<geom {FEET[feet]} pos="{x} {y} -0.04" mass="0"/>' for x, y in places)
    return f"""<mujoco>{OPTION.format(IMPRATIO["table"])}{MESHES}<worldbody>
      <body><joint axis="0 0 1" armature="1000"/><geom type="box" size="{TABLE_M} {TABLE_M} 0.05"/></body>
      <body pos="{PLACE_M} 0 0.1"><freejoint/>
        <geom type="box" size="0.05 0.05 0.04" mass="0.2" contype="0" conaffinity="0"/>{stand}
      </body>
    </worldbody></mujoco>"""


def thrown(data: mujoco.MjData, *, height_m: float = 0.0, roll: bool = False, spin: float = 0.0) -> None:
    """Throw along x, from ``height_m`` above the plane, rolling or not, with a spin about the vertical [rad/s]."""
    data.qpos[2] += height_m
    data.qvel[:] = SPEED_M_S, 0.0, 0.0, 0.0, SPEED_M_S / RADIUS_M if roll else 0.0, spin


def carried(data: mujoco.MjData, *, at_rest: bool = False) -> None:
    """Put on the turning table, at rest on it or against the ground."""
    data.qvel[0] = TURN_RAD_S
    if not at_rest:
        data.qvel[1:] = 0.0, TURN_RAD_S * PLACE_M, 0.0, 0.0, 0.0, TURN_RAD_S


MOTIONS = [
    *(
        Motion("impact", body, "plane", on_plane(body), partial(thrown, height_m=HEIGHT_M))
        for body in ("sphere", "cylinder", "mesh")
    ),
    *(
        Motion("roll", body, "plane", on_plane(body), partial(thrown, roll=True))
        for body in ("sphere", "cylinder", "capsule")
    ),
    Motion("pivot", "sphere", "plane", on_plane("sphere"), partial(thrown, roll=True, spin=SPIN_RAD_S)),
    Motion("slide", "mesh", "plane", on_plane("mesh"), thrown),
    *(Motion("carried", feet, "table", on_table(feet), carried) for feet in FEET),
    *(Motion("caught", feet, "table", on_table(feet), partial(carried, at_rest=True)) for feet in FEET),
]


def measure(conditions: Conditions) -> list[dict]:
    """Measure a row for each motion, variant and engine: where the body is at the end, or how it walks on the table."""
    chosen = [(motion, each) for motion in MOTIONS if (motion.name, motion.body) in IN_WARP for each in COMPARED]
    device = wp.get_device(conditions.device)
    paths = run_in_warp([(*run, seconds_of(run[0], conditions)) for run in chosen], device)
    in_warp = {(motion.name, motion.body, each): path for (motion, each), path in zip(chosen, paths, strict=True)}
    rows = []
    for motion, variant in product(MOTIONS, VARIANTS):
        path = in_warp.get((motion.name, motion.body, variant))
        if path is not None:
            rows.append(row_of(motion, variant, "warp", lambda path=path: path))
        rows.append(row_of(motion, variant, "c", partial(run_in_c, motion, variant, seconds_of(motion, conditions))))
    return rows


def row_of(motion: Motion, variant: str, engine: str, run: Callable[[], np.ndarray]) -> dict[str, object]:
    row = {"case": f"{motion.name}-{motion.body}-{variant}-{engine}".replace(" ", "-"), "motion": motion.name}
    row |= {"body": motion.body, "variant": variant, "backend": engine, "contact_bias": variant != "plain"}
    try:
        return row | columns_of(motion, run())
    except RunFailed as failed:
        return row | absent(COLUMNS[motion.place], str(failed))


def options_of(motion: Motion, variant: str) -> dict[str, bool] | None:
    """Return the options of the term for a motion; None without it."""
    options = VARIANTS[variant]
    return options | {"centred": True} if variant == "exact" and motion.place == "table" else options


def columns_of(motion: Motion, path: np.ndarray) -> dict[str, float]:
    """Tell what a path shows.

    Raises:
        RunFailed: It is no path, or leaves the table.
    """
    if not np.isfinite(path).all():
        raise RunFailed("not finite")
    return plane_columns(path) if motion.place == "plane" else table_columns(path)


def seconds_of(motion: Motion, conditions: Conditions) -> float:
    return SECONDS[motion.place][conditions.profile]


def plane_columns(path: np.ndarray) -> dict[str, float]:
    """Tell where a body on the plane ends, from where it began; shape [samples, 3]."""
    travel, sideways, rise = 1e3 * (path[-1] - path[0])
    return {"travel_mm": float(travel), "sideways_mm": float(sideways), "rise_mm": float(rise)}


def table_columns(path: np.ndarray) -> dict[str, float]:
    """Fit how fast the distance from the axis grows once the body turns with the table.

    Raises:
        RunFailed: It leaves the table.
    """
    time_s, radius_m = SAMPLE_S * np.arange(len(path)), np.hypot(*path[:, :2].T)
    if radius_m.max() > TABLE_M:
        raise RunFailed("it leaves the table")
    settled = time_s >= CAUGHT_S
    growth = np.polyfit(time_s[settled], np.log(radius_m[settled]), 1)[0]
    return {"growth_per_s": float(growth), "end_radius_mm": 1e3 * float(radius_m[-1])}


def started(motion: Motion) -> tuple[mujoco.MjModel, mujoco.MjData]:
    model = mujoco.MjModel.from_xml_string(motion.mjcf)
    data = mujoco.MjData(model)
    motion.start(data)
    mujoco.mj_forward(model, data)
    return model, data


def run_in_c(motion: Motion, variant: str, seconds: float) -> np.ndarray:
    """Return the places of the body every SAMPLE_S [m], shape [samples, 3]; RunFailed as from the engine."""
    model, data = started(motion)
    term, options = contact_place_c if variant == "exact" else contact_bias_c, options_of(motion, variant)
    control = None if options is None else partial(term.subtract_bias, **options)
    return path_in_c(model, data, control, seconds)


class WarpRun:
    """A motion in MuJoCo Warp, captured and at its start."""

    def __init__(self, motion: Motion, variant: str, seconds: float, device: wp.Device):
        model, data = started(motion)
        self.sample_count = round(seconds / SAMPLE_S)
        self.stream = wp.Stream(device) if device.is_cuda else None
        with wp.ScopedDevice(device), wp.ScopedStream(self.stream):
            # Both are kept for as long as the graph: on CUDA it keeps none of the arrays that it reads.
            self.engine, self.data = mjw.put_model(model), mjw.put_data(model, data, nconmax=64, njmax=256)
            start = wp.clone(self.data.qpos), wp.clone(self.data.qvel)
            self.path = wp.zeros((self.sample_count + 1, model.nq), dtype=float)
            wp.copy(self.path, start[0])
            if (options := options_of(motion, variant)) is not None:
                term = contact_place if variant == "exact" else contact_bias
                term.install(SimpleNamespace(mjw_model=self.engine, mjw_data=self.data), **options)
            mjw.step(self.engine, self.data)  # compiles, which must not happen inside a capture
            wp.copy(self.data.qpos, start[0])
            wp.copy(self.data.qvel, start[1])
            with wp.ScopedCapture() as capture:
                for _ in range(round(SAMPLE_S / model.opt.timestep)):
                    mjw.step(self.engine, self.data)
            self.graph = capture.graph

    def sample(self, number: int) -> None:
        """Queue the steps up to a sample, and keep it."""
        with wp.ScopedStream(self.stream):
            wp.capture_launch(self.graph)
            wp.copy(self.path, self.data.qpos, dest_offset=number * self.path.shape[1], count=self.path.shape[1])


def run_in_warp(motions: Sequence[tuple[Motion, str, float]], device: wp.Device) -> list[np.ndarray]:
    """Run motions in MuJoCo Warp side by side: each has one world, which leaves most of a GPU idle."""
    runs = [WarpRun(*motion, device) for motion in tqdm(motions, desc="cure, bodies", unit="run", delay=3.0)]
    for number in range(1, 1 + max(run.sample_count for run in runs)):
        for run in runs:
            if number <= run.sample_count:
                run.sample(number)
    wp.synchronize_device(device)
    return [run.path.numpy()[:, -7:-4].astype(float) for run in runs]
