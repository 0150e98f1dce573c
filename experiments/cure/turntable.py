"""A box on a table that turns: no robot, no grasp, and it walks outward.

It stands on four feet, since MuJoCo Warp takes a step in ten for one without contact where a box rests on a box.

The table's point under the box has the acceleration ω² r to the centre, which is J̇ q̇ of the contacts. With b of their
friction rows, R of their regularization, n contacts and the box's mass m, the parts in ``budget`` give

    dr/dt = r ω² ((1 + R m / n) / b - h/2) (1 - 5 ω²/b²),

so r grows exponentially; h/2 is that of a semi-implicit step. With the term put back the 1 is gone. The last factor is
of second order: in the frame of the table a sliding velocity v has a Coriolis acceleration of 2 ω v, which turns it by
2 ω/b and takes 4 ω²/b² of it, and that v grows takes ω²/b².
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from types import SimpleNamespace

import mujoco
import mujoco_warp as mjw
import numpy as np
import warp as wp
from tqdm import tqdm

from experiments.simulation import contact_bias, contact_bias_c
from experiments.simulation.c_warnings import RunFailed, refuse_warned
from experiments.simulation.measurement import Conditions, absent
from experiments.simulation.mjcf_engines import Contacts, contacts_in_c, contacts_in_warp
from newton_lint.newton_models.compat import warp_has_noslip

TURN_RAD_S = 2.0
RADIUS_M = 0.2
MASS_KG = 0.2
SECONDS = {"full": 6.0, "quick": 3.0}
SETTLE_S = 1.0
"""Time in which the box sinks into its contacts; the growth is measured after it."""
SAMPLE_S = 0.1
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


ENUMS = {
    "rk4": int(mujoco.mjtIntegrator.mjINT_RK4),
    "euler": int(mujoco.mjtIntegrator.mjINT_EULER),
    "pyramidal": int(mujoco.mjtCone.mjCONE_PYRAMIDAL),
}
"""MuJoCo's numbers by the words for them."""


@dataclass(frozen=True)
class Turntable:
    """A run of the box on the table."""

    name: str
    engine: str = "warp"
    """``warp`` (MuJoCo Warp) or ``c`` (MuJoCo's C engine)."""
    contact_bias: bool = False
    bias_centred: bool = False
    options: dict[str, object] = field(default_factory=dict)
    """Fields of ``mjOption`` that are not as in the MJCF."""
    timeconst_s: float = 0.02

    def model(self) -> mujoco.MjModel:
        model = mujoco.MjModel.from_xml_string(MJCF)
        for name, value in self.options.items():
            setattr(model.opt, name, ENUMS.get(value, value))
        model.geom_solref[:, 0] = self.timeconst_s
        return model


@dataclass(frozen=True)
class Run:
    """Distance of the box from the axis every SAMPLE_S, and its contacts at the end."""

    radius_m: np.ndarray
    contacts: Contacts


RK4 = {"integrator": "rk4"}
PYRAMIDAL = {"cone": "pyramidal"}
HIGH_IMPRATIO = {"impratio": 100.0}
VARIANTS = {
    "plain": {},
    "rk4": {"options": RK4},
    "euler": {"options": {"integrator": "euler"}},
    "noslip": {"options": {"noslip_iterations": 10}},
    "impratio": {"options": HIGH_IMPRATIO},
    "pyramidal": {"options": PYRAMIDAL},
    "half-timeconst": {"timeconst_s": 0.01},
    "half-step": {"options": {"timestep": 0.001}},
    "term": {"contact_bias": True},
    "term-pyramidal": {"contact_bias": True, "options": PYRAMIDAL},
    "term-rk4": {"contact_bias": True, "options": RK4},
    "term-rk4-impratio": {"contact_bias": True, "options": RK4 | HIGH_IMPRATIO},
    "term-centred": {"contact_bias": True, "bias_centred": True},
    "term-centred-impratio": {"contact_bias": True, "bias_centred": True, "options": HIGH_IMPRATIO},
}
CASES = [
    Turntable(f"{name}-{engine}", engine, **fields) for engine in ("warp", "c") for name, fields in VARIANTS.items()
]


def measure(conditions: Conditions) -> list[dict]:
    """Measure a row for each run: how fast the box's distance from the axis grows, measured and predicted."""
    return [row_of(case, conditions) for case in tqdm(CASES, desc="turntable", unit="run", delay=3.0)]


