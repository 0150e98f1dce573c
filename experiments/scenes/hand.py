"""A hand of 15 joints closes around a capsule, turns over and swings it at arm's length: up to which step it holds.

After the grasping test of Erez, Tassa and Todorov (2015), who asked up to which time step a hand holds a capsule while
the arm moves. Their robot, of 35 joints, is not published as a model: this hand is one of our own, and only the
question is theirs.

The arm turns about a vertical axis with the rate ω, and the capsule points along it, at the distance r. A friction row
leaves out what the turning asks for, ω² r outward, brakes with b v, and yields R f to the force f that keeps the
capsule's mass m turning. Euler and implicitfast move by the speed at a step's end, which takes back half a step h of
what was left out; RK4 does not. So the capsule creeps outward, as the box on the turntable of this report:

    dr/dt = ω² r ((1 + m R) / b - h / 2),    b = 2 / (dmax max(timeconst, 2 h)).
"""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial

import mujoco
import numpy as np
from tqdm import tqdm

from experiments.simulation import contact_bias_c
from experiments.simulation.c_warnings import RunFailed
from experiments.simulation.mjcf_engines import ENGINES, SOLIMP, STEPS, Contacts, Engine, InC, numbers
from measured_report.measuring.measurement import Conditions, absent
from newton_lint.creep import response

REACH_M = 0.5
"""From the arm's axis to the middle of the palm."""
PALM_HALF_SIZE_M = (0.055, 0.036, 0.01)
LINKS_M = (0.045, 0.032, 0.025)
"""Lengths of finger and thumb, from the palm on."""
LINK_RADIUS_M, LINK_MASS_KG = 0.009, 0.03
ROOT_M = 0.034
"""Distance of fingers and thumb from the palm's middle, to either side."""
FINGERS_AT_M = (-0.044, -0.022, 0.022, 0.044)
"""Places along the capsule; the thumb is opposite, in the middle."""
RADIUS_M, HALF_LENGTH_M, MASS_KG = 0.025, 0.06, 0.2
"""The capsule; the length is without its ends."""
WEIGHT_N = 9.81 * MASS_KG
GAP_M = 0.0002
"""Gap between capsule and palm at the start."""
GAIN_N_M_RAD = 1.0
CLOSED_RAD = (0.5, 1.1, 1.0)
"""Angles of a finger's joints: farther than the capsule lets them close."""
PHASES_S = (0.4, 1.0, 1.2)
"""Ends of the closing, of the turning over, and of the rest before the swing [s]."""
SWING_RAD, SWING_HZ, RAMP_S = 0.6, 1.0, 0.5
SECONDS = {"full": 3.0, "quick": 1.0}
LOST_M = HALF_LENGTH_M + RADIUS_M
"""A capsule that is moved by more has its rear end before the palm's middle: it is lost."""
STEPS_MS = {"full": (0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0), "quick": (2.0, 8.0, 32.0, 64.0)}
TOLERANCE = {"full": 0.01, "quick": 0.1}
"""Resolution of the search for the largest step that holds, between two of these."""


@dataclass(frozen=True)
class Grasp:
    """One way to simulate it; options as in MJCF."""

    name: str
    engine: str = "c"
    integrator: str = "implicitfast"
    cone: str = "elliptic"
    impratio: float = 10.0
    timeconst_s: float = 0.004
    contact_bias: bool = False
    """Friction rows are given back what they leave out, centred; in C alone."""

    def mjcf(self, timestep_s: float) -> str:
        """Write the scene."""
        option = f'timestep="{timestep_s}" integrator="{self.integrator}" cone="{self.cone}" impratio="{self.impratio}"'
        digits = {f"finger{number}": (x, 1) for number, x in enumerate(FINGERS_AT_M)} | {"thumb": (0.0, -1)}
        hand = "".join(_finger(name, x, side) for name, (x, side) in digits.items())
        actuators = "".join(
            f'<position joint="{digit}_{joint}" kp="{GAIN_N_M_RAD}"/>' for digit in digits for joint in range(3)
        )
        return f"""
        <mujoco>
          <compiler angle="radian"/>
          <option {option}/>
          <default>
            <geom solref="{self.timeconst_s} 1" solimp="{numbers(SOLIMP)}"/>
            <default class="finger"> <joint damping="0.03" armature="0.0005" range="-0.5 2"/> </default>
          </default>
          <worldbody>
            <body name="arm">
              <joint name="swing" axis="0 0 1" damping="2" armature="0.1"/>
              <geom type="capsule" size="0.02" fromto="0 0 0 0.35 0 0" mass="0.5" contype="0" conaffinity="0"/>
              <body name="palm" pos="{REACH_M} 0 0">
                <joint name="turn" axis="1 0 0" damping="0.5" armature="0.02"/>
                <geom type="box" size="{numbers(PALM_HALF_SIZE_M)}" pos="0 0 {-PALM_HALF_SIZE_M[2]}" mass="0.3"/>
                {hand}
              </body>
            </body>
            <body name="capsule" pos="{REACH_M} 0 {RADIUS_M + GAP_M}">
              <freejoint/>
              <geom type="capsule" size="{RADIUS_M} {HALF_LENGTH_M}" zaxis="1 0 0" mass="{MASS_KG}"/>
            </body>
          </worldbody>
          <actuator>
            <position joint="swing" kp="200"/>
            <position joint="turn" kp="20"/>
            {actuators}
          </actuator>
        </mujoco>"""


