"""List the parts of a scene and the amount of each that a short run uses."""

from dataclasses import dataclass, field
from typing import Any, Protocol

import newton
import numpy as np
import warp as wp
from newton import ShapeFlags
from newton.solvers import SolverMuJoCo
from tqdm import tqdm

from experiments.facts.case import Case
from experiments.simulation.task import Task
from experiments.simulation.timing import buffer_bytes_per_world

# Frames of the run. For the shake these are the set-up and one and a half cycles.
FRAME_COUNT = 300
# Frames between two checks of the inverse kinematics and the written state.
LOOK_FRAME_STEP = 10
# Counts of rows in the engine's data: all rows, rows of limits, and rows of equality
# constraints.
PEAKS = (
    "nefc",
    "nl",
    "ne",
)
OUTPUTS = ("ten_length", "sensordata")


class AuditedScene(Protocol):
    model: newton.Model
    solver: SolverMuJoCo
    contacts: newton.Contacts | None
    state: newton.State
    case: Case  # only in a scene with a task

    def step(self) -> None: ...


@dataclass(frozen=True)
class Item:
    """Describe a part of a scene that takes time or memory."""

    name: str
    present: float  # available amount
    used: float  # amount that the run used
    note: str = ""  # names unused parts, if that helps


@dataclass
class Seen:
    """Returns the findings of the run so far, in the first world."""

    pairs_near: set[tuple[int, int]] = field(default_factory=set)
    pairs_loaded: set[tuple[int, int]] = field(default_factory=set)
    contact_counts: list[int] = field(default_factory=list)
    loaded_counts: list[int] = field(default_factory=list)
    peaks: dict[str, int] = field(default_factory=lambda: dict.fromkeys(PEAKS, 0))
    outputs: dict[str, list[np.ndarray]] = field(
        default_factory=lambda: {name: [] for name in OUTPUTS}
    )
    state_changes: list[float] = field(default_factory=list)
    """Largest change of a coordinate in each checked write of Newton's state."""
    actuators_moved: set[int] = field(default_factory=set)
    ik_iterations_moving: int = 0

    def look(self, scene: AuditedScene) -> None:
        data = scene.solver.mjw_data
        count = min(int(data.nacon.numpy()[0]), data.naconmax)
        mine = data.contact.worldid.numpy()[:count] == 0
        pairs = scene.solver.mjc_geom_to_newton_shape.numpy()[0][
            data.contact.geom.numpy()[:count][mine]
        ]
        address = data.contact.efc_address.numpy()[:count, 0][mine]
        force = data.efc.force.numpy()[0]
        loaded = np.array(
            [row >= 0 and force[row] > 0.0 for row in address], dtype=bool
        )
        pairs = np.sort(pairs, axis=1)
        self.pairs_near.update((int(a), int(b)) for a, b in pairs)
        self.pairs_loaded.update((int(a), int(b)) for a, b in pairs[loaded])
        self.contact_counts.append(len(pairs))
        self.loaded_counts.append(int(loaded.sum()))
        for name, peak in self.peaks.items():
            self.peaks[name] = max(peak, int(getattr(data, name).numpy()[0]))
        for name, looks in self.outputs.items():
            # a copy, because on a CPU it is a view
            looks.append(getattr(data, name).numpy()[0].copy())
        self.actuators_moved.update(
            int(index) for index in np.flatnonzero(data.actuator_force.numpy()[0])
        )

    def changed_count(self, name: str) -> int:
        """Return the count of numbers that differed between checks."""
        looks = np.array(self.outputs[name])
        return int((looks != looks[0]).any(axis=0).sum())


def audit(scene: AuditedScene, frame_count: int = FRAME_COUNT) -> list[Item]:
    """Run the scene for ``frame_count`` frames and list the available and used amounts."""
    seen, task = Seen(), getattr(scene, "task", None)
    for frame in tqdm(range(frame_count), desc="audit", unit="frame", delay=3.0):
        is_look = frame % LOOK_FRAME_STEP == 0
        before = wp.clone(task.solution) if task and is_look else None
        wp.synchronize()  # the scene may use other streams
        scene.step()
        seen.look(scene)
        if is_look:
            seen.state_changes.append(_state_change(scene))
        if before is not None:
            moving = _moving_iterations(task, before, scene.case.ik_iterations)
            seen.ik_iterations_moving = max(seen.ik_iterations_moving, moving)
    iterations = "IK iterations per frame, against the last that changed a bit"
    changes = seen.state_changes if scene.solver.update_data_interval else []
    return [
        *_shape_items(scene.model, seen),
        *_contact_items(scene, seen),
        *_feature_items(scene.solver.mj_model, seen),
        *(
            [Item(iterations, scene.case.ik_iterations, seen.ik_iterations_moving)]
            if task
            else []
        ),
        Item(
            "looks at a write of Newton's state into the engine, against those where it changed a bit",
            len(changes),
            sum(change > 0.0 for change in changes),
            f"largest change of a coordinate {max(changes):.1e}" if changes else "",
        ),
    ]


