"""Steps a scene in MuJoCo C for 2 s from each start, and records its motion."""

import time
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property

import mujoco
import numpy as np
from mujoco import MjData, MjModel

from newton_lint.scene import FREE, WEIGHTLESS

SPAN_S = 2.0
"""Time for which a scene is stepped from each start."""
SAMPLE_S = 0.02
"""Time between two samples of the motion."""
BUDGET_S = 2.0
"""A run stops early after this processor time."""
MOST_STARTS = 4
"""A scene is stepped from at most this many starts."""
MOST_DOFS = 3000
"""Scenes with more degrees of freedom are not stepped: a step takes seconds."""
LATE = 0.75
"""Readings are averaged over the samples after this share of a run."""
STILL_M = 2e-3
"""A body rests if it moves by less than this during the late samples."""
SINGLE_STEPS = 12
"""Jitter is measured over this many steps at the end of a run."""
# After these warnings mj_checkPos and mj_checkAcc reset the state, which then looks
# valid; only their counts remain.
BAD = [
    int(getattr(mujoco.mjtWarning, f"mjWARN_BAD{name}"))
    for name in ("QPOS", "QVEL", "QACC")
]
STATE = ("qpos", "qvel", "act", "ctrl", "mocap_pos", "mocap_quat", "qacc_warmstart")
"""Arrays of the data that make up a state."""
COPIED = (
    "qpos",
    "qvel",
    "xpos",
    "xmat",
    "geom_xpos",
    "geom_xmat",
    "ten_length",
    "actuator_length",
    "qfrc_constraint",
    "cvel",
)
"""Arrays of the data that each sample keeps."""


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
        data = MjData(model)
        if self.key is not None:
            mujoco.mj_resetDataKeyframe(model, data, self.key)
        # mj_copyData would need the same model, but this one may be changed.
        for name in STATE if self.state is not None else ():
            getattr(data, name)[:] = getattr(self.state, name)
        return data


@dataclass(frozen=True)
class Touches:
    """The contacts of a sample; arrays [contact_count, …], ordered as in the data."""

    geoms: np.ndarray
    normal: np.ndarray
    depth_m: np.ndarray
    normal_n: np.ndarray
    """Normal force, which is 0 for contacts that bear none."""
    friction_n: np.ndarray
    """Friction on the second geom, in the world frame [contact_count, 3]."""
    used: np.ndarray
    """Share of the friction cone that is used."""
    velocity_m_s: np.ndarray
    """Velocity of the second geom relative to the first [contact_count, 3]."""

    @cached_property
    def pairs(self) -> np.ndarray:
        """Return the geoms of each contact, the lower one first."""
        return np.sort(self.geoms, axis=1)

    def between(self, pair: Sequence[int]) -> np.ndarray:
        """Return whether each contact is between two geoms."""
        return (self.pairs == sorted(pair)).all(axis=1)


