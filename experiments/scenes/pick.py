"""Pick up a cube or a ball with a Panda, lift it, and shake it at random until 20 s.

The scene follows Motphys' phys-bench (``grasp/``). Its scenes do not set cone, impratio
or integrator, so MuJoCo's defaults apply: a pyramidal cone, impratio 1, and Euler. Each
joint of the arm gets a new random target around its pose every two steps, so that a
longer step gives another shake. Each setting is also held still, in C.
"""

from dataclasses import asdict, dataclass
from functools import partial
from itertools import product
from typing import Any

import numpy as np
from tqdm import tqdm

from experiments.drivers.contacts import load_columns
from experiments.drivers.mjcf import ENGINES, SOLIMP, columns_of, numbers
from experiments.drivers.mujoco_c import STEPS, InC
from measured_report.files.root import ROOT
from measured_report.measuring.measurement import Conditions, absent
from newton_lint.law import Contact, Option

# Robot, floor and one free object; the file names the source of the robot.
SCENE = "assets/panda.xml"
OPEN_M = 0.04  # opening of each finger
# Poses of the arm [rad].
READY = (0.0, 0.0, 0.0, -1.5708, 0.0, 1.5708, -0.7853)
AT_OBJECT = (-1.0104, 1.5623, 1.3601, -1.6840, -1.5863, 1.7810, 1.4598)
LIFTED = (-1.0426, 1.4028, 1.5634, -1.7114, -1.4055, 1.6015, 1.4510)
PHASES_S = (1.0, 2.0, 3.0, 4.0)
"""Times at which the motions end: over the object, down to it, closing, and lifting."""
PAD_HEIGHT_M = 0.00825  # half the length of a pad along the finger
PAD_TIMECONST_S = 0.01  # as published
PAD_SOLIMP = (0.99, 0.995, 0.01, 0.5, 2.0)  # of the scene
OBJECT_TIMECONST_S = 0.02  # MuJoCo's default
OBJECTS = {
    "cube": 'type="box" size="0.02 0.02 0.02"',
    "ball": 'type="sphere" size="0.02"',
}
TOUCHED_M = {"cube": 0.02, "ball": 0.0}
"""Largest height above an object's centre at which the pads touch it.

They touch a ball at a single point.
"""
SPREAD_RAD = 0.025  # standard deviation of a shake's targets
END_S = {"full": 20.0, "quick": 6.0}
SEED_COUNT = {"full": 8, "quick": 2}
LOST_M = 0.04  # height below which an object counts as dropped after the lift
HOLD_S = (4.5, 5.5)  # interval in which the creep of a held grasp is measured
COUNTS = ("lifted_count", "held_count")
DROPS = ("first_drop_s", "median_drop_s", "last_drop_s")
HELD = (
    "creep_mm_s",
    "predicted_creep_mm_s",
    "forecast_creep_mm_s",
    "normal_force_n",
    "margin_mm",
    "forecast_drop_s",
)


