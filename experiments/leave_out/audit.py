"""What a scene has and does not use, from a short run.

    python -m experiments.leave_out.audit                      the shake scene, as shipped
    python -m experiments.leave_out.audit module:function      another one

The function returns an object in the conventions of Newton's examples: ``model``, ``solver`` (a SolverMuJoCo),
``contacts`` (None when MuJoCo generates them), ``state`` after the last frame and ``step()``, which runs one frame.
"""

import argparse
import importlib
import sys
from dataclasses import dataclass, field
from typing import Protocol

import newton
import numpy as np
import warp as wp
from newton import ShapeFlags
from newton.solvers import SolverMuJoCo
from tqdm import tqdm

from experiments.facts.case import UNTRIMMED
from experiments.simulation.simulation import Simulation
from experiments.simulation.task import Task
from experiments.simulation.timing import buffer_bytes_per_world

FRAME_COUNT = 300
"""Frames of the run: for the shake scene the set-up and a cycle and a half of shake."""
LOOK_FRAME_STEP = 10
"""Frames between two looks at the inverse kinematics and at the writes of Newton's state."""


class AuditedScene(Protocol):
    model: newton.Model
    solver: SolverMuJoCo
    contacts: newton.Contacts | None
    state: newton.State

    def step(self) -> None: ...


@dataclass(frozen=True)
class Item:
    """One thing that a scene pays for."""

    name: str
    present: float
    """How much of it there is."""
    used: float
    """How much of it the run used."""
    note: str = ""
    """Which ones are not used, where that helps."""


@dataclass
class Seen:
    """What the run showed so far, in the first world."""

    shapes_near: set[int]
    pairs_near: set[tuple[int, int]]
    pairs_loaded: set[tuple[int, int]]
    contact_counts: list[int]
    loaded_counts: list[int]
    constraint_peak: int = 0
    limit_peak: int = 0
    equality_peak: int = 0
    tendon_lengths: list[np.ndarray] = field(default_factory=list)
    sensor_values: list[np.ndarray] = field(default_factory=list)
    state_changes: list[float] = field(default_factory=list)
    """Largest change of a coordinate in each write of Newton's state that was looked at."""
    actuators_moved: set[int] = field(default_factory=set)
    ik_iterations_moving: int = 0


def audit(scene: AuditedScene, frame_count: int = FRAME_COUNT) -> list[Item]:
    """Run the scene for ``frame_count`` frames and list what it has against what it used."""
    seen = Seen(set(), set(), set(), [], [])
    task = getattr(scene, "task", None)
    for frame in tqdm(range(frame_count), desc="audit", unit="frame", delay=3.0):
        before = wp.clone(task.solution) if task and frame % LOOK_FRAME_STEP == 0 else None
        wp.synchronize()  # the scene may have streams of its own
        scene.step()
        _look(scene, seen)
        if frame % LOOK_FRAME_STEP == 0:
            seen.state_changes.append(_state_change(scene))
        if before is not None:
            moving = _moving_iterations(task, before, scene.case.ik_iterations)
            seen.ik_iterations_moving = max(seen.ik_iterations_moving, moving)
    iterations = "IK iterations per frame, against the last that changed a bit"
    return [
        *_shape_items(scene, seen),
        *_contact_items(scene, seen),
        *_feature_items(scene, seen),
        *([Item(iterations, scene.case.ik_iterations, seen.ik_iterations_moving)] if task else []),
        _state_item(scene, seen),
    ]


def _look(scene: AuditedScene, seen: Seen) -> None:
    data = scene.solver.mjw_data
    count = min(int(data.nacon.numpy()[0]), data.naconmax)
    mine = data.contact.worldid.numpy()[:count] == 0
    pairs = scene.solver.mjc_geom_to_newton_shape.numpy()[0][data.contact.geom.numpy()[:count][mine]]
    address = data.contact.efc_address.numpy()[:count, 0][mine]
    force = data.efc.force.numpy()[0]
    loaded = np.array([row >= 0 and force[row] > 0.0 for row in address], dtype=bool)
    seen.shapes_near.update(int(shape) for shape in pairs.reshape(-1))
    seen.pairs_near.update((int(a), int(b)) for a, b in np.sort(pairs, axis=1))
    seen.pairs_loaded.update((int(a), int(b)) for a, b in np.sort(pairs[loaded], axis=1))
    seen.contact_counts.append(len(pairs))
    seen.loaded_counts.append(int(loaded.sum()))
    seen.constraint_peak = max(seen.constraint_peak, int(data.nefc.numpy()[0]))
    seen.limit_peak = max(seen.limit_peak, int(data.nl.numpy()[0]))
    seen.equality_peak = max(seen.equality_peak, int(data.ne.numpy()[0]))
    seen.tendon_lengths.append(data.ten_length.numpy()[0].copy())  # on a CPU it is a view
    seen.sensor_values.append(data.sensordata.numpy()[0].copy())
    seen.actuators_moved.update(int(index) for index in np.flatnonzero(data.actuator_force.numpy()[0]))


def _shape_items(scene: AuditedScene, seen: Seen) -> list[Item]:
    model = scene.model
    flags, world = model.shape_flags.numpy(), model.shape_world.numpy()
    first = [shape for shape in range(model.shape_count) if world[shape] <= 0]
    colliding = [shape for shape in first if flags[shape] & ShapeFlags.COLLIDE_SHAPES]
    idle = [shape for shape in colliding if shape not in seen.shapes_near]
    pairs = model.shape_contact_pairs.numpy()
    pairs = pairs[(world[pairs] <= 0).all(axis=1)]
    return [
        Item("shapes for looking at only", len(first) - len(colliding), 0),
        Item(
            "colliding shapes that came near anything", len(colliding), len(colliding) - len(idle), _names(model, idle)
        ),
        Item("pairs of shapes that may collide, against those that came near", len(pairs), len(seen.pairs_near)),
        Item("pairs of shapes that may collide, against those that carried force", len(pairs), len(seen.pairs_loaded)),
    ]


