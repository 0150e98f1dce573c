"""Every scene as the lint reads it, and what the law predicts of the thing that is held when the expert has it."""

import copy
from collections import Counter
from unittest.mock import patch

import mujoco

from experiments import episodes
from measured_report.measuring.batch import Batch, Plan
from measured_report.measuring.measurement import Conditions, Measurement, absent
from newton_lint.findings import grouped
from newton_lint.report import scene_of
from newton_lint.rules import lint
from newton_lint.settle import Work, held
from newton_lint.target import Target

SETTLE_S = 1.0
"""How long the hand stands still before forces are read."""
PREDICTED = ("load_n", "creep_mm_s", "speed_mm_s")


class Caught(episodes.Touch):
    """The same, which keeps the last state in which each thing was held."""

    def __init__(self, model: mujoco.MjModel):
        super().__init__(model)
        self.states: dict[int, mujoco.MjData] = {}

    def look(self, data, moved_m):
        super().look(data, moved_m)
        self.states |= {body: copy.copy(data) for body, count in self.runs.items() if count >= episodes.HELD_STEPS}


def run(task: str) -> dict[str, object]:
    """Lint the scene of a task, and predict how fast what the expert holds creeps once the hand stands still."""
    seen: list[Caught] = []

    def watch(model: mujoco.MjModel) -> Caught:
        seen.append(Caught(model))
        return seen[0]

    with patch.object(episodes, "Touch", watch):  # no parameter of its own, for which all runs would be stale
        episode = next(episodes.episodes(task, episodes.FIRST_SEEDS[:1]))
    model, [caught] = seen[0].model, seen
    found = grouped(lint(scene_of(Target(task, model))))
    counts = Counter(group.first.severity for group in found)
    row = {"case": task, "warning_count": counts["warning"] + counts["error"], "note_count": counts["note"]}
    row |= {"rules": ", ".join(sorted({group.first.rule for group in found})), "body": episode.grasped}
    if not episode.grasped:
        return row | absent(PREDICTED, "nothing is grasped")
    target = Target(task, model, data=caught.states[model.body(episode.grasped).id])
    hold = held(scene_of(target), target, Work(episode.grasped, settle_s=SETTLE_S))
    if hold is None or hold.slides:
        return row | absent(PREDICTED, "it is lost once the hand stands still")
    return row | {"load_n": hold.load_n, "creep_mm_s": hold.mm_s, "speed_mm_s": hold.moves_mm_s}


def measure(conditions: Conditions) -> Plan:
    rows = yield [Batch(task, run, (task,)) for task in (episodes.TASKS[:5] if conditions.quick else episodes.TASKS)]
    return Measurement(rows)
