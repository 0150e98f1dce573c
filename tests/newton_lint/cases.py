"""Scenes with creep that the lint predicts and that MuJoCo C simulates."""

import math
from collections.abc import Iterator
from dataclasses import dataclass

import mujoco
import numpy as np

from newton_lint.report import scene_of
from newton_lint.target import Target
from tests.newton_lint.settle import Work, settled, settled_hold, started

BALLAST = 'tolerance="1e-12" iterations="200"'
INCLINE = """
<mujoco>
  <option timestep="{dt}" cone="{cone}" impratio="{impratio}" integrator="{integrator}" {option} gravity="{gx} 0 {gz}">
    {flags}
  </option>
  <default><geom friction="{mu}" condim="{condim}" solref="{solref}" solimp="{solimp}"/></default>
  <worldbody>
    <geom name="floor" type="plane" size="5 5 1" {floor}/>
    <body name="held" pos="0 0 0.049"><freejoint/>
      <geom name="box" type="{shape}" size="0.05 0.05 0.05" mass="{mass}" {box}/></body>
  </worldbody>
  {rest}
</mujoco>
"""
PINCH = """
<mujoco>
  <option timestep="{dt}" cone="{cone}" impratio="{impratio}" integrator="{integrator}" {option}>{flags}</option>
  <default><geom friction="{mu}" condim="{condim}" solref="{solref}" solimp="{solimp}"/></default>
  <worldbody>
    <body name="palm" pos="0 0 0.5">
      <body name="left" pos="-0.04 0 0"><joint name="l" type="slide" axis="1 0 0" damping="20"/>
        <geom name="left_pad" type="box" size="0.01 0.02 0.02" mass="0.1" {floor}/></body>
      <body name="right" pos="0.04 0 0"><joint name="r" type="slide" axis="-1 0 0" damping="20"/>
        <geom name="right_pad" type="box" size="0.01 0.02 0.02" mass="0.1" {floor}/></body>
    </body>
    <body name="held" pos="0 0 0.5"><freejoint/>
      <geom name="box" type="{shape}" size="0.0295 0.0295 0.0295" mass="{mass}" {box}/></body>
  </worldbody>
  <actuator><motor joint="l"/><motor joint="r"/></actuator>
  <keyframe><key ctrl="{grip} {grip}" qpos="0 0 0 0 0.5 1 0 0 0"/></keyframe>
  {rest}
</mujoco>
"""
TURN = """
<mujoco>
  <option timestep="{dt}" cone="{cone}" impratio="{impratio}" integrator="{integrator}" {option}>{flags}</option>
  <default><geom friction="{mu}" condim="{condim}" solref="{solref}" solimp="{solimp}"/></default>
  <worldbody>
    <body name="table"><joint type="hinge" axis="0 0 1" armature="1e6"/>
      <geom name="floor" type="box" size="2 2 1" pos="0 0 -1" mass="1" {floor}/></body>
    <body name="held" pos="{radius} 0 0.099">
      <joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/><joint type="slide" axis="0 0 1"/>
      <geom name="box" type="sphere" size="0.1" mass="{mass}" {box}/></body>
  </worldbody>
  {rest}
</mujoco>
"""
USUAL = {
    "dt": 0.002, "cone": "elliptic", "impratio": 1, "integrator": "Euler", "option": BALLAST, "flags": "", "mu": 1,
    "condim": 3, "solref": "0.02 1", "solimp": "0.9 0.95 0.001 0.5 2", "floor": "", "box": "", "shape": "box",
    "mass": 0.5, "rest": "", "grip": 30, "radius": 1.0, "slope": 0.2,
}  # fmt: skip
PAIR = '<contact><pair geom1="{one}" geom2="box" {more}/></contact>'


