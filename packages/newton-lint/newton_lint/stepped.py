"""What a scene does when MuJoCo C steps it from its start and its keyframes."""

import time
from collections.abc import Sequence
from dataclasses import dataclass, field

import mujoco
import numpy as np
from mujoco import MjData, MjModel

from newton_lint.scene import FREE, WEIGHTLESS
from newton_lint.settle import started
from newton_lint.target import Target

# Time that a scene is stepped by each call, and time of the processor after which a run stops where it is.
STEPPED_S = 0.2
BUDGET_S = 5.0
# What moves in more ways is not stepped: a step takes seconds.
MOST_STARTS = 4
MOST_DOFS = 3000
# After one of them mj_checkPos and mj_checkAcc reset the state, which then looks sound: only the count stays.
BAD = [
    int(getattr(mujoco.mjtWarning, f"mjWARN_BAD{name}"))
    for name in ("QPOS", "QVEL", "QACC")
]


@dataclass(frozen=True)
class Start:
    """A state that a scene, and any variant of it, can start from."""

    name: str
    key: int | None = None
    """Its keyframe; None of another state."""
    state: MjData | None = None
    """The state that a function returned."""

    def __str__(self) -> str:
        return self.name

    def data(self, model: MjModel) -> MjData:
        """Return a model in this state."""
        if self.state is not None:
            return started(model, self.state)
        data = MjData(model)
        if self.key is not None:
            mujoco.mj_resetDataKeyframe(model, data, self.key)
        return data


@dataclass(frozen=True)
class Run:
    """A run of a scene from one state."""

    start: Start
    time_s: float
    """How long it was stepped; less where it blew up or took too long."""
    bad: bool
    """Whether it blew up."""
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
    data: MjData = field(compare=False, repr=False)

    @property
    def thrown_m_s(self) -> np.ndarray:
        """Return speed of each free body that nothing but contacts can have given it."""
        return np.sqrt(2.0 * np.maximum(self.rise_m2_s2, 0.0))


def free_joints(model: MjModel) -> np.ndarray:
    return np.flatnonzero(model.jnt_type == FREE)


def starts(model: MjModel, target: Target) -> list[Start]:
    """Return the states that a scene can start from: the one that a function returns, or its own and its keyframes."""
    if target.data is not None:
        return [Start("the given state", state=target.data)]
    keys = range(min(model.nkey, MOST_STARTS - 1))
    return [
        Start("the start"),
        *(Start(f"keyframe {model.key(key).name or key}", key) for key in keys),
    ]


def runs_of(model: MjModel, target: Target, time_s: float = STEPPED_S) -> list[Run]:
    """Step a scene from each of its starts; none where a step would take seconds."""
    if model.nv > MOST_DOFS:
        return []
    return [run_of(model, start, time_s) for start in starts(model, target)]


def run_of(model: MjModel, start: Start, time_s: float) -> Run:
    """Step a model from a start, and return what it did."""
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
        iterations = data.solver_niter  # of each island, those that are not there 0
        limited = limited + (iterations.max() >= most)
        solved = solved + iterations.sum()
        if bad := is_bad(data):
            break
        rise = np.maximum(rise, energy() - begin)
        if time.process_time() - since > BUDGET_S:
            break
    reached = step * model.opt.timestep
    return Run(
        start,
        reached,
        bad,
        first,
        deepest,
        late,
        rise,
        np.linalg.norm(data.qvel[speeds], axis=1),
        limited / step,
        (step + 0.5 * solved) / reached,
        (time.process_time() - since) / reached,
        data,
    )


def is_bad(data: MjData) -> bool:
    """Tell whether a state blew up."""
    return any(data.warning[number].number for number in BAD)


def deepest_of(data: MjData) -> float:
    """Return how deep the deepest contact is [m]; 0 where none is pressed in."""
    return (
        -data.contact.dist.min(initial=0.0) if data.ncon else 0.0
    )  # dist is below 0 inside


def overlaps(data: MjData) -> dict[tuple[int, int], float]:
    """Return the deepest contact of each pair of geoms that press each other, from their margin on."""
    deepest: dict[tuple[int, int], float] = {}
    depths = data.contact.includemargin - data.contact.dist
    for pair, depth in zip(data.contact.geom.tolist(), depths.tolist(), strict=True):
        if depth > 0.0 <= min(pair):  # a flex has the geom -1
            deepest[tuple(pair)] = max(depth, deepest.get(tuple(pair), 0.0))
    return deepest


def contact_forces(model: MjModel, data: MjData, contacts: Sequence[int]) -> np.ndarray:
    """Return what contacts bear along their axes, force and torque; zeros of those that bear nothing."""
    forces = np.zeros((len(contacts), 6))
    for index, force in zip(contacts, forces, strict=True):
        mujoco.mj_contactForce(model, data, index, force)
    return forces
