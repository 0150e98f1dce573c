"""Measures the corpus in plain MuJoCo, and compares the lint with the measurements.

``python -m tests.newton_lint.truth`` writes corpus/truth.json and the table in
docs/lint.md. The measurements use no code of the lint.
"""

import json
import math
from collections import Counter
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import mujoco
import numpy as np

from measured_report.files.config import read_toml
from newton_lint.findings import Finding
from newton_lint.report import Request, report_of
from newton_lint.target import read_target

CORPUS = Path(__file__).parent / "corpus"
DOCUMENT = Path(__file__).parents[2] / "docs" / "lint.md"
BEGIN = "<!-- corpus -->\n"
END = "<!-- /corpus -->\n"
SPAN_S = 2.0
LATE_S = 0.5
SAMPLE_S = 0.006


@dataclass(frozen=True)
class Scene:
    """A scene of the corpus, with its remedy applied or not."""

    name: str
    mended: bool = False
    facts: dict[str, Any] = field(hash=False, compare=False, default_factory=dict)

    def text(self) -> str:
        text = (CORPUS / f"{self.name}.xml").read_text(encoding="utf-8")
        for old, new in self.facts.get("remedy", ()) if self.mended else ():
            assert old in text, (self.name, old)
            text = text.replace(old, new)
        return text


class Motion:
    """The motion of a scene for 2 s from its first keyframe, or from its default."""

    def __init__(self, text: str):
        self.model = mujoco.MjModel.from_xml_string(text)
        self.data = mujoco.MjData(self.model)
        if self.model.nkey:
            mujoco.mj_resetDataKeyframe(self.model, self.data, 0)
        mujoco.mj_forward(self.model, self.data)
        self.first = self._state()
        self.start_gaps = self.first["gaps"]
        self.bad = 0
        self.fast = 0.0
        self.states = [self.first]
        each = max(1, round(SAMPLE_S / self.model.opt.timestep))
        for _ in range(round(SPAN_S / (each * self.model.opt.timestep))):
            mujoco.mj_step(self.model, self.data, nstep=each)
            self.bad |= any(warning.number for warning in self.data.warning[3:6])
            if self.data.time < 0.2:
                self.fast = max(self.fast, float(np.abs(self.data.qvel).max(initial=0)))
            self.states.append(self._state())
        self.late = self.states[-round(len(self.states) * LATE_S / SPAN_S) :]

    def _state(self) -> dict[str, Any]:
        data = self.data
        rows = np.flatnonzero(data.efc_type[: data.nefc] == 0)
        gaps: dict[int, list[float]] = {}
        for row in rows.tolist():
            gaps.setdefault(int(data.efc_id[row]), []).append(float(data.efc_pos[row]))
        depths: dict[tuple[int, int], float] = {}
        for contact in data.contact:
            pair = (min(contact.geom), max(contact.geom))
            depths[pair] = max(depths.get(pair, 0.0), -contact.dist)
        names = ("xpos", "xmat", "geom_xpos", "qpos", "qvel", "ten_length", "cvel")
        arrays = {name: getattr(data, name).copy() for name in names}
        return {"time": data.time, "depths": depths, "gaps": gaps, **arrays}

    def late_mean(self, read: Callable[[dict[str, Any]], float]) -> float:
        return float(np.mean([read(state) for state in self.late]))

    def body(self, name: str) -> int:
        return self.model.body(name).id

    def dof(self, body: str) -> int:
        return int(self.model.body(body).dofadr[0])


def _depth(motion: Motion, one: str, two: str) -> float:
    """Return the deepest contact of two geoms [mm]."""
    pair = tuple(sorted(motion.model.geom(name).id for name in (one, two)))
    return 1e3 * motion.late_mean(lambda state: state["depths"].get(pair, 0.0))


def _creep(motion: Motion, body: str, support: str) -> float:
    """Return the speed of a body in the frame of its support [mm/s]."""
    places = []
    for state in (motion.late[0], motion.late[-1]):
        frame = state["xmat"][motion.body(support)].reshape(3, 3)
        between = state["xpos"][motion.body(body)] - state["xpos"][motion.body(support)]
        places.append(frame.T @ between)
    time = motion.late[-1]["time"] - motion.late[0]["time"]
    return 1e3 * float(np.linalg.norm(places[1] - places[0])) / time


