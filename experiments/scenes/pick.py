"""A Panda picks up a cube or a ball, lifts it, and shakes it at random until 20 s have passed.

After Motphys' phys-bench (``grasp/``), whose scenes say nothing of cone, impratio or integrator, so that MuJoCo's own
count: a pyramidal cone, impratio 1, Euler. Every two steps each joint of the arm gets a target at random about its
pose, so that a longer step is another shake. Each setting is also held still, in C.
"""

from dataclasses import dataclass, replace
from itertools import product
from typing import Any

import numpy as np
from tqdm import tqdm

from experiments.drivers.mjcf import ENGINES, SOLIMP, numbers
from experiments.drivers.mujoco_c import STEPS, InC
from experiments.simulation.c_warnings import RunFailed
from measured_report.files.root import ROOT
from measured_report.measuring.measurement import Conditions, absent
from newton_lint.law import Contact, Option

SCENE = "assets/panda.xml"  # the robot, a floor and one free object; it says whose robot it is
OPEN_M = 0.04  # how far each finger opens
READY = (0.0, 0.0, 0.0, -1.5708, 0.0, 1.5708, -0.7853)
AT_OBJECT = (-1.0104, 1.5623, 1.3601, -1.6840, -1.5863, 1.7810, 1.4598)
LIFTED = (
    -1.0426,
    1.4028,
    1.5634,
    -1.7114,
    -1.4055,
    1.6015,
    1.4510,
)  # poses of the arm [rad]
PHASES_S = (1.0, 2.0, 3.0, 4.0)
"""Ends of the motion over the object, of the one down to it, of closing and of lifting [s]."""
PAD_HEIGHT_M = 0.00825  # half the length of a pad along the finger
PAD_SOLREF, PAD_SOLIMP = (
    (0.01, 1.0),
    (0.99, 0.995, 0.01),
)  # as published; the solimp is the scene's
OBJECTS = {
    "cube": 'type="box" size="0.02 0.02 0.02"',
    "ball": 'type="sphere" size="0.02"',
}
TOUCHED_M = {"cube": 0.02, "ball": 0.0}
"""How far above its centre the pads touch an object at most: a ball in one point."""
OBJECT_SOLREF = (0.02, 1.0)  # MuJoCo's own
SPREAD_RAD = 0.025  # standard deviation of the targets of a shake
END_S = {"full": 20.0, "quick": 6.0}
SEED_COUNT = {"full": 8, "quick": 2}
LOST_M = 0.04  # an object below this height after the lifting is dropped
HOLD_S = (
    4.5,
    5.5,
)  # times between which the creep of a grasp that is held still is measured
COUNTS, DROPS = (
    ("lifted_count", "held_count"),
    ("first_drop_s", "median_drop_s", "last_drop_s"),
)
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
    """One case, run with several shakes; options as in MJCF."""

    name: str
    engine: str = "c"
    object: str = "cube"
    timestep_s: float = 0.002
    cone: str = "pyramidal"
    impratio: float = 1.0
    timeconst_s: float | None = (
        None  # time constant of pads and object; None: as published
    )

    def mjcf(self) -> str:
        """Write the scene."""
        pads, touched = self.solrefs
        scene = (ROOT / SCENE).read_text(encoding="utf-8")
        # MuJoCo's own integrator is named, since Newton takes implicitfast where a file names none.
        option = f'timestep="{self.timestep_s}" integrator="Euler" cone="{self.cone}" impratio="{self.impratio}"'
        return scene.format(
            object_geom=f'{OBJECTS[self.object]} solref="{numbers(touched)}" solimp="{numbers(SOLIMP)}"',
            option=option,
            pad_solref=numbers(pads),
        )

    @property
    def solrefs(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Solrefs of a pad and of the object."""
        if self.timeconst_s is None:
            return PAD_SOLREF, OBJECT_SOLREF
        return (self.timeconst_s, 1.0), (self.timeconst_s, 1.0)


SETTINGS: dict[str, dict[str, Any]] = {
    "published": {},
    "elliptic": {"cone": "elliptic", "impratio": 10.0},
    "short": {"timeconst_s": 0.004},
}


def cases() -> list[Pick]:
    """List every setting with either step in C and through Newton."""
    picks = []
    for kind, (step, step_s), name in product(
        OBJECTS, (("2ms", 0.002), ("10ms", 0.01)), SETTINGS
    ):
        case = Pick(
            f"{kind}-{step}-{name}", object=kind, timestep_s=step_s, **SETTINGS[name]
        )
        picks += [
            replace(case, name=f"{case.name}-{engine}", engine=engine)
            for engine in ("c", "newton")
        ]
    return picks


def rows(conditions: Conditions) -> list[dict[str, object]]:
    """Make a row for each case, and one for each setting with the grasp held still."""
    results = []
    for case in tqdm(cases(), desc="pick", unit="case", delay=3.0):
        row = described(case) | {"seed_count": SEED_COUNT[conditions.profile]}
        try:
            controls = shake_controls(case, conditions.profile)
            results.append(row | shake(case, controls, conditions.device))
        except RunFailed as failed:
            results.append(row | absent((*COUNTS, *DROPS), str(failed)))
    for kind, name in product(OBJECTS, SETTINGS):
        case = Pick(f"{kind}-{name}-held", object=kind, **SETTINGS[name])
        try:
            results.append(described(case) | hold(case))
        except RunFailed as failed:
            results.append(described(case) | absent(HELD, str(failed)))
    return results


def described(case: Pick) -> dict[str, object]:
    """Return what a case sets as columns."""
    return {
        "case": case.name,
        "backend": case.engine,
        "object": case.object,
        "cone": case.cone,
        "impratio": case.impratio,
        "timestep": case.timestep_s,
        "timeconst_s": case.solrefs[0][0],
    }


def pick_controls(time_s: np.ndarray) -> np.ndarray:
    """Return the controls of arm and fingers [rad, m] that pick up and hold, shape [time, 8]."""
    ends_s = (0.0, *PHASES_S)
    arm = zip(READY, LIFTED, AT_OBJECT, AT_OBJECT, LIFTED, strict=True)
    fingers = (OPEN_M, OPEN_M, OPEN_M, 0.0, 0.0)
    return np.stack([np.interp(time_s, ends_s, at) for at in (*arm, fingers)], axis=-1)


def shake_controls(case: Pick, profile: str) -> np.ndarray:
    """Return the same with targets at random once it is lifted, shape [sample, seed, 8]."""
    sample_s = STEPS * case.timestep_s
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
    """Return the sample after which the object should be up."""
    return round(PHASES_S[-1] / (STEPS * case.timestep_s)) - 1


def shake(case: Pick, controls: np.ndarray, device: str) -> dict[str, object]:
    """Pick the object up and shake it, until the end or until all worlds have dropped it.

    Raises:
        RunFailed: An engine failed in one of the shakes.
    """
    world_count = controls.shape[1]
    engine = ENGINES[case.engine](case.mjcf(), world_count, device)
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
        drop_s[is_low & is_up] = (sample + 1) * STEPS * case.timestep_s
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
    """Pick the object up in MuJoCo's C engine and hold it still: its creep, and as predicted.

    The margin is how far it may still sink until the pads' lower edge has passed what
    they touch.
    """
    engine = InC(case.mjcf())
    [world] = engine.worlds
    sample_s = STEPS * case.timestep_s
    height_m = []
    for time_s in sample_s * np.arange(1, round(HOLD_S[1] / sample_s) + 1):
        engine.command(pick_controls(time_s)[None])
        engine.advance()
        if time_s >= HOLD_S[0]:
            height_m.append(world.body("object").xpos[2] - world.geom("pad1").xpos[2])
    contacts = engine.contacts()
    model = engine.model
    weight_n = float(-model.opt.gravity[2] * model.body_mass[-1])
    contact = Contact(
        0.5 * np.sum(case.solrefs, axis=0),
        0.5 * np.add((*PAD_SOLIMP, 0.5, 2.0), SOLIMP),
        1.0,
        sum(model.body_invweight0[[-2, -1], 0]),
    )
    option = Option(case.timestep_s, cone=case.cone, impratio=case.impratio)
    forecast_mm_s = 1e3 * contacts.forecast_creep_m_s(weight_n, contact, option)
    margin_mm = 1e3 * float(height_m[0] + PAD_HEIGHT_M + TOUCHED_M[case.object])
    watched_s = sample_s * (len(height_m) - 1)
    return {
        "creep_mm_s": 1e3 * float((height_m[0] - height_m[-1]) / watched_s),
        "predicted_creep_mm_s": 1e3 * contacts.creep_m_s(weight_n),
        "forecast_creep_mm_s": forecast_mm_s,
        "normal_force_n": contacts.normal_n,
        "loaded_contact_count": contacts.count,
        "margin_mm": margin_mm,
        "forecast_drop_s": HOLD_S[0] + margin_mm / forecast_mm_s,
    }
