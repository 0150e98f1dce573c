"""A box on a slope that is far too flat to slide on: the plainest contact that creeps."""

import math
from dataclasses import dataclass

import numpy as np

from experiments.simulation.mjcf_engines import STEPS, InC
from newton_lint.creep import impedance_at, predicted_creep

TILT_RAD = 0.1
GRAVITY_M_S2 = 9.81
MASS_KG = 0.2
FRICTION = 1.0
SOLIMP = (0.9, 0.95, 0.001, 0.5, 2.0)
SETTLE_S, SECONDS = 1.0, 0.5


@dataclass(frozen=True)
class Slope:
    """One run; options as in MJCF."""

    name: str
    timeconst_s: float = 0.02
    impratio: float = 1.0
    cone: str = "elliptic"

    def mjcf(self) -> str:
        """The scene, in the slope's own axes."""
        x, z = GRAVITY_M_S2 * math.sin(TILT_RAD), -GRAVITY_M_S2 * math.cos(TILT_RAD)
        contact = f'friction="{FRICTION} 0.005 0.0001" solref="{self.timeconst_s} 1"'
        return f"""
        <mujoco>
          <option timestep="0.0005" gravity="{x} 0 {z}" cone="{self.cone}" impratio="{self.impratio}"/>
          <worldbody>
            <geom type="plane" size="1 1 0.1" {contact}/>
            <body name="box" pos="0 0 0.02">
              <freejoint/>
              <geom type="box" size="0.04 0.04 0.02" mass="{MASS_KG}" {contact}/>
            </body>
          </worldbody>
        </mujoco>"""


def creep_mm_s(case: Slope) -> tuple[float, float]:
    """How fast the box slides down in MuJoCo's C engine, and predicted from its parameters and depth [mm/s].

    Raises:
        RunFailed: Of the engine.
    """
    engine = InC(case.mjcf())
    model, [world] = engine.model, engine.worlds
    pair_s = STEPS * model.opt.timestep
    for _ in range(round(SETTLE_S / pair_s)):
        engine.advance()
    start = world.qpos[0]
    for _ in range(round(SECONDS / pair_s)):
        engine.advance()
    contacts = engine.contacts()
    forecast = predicted_creep(
        (case.timeconst_s, 1.0),
        SOLIMP[1],
        timestep_s=model.opt.timestep,
        load_n=MASS_KG * GRAVITY_M_S2 * np.sin(TILT_RAD) / contacts.count,
        inverse_mass_1_kg=1.0 / MASS_KG,
        impedance=impedance_at(SOLIMP, contacts.depth_m),
        impratio=case.impratio,
        cone=case.cone,
        mu=FRICTION,
    )
    return 1e3 * (world.qpos[0] - start) / SECONDS, forecast.load_mm_s
