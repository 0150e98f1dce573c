"""What a scene does when MuJoCo C steps it from its start and its keyframes."""

import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

import mujoco
import numpy as np

from newton_lint.scene import FREE
from newton_lint.settle import started
from newton_lint.target import Target

STEPPED_S, BUDGET_S = 0.2, 5.0
"""Time that a scene is stepped by each call, and time of the processor after which a run stops where it is."""
MOST_STARTS, MOST_DOFS = 4, 3000
"""What moves in more ways is not stepped: a step takes seconds."""
# After one of them mj_checkPos and mj_checkAcc reset the state, which then looks sound: only the count stays.
BAD = {int(getattr(mujoco.mjtWarning, f"mjWARN_BAD{name}")): f"BAD{name}" for name in ("QPOS", "QVEL", "QACC")}


@dataclass(frozen=True)
class Run:
    """A run of a scene from one state."""

    start: str
    time_s: float
    """How long it was stepped; less where it blew up or took too long."""
    bad: str
    """The engine's name for what blew up; empty where nothing did."""
    first: dict[tuple[int, int], float]
    """Deepest overlap of each pair of geoms at the start [m]."""
    deepest_m: float
    """Of all contacts at all times."""
    late_m: float
    """Of those after the first third."""
    rise_m2_s2: np.ndarray
    """Of each free body the most energy that it gained [J/kg]."""
    speeds_m_s: np.ndarray
    """Of each free body at the end."""
    at_limit: float
    """Share of the steps in which the solver used up its iterations."""
    effort: float
    """Steps and half the solver's iterations in a simulated second, which no clock of a busy machine blurs."""
    cost_s: float
    """Time of the processor that it takes."""
    data: mujoco.MjData = field(compare=False, repr=False)

    @property
    def thrown_m_s(self) -> np.ndarray:
        """Return speed of each free body that nothing but contacts can have given it."""
        return np.sqrt(2.0 * np.maximum(self.rise_m2_s2, 0.0))


def free_joints(model: mujoco.MjModel) -> np.ndarray:
    return np.flatnonzero(model.jnt_type == FREE)


def starts(model: mujoco.MjModel, target: Target) -> Iterator[tuple[str, mujoco.MjData]]:
    """Yield the states that a scene can start from: the one that a function returns, or its own and its keyframes."""
    if target.data is not None:
        yield "the given state", started(model, target.data)
        return
    yield "the start", mujoco.MjData(model)
    for key in range(min(model.nkey, MOST_STARTS - 1)):
        data = mujoco.MjData(model)
        mujoco.mj_resetDataKeyframe(model, data, key)
        yield f"keyframe {model.key(key).name or key}", data


def runs_of(model: mujoco.MjModel, target: Target, time_s: float = STEPPED_S) -> list[Run]:
    """Step a scene from each of its starts; none where a step would take seconds."""
    if model.nv > MOST_DOFS:
        return []
    return [run_of(model, data, name, time_s) for name, data in starts(model, target)]


def run_of(model: mujoco.MjModel, data: mujoco.MjData, name: str, time_s: float) -> Run:
    """Step a state, and return what it did."""
    mujoco.mj_forward(model, data)
    first = overlaps(data)
    free = free_joints(model)
    places, speeds = model.jnt_qposadr[free][:, None] + np.arange(3), model.jnt_dofadr[free][:, None] + np.arange(3)
    gravity = np.zeros(3) if model.opt.disableflags & int(mujoco.mjtDisableBit.mjDSBL_GRAVITY) else model.opt.gravity

    def energy() -> np.ndarray:
        return 0.5 * (data.qvel[speeds] ** 2).sum(axis=1) - data.qpos[places] @ gravity

    begin, rise, deepest, late, limited, solved = energy(), np.zeros(len(free)), deepest_of(data), 0.0, 0, 0
    count, most, since = max(1, round(time_s / model.opt.timestep)), model.opt.iterations, time.process_time()
    for step in range(1, count + 1):
        mujoco.mj_step(model, data)
        now_m = deepest_of(data)
        deepest, late = max(deepest, now_m), max(late, now_m) if 3 * step > count else late
        iterations = data.solver_niter  # of each island, those that are not there 0
        limited, solved = limited + (iterations.max() >= most), solved + iterations.sum()
        if bad := next((warning for number, warning in BAD.items() if data.warning[number].number), ""):
            break
        rise = np.maximum(rise, energy() - begin)
        if time.process_time() - since > BUDGET_S:
            break
    reached = step * model.opt.timestep
    effort, cost = (step + 0.5 * solved) / reached, (time.process_time() - since) / reached
    now = np.linalg.norm(data.qvel[speeds], axis=1)
    return Run(name, reached, bad, first, deepest, late, rise, now, limited / step, effort, cost, data)


def deepest_of(data: mujoco.MjData) -> float:
    """Return how deep the deepest contact is [m]; 0 where none is pressed in."""
    return float(-data.contact.dist.min(initial=0.0)) if data.ncon else 0.0  # dist is below 0 inside


def overlaps(data: mujoco.MjData) -> dict[tuple[int, int], float]:
    """Return the deepest contact of each pair of geoms that press each other, from their margin on."""
    deepest: dict[tuple[int, int], float] = {}
    depths = data.contact.includemargin - data.contact.dist
    for pair, depth in zip(data.contact.geom.tolist(), depths.tolist(), strict=True):
        if depth > 0.0 <= min(pair):  # a flex has the geom -1
            deepest[tuple(pair)] = max(depth, deepest.get(tuple(pair), 0.0))
    return deepest


def contact_forces(model: mujoco.MjModel, data: mujoco.MjData, contacts: Sequence[int]) -> np.ndarray:
    """Return what contacts bear along their axes, force and torque; zeros of those that bear nothing."""
    forces = np.zeros((len(contacts), 6))
    for index, force in zip(contacts, forces, strict=True):
        mujoco.mj_contactForce(model, data, index, force)
    return forces