SETTINGS = (
    Grasp("implicitfast"),
    Grasp("euler", integrator="Euler"),
    Grasp("rk4", integrator="RK4"),
    Grasp("pyramidal", cone="pyramidal", impratio=1.0),
    Grasp("own-timeconst", timeconst_s=0.02),
    Grasp("term", contact_bias=True),
    Grasp("warp", engine="warp"),
    Grasp("through-newton", engine="newton"),
)


def _finger(name: str, x: float, side: int, joint: int = 0) -> str:
    """Write a finger on one side of the palm, from a joint on."""
    if joint == len(LINKS_M):
        return ""
    at = f"0 0 {LINKS_M[joint - 1]}" if joint else f"{x} {side * ROOT_M} 0"
    return f"""
    <body name="{name}_{joint}" pos="{at}">
      <joint name="{name}_{joint}" class="finger" axis="{side} 0 0"/>
      <geom type="capsule" size="{LINK_RADIUS_M}" fromto="0 0 0 0 0 {LINKS_M[joint]}" mass="{LINK_MASS_KG}"/>
      {_finger(name, x, side, joint + 1)}
    </body>"""


def command(time_s: float) -> np.ndarray:
    """Return the controls of arm, palm and fingers [rad], shape [17]."""
    closed, turned, begin = PHASES_S
    grip = np.array(CLOSED_RAD) * min(time_s / closed, 1.0)
    turn = math.pi * _eased((time_s - closed) / (turned - closed))
    swinging = max(time_s - begin, 0.0)
    swing = SWING_RAD * _eased(swinging / RAMP_S) * math.sin(2.0 * math.pi * SWING_HZ * swinging)
    return np.array([swing, turn, *np.tile(grip, len(FINGERS_AT_M) + 1)])


def _eased(part: float) -> float:
    """Go from 0 to 1 without a jolt at either end."""
    part = min(max(part, 0.0), 1.0)
    return part * part * (3.0 - 2.0 * part)


class WithBias(InC):
    """MuJoCo's C engine, with what friction rows leave out put back."""

    def advance(self) -> None:
        mujoco.set_mjcb_control(partial(contact_bias_c.subtract_bias, centred=True))  # one for all models
        try:
            super().advance()
        finally:
            mujoco.set_mjcb_control(None)


@dataclass(frozen=True)
class Look:
    """A look at where the capsule is, and how fast the arm turns."""

    place_m: np.ndarray
    """Place in the palm's frame, shape [3]."""
    radius_m: float
    """Distance from the arm's axis."""
    rate_rad_s: float

    @classmethod
    def at(cls, engine: Engine) -> "Look":
        """Look after the last step."""
        if isinstance(engine, InC):
            [world] = engine.worlds
            qpos, qvel = world.qpos, world.qvel
        else:
            qpos, qvel = engine.data.qpos.numpy()[0], engine.data.qvel.numpy()[0]
        swing, turn, position = qpos[0], qpos[1], qpos[engine.free[0]]
        palm = _about_z(swing) @ np.array([REACH_M, 0.0, 0.0])
        place = (_about_z(swing) @ _about_x(turn)).T @ (position - palm)
        return cls(place, float(np.hypot(*position[:2])), float(qvel[0]))


def _about_z(angle_rad: float) -> np.ndarray:
    cos, sin = np.cos(angle_rad), np.sin(angle_rad)
    return np.array([[cos, -sin, 0.0], [sin, cos, 0.0], [0.0, 0.0, 1.0]])


def _about_x(angle_rad: float) -> np.ndarray:
    cos, sin = np.cos(angle_rad), np.sin(angle_rad)
    return np.array([[1.0, 0.0, 0.0], [0.0, cos, -sin], [0.0, sin, cos]])


@dataclass(frozen=True)
class Swung:
    """A run, up to where the capsule is lost, if it is."""

    failure: str | None
    """Reason why it is not held."""
    slip_m: float
    """Way in the hand since the swing began."""
    law_slip_m: float
    """The same by the law in the module's text."""
    radius_m: float
    """Distance from the arm's axis when the swing began."""
    contacts: Contacts
    """Contacts when the swing began."""


