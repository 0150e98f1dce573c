"""A Panda picks up a cube or a ball, lifts it, and shakes it at random until 20 s have passed.

After Motphys' phys-bench (``grasp/``), whose scenes say nothing of cone, impratio or integrator, so that MuJoCo's own
count: a pyramidal cone, impratio 1, Euler. Every two steps each joint of the arm gets a target at random about its
pose, so that a longer step is another shake. Each setting is also held still, in C.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

import numpy as np
from tqdm import tqdm

from experiments.simulation.c_warnings import RunFailed
from experiments.simulation.mjcf_engines import ENGINES, SOLIMP, STEPS, InC, numbers
from measured_report.files.root import ROOT
from measured_report.measuring.measurement import Conditions, absent
from newton_lint.law import Contact, Option, impedance_at, response_of

SCENE = "assets/panda.xml"  # the robot, a floor and one free object; it says whose robot it is
OPEN_M = 0.04  # how far each finger opens
READY = (0.0, 0.0, 0.0, -1.5708, 0.0, 1.5708, -0.7853)
AT_OBJECT = (-1.0104, 1.5623, 1.3601, -1.6840, -1.5863, 1.7810, 1.4598)
LIFTED = (-1.0426, 1.4028, 1.5634, -1.7114, -1.4055, 1.6015, 1.4510)  # poses of the arm [rad]
PHASES_S = (1.0, 2.0, 3.0, 4.0)
"""Ends of the motion over the object, of the one down to it, of closing and of lifting [s]."""
PAD_HEIGHT_M = 0.00825  # half the length of a pad along the finger
PAD_SOLREF, PAD_SOLIMP = (0.01, 1.0), (0.99, 0.995, 0.01)  # as published; the solimp is the scene's
OBJECTS = {"cube": 'type="box" size="0.02 0.02 0.02"', "ball": 'type="sphere" size="0.02"'}
TOUCHED_M = {"cube": 0.02, "ball": 0.0}
"""How far above its centre the pads touch an object at most: a ball in one point."""
OBJECT_SOLREF = (0.02, 1.0)  # MuJoCo's own
SPREAD_RAD = 0.025  # standard deviation of the targets of a shake
END_S = {"full": 20.0, "quick": 6.0}
SEED_COUNT = {"full": 8, "quick": 2}
LOST_M = 0.04  # an object below this height after the lifting is dropped
HOLD_S = (4.5, 5.5)  # times between which the creep of a grasp that is held still is measured
COUNTS, DROPS = ("lifted_count", "held_count"), ("first_drop_s", "median_drop_s", "last_drop_s")
HELD = ("creep_mm_s", "predicted_creep_mm_s", "forecast_creep_mm_s", "normal_force_n", "margin_mm", "forecast_drop_s")


@dataclass(frozen=True)
class Pick:
    """One case, run with several shakes; options as in MJCF."""

    name: str
    engine: str = "c"
    object: str = "cube"
    timestep_s: float = 0.002
    cone: str = "pyramidal"
    impratio: float = 1.0
    timeconst_s: float | None = None  # time constant of pads and object; None: as published

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
    for kind, (step, step_s), name in product(OBJECTS, (("2ms", 0.002), ("10ms", 0.01)), SETTINGS):
        case = Pick(f"{kind}-{step}-{name}", object=kind, timestep_s=step_s, **SETTINGS[name])
        picks += [replace(case, name=f"{case.name}-{engine}", engine=engine) for engine in ("c", "newton")]
    return picks


def rows(conditions: Conditions) -> list[dict[str, object]]:
    """Make a row for each case, and one for each setting with the grasp held still."""
    results = [shaken(case, conditions) for case in tqdm(cases(), desc="pick", unit="case", delay=3.0)]
    for kind, name in product(OBJECTS, SETTINGS):
        case = Pick(f"{kind}-{name}-held", object=kind, **SETTINGS[name])
        try:
            results.append(described(case) | hold(case))
        except RunFailed as failed:
            results.append(described(case) | absent(HELD, str(failed)))
    return results


def described(case: Pick) -> dict[str, object]:
    """Say what a case sets."""
    row: dict[str, object] = {"case": case.name, "backend": case.engine, "object": case.object, "cone": case.cone}
    return row | {"impratio": case.impratio, "timestep": case.timestep_s, "timeconst_s": case.solrefs[0][0]}


def shaken(case: Pick, conditions: Conditions) -> dict[str, object]:
    """Make the row of a case: how many shakes the grasp stood, and when it dropped the object in the others."""
    seeds = range(SEED_COUNT[conditions.profile])
    row = described(case) | {"seed_count": len(seeds)}
    try:
        return row | shake_columns(*shake(case, seeds, END_S[conditions.profile], conditions.device))
    except RunFailed as failed:
        return row | absent((*COUNTS, *DROPS), str(failed))


def command(time_s: float) -> np.ndarray:
    """Return the controls of arm and fingers while the object is picked up, and after it [rad, m], shape [8]."""
    over, down, closed, lifted = PHASES_S
    at = (0.0, over, down, closed, lifted)
    arm = [np.interp(time_s, at, joint) for joint in zip(READY, LIFTED, AT_OBJECT, AT_OBJECT, LIFTED, strict=True)]
    return np.array([*arm, np.interp(time_s, at, (OPEN_M, OPEN_M, OPEN_M, 0.0, 0.0))])


def shake_columns(lifted: np.ndarray, drop_s: np.ndarray) -> dict[str, object]:
    dropped = drop_s[~np.isnan(drop_s)]
    row = dict(zip(COUNTS, (int(lifted.sum()), len(drop_s) - len(dropped)), strict=True))
    if not len(dropped):
        return row | absent(DROPS, "it was never dropped")
    return row | dict(zip(DROPS, map(float, (dropped.min(), np.median(dropped), dropped.max())), strict=True))


def shake(case: Pick, seeds: Sequence[int], end_s: float, device: str) -> tuple[np.ndarray, np.ndarray]:
    """Pick the object up and shake it, once with each seed, until the end or until all have dropped it.

    Returns:
        Whether the object was up when the shake began, and when it was dropped [s], nan where it was not; shape [seed].

    Raises:
        RunFailed: An engine failed in one of the shakes.
    """
    engine = ENGINES[case.engine](case.mjcf(), len(seeds), device)
    randoms = [np.random.default_rng(seed) for seed in seeds]
    pair_s = STEPS * case.timestep_s
    begin = round(PHASES_S[-1] / pair_s)
    drop_s = np.full(len(seeds), np.nan)
    lifted: np.ndarray = np.zeros(len(seeds), dtype=bool)
    control = np.tile(command(0.0), (len(seeds), 1))
    for pair in range(1, round(end_s / pair_s) + 1):
        time_s = pair * pair_s
        if pair < begin:
            control[:] = command(time_s)
        else:
            control[:, :7] = LIFTED + np.array([random.normal(0.0, SPREAD_RAD, 7) for random in randoms])
        engine.command(control)
        engine.advance()
        if pair >= begin:
            low = ~(engine.body()[0][:, 2] >= LOST_M)
            if pair == begin:
                lifted = ~low
            drop_s[low & np.isnan(drop_s)] = time_s
            if not np.isnan(drop_s).any():
                break
    return lifted, drop_s


def hold(case: Pick) -> dict[str, float]:
    """Pick the object up in MuJoCo's C engine and hold it still: its creep, by its contacts' law and by the parameters.

    The margin is how far it may still sink until the pads' lower edge has passed what they touch.
    """
    engine = InC(case.mjcf())
    model, [world] = engine.model, engine.worlds
    pair_s, height = STEPS * case.timestep_s, []
    for pair in range(1, round(HOLD_S[1] / pair_s) + 1):
        engine.command(command(pair * pair_s)[None])
        engine.advance()
        if pair * pair_s >= HOLD_S[0]:
            height.append(world.body("object").xpos[2] - world.geom("pad1").xpos[2])
    contacts, weight_n = engine.contacts(), float(-model.opt.gravity[2] * model.body_mass[-1])
    pads, touched = case.solrefs
    solimp = 0.5 * np.add((*PAD_SOLIMP, 0.5, 2.0), SOLIMP)
    finger, grasped = (model.body_invweight0[body, 0] for body in (-2, -1))
    option = Option(case.timestep_s, cone=case.cone, impratio=case.impratio)
    contact = Contact(0.5 * np.add(pads, touched), solimp, 1.0, finger + grasped)
    response = response_of(contact, option, impedance_at(solimp, contacts.depth_m))
    forecast_mm_s = 1e3 * response.load_m_s_n * weight_n / contacts.count
    margin_mm = 1e3 * float(height[0] + PAD_HEIGHT_M + TOUCHED_M[case.object])
    return {
        "creep_mm_s": 1e3 * float((height[0] - height[-1]) / (pair_s * (len(height) - 1))),
        "predicted_creep_mm_s": 1e3 * contacts.creep_m_s(weight_n),
        "forecast_creep_mm_s": forecast_mm_s,
        "normal_force_n": contacts.normal_n,
        "loaded_contact_count": contacts.count,
        "margin_mm": margin_mm,
        "forecast_drop_s": HOLD_S[0] + margin_mm / forecast_mm_s,
    }