@dataclass(frozen=True)
class Sample:
    """The state of a scene at one time."""

    time_s: float
    arrays: dict[str, np.ndarray]
    """Copies of the arrays of ``MjData`` named in ``COPIED``."""
    touches: Touches
    gaps: dict[int, float]
    """How far each equality is open; for a weld, only the translation [m or rad]."""

    @property
    def speed(self) -> float:
        """Return the fastest speed of any dof [m/s or rad/s]."""
        return np.abs(self.arrays["qvel"]).max(initial=0.0)


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
    samples: list[Sample]
    deepest_m: float
    """Deepest contact over the whole run."""
    late_m: float
    """Deepest contact after the first third of the run."""
    rise_m2_s2: np.ndarray
    """Largest gain in energy of each free body [J/kg]."""
    speeds_m_s: np.ndarray
    """Speed of each free body at the end."""
    jitter: np.ndarray
    """How much each velocity jumps from one step to the next [m/s or rad/s]."""
    at_limit: float
    """Share of the samples in which the solver used all its iterations."""
    effort: float
    """Steps plus half the solver's iterations per simulated second.

    Unlike a time, it does not depend on the load of the machine.
    """
    spent_s: float
    """Processor time."""
    data: MjData = field(compare=False, repr=False)
    """The final state."""

    @property
    def thrown_m_s(self) -> np.ndarray:
        """Return the speed of each free body that only contacts can have caused."""
        return np.sqrt(2.0 * np.maximum(self.rise_m2_s2, 0.0))

    @cached_property
    def late(self) -> list[Sample]:
        """Return the samples over which readings are averaged."""
        return self.samples[int(LATE * len(self.samples)) :]

    @cached_property
    def pairs(self) -> list[tuple[int, int]]:
        """Return the pairs of geoms that touch in any sample, in order of the time."""
        touching = [
            pair for sample in self.samples for pair in sample.touches.pairs.tolist()
        ]
        return list(dict.fromkeys(map(tuple, touching)))

    @cached_property
    def speed(self) -> float:
        """Return the fastest speed, averaged over the late samples [m/s or rad/s]."""
        return float(np.mean([sample.speed for sample in self.late]))

    @cached_property
    def still(self) -> np.ndarray:
        """Return whether each body rests at the end of the run."""
        places = np.array([sample.arrays["xpos"] for sample in self.late])
        # A ball that rolls on the spot keeps its position, but its axes move.
        axes = np.array([sample.arrays["xmat"] for sample in self.late])
        moved = np.ptp(places, axis=0).max(axis=1)
        turned = np.ptp(axes, axis=0).max(axis=1)
        return (moved < STILL_M) & (turned < 10.0 * STILL_M)

    def mean(self, name: str) -> np.ndarray:
        """Return the mean of an array over the late samples."""
        return np.mean([sample.arrays[name] for sample in self.late], axis=0)


def free_joints(model: MjModel) -> np.ndarray:
    return np.flatnonzero(model.jnt_type == FREE)


def starts(model: MjModel, data: MjData | None) -> list[Start]:
    """Return the starts of a scene: the given state, or the default and keyframes."""
    if data is not None:
        return [Start("the given state", state=data)]
    keys = range(min(model.nkey, MOST_STARTS - 1))
    return [
        Start("the start"),
        *(Start(f"keyframe {model.key(key).name or key}", key) for key in keys),
    ]


def runs_of(model: MjModel, data: MjData | None) -> list[Run]:
    """Step a model from all its starts, unless it has too many degrees of freedom."""
    if model.nv > MOST_DOFS:
        return []
    return [run_of(model, start) for start in starts(model, data)]