def row_of(case: Turntable, conditions: Conditions) -> dict[str, object]:
    row = {"case": case.name, "backend": case.engine, "contact_bias": case.contact_bias, **case.options}
    row |= {"bias_centred": case.bias_centred, "timeconst_s": case.timeconst_s}
    if case.engine == "warp" and "noslip_iterations" in case.options and not warp_has_noslip():
        return row | absent(GROWTHS, "MuJoCo Warp here has no noslip")
    seconds = SECONDS[conditions.profile]
    try:
        run = run_in_c(case, seconds) if case.engine == "c" else run_in_warp(case, seconds, conditions.device)
        return row | growth_columns(run) | {"predicted_growth_per_s": predicted_growth_per_s(case, run)}
    except RunFailed as failed:
        return row | absent(GROWTHS, str(failed))


def growth_columns(run: Run) -> dict[str, float]:
    """Fit the rate of the exponential growth, from a line through the logarithm, and the ends.

    Raises:
        RunFailed: The box is not on the table any more, or nowhere.
    """
    if not np.isfinite(run.radius_m).all():
        raise RunFailed("not finite")
    if run.contacts.count == 0:
        raise RunFailed("nothing is touched at the end")
    time_s = SAMPLE_S * np.arange(len(run.radius_m))
    settled = time_s >= SETTLE_S
    growth = np.polyfit(time_s[settled], np.log(run.radius_m[settled]), 1)[0]
    start, end = run.radius_m[settled][[0, -1]]
    return {
        "loaded_contact_count": run.contacts.count,
        "growth_per_s": float(growth),
        "start_radius_mm": 1e3 * float(start),
        "end_radius_mm": 1e3 * float(end),
    }


def start_state(model: mujoco.MjModel) -> mujoco.MjData:
    """Put the box at rest on the turning table."""
    data = mujoco.MjData(model)
    data.qvel[:] = TURN_RAD_S, 0.0, TURN_RAD_S * RADIUS_M, 0.0, 0.0, 0.0, TURN_RAD_S
    mujoco.mj_forward(model, data)
    return data


def path_in_c(
    model: mujoco.MjModel, data: mujoco.MjData, control: Callable[..., None] | None, seconds: float
) -> np.ndarray:
    """Return the places of the last body, which is free, every SAMPLE_S in MuJoCo's C engine [m], shape [samples, 3].

    Raises:
        RunFailed: Of the engine.
    """
    mujoco.set_mjcb_control(control)  # for all models, so only for as long as this one is stepped
    try:
        path = [data.qpos[-7:-4].copy()]
        for _ in range(round(seconds / SAMPLE_S)):
            for _ in range(round(SAMPLE_S / model.opt.timestep)):
                mujoco.mj_step(model, data)
            refuse_warned(data)
            path.append(data.qpos[-7:-4].copy())
    finally:
        mujoco.set_mjcb_control(None)
    return np.array(path)


def run_in_c(case: Turntable, seconds: float) -> Run:
    """Run the box in MuJoCo's C engine; RunFailed as from it."""
    model = case.model()
    data = start_state(model)
    control = partial(contact_bias_c.subtract_bias, centred=case.bias_centred) if case.contact_bias else None
    path = path_in_c(model, data, control, seconds)
    return Run(np.hypot(*path[:, :2].T), contacts_in_c(model, data))


def run_in_warp(case: Turntable, seconds: float, device: str) -> Run:
    model = case.model()
    with wp.ScopedDevice(device):
        m, d = mjw.put_model(model), mjw.put_data(model, start_state(model), nconmax=32, njmax=128)
        if case.contact_bias:
            contact_bias.install(SimpleNamespace(mjw_model=m, mjw_data=d), centred=case.bias_centred)
        mjw.step(m, d)  # compiles, which must not happen inside a capture
        with wp.ScopedCapture() as capture:
            for _ in range(round(SAMPLE_S / model.opt.timestep)):
                mjw.step(m, d)
        radius = [np.hypot(*d.qpos.numpy()[0, 1:3].astype(float))]
        for _ in range(round(seconds / SAMPLE_S)):
            wp.capture_launch(capture.graph)
            radius.append(np.hypot(*d.qpos.numpy()[0, 1:3].astype(float)))
        return Run(np.array(radius), contacts_in_warp(model, d))


def predicted_growth_per_s(case: Turntable, run: Run) -> float:
    """Predict the growth by the law in the module's text, with the softness of the contacts that the run ends with."""
    model = case.model()
    h = model.opt.timestep
    b = contact_bias_c.damping(model, model.geom_solref[0], model.geom_solimp[0])
    creep = 0.0 if "noslip_iterations" in case.options else MASS_KG * run.contacts.softness_1_kg
    left_out = 1.0 - case.contact_bias * (1.0 - 0.5 * h * b * case.bias_centred)
    step = 0.0 if case.options.get("integrator") == "rk4" else 0.5 * h
    return float(TURN_RAD_S**2 * ((left_out + creep) / b - step) * (1.0 - 5.0 * (TURN_RAD_S / b) ** 2))
