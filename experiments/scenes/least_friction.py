"""The least friction with which a cube stays between a Panda's fingers, over the least by Coulomb's law, m g / N.

After the critical friction test of MotrixSim's grasp contact benchmark: the cube is picked up with ample friction, the
fingers' force is measured, and from that state, at rest, the cube is held for 5 s with another friction.

The cube is not held at its centre, and so Coulomb's law asks for more than m g / N. Let contacts with normal forces Nᵢ
slide with velocities vᵢ while the cube moves along the fingers as a rigid body whose centre sinks with 1 m/s. Friction
can stop that motion if Σ μ Nᵢ |vᵢ| ≥ m g, and it holds the cube if it can stop every one: the least friction is
μ = m g / min Σ Nᵢ |vᵢ|. A pyramid with its edges along the tangents has the larger of the two parts of vᵢ along them in
place of |vᵢ|.
"""

import math
from dataclasses import dataclass

import mujoco
import numpy as np

from experiments.scenes import panda
from experiments.scenes.engines import STEPS, InC

CUBE = 'type="box" size="0.02 0.02 0.02" solref="0.005 1" solimp="0.99 0.99 0.5"'
TIMESTEP_S = 0.002
WARM_UP_S = 5.0
WINDOW_S = 0.2
"""At the end of the warm-up, over which the force is averaged."""
HOLD_S = {"full": 5.0, "quick": 1.0}
DROP_M = 0.005
"""A cube that sinks by more has slipped."""
LEAST, MOST = 0.5, 32.0
"""Between these multiples of m g / N the least one is looked for."""
TOLERANCE = 0.002


@dataclass(frozen=True)
class Setting:
    """Options as in MJCF."""

    name: str
    cone: str = "pyramidal"
    impratio: float = 1.0
    integrator: str = "Euler"
    noslip_iterations: int = 0

    def mjcf(self) -> str:
        """The scene."""
        option = f'timestep="{TIMESTEP_S}" cone="{self.cone}" impratio="{self.impratio}" integrator="{self.integrator}"'
        return panda.mjcf(CUBE, f'{option} noslip_iterations="{self.noslip_iterations}"')


@dataclass(frozen=True)
class Start:
    """The grasp that is tried with less friction."""

    engine: InC
    qpos: np.ndarray
    force_n: float
    """Of both fingers together, averaged."""
    weight_n: float
    speed_m_s: float
    """Root mean square of the cube's speed while it is held still."""
    normals_n: np.ndarray
    """Normal force of each contact, shape [contact]."""
    places_m: np.ndarray
    """Of the contacts, from the cube's centre, shape [contact, 3]."""
    frames: np.ndarray
    """Normal and tangents of the contacts, shape [contact, 3, 3]."""


def warm_up(setting: Setting) -> Start:
    """Pick the cube up.

    Raises:
        RunFailed: Of the engine, here as in all that follows.
    """
    engine = InC(setting.mjcf())
    model, [world] = engine.model, engine.worlds
    forces, speeds, pair_s = [], [], STEPS * TIMESTEP_S
    for pair in range(1, round(WARM_UP_S / pair_s) + 1):
        engine.command(panda.command(pair * pair_s)[None])
        engine.advance()
        if pair * pair_s >= WARM_UP_S - WINDOW_S:
            forces.append(engine.contacts().normal_n)
            speeds.append(engine.body()[1][0])
    force = np.zeros((world.ncon, 6))
    for contact in range(world.ncon):
        mujoco.mj_contactForce(model, world, contact, force[contact])
    return Start(
        engine,
        world.qpos.copy(),
        float(np.mean(forces)),
        float(-model.opt.gravity[2] * model.body_mass[-1]),
        float(np.sqrt(np.mean(np.sum(np.square(speeds), axis=1)))),
        force[:, 0],
        world.contact.pos - world.xipos[-1],
        world.contact.frame.reshape(-1, 3, 3).copy(),
    )


def coulomb_factor(start: Start, cone: str) -> float:
    """The least friction by Coulomb's law for where the cube is held, over m g / N; see the module's text."""
    down = np.array([0.0, 0.0, -1.0])
    normal = start.frames[0, 0]
    aside = np.cross(normal, down)

    def stopped(slide: float, turn: float) -> float:
        """Σ Nᵢ |vᵢ| for a centre that also moves aside [m/s], and a turn about the fingers [rad/s]."""
        velocity = down + slide * aside + np.cross(turn * normal, start.places_m)
        parts = np.abs(np.einsum("cij,cj->ci", start.frames[:, 1:], velocity))
        speed = parts.max(axis=1) if cone == "pyramidal" else np.linalg.norm(parts, axis=1)
        return float(start.normals_n @ speed)

    # The sum is convex, so that a grid that closes in on its least point finds it.
    best, span = np.zeros(2), np.array([1.0, 100.0])
    for _ in range(40):
        grid = [best + span * (a, b) for a in np.linspace(-1.0, 1.0, 9) for b in np.linspace(-1.0, 1.0, 9)]
        best, span = min(grid, key=lambda at: stopped(*at)), 0.6 * span
    return float(start.normals_n.sum() / stopped(*best))


def drop_m(start: Start, factor: float, seconds: float) -> float:
    """How far the cube sinks with a multiple of m g / N [m]; once it has slipped it is watched no longer."""
    engine = start.engine
    model, [world] = engine.model, engine.worlds
    model.geom_friction[1:, 0] = factor * start.weight_n / start.force_n  # all but the floor
    mujoco.mj_resetData(model, world)
    world.qpos[:] = start.qpos
    world.ctrl[:] = panda.command(WARM_UP_S)
    mujoco.mj_forward(model, world)
    height = world.qpos[engine.free[0]][2]
    lowest = height
    for _ in range(round(seconds / (STEPS * TIMESTEP_S))):
        engine.advance()
        lowest = min(lowest, world.qpos[engine.free[0]][2])
        if height - lowest > DROP_M:
            break
    return float(height - lowest)


def least_factors(start: Start, seconds: float) -> tuple[float, float]:
    """A multiple that does not hold and the least one that does, ``TOLERANCE`` apart.

    0 and the least one that is tried where that holds; the largest and infinity where that does not.
    """
    low, high = LEAST, MOST
    if drop_m(start, high, seconds) > DROP_M:
        return high, math.inf
    if drop_m(start, low, seconds) <= DROP_M:
        return 0.0, low
    while high / low > 1.0 + TOLERANCE:
        middle = float(np.sqrt(low * high))
        low, high = (low, middle) if drop_m(start, middle, seconds) <= DROP_M else (middle, high)
    return low, high