@dataclass(frozen=True)
class Pick:
    """Describe one case, whose row has these columns; options are as in MJCF."""

    case: str
    backend: str = "c"
    object: str = "cube"
    timestep: float = 0.002
    cone: str = "pyramidal"
    impratio: float = 1.0
    timeconst_s: float = PAD_TIMECONST_S  # of the pads

    @property
    def solrefs(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Return the solrefs of a pad and of the object.

        The object has its own solref if the pads have the published one.
        """
        is_published = self.timeconst_s == PAD_TIMECONST_S
        object_s = OBJECT_TIMECONST_S if is_published else self.timeconst_s
        return (self.timeconst_s, 1.0), (object_s, 1.0)

    def mjcf(self) -> str:
        """Return the scene."""
        pads, touched = map(numbers, self.solrefs)
        shape = OBJECTS[self.object]
        # The integrator is named explicitly, because Newton's default would be
        # implicitfast.
        return (
            (ROOT / SCENE)
            .read_text(encoding="utf-8")
            .format(
                object_geom=f'{shape} solref="{touched}" solimp="{numbers(SOLIMP)}"',
                option=f'timestep="{self.timestep}" integrator="Euler" cone="{self.cone}" '
                f'impratio="{self.impratio}"',
                pad_solref=pads,
            )
        )


SETTINGS: dict[str, dict[str, Any]] = {
    "published": {},
    "elliptic": {"cone": "elliptic", "impratio": 10.0},
    "short": {"timeconst_s": 0.004},
}


# Every setting with either step, in C and through Newton.
SHAKEN = [
    Pick(
        f"{kind}-{1e3 * step_s:g}ms-{name}-{engine}",
        engine,
        kind,
        step_s,
        **SETTINGS[name],
    )
    for kind, step_s, name, engine in product(
        OBJECTS, (0.002, 0.01), SETTINGS, ("c", "newton")
    )
]
STILL = [
    Pick(f"{kind}-{name}-held", object=kind, **SETTINGS[name])
    for kind, name in product(OBJECTS, SETTINGS)
]


def rows(conditions: Conditions) -> list[dict[str, object]]:
    """Return a row for each case, and a row for each setting held still."""
    rows = []
    for case in tqdm(SHAKEN, desc="pick", unit="case", delay=3.0):
        controls = shake_controls(case, conditions.profile)
        measure = partial(shake, case, controls, conditions.device)
        count = {"seed_count": SEED_COUNT[conditions.profile]}
        rows.append(asdict(case) | count | columns_of(measure, (*COUNTS, *DROPS)))
    return rows + [
        asdict(case) | columns_of(partial(hold, case), HELD) for case in STILL
    ]


def pick_controls(time_s: np.ndarray) -> np.ndarray:
    """Return the controls for picking up and holding [rad, m], shape [time, 8].

    The columns are the seven joints of the arm and the fingers.
    """
    ends_s = (0.0, *PHASES_S)
    arm = zip(READY, LIFTED, AT_OBJECT, AT_OBJECT, LIFTED, strict=True)
    fingers = (OPEN_M, OPEN_M, OPEN_M, 0.0, 0.0)
    return np.stack([np.interp(time_s, ends_s, at) for at in (*arm, fingers)], axis=-1)


def shake_controls(case: Pick, profile: str) -> np.ndarray:
    """Return the same controls with random targets after the lift.

    The shape is [sample, seed, 8].
    """
    sample_s = STEPS * case.timestep
    count = round(END_S[profile] / sample_s)
    lifting = pick_controls(sample_s * np.arange(1, count + 1))
    controls = np.repeat(lifting[:, None], SEED_COUNT[profile], axis=1)
    begin = lifted_sample(case)
    for seed in range(SEED_COUNT[profile]):
        random = np.random.default_rng(seed)
        jerks = random.normal(0.0, SPREAD_RAD, (count - begin, 7))
        controls[begin:, seed, :7] = LIFTED + jerks
    return controls


def lifted_sample(case: Pick) -> int:
    """Return the sample after which the object should be lifted."""
    return round(PHASES_S[-1] / (STEPS * case.timestep)) - 1


def shake(case: Pick, controls: np.ndarray, device: str) -> dict[str, object]:
    """Pick the object up and shake it until the end or until all worlds dropped it.

    Raises:
        RunFailed: An engine failed in one of the shakes.
    """
    world_count = controls.shape[1]
    engine = ENGINES[case.backend](case.mjcf(), world_count, device)
    is_up = np.ones(world_count, dtype=bool)
    drop_s = np.full(world_count, np.nan)
    for sample, control in enumerate(controls):
        engine.command(control)
        engine.advance()
        if sample < lifted_sample(case):
            continue
        is_low = ~(engine.body()[0][:, 2] >= LOST_M)
        if sample == lifted_sample(case):
            lifted_count = int(is_up.sum() - is_low.sum())
        drop_s[is_low & is_up] = (sample + 1) * STEPS * case.timestep
        is_up &= ~is_low
        if not is_up.any():
            break
    row = dict(zip(COUNTS, (lifted_count, int(is_up.sum())), strict=True))
    dropped_s = drop_s[~is_up]
    if not len(dropped_s):
        return row | absent(DROPS, "it was never dropped")
    times = (dropped_s.min(), np.median(dropped_s), dropped_s.max())
    return row | dict(zip(DROPS, map(float, times), strict=True))


def hold(case: Pick) -> dict[str, float]:
    """Hold the object still in MuJoCo's C engine; return its creep and margin.

    The margin is the distance that the object can still sink before the lower edge of
    the pads loses contact with it.
    """
    engine = InC(case.mjcf())
    [world] = engine.worlds
    sample_s = STEPS * case.timestep
    height_m = []
    for time_s in sample_s * np.arange(1, round(HOLD_S[1] / sample_s) + 1):
        engine.command(pick_controls(time_s)[None])
        engine.advance()
        if time_s >= HOLD_S[0]:
            height_m.append(world.body("object").xpos[2] - world.geom("pad1").xpos[2])
    model = engine.model
    weight_n = float(-model.opt.gravity[2] * model.body_mass[-1])
    contact = Contact(
        0.5 * np.sum(case.solrefs, axis=0),
        0.5 * np.add(PAD_SOLIMP, SOLIMP),
        1.0,
        sum(model.body_invweight0[[-2, -1], 0]),
    )
    option = Option(case.timestep, cone=case.cone, impratio=case.impratio)
    row = load_columns(engine.contacts(), weight_n, contact, option)
    margin_mm = 1e3 * float(height_m[0] + PAD_HEIGHT_M + TOUCHED_M[case.object])
    watched_s = sample_s * (len(height_m) - 1)
    return row | {
        "creep_mm_s": 1e3 * float((height_m[0] - height_m[-1]) / watched_s),
        "margin_mm": margin_mm,
        "forecast_drop_s": HOLD_S[0] + margin_mm / row["forecast_creep_mm_s"],
    }