def swing(grasp: Grasp, timestep_s: float, seconds: float, device: str) -> Swung:
    """Close the hand, turn it over and swing it, until the end or until the capsule is lost."""
    mjcf, pair_s = grasp.mjcf(timestep_s), STEPS * timestep_s
    engine = WithBias(mjcf) if grasp.contact_bias else ENGINES[grasp.engine](mjcf, 1, device)
    begin, end = (round(time_s / pair_s) for time_s in (PHASES_S[-1], PHASES_S[-1] + seconds))
    start = look = Look.at(engine)
    contacts, turning_per_s, failure = engine.contacts(), 0.0, None
    for pair in range(end):
        if pair == begin:
            start, contacts, turning_per_s = look, engine.contacts(), 0.0
        engine.command(command((pair + 0.5) * pair_s)[None])
        try:
            engine.advance()
        except RunFailed as failed:
            failure = str(failed)
            break
        look = Look.at(engine)
        turning_per_s += pair_s * look.rate_rad_s**2
        if np.linalg.norm(look.place_m - start.place_m) > LOST_M:
            failure = "dropped"
            break
    slip_m = float(np.linalg.norm(look.place_m - start.place_m))
    law_slip_m = start.radius_m * math.expm1(rate_s(grasp, timestep_s, contacts) * turning_per_s)
    return Swung(failure, slip_m, law_slip_m, start.radius_m, contacts)


def rate_s(grasp: Grasp, timestep_s: float, contacts: Contacts) -> float:
    """Return how fast the capsule creeps outward by the law, of ω² r [s]; nan where nothing is touched."""
    if not contacts.count:
        return math.nan
    response_s = response((grasp.timeconst_s, 1.0), SOLIMP[1], timestep_s)
    offset_s = 0.0 if grasp.integrator == "RK4" else 0.5 * timestep_s
    left_out_s = 0.0 if grasp.contact_bias else response_s - offset_s
    return left_out_s + MASS_KG * contacts.softness_1_kg * response_s


def rows(conditions: Conditions) -> list[dict[str, object]]:
    """Make a row for each setting and step, and one for each setting with the largest step that holds."""
    found: list[dict[str, object]] = []
    for grasp in tqdm(SETTINGS, desc="hand", unit="setting", delay=3.0):

        def run(step_ms: float, grasp: Grasp = grasp) -> Swung:
            return swing(grasp, 1e-3 * step_ms, SECONDS[conditions.profile], conditions.device)

        said = {"backend": grasp.engine, "integrator": grasp.integrator, "cone": grasp.cone, "impratio": grasp.impratio}
        said |= {"timeconst_s": grasp.timeconst_s, "contact_bias": grasp.contact_bias}
        runs = {step_ms: run(step_ms) for step_ms in STEPS_MS[conditions.profile]}
        for step_ms, swung in runs.items():
            row = {"case": f"{step_ms:g}ms-{grasp.name}", **said, "step_ms": step_ms}
            found.append(row | run_columns(step_ms, swung))
        largest = largest_columns(runs, run, TOLERANCE[conditions.profile])
        found.append({"case": grasp.name, **said, **largest, "lost_mm": 1e3 * LOST_M})
    return found


def run_columns(step_ms: float, swung: Swung) -> dict[str, object]:
    """Say whether the capsule was held, why not, and how far it moved in the hand, measured and by the law."""
    row: dict[str, object] = {"is_held": swung.failure is None, "failure": swung.failure}
    if swung.failure:
        names = ("slip_mm", "predicted_slip_mm", "normal_force_n", "loaded_contact_count")
        return row | absent(names, f"{swung.failure} with a step of {step_ms:g} ms")
    row |= {"weight_n": WEIGHT_N, "slip_mm": 1e3 * swung.slip_m, "predicted_slip_mm": 1e3 * swung.law_slip_m}
    return row | {"normal_force_n": swung.contacts.normal_n, "loaded_contact_count": swung.contacts.count}


def largest_columns(runs: Mapping[float, Swung], run: Callable[[float], Swung], tolerance: float) -> dict[str, object]:
    """Close in on the largest step that holds, from the last one tried that does, and say what the law makes of it.

    By the law the logarithm of the distance from the axis grows in proportion with the step, wherever two of them are
    more than the timeconst.
    """
    names = ("largest_step_ms", "failing_step_ms", "predicted_largest_step_ms")
    low = max((step for step, swung in runs.items() if not swung.failure), default=None)
    if low is None:
        return absent(names, "no step that was tried holds it")
    high = min((step for step in runs if step > low), default=None)
    if high is None:
        return absent(names, f"the longest step that was tried holds it, {low:g} ms")
    held = runs[low]
    while high / low > 1.0 + tolerance:
        middle = math.sqrt(low * high)
        tried = run(middle)
        if tried.failure:
            high = middle
        else:
            low, held = middle, tried
    predicted = low * math.log1p(LOST_M / held.radius_m) / math.log1p(held.law_slip_m / held.radius_m)
    return dict(zip(names, (low, high, predicted), strict=True))