def run_of(model: MjModel, start: Start, time_s: float = SPAN_S) -> Run:
    """Step a model from a start and return the record of the run."""
    data = start.data(model)
    mujoco.mj_forward(model, data)
    first = overlaps(data)
    free = free_joints(model)
    places = model.jnt_qposadr[free][:, None] + np.arange(3)
    speeds = model.jnt_dofadr[free][:, None] + np.arange(3)
    gravity = np.zeros(3) if model.opt.disableflags & WEIGHTLESS else model.opt.gravity

    # The energy of a free body can only fall unless a contact or an actuator acts on it.
    def energy() -> np.ndarray:
        return 0.5 * (data.qvel[speeds] ** 2).sum(axis=1) - data.qpos[places] @ gravity

    begin = energy()
    rise = np.zeros(len(free))
    samples = [sample_of(model, data)]
    depths = [deepest_of(data)]
    step = model.opt.timestep
    # Steps longer than the sampling time are sampled one by one.
    stride = max(1, round(SAMPLE_S / step))
    count = max(1, round(time_s / (stride * step)))
    limited = 0
    solved = 0.0
    bad = False
    since = time.process_time()
    for _ in range(count):
        mujoco.mj_step(model, data, nstep=stride)
        iterations = data.solver_niter  # One number per island, 0 for unused ones.
        limited += int(iterations.max() >= model.opt.iterations)
        solved += float(iterations.sum())
        if bad := is_bad(data):
            break
        depths.append(deepest_of(data))
        rise = np.maximum(rise, energy() - begin)
        samples.append(sample_of(model, data))
        # A short run is still evaluated, but changes are not compared with it.
        if time.process_time() - since > BUDGET_S:
            break
    spent = time.process_time() - since
    # MuJoCo sets the time back to 0 when it resets the state.
    reached = data.time - samples[0].time_s if not bad else len(samples) * stride * step
    sampled = max(1, len(samples) - 1)
    return Run(
        start=start,
        time_s=reached,
        bad=bad,
        first=first,
        samples=samples,
        deepest_m=max(depths),
        late_m=max(depths[len(depths) // 3 :]),
        rise_m2_s2=rise,
        speeds_m_s=np.linalg.norm(data.qvel[speeds], axis=1),
        jitter=np.zeros(model.nv) if bad else _jitter(model, data),
        at_limit=limited / sampled,
        effort=(1.0 + 0.5 * solved / sampled) / step,
        spent_s=spent,
        data=data,
    )


def _jitter(model: MjModel, data: MjData) -> np.ndarray:
    """Return how much each velocity alternates from one step to the next."""
    speeds = np.zeros((SINGLE_STEPS, model.nv))
    for row in speeds:
        mujoco.mj_step(model, data)
        row[:] = data.qvel
    # The fourth difference of a velocity that alternates by ±v is 16 v, and that of a
    # smooth motion, even of a fast swing with long steps, is small.
    return np.sqrt((np.diff(speeds, n=4, axis=0) ** 2).mean(axis=0)) / 16.0


def sample_of(model: MjModel, data: MjData) -> Sample:
    """Return the state of a scene, with the forces of the last step."""
    rows = data.efc_type[: data.nefc] == int(mujoco.mjtConstraint.mjCNSTR_EQUALITY)
    ids = data.efc_id[: data.nefc][rows]
    errors = data.efc_pos[: data.nefc][rows]
    # A weld has six rows: the first three are the translation.
    gaps = {
        int(equality): float(np.linalg.norm(errors[ids == equality][:3]))
        for equality in np.unique(ids)
    }
    arrays = {name: getattr(data, name).copy() for name in COPIED}
    return Sample(data.time, arrays, touches_of(model, data), gaps)


def touches_of(model: MjModel, data: MjData) -> Touches:
    """Return the contacts between geoms, with the forces of the last step."""
    contact = data.contact
    indices = np.flatnonzero(contact.geom.min(axis=1, initial=0) >= 0)
    geoms = contact.geom[indices]
    frames = contact.frame[indices].reshape(-1, 3, 3)
    forces = contact_forces(model, data, indices)
    mu = np.maximum(contact.friction[indices, :2], mujoco.mjMINMU)
    # A pyramid limits the sum of the two axes, an elliptic cone their Euclidean length.
    shares = np.abs(forces[:, 1:]) / mu
    is_pyramid = model.opt.cone == int(mujoco.mjtCone.mjCONE_PYRAMIDAL)
    load = shares.sum(axis=1) if is_pyramid else np.hypot(*shares.T)
    bodies = model.geom_bodyid[geoms]
    spins = data.cvel[bodies, :3]
    # cvel is the velocity at the centre of mass of the whole tree, so it is moved to
    # the contact point.
    arms = contact.pos[indices][:, None] - data.subtree_com[model.body_rootid[bodies]]
    speeds = data.cvel[bodies, 3:] + np.cross(spins, arms)
    return Touches(
        geoms=geoms,
        normal=frames[:, 0],
        depth_m=-contact.dist[indices],
        normal_n=forces[:, 0],
        friction_n=np.einsum("ni,nij->nj", forces[:, 1:], frames[:, 1:]),
        used=load / np.maximum(forces[:, 0], mujoco.mjMINVAL),
        velocity_m_s=speeds[:, 1] - speeds[:, 0],
    )


def contact_forces(model: MjModel, data: MjData, indices: np.ndarray) -> np.ndarray:
    """Return normal and friction forces of contacts in their frames, shape [n, 3]."""
    forces = np.zeros((len(indices), 3))
    force = np.zeros(6)
    for row, index in zip(forces, indices.tolist(), strict=True):
        mujoco.mj_contactForce(model, data, index, force)
        row[:] = force[:3]
    return forces


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
    pairs = np.sort(data.contact.geom, axis=1).tolist()
    for (low, high), depth in zip(pairs, depths.tolist(), strict=True):
        if depth > 0.0 <= low:  # A flex has the geom -1.
            deepest[low, high] = max(depth, deepest.get((low, high), 0.0))
    return deepest
