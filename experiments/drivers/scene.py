"""Define scenes as data, and the traces that engines return."""

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
    """Describe a free body that is a box or stands on balls."""

    mass_kg: float
    inertia_kg_m2: Vector
    position_m: Vector = ORIGIN
    foot_m: float = 0.0  # radius of the balls
    feet: Sequence[Vector] = ()  # positions of the balls; a body without them is a box
    half_size_m: Vector = ()
    velocity_m_s: Vector = ORIGIN
    spin_rad_s: Vector = ORIGIN


@dataclass(frozen=True)
class Support:
    """Describe a box on a joint with the world, on which gravity does not act."""

    joint: str  # ``hinge`` or ``slide``
    axis: Vector
    half_size_m: Vector
    position_m: Vector
    mass_kg: float
    inertia_kg_m2: float
    speed: float = 0.0  # speed of a hinge at the start [rad/s]
    force_n: float = 0.0


@dataclass(frozen=True)
class Robot:
    """Describe an arm in URDF and its drives."""

    file: str
    tool: str
    ke: float
    kd: float
    effort: Vector
    armature: Vector


@dataclass(frozen=True)
class Scene:
    """Describe the scene of a run.

    Engines that read MJCF take bodies and friction from it.
    """

    step_s: float  # 0 means continuous time
    sample_s: float
    targets: Sequence[Vector]  # targets of the actuators from one sample to the next
    mjcf: str = ""
    qpos: Vector = ()  # joint positions of the robot at the start [rad, m]
    qvel: Vector = ()
    body: Body | None = None
    supports: Sequence[Support] = ()
    robot: Robot | None = None
    friction: float = 1.0
    gravity_m_s2: Vector = (0.0, 0.0, -GRAVITY_M_S2)


@dataclass(frozen=True)
class Trace:
    """The results of a run; a result that an engine does not provide is None.

    Attributes:
        poses: Poses of the body and the robot's tool, or of the body in each world, at
            the start and after each sample. A pose is a position [m] with a quaternion
            (x, y, z, w), or a position alone. Shape [1 + samples, bodies, 7 or 3].
        forces: Sums of normal and of tangential forces [N] and the largest depth [m] of
            all contacts after each sample, shape [samples, 3]; NaN if they are unknown.
        joints: Final positions of all joints [rad, m]. velocity_m_s: Velocity of the
        body, shape [1 + samples, worlds, 3]. contacts: Final contacts of the first
        world. model: The model that the engine uses.
    """

    poses: np.ndarray
    forces: np.ndarray | None = None
    joints: np.ndarray | None = None
    velocity_m_s: np.ndarray | None = None
    contacts: Contacts | None = None
    model: mujoco.MjModel | None = None

    @property
    def path_m(self) -> np.ndarray:
        """Return the body's positions in the first world [m], [1 + samples, 3]."""
        return self.poses[:, 0, :3]
