"""A box on a slope that is far too flat to slide on: the plainest contact that creeps."""

import math
from dataclasses import dataclass
from itertools import product

from experiments.simulation.c_warnings import RunFailed
from experiments.simulation.mjcf_engines import GRAVITY_M_S2, SOLIMP, STEPS, InC
from measured_report.measuring.measurement import Conditions, absent
from newton_lint.law import Contact, Option, impedance_at, response_of

TILT_RAD = 0.1
MASS_KG = 0.2
FRICTION = 1.0
SETTLE_S, SECONDS = 1.0, 0.5


@dataclass(frozen=True)
class Slope:
    """One run; options as in MJCF."""

    name: str
    timeconst_s: float = 0.02
    impratio: float = 1.0
    cone: str = "elliptic"

    def mjcf(self) -> str:
        """Write the scene in the slope's own axes."""
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


CASES = (
    *(
        Slope(f"slope-{1e3 * timeconst:g}ms-impratio-{impratio:g}", timeconst, impratio)
        for timeconst, impratio in product((0.002, 0.02, 0.1), (1.0, 10.0, 100.0))
    ),
    Slope("slope-20ms-pyramidal", cone="pyramidal"),
)


def rows(_: Conditions) -> list[dict[str, object]]:
    """Make a row for each run; they take a second, whatever the profile."""
    results = []
    for case in CASES:
        row = {"case": case.name, "backend": "c", "cone": case.cone, "impratio": case.impratio}
        row["timeconst_s"] = case.timeconst_s
        names = ("creep_mm_s", "forecast_creep_mm_s")
        try:
            results.append(row | dict(zip(names, creep_mm_s(case), strict=True)))
        except RunFailed as failed:
            results.append(row | absent(names, str(failed)))
    return results


def creep_mm_s(case: Slope) -> tuple[float, float]:
    """Measure how fast the box slides down in MuJoCo's C engine, and predict it from parameters and depth [mm/s]."""
    engine = InC(case.mjcf())
    model, [world] = engine.model, engine.worlds
    pair_s = STEPS * model.opt.timestep
    for _ in range(round(SETTLE_S / pair_s)):
        engine.advance()
    start = world.qpos[0]
    for _ in range(round(SECONDS / pair_s)):
        engine.advance()
    contacts = engine.contacts()
    option = Option(model.opt.timestep, cone=case.cone, impratio=case.impratio)
    contact = Contact((case.timeconst_s, 1.0), SOLIMP, FRICTION, 1.0 / MASS_KG)
    response = response_of(contact, option, impedance_at(SOLIMP, contacts.depth_m))
    load_n = MASS_KG * GRAVITY_M_S2 * math.sin(TILT_RAD) / contacts.count
    return 1e3 * (world.qpos[0] - start) / SECONDS, 1e3 * response.load_m_s_n * load_n