def _turn(motion: Motion, body: str, support: str) -> float:
    """Return the largest angle by which a body turns on its support [°]."""
    first = None
    largest = 0.0
    for state in motion.states:
        frames = state["xmat"].reshape(-1, 3, 3)
        turned = frames[motion.body(support)].T @ frames[motion.body(body)]
        first = turned if first is None else first
        cosine = 0.5 * (np.trace(first.T @ turned) - 1.0)
        largest = max(largest, math.acos(min(1.0, max(-1.0, cosine))))
    return math.degrees(largest)


def _size(gap: list[float], is_angle: bool) -> float:
    scale = math.degrees(1.0) if is_angle else 1e3
    return scale * float(np.linalg.norm(gap[:3]))


def _is_hinge(motion: Motion, name: str) -> bool:
    equality = motion.model.equality(name)
    is_joint = equality.type[0] == int(mujoco.mjtEq.mjEQ_JOINT)
    return bool(is_joint and motion.model.jnt_type[equality.obj1id[0]] == 3)


def _gap(motion: Motion, name: str) -> float:
    """Return how far an equality is open [mm or °]."""
    index = motion.model.equality(name).id
    angle = _is_hinge(motion, name)
    return motion.late_mean(lambda state: _size(state["gaps"].get(index, [0.0]), angle))


def _start_gap(motion: Motion, name: str) -> float:
    """Return how far an equality is open at the start [mm or °]."""
    index = motion.model.equality(name).id
    return _size(motion.start_gaps.get(index, [0.0]), _is_hinge(motion, name))


def _error(motion: Motion, joint: str, target: str) -> float:
    """Return how far a joint is from an angle [°]."""
    address = motion.model.joint(joint).qposadr[0]
    goal = float(target)
    return math.degrees(
        motion.late_mean(lambda state: abs(state["qpos"][address] - goal))
    )


def _joint_past(motion: Motion, name: str) -> float:
    """Return how far a hinge is beyond its range [°]."""
    joint = motion.model.joint(name)
    low, high = joint.range

    def past(state: dict[str, Any]) -> float:
        value = state["qpos"][joint.qposadr[0]]
        return max(low - value, value - high, 0.0)

    return math.degrees(motion.late_mean(past))


def _tendon_past(motion: Motion, name: str) -> float:
    """Return how far a tendon is beyond its range [mm]."""
    index = motion.model.tendon(name).id
    high = motion.model.tendon_range[index, 1]
    return 1e3 * motion.late_mean(lambda state: state["ten_length"][index] - high)


def _joint_speed(motion: Motion, name: str) -> float:
    """Return the speed of a hinge [°/s]."""
    address = motion.model.joint(name).dofadr[0]
    return math.degrees(abs(motion.late_mean(lambda state: state["qvel"][address])))


def _fall(motion: Motion, body: str) -> float:
    """Return how far a body moves from its initial position [mm]."""
    index = motion.body(body)
    moved = motion.states[-1]["xpos"][index] - motion.first["xpos"][index]
    return 1e3 * float(np.linalg.norm(moved))


def _lag(motion: Motion, body: str) -> float:
    """Return by how much a body falls short of a free fall after 0.5 s [mm]."""
    index = motion.body(body)
    state = next(state for state in motion.states if state["time"] >= 0.5)
    fallen = motion.first["xpos"][index][2] - state["xpos"][index][2]
    free = 0.5 * 9.81 * state["time"] * (state["time"] + motion.model.opt.timestep)
    return 1e3 * abs(free - float(fallen))


def _held(motion: Motion, body: str) -> float:
    """Return 1 if a body stays within 10 mm of its place, else 0."""
    return float(_fall(motion, body) < 10.0)


