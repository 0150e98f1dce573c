"""Measure a capsule between two pads under gravity, as published.

The scene follows google-deepmind/mujoco issue #3328, which gives masses, sizes,
friction and damping. The other parameters were chosen to match the loads in the issue.
With a gain of 20 kN/m the pads press with 12 N, and with a timeconst of 4 ms with 60 N.
The capsule is longer than the width of the pads.
"""

from dataclasses import asdict, dataclass, replace
from functools import partial

import numpy as np
from tqdm import tqdm

from experiments.drivers.contacts import load_columns
from experiments.drivers.mjcf import ENGINES, SOLIMP, columns_of, numbers, run
from experiments.drivers.mujoco_c import STEPS
from experiments.drivers.scene import GRAVITY_M_S2, Scene
from experiments.simulation.compat import warp_has_noslip
from measured_report.measuring.measurement import Conditions, absent
from newton_lint.law import Contact, Option

MASS_KG = 0.045
RADIUS_M = 0.004
PAD_HALF_SIZE_M = (0.008, 0.03, 0.02)
PAD_MASS_KG = 0.2
GAP_M = 0.0005  # gap between capsule and pad at the start
SQUEEZE_M = 0.002  # distance past contact to which the actuators pull each pad
TARGET = (GAP_M + SQUEEZE_M, -GAP_M - SQUEEZE_M)
GAIN_N_M = 20e3
DAMPING_N_S_M = 100.0
FRICTION = (0.7, 0.005, 0.0001)
STEP_S = 0.002
SETTLE_S = 0.5
SECONDS = {"full": 2.0, "quick": 0.5}
CREEPS = (
    "creep_mm_s",
    "steady_creep_mm_s",
    "predicted_creep_mm_s",
    "forecast_creep_mm_s",
)


@dataclass(frozen=True)
class Pinch:
    """Describe one run, whose row has these columns; options are as in MJCF."""

    case: str
    backend: str = "c"
    cone: str = "elliptic"
    impratio: float = 10.0
    noslip_iterations: int = 0
    timeconst_s: float = 0.02
    condim: int = 3
    half_length_m: float = 0.05

    def mjcf(self) -> str:
        """Return the scene."""
        contact = f'friction="{numbers(FRICTION)}" condim="{self.condim}" solref="{self.timeconst_s} 1"'
        offset_m = RADIUS_M + GAP_M + PAD_HALF_SIZE_M[0]
        pads = "".join(
            f"""
            <body name="pad_{side}" pos="{x} 0 0">
              <joint name="slide_{side}" type="slide" axis="1 0 0" damping="{DAMPING_N_S_M}"/>
              <geom type="box" size="{numbers(PAD_HALF_SIZE_M)}" mass="{PAD_MASS_KG}" {contact}/>
            </body>"""
            for side, x in (("left", -offset_m), ("right", offset_m))
        )
        return f"""
        <mujoco>
          <option timestep="{STEP_S}" gravity="0 0 {-GRAVITY_M_S2}" cone="{self.cone}" impratio="{self.impratio}"
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


VARIANTS = (
    Pinch("recipe"),
    Pinch("impratio-1", impratio=1.0),
    Pinch("impratio-100", impratio=100.0),
    Pinch("impratio-1000", impratio=1000.0),
    Pinch("pyramidal", cone="pyramidal", impratio=1.0),
    Pinch("stiff", timeconst_s=0.004),
    Pinch("noslip", noslip_iterations=10),
    Pinch("condim-6", condim=6),
    Pinch("within-pads", half_length_m=0.02),
)
CASES = [
    replace(variant, case=f"{variant.case}-{engine}", backend=engine)
    for engine in ENGINES
    for variant in VARIANTS
]


def rows(conditions: Conditions) -> list[dict[str, object]]:
    """Return a row with the measured and predicted creep of the capsule for each run."""
    seconds = SECONDS[conditions.profile]
    rows = []
    for case in tqdm(CASES, desc="capsule", unit="run", delay=3.0):
        if case.backend != "c" and case.noslip_iterations and not warp_has_noslip():
            columns = absent(CREEPS, "MuJoCo Warp here has no noslip")
        else:
            measure = partial(sink, case, seconds, conditions.device)
            columns = columns_of(measure, CREEPS)
        rows.append(asdict(case) | columns)
    return rows


def sink(case: Pinch, seconds: float, device: str) -> dict[str, float]:
    """Squeeze the capsule and return its measured creep and two predictions.

    The predictions follow R f = b v. One uses R of the final contacts, and the other
    uses the parameters and the depth of the contacts.
    """
    sample_s = STEPS * STEP_S
    settled, count = (round(time_s / sample_s) for time_s in (SETTLE_S, seconds))
    scene = Scene(STEP_S, sample_s, [TARGET] * (settled + count), case.mjcf())
    trace = run(scene, case.backend, device)
    height_m = trace.path_m[settled:, 2]
    speed_m_s = -trace.velocity_m_s[settled + 1 :, 0, 2]
    pad, capsule = trace.model.body_invweight0[[1, -1], 0].tolist()
    # An engine may drop noslip from the MJCF.
    noslip = bool(trace.model.opt.noslip_iterations)
    option = Option(0.0, cone=case.cone, impratio=case.impratio, noslip=noslip)
    contact = Contact((case.timeconst_s, 1.0), SOLIMP, FRICTION[0], pad + capsule)
    return {
        "creep_mm_s": 1e3 * float((height_m[0] - height_m[-1]) / (sample_s * count)),
        "steady_creep_mm_s": 1e3 * float(np.median(speed_m_s)),
        **load_columns(trace.contacts, MASS_KG * GRAVITY_M_S2, contact, option),
    }
