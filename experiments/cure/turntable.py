"""Measure a box that creeps outward on a rotating table, without a robot or a grasp.

The box stands on four feet, because MuJoCo Warp loses the contact in one of ten steps
if a box rests on a box.

The point of the table under the box has the acceleration ω² r towards the centre, which
is the J̇ q̇ of the contacts. Let b be the damping of the friction rows, R their
regularization, n the number of contacts, and m the mass of the box. The parts in
``budget`` then give

    dr/dt = r ω² ((1 + R m / n) / b - h/2) (1 - 5 ω²/b²),

so that r grows exponentially. The term h/2 belongs to a semi-implicit step of length h.
If the term is restored, the 1 disappears. The last factor is of second order. In the
frame of the table, a sliding velocity v has a Coriolis acceleration of 2 ω v. This
rotates the velocity by 2 ω/b and reduces it by 4 ω²/b². The growth of v reduces it by
another ω²/b².
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
# Time in which the box sinks into its contacts [s]. The growth is measured after this
# time.
SETTLE_S = 1.0
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
    """Describe a variant of the scene that may change the creep."""

    contact_bias: bool = False
    bias_centred: bool = False
    # Options of MJCF that differ from the scene.
    options: Mapping[str, Any] = field(default_factory=dict)
    timeconst_s: float = 0.02

    @property
    def mjcf(self) -> str:
        """Return the scene, in which the box starts at rest on the rotating table."""
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
    """Return a row with the measured and predicted growth of the radius for each run."""
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
    """Return the positions of a scene's free body and its final contacts.

    The positions are sampled every SAMPLE_S [m], shape [samples, 3].

    Args:
        term: A function that installs the term in MuJoCo Warp, or that MuJoCo's C
        engine calls before it solves.
            None leaves the engine unchanged.

    Raises:
        RunFailed: The engine has diverged or raised a warning.
    """
    world = ENGINES[engine](mjcf, device=device)
    if term and engine == "warp":
        term(SimpleNamespace(mjw_model=world.engine, mjw_data=world.data))
    count = round(SAMPLE_S / (STEPS * world.model.opt.timestep))
    # The callback applies to all models, so it is set only while this one is stepped.
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
    """Return the rate of exponential growth after a time.

    It is the slope of a line that is fitted to the logarithm of the samples.
    """
    time_s = SAMPLE_S * np.arange(len(radius_m))
    settled = time_s >= since_s
    return float(np.polyfit(time_s[settled], np.log(radius_m[settled]), 1)[0])


def predicted_growth_per_s(variant: Variant, contacts: Contacts) -> float:
    """Return the growth that the law of this module predicts for the final contacts."""
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
