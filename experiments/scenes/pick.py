"""A Panda picks up a cube or a ball, lifts it, and shakes it at random until 20 s have passed.

After Motphys' phys-bench (``grasp/``), whose scenes say nothing of cone, impratio or integrator, so that MuJoCo's own
count: a pyramidal cone, impratio 1, Euler. Every two steps each joint of the arm gets a target at random about its
pose, so that a longer step is another shake.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from experiments.scenes import panda
from experiments.simulation.mjcf_engines import ENGINES, STEPS, Contacts, Engine, InC
from newton_lint.creep import impedance_at, predicted_creep

OBJECTS = {"cube": 'type="box" size="0.02 0.02 0.02"', "ball": 'type="sphere" size="0.02"'}
TOUCHED_M = {"cube": 0.02, "ball": 0.0}
"""How far above its centre the pads touch an object at most: a ball in one point."""
OBJECT_SOLREF, OBJECT_SOLIMP = (0.02, 1.0), (0.9, 0.95, 0.001, 0.5, 2.0)
"""MuJoCo's own."""
SPREAD_RAD = 0.025
"""Standard deviation of the targets of a shake."""
END_S = {"full": 20.0, "quick": 6.0}
LOST_M = 0.04
"""An object below this height after the lifting is dropped."""
HOLD_S = (4.5, 5.5)
"""When the creep of a grasp that is held still is measured."""


@dataclass(frozen=True)
class Pick:
    """One case, run with several shakes; options as in MJCF."""

    name: str
    engine: str = "c"
    object: str = "cube"
    timestep_s: float = 0.002
    cone: str = "pyramidal"
    impratio: float = 1.0
    integrator: str = "Euler"
    timeconst_s: float | None = None
    """Of pads and object; None: as published."""

    def mjcf(self) -> str:
        """The scene."""
        pads, own = self.solrefs
        option = f'timestep="{self.timestep_s}" integrator="{self.integrator}"'
        solimp = " ".join(map(str, OBJECT_SOLIMP))
        return panda.mjcf(
            f'{OBJECTS[self.object]} solref="{own[0]} {own[1]}" solimp="{solimp}"',
            f'{option} cone="{self.cone}" impratio="{self.impratio}"',
            pad_solref=pads,
        )

    @property
    def solrefs(self) -> tuple[tuple[float, float], tuple[float, float]]:
        """Of a pad and of the object."""
        if self.timeconst_s is None:
            return panda.PAD_SOLREF, OBJECT_SOLREF
        return (self.timeconst_s, 1.0), (self.timeconst_s, 1.0)


@dataclass(frozen=True)
class Picked:
    """What the shakes of a case show."""

    lifted: np.ndarray
    """Whether the object was up when the shake began, shape [shake]."""
    drop_s: np.ndarray
    """When it was dropped, nan where it was not [s], shape [shake]."""


def shake(case: Pick, seeds: Sequence[int], end_s: float, device: str) -> Picked:
    """Pick the object up and shake it, once with each seed, until the end or until all have dropped it.

    Raises:
        RunFailed: Of an engine in one of the shakes.
    """
    engine = _engine(case, len(seeds), device)
    randoms = [np.random.default_rng(seed) for seed in seeds]
    pair_s = STEPS * case.timestep_s
    begin = round(panda.PHASES_S[-1] / pair_s)
    drop_s = np.full(len(seeds), np.nan)
    lifted: np.ndarray = np.zeros(len(seeds), dtype=bool)
    control = np.tile(panda.command(0.0), (len(seeds), 1))
    for pair in range(1, round(end_s / pair_s) + 1):
        time_s = pair * pair_s
        if pair < begin:
            control[:] = panda.command(time_s)
        else:
            control[:, :7] = panda.LIFTED + np.array([random.normal(0.0, SPREAD_RAD, 7) for random in randoms])
        engine.command(control)
        engine.advance()
        if pair >= begin:
            low = ~(engine.body()[0][:, 2] >= LOST_M)
            if pair == begin:
                lifted = ~low
            drop_s[low & np.isnan(drop_s)] = time_s
            if not np.isnan(drop_s).any():
                break
    return Picked(lifted, drop_s)


@dataclass(frozen=True)
class Held:
    """What a grasp shows that is held still."""

    creep_m_s: float
    """How far the object sank against the hand, by the time."""
    contacts: Contacts
    law_m_s: float
    """By R f = b v of its contacts."""
    forecast_m_s: float
    """By the parameters and the contacts' depth alone."""
    margin_m: float
    """How far it may still sink until the pads' lower edge has passed what they touch."""


def hold(case: Pick) -> Held:
    """Pick the object up in MuJoCo's C engine and hold it still."""
    engine = InC(case.mjcf())
    [world] = engine.worlds
    pair_s, height = STEPS * case.timestep_s, []
    for pair in range(1, round(HOLD_S[1] / pair_s) + 1):
        engine.command(panda.command(pair * pair_s)[None])
        engine.advance()
        if pair * pair_s >= HOLD_S[0]:
            height.append(world.body("object").xpos[2] - world.geom("pad1").xpos[2])
    contacts = engine.contacts()
    creep = (height[0] - height[-1]) / (pair_s * (len(height) - 1))
    margin = height[0] + panda.PAD_HALF_SIZE_M[2] + TOUCHED_M[case.object]
    law, forecast = contacts.creep_m_s(weight_n(engine)), forecast_m_s(case, engine, contacts)
    return Held(float(creep), contacts, law, forecast, float(margin))


def weight_n(engine: Engine) -> float:
    """Of what is held."""
    return float(-engine.model.opt.gravity[2] * engine.model.body_mass[-1])


def forecast_m_s(case: Pick, engine: Engine, contacts: Contacts) -> float:
    """The creep of the grasp held still, from what is authored, the masses and how deep the contacts are."""
    pads, own = case.solrefs
    solref = 0.5 * np.add(pads, own)
    solimp = 0.5 * np.add((*panda.PAD_SOLIMP, 0.5, 2.0), OBJECT_SOLIMP)
    finger, held = (engine.model.body_invweight0[body, 0] for body in (-2, -1))
    return (
        1e-3
        * predicted_creep(
            solref,
            solimp[1],
            timestep_s=case.timestep_s,
            load_n=weight_n(engine) / contacts.count,
            inverse_mass_1_kg=finger + held,
            impedance=impedance_at(solimp, contacts.depth_m),
            impratio=case.impratio,
            cone=case.cone,
        ).load_mm_s
    )


def _engine(case: Pick, world_count: int, device: str) -> Engine:
    return ENGINES[case.engine](case.mjcf(), world_count, device)
