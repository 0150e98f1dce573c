"""Measure the simplest creep of a contact: a box on a slope too flat for sliding."""

import math
from dataclasses import asdict, dataclass
from functools import partial
from itertools import product

from experiments.drivers.contacts import forecast_creep_m_s
from experiments.drivers.mjcf import SOLIMP, columns_of, run
from experiments.drivers.mujoco_c import STEPS
from experiments.drivers.scene import GRAVITY_M_S2, Scene
from measured_report.measuring.measurement import Conditions
from newton_lint.law import Contact, Option

TILT_RAD = 0.1
MASS_KG = 0.2
FRICTION = 1.0
STEP_S = 0.0005
SETTLE_S = 1.0
SECONDS = 0.5
CREEPS = ("creep_mm_s", "forecast_creep_mm_s")


@dataclass(frozen=True)
class Slope:
    """Describe one run, whose row has these columns; options are as in MJCF."""

    case: str
    timeconst_s: float = 0.02
    impratio: float = 1.0
    cone: str = "elliptic"
    backend: str = "c"

    def mjcf(self) -> str:
        """Return the scene in the axes of the slope."""
        x = GRAVITY_M_S2 * math.sin(TILT_RAD)
        z = -GRAVITY_M_S2 * math.cos(TILT_RAD)
        contact = f'friction="{FRICTION} 0.005 0.0001" solref="{self.timeconst_s} 1"'
        return f"""
        <mujoco>
          <option timestep="{STEP_S}" gravity="{x} 0 {z}" cone="{self.cone}"
            impratio="{self.impratio}"/>
          <worldbody>
            <geom type="plane" size="1 1 0.1" {contact}/>
            <body name="box" pos="0 0 0.02">
              <freejoint/>
              <geom type="box" size="0.04 0.04 0.02" mass="{MASS_KG}" {contact}/>
            </body>
          </worldbody>
        </mujoco>"""


CASES = (
    *(
        Slope(f"slope-{1e3 * timeconst:g}ms-impratio-{impratio:g}", timeconst, impratio)
        for timeconst, impratio in product((0.002, 0.02, 0.1), (1.0, 10.0, 100.0))
    ),
    Slope("slope-20ms-pyramidal", cone="pyramidal"),
)


def rows(_: Conditions) -> list[dict[str, object]]:
    """Return a row for each run; all take about a second in either profile."""
    return [asdict(case) | columns_of(partial(creep, case), CREEPS) for case in CASES]


def creep(case: Slope) -> dict[str, float]:
    """Return the measured and predicted creep of the box in MuJoCo's C engine."""
    settled, count = (round(time_s / STEPS / STEP_S) for time_s in (SETTLE_S, SECONDS))
    targets = [()] * (settled + count)
    trace = run(Scene(STEP_S, STEPS * STEP_S, targets, case.mjcf()), case.backend)
    option = Option(STEP_S, cone=case.cone, impratio=case.impratio)
    contact = Contact((case.timeconst_s, 1.0), SOLIMP, FRICTION, 1.0 / MASS_KG)
    load_n = MASS_KG * GRAVITY_M_S2 * math.sin(TILT_RAD)
    forecast_m_s = forecast_creep_m_s(trace.contacts, load_n, contact, option)
    slid_m = trace.path_m[-1, 0] - trace.path_m[settled, 0]
    creeps = (float(slid_m) / SECONDS, forecast_m_s)
    return {name: 1e3 * value for name, value in zip(CREEPS, creeps, strict=True)}
