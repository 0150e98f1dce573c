"""A capsule between two pads, and nothing but gravity pulls at it.

After google-deepmind/mujoco issue #3328, which gives masses, sizes, friction and damping. What its text leaves open was
chosen by what it says of the loads: with a gain of 20 kN/m the pads press with the 12 N that it gives, and with a
timeconst of 4 ms with its 60 N. The capsule is longer than the pads are wide.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from experiments.simulation.mjcf_engines import ENGINES, Contacts, Engine
from newton_lint.creep import impedance_at, predicted_creep

MASS_KG = 0.045
RADIUS_M = 0.004
HALF_LENGTH_M = 0.05
PAD_HALF_SIZE_M = (0.008, 0.03, 0.02)
PAD_MASS_KG = 0.2
GAP_M = 0.0005
"""Between capsule and pad at the start."""
SQUEEZE_M = 0.002
"""How far past touching the actuators pull each pad."""
GAIN_N_M = 20e3
DAMPING_N_S_M = 100.0
FRICTION = (0.7, 0.005, 0.0001)
SOLIMP = (0.9, 0.95, 0.001, 0.5, 2.0)
"""MuJoCo's own."""
GRAVITY_M_S2 = 9.81
SETTLE_S = 0.5
SECONDS = {"full": 2.0, "quick": 0.5}


@dataclass(frozen=True)
class Pinch:
    """One run; options as in MJCF."""

    name: str
    engine: str = "c"
    cone: str = "elliptic"
    impratio: float = 10.0
    noslip_iterations: int = 0
    timeconst_s: float = 0.02
    condim: int = 3
    half_length_m: float = HALF_LENGTH_M

    def mjcf(self) -> str:
        """The scene."""
        friction, half_size = (" ".join(map(str, values)) for values in (FRICTION, PAD_HALF_SIZE_M))
        contact = f'friction="{friction}" condim="{self.condim}" solref="{self.timeconst_s} 1"'
        place = RADIUS_M + GAP_M + PAD_HALF_SIZE_M[0]
        pads = "".join(
            f"""
            <body name="pad_{side}" pos="{x} 0 0">
              <joint name="slide_{side}" type="slide" axis="1 0 0" damping="{DAMPING_N_S_M}"/>
              <geom type="box" size="{half_size}" mass="{PAD_MASS_KG}" {contact}/>
            </body>"""
            for side, x in (("left", -place), ("right", place))
        )
        return f"""
        <mujoco>
          <option timestep="0.002" gravity="0 0 {-GRAVITY_M_S2}" cone="{self.cone}" impratio="{self.impratio}"
            noslip_iterations="{self.noslip_iterations}"/>
          <worldbody>{pads}
            <body name="capsule">
              <freejoint/>
              <geom type="capsule" size="{RADIUS_M} {self.half_length_m}" zaxis="0 1 0" mass="{MASS_KG}" {contact}/>
            </body>
          </worldbody>
          <actuator>
            <position joint="slide_left" kp="{GAIN_N_M}"/>
            <position joint="slide_right" kp="{GAIN_N_M}"/>
          </actuator>
        </mujoco>"""


@dataclass(frozen=True)
class Sinking:
    """What a run shows."""

    speed_m_s: np.ndarray
    """Of the capsule, downward, after the settling, each two steps."""
    mean_m_s: float
    """How far it sank in that time, by the time."""
    contacts: Contacts
    """At the end."""
    inverse_masses_1_kg: Sequence[float]
    """``body_invweight0`` of pad and capsule [1/kg]."""
    noslip: bool
    """Whether the engine ran the noslip pass, which what the way there made of the MJCF need not have."""


def run(case: Pinch, seconds: float, device: str) -> Sinking:
    """Squeeze the capsule and watch it sink."""
    engine: Engine = ENGINES[case.engine](case.mjcf(), 1, device)
    travel = GAP_M + SQUEEZE_M
    engine.command(np.array([[travel, -travel]]))
    pair_s = 2.0 * engine.model.opt.timestep
    for _ in range(round(SETTLE_S / pair_s)):
        engine.advance()
    height, speed = [engine.body()[0][0, 2]], []
    for _ in range(round(seconds / pair_s)):
        engine.advance()
        position, velocity = engine.body()
        height.append(position[0, 2])
        speed.append(-velocity[0, 2])
    mean = (height[0] - height[-1]) / (pair_s * len(speed))
    return Sinking(
        np.array(speed),
        float(mean),
        engine.contacts(),
        engine.model.body_invweight0[[1, -1], 0].tolist(),
        bool(engine.model.opt.noslip_iterations),
    )


def columns(case: Pinch, sinking: Sinking) -> dict[str, float]:
    """Numbers of a row: how fast it sank, and how fast by R f = b v.

    Once with R of the contacts that the run ends with, and once from what is authored and how deep they are.
    """
    weight_n = MASS_KG * GRAVITY_M_S2
    law = 0.0 if sinking.noslip else sinking.contacts.creep_m_s(weight_n)
    pad, capsule = sinking.inverse_masses_1_kg
    forecast = predicted_creep(
        (case.timeconst_s, 1.0),
        SOLIMP[1],
        load_n=weight_n / sinking.contacts.count,
        inverse_mass_1_kg=pad + capsule,
        impedance=impedance_at(SOLIMP, sinking.contacts.depth_m),
        impratio=math.inf if sinking.noslip else case.impratio,
        cone=case.cone,
        mu=FRICTION[0],
    )
    return {
        "creep_mm_s": 1e3 * sinking.mean_m_s,
        "steady_creep_mm_s": 1e3 * float(np.median(sinking.speed_m_s)),
        "predicted_creep_mm_s": 1e3 * law,
        "forecast_creep_mm_s": forecast.load_mm_s,
        "normal_force_n": sinking.contacts.normal_n,
        "loaded_contact_count": sinking.contacts.count,
        "pad_inverse_mass": pad,
        "capsule_inverse_mass": capsule,
    }
