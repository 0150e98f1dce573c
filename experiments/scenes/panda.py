"""A Panda that picks up a small object: the robot of phys-bench's and MotrixSim's grasps, as the numbers that it is.

Offsets, masses and inertias are Franka's (franka_description, ``inertial.yaml``); gains, damping, pads and how the
fingers are driven are those of MuJoCo Menagerie's Panda for MJX, which both benchmarks use. Of its shapes only those
that can touch something are here: a box on each finger, and a capsule around the hand.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from experiments.simulation.mjcf_engines import numbers


@dataclass(frozen=True)
class Link:
    """A link of the arm; its joint turns about its z axis."""

    offset_m: tuple[float, float, float]
    """Place on the link before."""
    turn: int
    """Quarter turns about x from the link before."""
    mass_kg: float
    centre_m: tuple[float, float, float]
    inertia_kg_m2: tuple[float, float, float, float, float, float]
    """Moments about the centre: xx, yy, zz, xy, xz, yz."""
    range_rad: tuple[float, float]
    damping: float
    gain: float
    """Gain of its position actuator, which damps with a tenth of it."""
    force_n_m: float


WIDE = (-2.8973, 2.8973)
LINKS = (
    Link(
        (0.0, 0.0, 0.333), 0, 4.970684, (0.003875, 0.002081, -0.04762),
        (0.70337, 0.70661, 0.009117, -0.000139, 0.006772, 0.019169), WIDE, 40.0, 4500.0, 87.0,
    ),
    Link(
        (0.0, 0.0, 0.0), -1, 0.646926, (-0.003141, -0.02872, 0.003495),
        (0.007962, 0.02811, 0.025995, -0.003925, 0.010254, 0.000704), (-1.7628, 1.7628), 40.0, 4500.0, 87.0,
    ),
    Link(
        (0.0, -0.316, 0.0), 1, 3.228604, (0.027518, 0.039252, -0.066502),
        (0.037242, 0.036155, 0.01083, -0.004761, -0.011396, -0.012805), WIDE, 40.0, 3500.0, 87.0,
    ),
    Link(
        (0.0825, 0.0, 0.0), 1, 3.587895, (-0.05317, 0.104419, 0.027454),
        (0.025853, 0.019552, 0.028323, 0.007796, -0.001332, 0.008641), (-3.0718, -0.0698), 40.0, 3500.0, 87.0,
    ),
    Link(
        (-0.0825, 0.384, 0.0), -1, 1.225946, (-0.011953, 0.041065, -0.038437),
        (0.035549, 0.029474, 0.008627, -0.002117, -0.004037, 0.000229), WIDE, 2.0, 2000.0, 12.0,
    ),
    Link(
        (0.0, 0.0, 0.0), 1, 1.666555, (0.060149, -0.014117, -0.010517),
        (0.001964, 0.004354, 0.005433, 0.000109, -0.001158, 0.000341), (-0.0175, 3.7525), 2.0, 2000.0, 12.0,
    ),
    Link(
        (0.088, 0.0, 0.0), 1, 0.735522, (0.010517, -0.004252, 0.061597),
        (0.012516, 0.010027, 0.004815, -0.000428, -0.001196, -0.000741), WIDE, 2.0, 2000.0, 12.0,
    ),
)  # fmt: skip
"""Base first."""

OPEN_M = 0.04
"""How far each finger opens."""
READY = (0.0, 0.0, 0.0, -1.5708, 0.0, 1.5708, -0.7853)
AT_OBJECT = (-1.0104, 1.5623, 1.3601, -1.6840, -1.5863, 1.7810, 1.4598)
LIFTED = (-1.0426, 1.4028, 1.5634, -1.7114, -1.4055, 1.6015, 1.4510)
"""Poses of the arm [rad]."""
PHASES_S = (1.0, 2.0, 3.0, 4.0)
"""Ends of the motion over the object, of the one down to it, of closing and of lifting [s]."""
PAD_HALF_SIZE_M = (0.00875, 0.0076, 0.00825)
PAD_SOLREF, PAD_SOLIMP = (0.01, 1.0), (0.99, 0.995, 0.01)
OBJECT_AT_M = (0.65, 0.0, 0.02)


def mjcf(object_geom: str, option: str, *, pad_solref: Sequence[float] = PAD_SOLREF) -> str:
    """Write the robot, a floor and one free object.

    Args:
        object_geom: Attributes of the object's geom.
        option: Attributes of ``option``.
    """
    pose = " ".join(map(str, (*READY, OPEN_M, OPEN_M, *OBJECT_AT_M, 1, 0, 0, 0)))
    actuators = "".join(
        f"""<position joint="joint{number}" kp="{link.gain}" kv="{0.1 * link.gain}"
          ctrlrange="{numbers(link.range_rad)}" forcerange="{-link.force_n_m} {link.force_n_m}"/>"""
        for number, link in enumerate(LINKS, start=1)
    )
    return f"""
    <mujoco>
      <compiler angle="radian" autolimits="true"/>
      <option {option}/>
      <default>
        <joint armature="0.1" damping="1"/>
        <default class="pad">
          <geom type="box" size="{numbers(PAD_HALF_SIZE_M)}" pos="0 0.00758 0.04525" contype="0" conaffinity="3"
            friction="1 0.005 0.0001" solref="{numbers(pad_solref)}" solimp="{numbers(PAD_SOLIMP)}"/>
        </default>
      </default>
      <worldbody>
        <geom name="floor" type="plane" size="0 0 0.05"/>
        {_arm(0)}
        <body name="object" pos="{numbers(OBJECT_AT_M)}"><freejoint/><geom name="object" {object_geom}/></body>
      </worldbody>
      <equality>
        <joint joint1="finger1" joint2="finger2" solimp="0.95 0.99 0.001" solref="0.005 1"/>
      </equality>
      <actuator>
        {actuators}
        <general joint="finger1" ctrlrange="0 {OPEN_M}" forcerange="-200 200" biastype="affine" gainprm="350 0 0"
          biasprm="0 -350 -10"/>
      </actuator>
      <keyframe><key qpos="{pose}" ctrl="{numbers((*READY, OPEN_M))}"/></keyframe>
    </mujoco>"""


def _arm(number: int) -> str:
    """Write the links from one on, each with the next in it, and the hand in the last."""
    if number == len(LINKS):
        return _hand()
    link = LINKS[number]
    half = 0.25 * np.pi * link.turn
    return f"""
    <body name="link{number + 1}" pos="{numbers(link.offset_m)}" quat="{np.cos(half)} {np.sin(half)} 0 0">
      <inertial mass="{link.mass_kg}" pos="{numbers(link.centre_m)}" fullinertia="{numbers(link.inertia_kg_m2)}"/>
      <joint name="joint{number + 1}" axis="0 0 1" range="{numbers(link.range_rad)}" damping="{link.damping}"/>
      {_arm(number + 1)}
    </body>"""


def _hand() -> str:
    fingers = "".join(
        f"""
        <body name="finger{number}" pos="0 0 0.0584" quat="{turn}">
          <inertial mass="0.015" pos="0 0 0" diaginertia="2.375e-6 2.375e-6 7.5e-7"/>
          <joint name="finger{number}" type="slide" axis="0 1 0" range="0 {OPEN_M}" damping="10"/>
          <geom name="pad{number}" class="pad"/>
        </body>"""
        for number, turn in ((1, "1 0 0 0"), (2, "0 0 0 1"))
    )
    return f"""
    <body name="hand" pos="0 0 0.107" quat="{np.cos(np.pi / 8)} 0 0 {-np.sin(np.pi / 8)}">
      <inertial mass="0.73" pos="-0.01 0 0.03" diaginertia="0.001 0.0025 0.0017"/>
      <geom name="hand" type="capsule" size="0.04 0.06" quat="1 1 0 0" pos="0 0 0.03" contype="0" conaffinity="1"/>
      {fingers}
    </body>"""


def command(time_s: float) -> np.ndarray:
    """Return the controls of arm and fingers while the object is picked up, and after it [rad, m], shape [8]."""
    over, down, closed, lifted = PHASES_S
    at = (0.0, over, down, closed, lifted)
    arm = [np.interp(time_s, at, joint) for joint in zip(READY, LIFTED, AT_OBJECT, AT_OBJECT, LIFTED, strict=True)]
    return np.array([*arm, np.interp(time_s, at, (OPEN_M, OPEN_M, OPEN_M, 0.0, 0.0))])
