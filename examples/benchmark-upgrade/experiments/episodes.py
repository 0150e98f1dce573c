"""Run Meta-World's tasks with its own scripted experts, and summarize each episode."""

import copy
import hashlib
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from statistics import median

import mujoco
import numpy as np
from metaworld.env_dict import ALL_V3_ENVIRONMENTS
from metaworld.policies import ENV_POLICY_MAP

from measured_report.measuring.measurement import absent

TASKS = tuple(sorted(ALL_V3_ENVIRONMENTS))
FIRST_SEEDS = range(50)
"""Seeds for all tasks; they are enough to find the tasks that a release may have changed."""
FRESH_SEEDS = range(100, 150)
"""Seeds for those tasks, which were not used to choose them."""
CHANGED = (
    "dial-turn-v3",
    "door-lock-v3",
    "hand-insert-v3",
    "peg-insert-side-v3",
    "push-back-v3",
    "shelf-place-v3",
    "stick-pull-v3",
    "stick-push-v3",
)
HELD_STEPS = 8
"""The number of consecutive steps of 12.5 ms for which both fingers must press on an object to grasp it."""
FINGERS = ("leftpad", "rightpad")
OBJECTS = np.r_[4:7, 11:14]
"""The entries of an observation with the positions of the one or two objects of a task [m]."""
Change = Callable[[mujoco.MjModel], None]


@dataclass(frozen=True)
class Episode:
    """Summarizes one episode, which ends at the first success or after 500 steps."""

    is_success: bool
    step_count: int
    grasped: str
    """The body that was held; empty if there was none."""
    untouched_mm: float
    """The distance that an object moved before the robot touched any object."""
    state: str
    """Four digits of the digest of the final positions and velocities; they differ if the motion differs."""


def episodes(
    task: str, seeds: Sequence[int], change: Change = lambda model: None
) -> Iterator[Episode]:
    """Run a task with each seed in a new environment, on a model that ``change`` has
    altered.
    """
    made: list[mujoco.MjModel] = []

    class Environment(ALL_V3_ENVIRONMENTS[task]):
        def _initialize_simulation(
            self,
        ):  # Compiling takes longer than most episodes, and its result is the same for each.
            if not made:
                made.append(super()._initialize_simulation()[0])
            model = copy.copy(made[0])
            change(model)
            return model, mujoco.MjData(model)

    for seed in seeds:
        env = Environment()
        env._partially_observable, env._freeze_rand_vec, env.seeded_rand_vec = (
            False,
            False,
            True,
        )
        env._set_task_called = True
        del env.sawyer_observation_space  # this record was made without the goal
        env.seed(seed)
        yield _run(env, ENV_POLICY_MAP[task]())


def _run(env, policy) -> Episode:
    observation, _ = env.reset()
    start, touch = observation[OBJECTS], Touch(env.model)
    for count in range(1, env.max_path_length + 1):  # noqa: B007
        action = np.clip(policy.get_action(observation), -1.0, 1.0)
        observation, _, _, _, told = env.step(action)
        touch.look(env.data, observation[OBJECTS] - start)
        if told["success"]:
            break
    last = np.concatenate([env.data.qpos, env.data.qvel]).tobytes()
    digest = hashlib.sha256(last).hexdigest()[:4]
    return Episode(
        bool(told["success"]), count, touch.grasped, 1e3 * touch.untouched_m, digest
    )


class Touch:
    """Records the objects that the robot touches, step by step."""

    def __init__(self, model: mujoco.MjModel):
        self.model, self.runs, self.longest = model, Counter(), Counter()
        self.pads = [model.body(name).id for name in FINGERS]
        self.robot = model.body_rootid[self.pads[0]]
        self.is_untouched, self.untouched_m = True, 0.0

    def look(self, data: mujoco.MjData, moved_m: np.ndarray) -> None:
        """Read the contacts that carry force in this step.

        Args:
            data: the state of the simulation.
            moved_m: the displacements of the two objects, six numbers [m].
        """
        there = data.contact.efc_address >= 0
        loaded = (
            there & (data.efc_force[np.where(there, data.contact.efc_address, 0)] > 0.0)
            if there.any()
            else there
        )
        bodies = self.model.geom_bodyid[data.contact.geom[loaded]]
        roots = self.model.body_rootid[bodies]
        self.is_untouched &= not ((roots == self.robot).sum(axis=1) == 1).any()
        if self.is_untouched:
            self.untouched_m = max(
                self.untouched_m, *np.linalg.norm(moved_m.reshape(2, 3), axis=1)
            )
        touched = [
            set(roots[(bodies == pad).any(axis=1)].flat) - {self.robot, 0}
            for pad in self.pads
        ]
        self.runs = Counter(
            {body: self.runs[body] + 1 for body in touched[0] & touched[1]}
        )
        self.longest |= self.runs

    @property
    def grasped(self) -> str:
        """Return the body that was held longest, or an empty string if no body was held long enough."""
        body, count = max(
            self.longest.items(), key=lambda item: item[1], default=(0, 0)
        )
        return self.model.body(body).name if count >= HELD_STEPS else ""


NUMBERS = ("success_count", "step_median", "grasp_count", "untouched_mm")


def row(task: str, seeds: Sequence[int]) -> dict[str, object]:
    """Run a task with each seed, the first of them twice, and return its row.

    If the release cannot run the task, the row contains the reason.
    """
    try:
        found = list(episodes(task, seeds))
        again = next(episodes(task, seeds[:1]))
    except Exception as error:
        reason = f"{type(error).__name__}: {' '.join(str(error).split())}"
        return {"case": task, "seed_count": len(seeds), **absent(NUMBERS, reason)}
    return {"case": task, **columns(found), "repeats": again == found[0]}


def columns(found: Sequence[Episode]) -> dict[str, object]:
    """Return the columns that summarize episodes; each text has one word or digit for each seed."""
    counts = [episode.step_count for episode in found if episode.is_success]
    bodies = Counter(episode.grasped for episode in found if episode.grasped)
    steps = (
        {"step_median": median(counts)}
        if counts
        else absent(["step_median"], "no episode succeeds")
    )
    return {
        "seed_count": len(found),
        "success_count": len(counts),
        **steps,
        "grasp_count": bodies.total(),
        "grasped": ", ".join(sorted(bodies)),
        "untouched_mm": float(median(episode.untouched_mm for episode in found)),
        "steps": " ".join(
            str(episode.step_count) if episode.is_success else "-" for episode in found
        ),
        "grasps": "".join(str(int(bool(episode.grasped))) for episode in found),
        "states": "".join(episode.state for episode in found),
    }