def _contact_items(scene: AuditedScene, seen: Seen) -> list[Item]:
    data = scene.solver.mjw_data
    contact_max = data.naconmax // data.nworld
    bytes_per_world = buffer_bytes_per_world(scene.solver, scene.contacts)
    share = max(max(seen.contact_counts) / contact_max, seen.constraint_peak / data.njmax)
    return [
        Item(
            "contacts per frame, against those that carry force",
            np.mean(seen.contact_counts),
            np.mean(seen.loaded_counts),
        ),
        Item("room for contacts per world, against the peak", contact_max, max(seen.contact_counts)),
        Item("room for constraint rows per world, against the peak", data.njmax, seen.constraint_peak),
        Item(
            "contact and constraint memory per world [B], against the share of the fuller buffer",
            bytes_per_world,
            share * bytes_per_world,
        ),
    ]


def _feature_items(scene: AuditedScene, seen: Seen) -> list[Item]:
    engine = scene.solver.mj_model
    limited = int(np.count_nonzero(engine.jnt_limited))
    return [
        Item("joints with limits, against the most that were reached at once", limited, seen.limit_peak),
        Item("equality constraints, against the most rows that they made", engine.neq, seen.equality_peak),
        Item("tendons, against those whose length changed", engine.ntendon, _changed_count(seen.tendon_lengths)),
        Item(
            "numbers from sensors, against those that changed", engine.nsensordata, _changed_count(seen.sensor_values)
        ),
        Item(
            "bodies, against those that move against their parent",
            engine.nbody - 1,
            np.count_nonzero(engine.body_dofnum),
        ),
        Item("actuators, against those that ever gave a force", engine.nu, len(seen.actuators_moved)),
    ]


def _changed_count(looks: list[np.ndarray]) -> int:
    """How many of the numbers were not the same in all looks."""
    return int((np.array(looks) != looks[0]).any(axis=0).sum())


def _state_change(scene: AuditedScene) -> float:
    """How much the largest change of a coordinate is when Newton's state is written into the engine."""
    data = scene.solver.mjw_data
    kept = [(array, wp.clone(array)) for array in (data.qpos, data.qvel)]
    scene.solver._update_mjc_data(data, scene.model, scene.state)
    change = max(float(np.abs(array.numpy() - copy.numpy()).max()) for array, copy in kept)
    for array, copy in kept:
        wp.copy(array, copy)
    return change


def _state_item(scene: AuditedScene, seen: Seen) -> Item:
    changes = seen.state_changes if scene.solver.update_data_interval else []
    return Item(
        "looks at a write of Newton's state into the engine, against those where it changed a bit",
        len(changes),
        sum(change > 0.0 for change in changes),
        f"largest change of a coordinate {max(changes):.1e}" if changes else "",
    )


def _moving_iterations(task: Task, before: wp.array, iterations: int) -> int:
    """The last of this frame's IK iterations that changed a bit of the solution, solving again from ``before``."""
    solutions = [before.numpy()]
    for count in range(1, iterations + 1):
        solution = wp.clone(before)
        task.solver.step(solution, count)
        solutions.append(solution.numpy())
    changes = [k for k in range(1, len(solutions)) if not np.array_equal(solutions[k], solutions[k - 1])]
    return max(changes, default=0)


def _names(model: newton.Model, shapes: list[int]) -> str:
    body = model.shape_body.numpy()
    return ", ".join(
        model.body_label[body[shape]].rsplit("/", 1)[-1] if body[shape] >= 0 else "ground" for shape in shapes
    )


def audit_rows(items: list[Item]) -> list[dict[str, object]]:
    """The items as rows of a record."""
    return [
        {"case": f"audit-{index}", "item": item.name, "present": float(item.present), "used": float(item.used)}
        | {"note": item.note}
        for index, item in enumerate(items)
    ]


def table(items: list[Item]) -> str:
    """The items as text, a line each."""
    width = max(len(item.name) for item in items)
    lines = [f"{'':{width}}  {'there':>10}  {'used':>10}"]
    lines += [f"{item.name:{width}}  {item.present:10.5g}  {item.used:10.5g}  {item.note}".rstrip() for item in items]
    return "\n".join(lines)


def shake_scene() -> AuditedScene:
    """One world of the shake scene exactly as shipped."""
    return Simulation([UNTRIMMED], wp.get_device())


def main() -> int:
    own = "experiments.leave_out.audit"
    parser = argparse.ArgumentParser(prog=f"python -m {own}", description=__doc__.split("\n")[0])
    parser.add_argument("scene", nargs="?", default=f"{own}:shake_scene", metavar="MODULE:FUNCTION")
    parser.add_argument("--num-frames", type=int, default=FRAME_COUNT, help="length of the run")
    arguments = parser.parse_args()
    wp.config.log_level = wp.LOG_WARNING
    module, _, function = arguments.scene.partition(":")
    try:
        build = getattr(importlib.import_module(module), function)
    except (ImportError, AttributeError, ValueError) as error:
        print(f"{arguments.scene} is no scene: {error}", file=sys.stderr)
        return 2
    print(table(audit(build(), arguments.num_frames)))
    return 0


if __name__ == "__main__":
    sys.exit(main())