def _sway(motion: Motion, body: str) -> float:
    """Return the range of a body's position in the last second [mm]."""
    index = motion.body(body)
    places = [
        state["xpos"][index] for state in motion.states[len(motion.states) // 2 :]
    ]
    return 1e3 * float(np.ptp(places, axis=0).max())


def _spin(motion: Motion, body: str) -> float:
    """Return the mean angular speed of a free body [°/s]."""
    dof = motion.dof(body) + 3
    return math.degrees(
        motion.late_mean(
            lambda state: float(np.linalg.norm(state["qvel"][dof : dof + 3]))
        )
    )


def _below(motion: Motion, geom: str, _: str) -> float:
    """Return how far the centre of a geom is below the ground [mm]."""
    index = motion.model.geom(geom).id
    return max(0.0, -1e3 * float(motion.states[-1]["geom_xpos"][index][2]))


def _thrown(motion: Motion, body: str) -> float:
    """Return the largest upward speed of a free body [m/s]."""
    dof = motion.dof(body) + 2
    return max(float(state["qvel"][dof]) for state in motion.states)


def _rattle(motion: Motion, one: str, two: str) -> float:
    """Return the standard deviation of the depth of a contact after 0.5 s [mm]."""
    pair = tuple(sorted(motion.model.geom(name).id for name in (one, two)))
    late = [state for state in motion.states if state["time"] > 0.5]
    return 1e3 * float(np.std([state["depths"].get(pair, 0.0) for state in late]))


def _rebound(motion: Motion, body: str) -> float:
    """Return how far the highest point of the last second misses the first one [mm]."""
    index = motion.body(body)
    heights = [float(state["xpos"][index][2]) for state in motion.states]
    return 1e3 * abs(max(heights[len(heights) // 2 :]) - heights[0])


def _speed(motion: Motion) -> float:
    """Return the fastest speed [m/s or rad/s]."""
    return motion.late_mean(lambda state: float(np.abs(state["qvel"]).max(initial=0.0)))


QUANTITIES: dict[str, Callable[..., float]] = {
    "depth": _depth,
    "creep": _creep,
    "turn": _turn,
    "gap": _gap,
    "start_gap": _start_gap,
    "error": _error,
    "joint_past": _joint_past,
    "tendon_past": _tendon_past,
    "joint_speed": _joint_speed,
    "fall": _fall,
    "descent": _fall,
    "spin": _spin,
    "lag": _lag,
    "held": _held,
    "sway": _sway,
    "below": _below,
    "thrown": _thrown,
    "rattle": _rattle,
    "rebound": _rebound,
    "speed": _speed,
    "rest": _speed,
    "start_speed": lambda motion: motion.fast,
    "bad": lambda motion: float(motion.bad),
}


def scenes() -> dict[str, dict[str, Any]]:
    """Return the facts about each scene by its name."""
    return read_toml(CORPUS / "corpus.toml")


def measured(name: str, facts: dict[str, Any], mended: bool) -> float:
    """Measure the quantity of a scene in plain MuJoCo."""
    kind, *arguments = facts["quantity"].split()
    motion = Motion(Scene(name, mended, facts).text())
    return float(f"{QUANTITIES[kind](motion, *arguments):.3g}")


def findings() -> dict[str, list[Finding]]:
    """Return the lint's warnings and errors on each scene."""
    reports = {
        name: report_of(read_target(str(CORPUS / f"{name}.xml")), Request())
        for name in scenes()
    }
    return {
        name: [item for item in report.findings if item.severity != "note"]
        for name, report in reports.items()
    }


def table(found: dict[str, list[Finding]]) -> str:
    """Return how often each rule finds its scenes, and how often it is right."""
    expected: Counter[str] = Counter()
    right: Counter[str] = Counter()
    reported: Counter[str] = Counter()
    fitting: Counter[str] = Counter()
    facts = scenes()
    for name, fact in facts.items():
        rules = {finding.rule for finding in found[name]}
        rule = fact["rule"]
        expected[rule] += 1
        right[rule] += rule in rules if rule else not rules
        for each in rules:
            reported[each] += 1
            fitting[each] += each == rule or each in fact.get("also", ())
    lines = [
        "| rule | scenes | found | reported | of them right |",
        "|---|---|---|---|---|",
    ]
    for rule in sorted(expected.keys() | reported.keys()):
        title = f"`{rule}`" if rule else "no fault"
        lines.append(
            f"| {title} | {expected[rule]} | {right[rule]} | {reported[rule]} |"
            f" {fitting[rule]} |"
        )
    lines.append(
        f"| all | {len(facts)} | {sum(right.values())} | {sum(reported.values())} |"
        f" {sum(fitting.values())} |"
    )
    return "\n".join(lines) + "\n"


def main() -> None:
    truth = {}
    for name, facts in scenes().items():
        truth[name] = {"measured": measured(name, facts, False)}
        if "remedy" in facts:
            truth[name]["with_remedy"] = measured(name, facts, True)
    (CORPUS / "truth.json").write_text(json.dumps(truth, indent=1) + "\n")
    text = DOCUMENT.read_text(encoding="utf-8")
    before, _, rest = text.partition(BEGIN)
    _, _, after = rest.partition(END)
    DOCUMENT.write_text(
        before + BEGIN + table(findings()) + END + after, encoding="utf-8"
    )


if __name__ == "__main__":
    main()