@dataclass(frozen=True)
class Case:
    """Describes a kind of scene and its differences from the usual settings."""

    kind: str
    changes: tuple[tuple[str, object], ...]

    def __str__(self) -> str:
        return f"{self.kind} {', '.join(f'{name}={value}' for name, value in self.changes)}"

    @property
    def text(self) -> str:
        given = USUAL | dict(self.changes)
        slope = math.atan(given["slope"])
        given |= {"gx": 9.81 * math.sin(slope), "gz": -9.81 * math.cos(slope)}
        return {"incline": INCLINE, "pinch": PINCH, "turn": TURN}[self.kind].format(
            **given
        )

    @property
    def target(self) -> Target:
        return Target(str(self), mujoco.MjModel.from_xml_string(self.text))

    def predicted_mm_s(self) -> float:
        """Return the prediction of ``--hold``, with ``--turn 0.5`` for a turning table."""
        target = self.target
        return settled_hold(
            scene_of(target),
            target,
            Work("held", turn_rad_s=0.5 * (self.kind == "turn")),
        ).mm_s

    def measured_mm_s(self) -> float:
        """Return the simulated speed of the body relative to its support."""
        model = self.target.model
        data = started(model)
        body = model.body("held").id
        support = 1 if self.kind == "turn" else 0
        if self.kind == "turn":
            data.qvel[0] = 0.5
            data.qvel[2] = 0.5 * dict(self.changes).get("radius", 1.0)
        start = _within(model, settled(model, data, 0.5), body, support)
        time = 0.3
        end = _within(model, settled(model, data, time), body, support)
        return 1e3 * float(np.linalg.norm(end - start)) / time


def _within(
    model: mujoco.MjModel, data: mujoco.MjData, body: int, support: int
) -> np.ndarray:
    """Return a position in another body's frame, or the distance from a turning axis."""
    mujoco.mj_kinematics(model, data)
    place = data.xmat[support].reshape(3, 3).T @ (data.xpos[body] - data.xpos[support])
    return np.array([math.hypot(*place[:2])]) if support else place


def cases() -> Iterator[Case]:
    """Yield all cases, kind by kind."""
    for kind in ("incline", "pinch", "turn"):
        yield from (Case(kind, changes) for changes in _settings(kind))


def _settings(kind: str) -> Iterator[tuple[tuple[str, object], ...]]:
    yield ()
    yield from ((("cone", "pyramidal"), ("mu", mu)) for mu in (0.6, 1, 2))
    yield from (
        (("cone", cone), ("impratio", 10)) for cone in ("pyramidal", "elliptic")
    )
    yield from (
        (("condim", condim), ("cone", cone))
        for condim in (4, 6)
        for cone in ("elliptic", "pyramidal")
    )
    yield from (
        (("solref", solref),)
        for solref in ("0.01 1", "0.001 1", "0.02 2", "-2500 -100", "-10000 -100")
    )
    yield from (
        (("solimp", solimp),)
        for solimp in (
            "0.5 0.9 0.01 0.5 2",
            "0.95 0.99 0.001 0.3 4",
            "0.95 0.6 0.002 0.5 2",
        )
    )
    yield (("floor", 'solref="0.004 1"'),)
    yield (("floor", 'solref="0.004 1" priority="1"'),)
    yield (("floor", 'solref="0.004 1" solmix="4"'),)
    yield (("box", 'solref="-9000 -200"'), ("floor", 'priority="1"'))
    yield (("box", 'solref="-9000 -200"'),)
    yield from ((("integrator", name),) for name in ("RK4", "implicit", "implicitfast"))
    yield (("integrator", "RK4"), ("dt", 0.01))
    yield (("dt", 0.01),)
    yield (("option", f'{BALLAST} noslip_iterations="20"'),)
    yield (
        ("option", f'{BALLAST} o_solref="0.005 1" o_solimp="0.8 0.9 0.001 0.5 2"'),
        ("flags", '<flag override="enable"/>'),
    )
    yield (("flags", '<flag refsafe="disable"/>'), ("solref", "0.003 1"))
    if kind != "pinch":
        yield (("rest", PAIR.format(one="floor", more='solref="0.006 1"')),)
        yield (("rest", PAIR.format(one="floor", more='solreffriction="0.005 1"')),)
        yield (
            (
                "rest",
                PAIR.format(
                    one="floor", more='solreffriction="-500 -80" friction="0.8 0.8"'
                ),
            ),
        )
        yield (("rest", PAIR.format(one="floor", more='friction="0.8 0.3"')),)
        yield (
            (
                "rest",
                '<default><pair solref="0.008 1"/></default>'
                + PAIR.format(one="floor", more=""),
            ),
        )
    if kind == "incline":
        yield from (
            (("slope", slope), ("cone", cone))
            for slope in (0.6, 0.95, 1.1)
            for cone in ("elliptic", "pyramidal")
        )
    if kind == "pinch":
        yield from ((("mass", mass), ("grip", 10)) for mass in (0.1, 1, 2.2))
