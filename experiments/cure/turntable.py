"""A box on a table that turns: no robot, no grasp, and it walks outward.

It stands on four feet, since MuJoCo Warp takes a step in ten for one without contact where a box rests on a box.

The table's point under the box has the acceleration ω² r to the centre, which is J̇ q̇ of the contacts. With b of their
friction rows, R of their regularization, n contacts and the box's mass m, the parts in ``budget`` give

    dr/dt = r ω² ((1 + R m / n) / b - h/2) (1 - 5 ω²/b²),

so r grows exponentially; h/2 is that of a semi-implicit step. With the term put back the 1 is gone. The last factor is
of second order: in the frame of the table a sliding velocity v has a Coriolis acceleration of 2 ω v, which turns it by
2 ω/b and takes 4 ω²/b² of it, and that v grows takes ω²/b².
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import partial
from itertools import product
from types import SimpleNamespace
from typing import Any

import mujoco
import numpy as np
from tqdm import tqdm

import contact_bias
import contact_bias_c
from experiments.drivers.contacts import Contacts
from experiments.drivers.mjcf import ENGINES, numbers
from experiments.drivers.mujoco_c import STEPS
from experiments.simulation.c_warnings import RunFailed
from experiments.simulation.compat import warp_has_noslip
from experiments.simulation.measurement import Conditions, absent

TURN_RAD_S = 2.0
RADIUS_M = 0.2
MASS_KG = 0.2
SECONDS = {"full": 6.0, "quick": 3.0}
SETTLE_S = 1.0  # time in which the box sinks into its contacts; the growth is measured after it
SAMPLE_S = 0.1
STEP_S = 0.002
GROWTHS = ("growth_per_s", "predicted_growth_per_s")
MJCF = f"""
<mujoco>
  <option timestep="0.002" cone="elliptic" integrator="implicitfast"/>
  <worldbody>
    <body>
      <joint axis="0 0 1" armature="1000"/>
      <geom type="box" size="0.5 0.5 0.05"/>
    </body>
    <body pos="{RADIUS_M} 0 0.1">
      <freejoint/>
      <geom type="box" size="0.05 0.05 0.04" mass="{MASS_KG}" contype="0" conaffinity="0"/>
      <geom type="sphere" size="0.01" pos="0.04 0.04 -0.04" mass="0"/>
      <geom type="sphere" size="0.01" pos="0.04 -0.04 -0.04" mass="0"/>
      <geom type="sphere" size="0.01" pos="-0.04 0.04 -0.04" mass="0"/>
      <geom type="sphere" size="0.01" pos="-0.04 -0.04 -0.04" mass="0"/>
    </body>
  </worldbody>
</mujoco>
"""


@dataclass(frozen=True)
class Variant:
    """What is done about the walk."""

    contact_bias: bool = False
    bias_centred: bool = False
    options: Mapping[str, Any] = field(
        default_factory=dict
    )  # options of MJCF that are not as in the scene
    timeconst_s: float = 0.02

    @property
    def mjcf(self) -> str:
        """Write the scene, which begins with the box at rest on the turning table."""
        options = " ".join(
            f'{name}="{WORDS.get(value, value)}"'
            for name, value in self.options.items()
        )
        start = numbers(
            [TURN_RAD_S, 0.0, TURN_RAD_S * RADIUS_M, 0.0, 0.0, 0.0, TURN_RAD_S]
        )
        settings = f'<option {options}/><default><geom solref="{self.timeconst_s} 1"/></default>'
        return MJCF.replace(
            "<worldbody>",
            f'{settings}<keyframe><key qvel="{start}"/></keyframe><worldbody>',
        )


WORDS = {"rk4": "RK4", "euler": "Euler"}  # integrators as MJCF spells them
RK4 = {"integrator": "rk4"}
PYRAMIDAL = {"cone": "pyramidal"}
HIGH_IMPRATIO = {"impratio": 100.0}
VARIANTS = {
    "plain": Variant(),
    "rk4": Variant(options=RK4),
    "euler": Variant(options={"integrator": "euler"}),
    "noslip": Variant(options={"noslip_iterations": 10}),
    "impratio": Variant(options=HIGH_IMPRATIO),
    "pyramidal": Variant(options=PYRAMIDAL),
    "half-timeconst": Variant(timeconst_s=0.01),
    "half-step": Variant(options={"timestep": 0.001}),
    "term": Variant(contact_bias=True),
    "term-pyramidal": Variant(contact_bias=True, options=PYRAMIDAL),
    "term-rk4": Variant(contact_bias=True, options=RK4),
    "term-rk4-impratio": Variant(contact_bias=True, options=RK4 | HIGH_IMPRATIO),
    "term-centred": Variant(contact_bias=True, bias_centred=True),
    "term-centred-impratio": Variant(
        contact_bias=True, bias_centred=True, options=HIGH_IMPRATIO
    ),
}
TERM = {"warp": contact_bias.install, "c": contact_bias_c.subtract_bias}  # type: dict[str, Callable]


def measure(conditions: Conditions) -> list[dict]:
    """Measure a row for each run: how fast the box's distance from the axis grows, measured and predicted."""
    runs = list(product(TERM, VARIANTS))
    return [
        row_of(engine, name, conditions)
        for engine, name in tqdm(runs, desc="turntable", unit="run", delay=3.0)
    ]