def _state_change(scene: AuditedScene) -> float:
    """Return the largest change of a coordinate by a write of Newton's state."""
    data = scene.solver.mjw_data
    copies = [(array, wp.clone(array)) for array in (data.qpos, data.qvel)]
    scene.solver._update_mjc_data(data, scene.model, scene.state)
    change = max(
        float(np.abs(array.numpy() - copy.numpy()).max()) for array, copy in copies
    )
    for array, copy in copies:
        wp.copy(array, copy)
    return change


def _moving_iterations(task: Task, before: wp.array, iterations: int) -> int:
    """Solve again from ``before`` and return the last IK iteration that changed any
    bit.
    """
    solutions = [before.numpy()]
    for count in range(1, iterations + 1):
        solution = wp.clone(before)
        task.solver.step(solution, count)
        solutions.append(solution.numpy())
    changes = [
        k
        for k in range(1, len(solutions))
        if not np.array_equal(solutions[k], solutions[k - 1])
    ]
    return max(changes, default=0)


def _shape_items(model: newton.Model, seen: Seen) -> list[Item]:
    flags, world = model.shape_flags.numpy(), model.shape_world.numpy()
    body, labels = model.shape_body.numpy(), model.body_label
    first = [shape for shape in range(model.shape_count) if world[shape] <= 0]
    colliding = [shape for shape in first if flags[shape] & ShapeFlags.COLLIDE_SHAPES]
    near = {shape for pair in seen.pairs_near for shape in pair}
    idle = [body[shape] for shape in colliding if shape not in near]
    names = ", ".join(
        labels[one].rsplit("/", 1)[-1] if one >= 0 else "ground" for one in idle
    )
    pairs = model.shape_contact_pairs.numpy()
    count = int((world[pairs] <= 0).all(axis=1).sum())
    return [
        Item("shapes for looking at only", len(first) - len(colliding), 0),
        Item(
            "colliding shapes that came near anything",
            len(colliding),
            len(colliding) - len(idle),
            names,
        ),
        Item(
            "pairs of shapes that may collide, against those that came near",
            count,
            len(seen.pairs_near),
        ),
        Item(
            "pairs of shapes that may collide, against those that carried force",
            count,
            len(seen.pairs_loaded),
        ),
    ]


def _contact_items(scene: AuditedScene, seen: Seen) -> list[Item]:
    data, most, rows = (
        scene.solver.mjw_data,
        max(seen.contact_counts),
        seen.peaks["nefc"],
    )
    contact_max = data.naconmax // data.nworld
    size = buffer_bytes_per_world(scene.solver, scene.contacts)
    used = max(most / contact_max, rows / data.njmax) * size
    loaded = np.mean(seen.loaded_counts)
    return [
        Item(
            "contacts per frame, against those that carry force",
            np.mean(seen.contact_counts),
            loaded,
        ),
        Item("room for contacts per world, against the peak", contact_max, most),
        Item("room for constraint rows per world, against the peak", data.njmax, rows),
        Item(
            "contact and constraint memory per world [B], against the share of the fuller buffer",
            size,
            used,
        ),
    ]


def _feature_items(engine: Any, seen: Seen) -> list[Item]:
    limited, moving = (
        int(np.count_nonzero(engine.jnt_limited)),
        np.count_nonzero(engine.body_dofnum),
    )
    lengths, values = map(seen.changed_count, OUTPUTS)
    return [
        Item(
            "joints with limits, against the most that were reached at once",
            limited,
            seen.peaks["nl"],
        ),
        Item(
            "equality constraints, against the most rows that they made",
            engine.neq,
            seen.peaks["ne"],
        ),
        Item("tendons, against those whose length changed", engine.ntendon, lengths),
        Item(
            "numbers from sensors, against those that changed",
            engine.nsensordata,
            values,
        ),
        Item(
            "bodies, against those that move against their parent",
            engine.nbody - 1,
            moving,
        ),
        Item(
            "actuators, against those that ever gave a force",
            engine.nu,
            len(seen.actuators_moved),
        ),
    ]


def audit_rows(items: list[Item]) -> list[dict[str, object]]:
    """Return the items as rows of a record."""
    return [
        {
            "case": f"audit-{index}",
            "item": item.name,
            "present": float(item.present),
            "used": float(item.used),
        }
        | {"note": item.note}
        for index, item in enumerate(items)
    ]
