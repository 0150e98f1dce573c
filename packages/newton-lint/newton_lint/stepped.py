"""Steps a scene in MuJoCo C from its start and its keyframes, and records the runs."""

import time
from collections.abc import Sequence
from dataclasses import dataclass, field

import mujoco
import numpy as np
from mujoco import MjData, MjModel

from newton_lint.scene import FREE, WEIGHTLESS
from newton_lint.settle import started
from newton_lint.target import Target

# A scene is stepped for this time by default.
STEPPED_S = 0.2
# A run stops early after this processor time.
BUDGET_S = 5.0
# A scene is stepped from at most this many starts.
MOST_STARTS = 4
# Scenes with more degrees of freedom are not stepped: a step takes seconds.
MOST_DOFS = 3000
# After these warnings mj_checkPos and mj_checkAcc reset the state, which then looks
# valid; only their counts remain.
BAD = [
    int(getattr(mujoco.mjtWarning, f"mjWARN_BAD{name}"))
    for name in ("QPOS", "QVEL", "QACC")
]


@dataclass(frozen=True)
class Start:
    """A state from which a scene, or any variant of it, can start."""

    name: str
    key: int | None = None
    """Its keyframe, or None."""
    state: MjData | None = None
    """The state that a function returned, or None."""

    def data(self, model: MjModel) -> MjData:
        """Return data of a model in this state."""
        if self.state is not None:
            return started(model, self.state)
        data = MjData(model)
        if self.key is not None:
            mujoco.mj_resetDataKeyframe(model, data, self.key)
        return data


@dataclass(frozen=True)
class Run:
    """The record of a scene that was stepped from one start."""

    start: Start
    time_s: float
    """Simulated time; shorter if the scene blew up or took too long."""
    bad: bool
    """Whether the scene blew up."""
    first: dict[tuple[int, int], float]
    """Deepest overlap of each pair of geoms at the start [m]."""
    deepest_m: float
    """Deepest contact over the whole run."""
    late_m: float
    """Deepest contact after the first third of the run."""
    rise_m2_s2: np.ndarray
    """Largest gain in energy of each free body [J/kg]."""
    speeds_m_s: np.ndarray
    """Speed of each free body at the end."""
    at_limit: float
    """Share of the steps in which the solver used all its iterations."""
    effort: float
    """Steps plus half the solver's iterations per simulated second.

    Unlike a time, it does not depend on the load of the machine.
    """
    cost_s: float
    """Processor time per simulated second."""
    data: MjData = field(compare=False, repr=False)

    @property
    def thrown_m_s(self) -> np.ndarray:
        """Return the speed of each free body that only contacts can have caused."""
        return np.sqrt(2.0 * np.maximum(self.rise_m2_s2, 0.0))


def free_joints(model: MjModel) -> np.ndarray:
    return np.flatnonzero(model.jnt_type == FREE)


def starts(model: MjModel, target: Target) -> list[Start]:
    """Return the starts of a scene: the given state, or the default and keyframes."""
    if target.data is not None:
        return [Start("the given state", state=target.data)]
    keys = range(min(model.nkey, MOST_STARTS - 1))
    return [
        Start("the start"),
        *(Start(f"keyframe {model.key(key).name or key}", key) for key in keys),
    ]


def runs_of(model: MjModel, target: Target, time_s: float = STEPPED_S) -> list[Run]:
    """Step a scene from each of its starts, or return [] if a step takes too long."""
    if model.nv > MOST_DOFS:
        return []
    return [run_of(model, start, time_s) for start in starts(model, target)]


def run_of(model: MjModel, start: Start, time_s: float) -> Run:
    """Step a model from a start and return the record of the run."""
    data = start.data(model)
    mujoco.mj_forward(model, data)
    first = overlaps(data)
    free = free_joints(model)
    places = model.jnt_qposadr[free][:, None] + np.arange(3)
    speeds = model.jnt_dofadr[free][:, None] + np.arange(3)
    gravity = np.zeros(3) if model.opt.disableflags & WEIGHTLESS else model.opt.gravity

    def energy() -> np.ndarray:
        return 0.5 * (data.qvel[speeds] ** 2).sum(axis=1) - data.qpos[places] @ gravity

    begin = energy()
    rise = np.zeros(len(free))
    deepest = deepest_of(data)
    late = 0.0
    limited = 0
    solved = 0
    count = max(1, round(time_s / model.opt.timestep))
    most = model.opt.iterations
    since = time.process_time()
    for step in range(1, count + 1):
        mujoco.mj_step(model, data)
        now_m = deepest_of(data)
        deepest = max(deepest, now_m)
        late = max(late, now_m) if 3 * step > count else late
        iterations = data.solver_niter  # One number per island, 0 for unused ones.
        limited = limited + (iterations.max() >= most)
        solved = solved + iterations.sum()
        if bad := is_bad(data):
            break
        rise = np.maximum(rise, energy() - begin)
        if time.process_time() - since > BUDGET_S:
            break
    reached = step * model.opt.timestep
    return Run(
        start=start,
        time_s=reached,
        bad=bad,
        first=first,
        deepest_m=deepest,
        late_m=late,
        rise_m2_s2=rise,
        speeds_m_s=np.linalg.norm(data.qvel[speeds], axis=1),
        at_limit=limited / step,
        effort=(step + 0.5 * solved) / reached,
        cost_s=(time.process_time() - since) / reached,
        data=data,
    )


def is_bad(data: MjData) -> bool:
    """Return whether the simulation blew up."""
    return any(data.warning[number].number for number in BAD)


def deepest_of(data: MjData) -> float:
    """Return the depth of the deepest contact [m], which is 0 if there is none."""
    # dist is negative inside.
    return -data.contact.dist.min(initial=0.0) if data.ncon else 0.0


def overlaps(data: MjData) -> dict[tuple[int, int], float]:
    """Return the largest overlap of each pair of geoms, including their margins [m]."""
    deepest: dict[tuple[int, int], float] = {}
    depths = data.contact.includemargin - data.contact.dist
    for pair, depth in zip(data.contact.geom.tolist(), depths.tolist(), strict=True):
        if depth > 0.0 <= min(pair):  # A flex has the geom -1.
            deepest[tuple(pair)] = max(depth, deepest.get(tuple(pair), 0.0))
    return deepest


def contact_forces(model: MjModel, data: MjData, contacts: Sequence[int]) -> np.ndarray:
    """Return force and torque of contacts in their frames, shape [contact_count, 6]."""
    forces = np.zeros((len(contacts), 6))
    for index, force in zip(contacts, forces, strict=True):
        mujoco.mj_contactForce(model, data, index, force)
    return forces
