"""A scene as data, and the trace that an engine returns of it."""

from collections.abc import Sequence
from dataclasses import dataclass

import mujoco
import numpy as np

from experiments.drivers.contacts import Contacts

GRAVITY_M_S2 = 9.81
Vector = Sequence[float]
ORIGIN = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Body:
    """A free body on balls, or a box."""

    mass_kg: float
    inertia_kg_m2: Vector
    position_m: Vector = ORIGIN
    foot_m: float = 0.0  # radius of the balls
    feet: Sequence[Vector] = ()  # where the balls are; without any it is a box
    half_size_m: Vector = ()
    velocity_m_s: Vector = ORIGIN
    spin_rad_s: Vector = ORIGIN


@dataclass(frozen=True)
class Support:
    """A box on a joint with the world, which bears no weight of its own."""

    joint: str  # ``hinge`` or ``slide``
    axis: Vector
    half_size_m: Vector
    position_m: Vector
    mass_kg: float
    inertia_kg_m2: float
    speed: float = 0.0  # of a hinge at the start [rad/s]
    force_n: float = 0.0


@dataclass(frozen=True)
class Robot:
    """An arm and its drives, as URDF has it."""

    file: str
    tool: str
    ke: float
    kd: float
    effort: Vector
    armature: Vector


@dataclass(frozen=True)
class Scene:
    """What an engine runs; one that reads MJCF takes bodies and friction from there."""

    step_s: float  # 0 is continuous time
    sample_s: float
    targets: Sequence[Vector]  # of the actuators, from one sample to the next
    mjcf: str = ""
    qpos: Vector = ()  # joints of the robot at the start [rad, m]
    qvel: Vector = ()
    body: Body | None = None
    supports: Sequence[Support] = ()
    robot: Robot | None = None
    friction: float = 1.0
    gravity_m_s2: Vector = (0.0, 0.0, -GRAVITY_M_S2)


@dataclass(frozen=True)
class Trace:
    """What a run shows; what an engine does not tell is None.

    Attributes:
        poses: Of the body and the robot's tool, or of the body in each world, at the start
            and after each sample: position [m] and quaternion (x, y, z, w) or position
            alone, shape [1 + samples, bodies, 7 or 3].
        forces: Sums of normal and of tangential forces [N] and the largest depth [m] of
            all contacts after each sample, shape [samples, 3]; NaN where it is not told.
        joints: Positions of all joints in the end [rad, m].
        velocity_m_s: Of the body in each world, shape [1 + samples, worlds, 3].
        contacts: Those of the first world in the end.
        model: The model as the engine has it.
    """

    poses: np.ndarray
    forces: np.ndarray | None = None
    joints: np.ndarray | None = None
    velocity_m_s: np.ndarray | None = None
    contacts: Contacts | None = None
    model: mujoco.MjModel | None = None

    @property
    def path_m(self) -> np.ndarray:
        """Positions of the body [m], in the first world, shape [1 + samples, 3]."""
        return self.poses[:, 0, :3]