def row_of(engine: str, name: str, conditions: Conditions) -> dict[str, object]:
    variant = VARIANTS[name]
    row = {
        "case": f"{name}-{engine}",
        "backend": engine,
        "contact_bias": variant.contact_bias,
        **variant.options,
    }
    row |= {"bias_centred": variant.bias_centred, "timeconst_s": variant.timeconst_s}
    if (
        engine == "warp"
        and "noslip_iterations" in variant.options
        and not warp_has_noslip()
    ):
        return row | absent(GROWTHS, "MuJoCo Warp here has no noslip")
    term = (
        partial(TERM[engine], centred=variant.bias_centred)
        if variant.contact_bias
        else None
    )
    try:
        path, contacts = run(
            engine, variant.mjcf, SECONDS[conditions.profile], conditions.device, term
        )
        if contacts.count == 0:
            raise RunFailed("nothing is touched at the end")
    except RunFailed as failed:
        return row | absent(GROWTHS, str(failed))
    radius_m = np.hypot(*path[:, :2].T)
    row |= {"start_radius_mm": 1e3 * float(radius_m[round(SETTLE_S / SAMPLE_S)])}
    row |= {
        "loaded_contact_count": contacts.count,
        "growth_per_s": growth_per_s(radius_m, SETTLE_S),
    }
    return row | {"predicted_growth_per_s": predicted_growth_per_s(variant, contacts)}


def run(
    engine: str,
    mjcf: str,
    seconds: float,
    device: str,
    term: Callable[..., None] | None = None,
) -> tuple[np.ndarray, Contacts]:
    """Return the places of a scene's free body every SAMPLE_S [m], shape [samples, 3], and its contacts in the end.

    Args:
        term: What is installed in MuJoCo Warp, and what MuJoCo's C engine calls before it solves; None for nothing.

    Raises:
        RunFailed: It shows no measurement any more.
    """
    world = ENGINES[engine](mjcf, device=device)
    if term and engine == "warp":
        term(SimpleNamespace(mjw_model=world.engine, mjw_data=world.data))
    count = round(SAMPLE_S / (STEPS * world.model.opt.timestep))
    # One for all models, so only for as long as this one is stepped.
    mujoco.set_mjcb_control(term if engine == "c" else None)
    try:
        path = [world.body()[0][0]]
        for _ in range(round(seconds / SAMPLE_S)):
            for _ in range(count):
                world.advance()
            path.append(world.body()[0][0])
    finally:
        mujoco.set_mjcb_control(None)
    return np.array(path), world.contacts()


def growth_per_s(radius_m: np.ndarray, since_s: float) -> float:
    """Fit the rate of an exponential growth from a time on, by a line through the logarithm of each sample."""
    time_s = SAMPLE_S * np.arange(len(radius_m))
    settled = time_s >= since_s
    return float(np.polyfit(time_s[settled], np.log(radius_m[settled]), 1)[0])


def predicted_growth_per_s(variant: Variant, contacts: Contacts) -> float:
    """Predict the growth by the law in the module's text, with the contacts that a run ends with."""
    h, b = variant.options.get("timestep", STEP_S), contacts.damping_per_s
    creep = (
        0.0
        if "noslip_iterations" in variant.options
        else MASS_KG * contacts.softness_1_kg
    )
    left_out = 1.0 - variant.contact_bias * (1.0 - 0.5 * h * b * variant.bias_centred)
    step = 0.0 if variant.options.get("integrator") == "rk4" else 0.5 * h
    return float(
        TURN_RAD_S**2
        * ((left_out + creep) / b - step)
        * (1.0 - 5.0 * (TURN_RAD_S / b) ** 2)
    )
