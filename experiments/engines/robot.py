"""Run the shake in other engines, with the joint targets of a run in MuJoCo C.

Features that one of the engines lacks are removed from all runs: gravity and with it
the ground, different friction coefficients of the bodies, the coupling of the fingers,
and friction in the joints. If an engine does not support armature, it is added to the
links that the joints move.
"""

import tempfile
from collections.abc import Sequence
from dataclasses import replace
from typing import Any, NamedTuple
from xml.etree import ElementTree

import numpy as np
import warp as wp

from experiments.drivers import engine
from experiments.drivers.grasp import FORCES, GRASP, grasp_columns
from experiments.drivers.scene import ORIGIN, Body, Robot, Scene
from experiments.drivers.scene import Trace as Shown
from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, Case
from experiments.facts.trace import FRAME_COLUMNS, Trace, first_failure
from experiments.simulation import scene
from experiments.simulation.measurement import (
    SHAKE_COLUMNS,
    Conditions,
    absent,
    summarize,
)
from experiments.simulation.simulation import Simulation
from experiments.simulation.task import FRAME_RATE

WEIGHTLESS = replace(
    AS_SHIPPED, backend="mujoco", gravity_m_s2=0.0, cube_mu=AS_SHIPPED.pad_mu
)
SHAKES = {"3cm": 0.03, "10cm": 0.1, "held": 0.0}  # amplitudes [m]
OFF = "path_off_mm"  # distance of the hand from its path in MuJoCo C
UNCOUNTED = ("peak_contact_count", "peak_constraint_count", "wall_s")
INERTIA = 'ixx="1e-7" iyy="1e-7" izz="1e-7" ixy="0" ixz="0" iyz="0"'
INERTIAL = f'<inertial><mass value="1e-4"/><inertia {INERTIA}/></inertial>'
"""Inertia for links that have none.

Some engines would otherwise assign 1 kg to such links.
"""


class Reference(NamedTuple):
    """A run in MuJoCo C with its initial joint positions and commands."""

    case: Case
    trace: Trace
    targets: np.ndarray  # shape [1 + frames, dofs]


def rows(conditions: Conditions, models: Sequence[Any]) -> list[dict[str, object]]:
    """Return a row for each shake in MuJoCo C and in each model that loads a robot."""
    base = replace(
        WEIGHTLESS, frame_count=conditions.frame_count(AS_SHIPPED.frame_count)
    )
    references = [
        reference(replace(base, name=shake, shake_amplitude_m=amplitude_m))
        for shake, amplitude_m in SHAKES.items()
    ]
    found = [row_of("mujoco-c", "own", each, each.trace) for each in references]
    for model in models:
        if not model.armature:
            continue
        with tempfile.TemporaryDirectory() as folder:
            file = f"{folder}/robot.urdf"
            write_robot(file, model.armature)
            scenes = [scene_of(each, file) for each in references]
            shown = engine.run(scenes, model.engine)
        for own, trace in zip(references, shown, strict=True):
            run = trace if isinstance(trace, str) else traced(trace, own.trace)
            found.append(row_of(model.name, model.armature, own, run))
    return found


def reference(case: Case) -> Reference:
    """Run a case in MuJoCo C."""
    simulation = Simulation([case], wp.get_device("cpu"))
    simulation.solver.mj_data.eq_active[:] = 0  # turns off the coupling of the fingers
    simulation.solver.mj_model.dof_frictionloss[:] = 0.0
    commanded = [simulation.joint_target.numpy()[0].copy()]
    for _ in range(case.frame_count):
        simulation.step()
        commanded.append(simulation.joint_target.numpy()[0].copy())
    [trace] = simulation.recorder.traces(0.0)
    targets = np.array(commanded, dtype=float)[:, : scene.ROBOT_DOF_COUNT]
    return Reference(case, trace, targets)


def write_robot(path: str, armature: str) -> None:
    """Write the robot's description for an engine.

    With ``own``, the engine supports armature. With ``links``, armature is added to the
    inertia of the links.
    """
    robot = ElementTree.parse(scene.ROBOT)
    for link in robot.iter("link"):
        for visual in link.findall("visual"):
            link.remove(visual)
        if link.find("inertial") is None:
            link.append(ElementTree.fromstring(INERTIAL))
    base, *joints = robot.iter("joint")
    base.find("origin").set("xyz", " ".join(map(str, scene.ROBOT_POSITION)))
    driven = [joint for joint in joints if joint.get("type") != "fixed"]
    for joint, added in zip(driven, scene.ARMATURE, strict=True):
        for part in [*joint.findall("dynamics"), *joint.findall("mimic")]:
            joint.remove(part)
        if armature == "links":
            inertial = robot.find(
                f"link[@name='{joint.find('child').get('link')}']/inertial"
            )
            is_turning = joint.get("type") == "revolute"  # about z, like a disc
            parts = (
                ("inertia", "izz", 1.0),
                ("inertia", "ixx", 0.5),
                ("inertia", "iyy", 0.5),
            )
            for tag, name, share in parts if is_turning else (("mass", "value", 1.0),):
                element = inertial.find(tag)
                element.set(name, str(float(element.get(name)) + share * added))
    robot.write(path)


def scene_of(own: Reference, file: str) -> Scene:
    """Return a case as a scene with the robot of a file and the same joint targets."""
    case = own.case
    mass_kg = case.cube_density_kg_m3 * case.cube_edge_m**3
    cube = Body(
        mass_kg=mass_kg,
        inertia_kg_m2=[mass_kg * case.cube_edge_m**2 / 6.0] * 3,
        position_m=scene.cube_start(case),
        foot_m=case.cube_edge_m
        # This sets the resolution of Drake's surfaces.
        / 2.0,
        half_size_m=[case.cube_edge_m / 2.0] * 3,
    )
    robot = Robot(
        file,
        scene.TRACKED_BODIES[metrics.TCP],
        scene.TARGET_KE,
        scene.TARGET_KD,
        scene.EFFORT_LIMIT,
        scene.ARMATURE,
    )
    return Scene(
        step_s=1.0 / FRAME_RATE / case.substeps,
        sample_s=1.0 / FRAME_RATE,
        targets=own.targets[1:].tolist(),
        qpos=own.targets[0].tolist(),
        body=cube,
        robot=robot,
        friction=case.pad_mu,
        gravity_m_s2=ORIGIN,
    )


def traced(shown: Shown, own: Trace) -> Trace:
    """Return the trace of an engine with the phases of the original run."""
    contacts = np.full((len(own.phase), len(FRAME_COLUMNS)), np.nan)
    contacts[:, [FRAME_COLUMNS.index(name) for name in FORCES]] = shown.forces
    poses = shown.poses[1:]
    return Trace(own.frame_dt, own.phase, poses, contacts, first_failure(poses, None))


def row_of(
    model: str, armature: str, own: Reference, trace: Trace | str
) -> dict[str, object]:
    """Return the row of a trace, or of the reason if there is none."""
    case = replace(own.case, name=f"{model}-shake-{own.case.name}")
    row: dict[str, Any] = {
        "case": case.name,
        "backend": model.partition("-")[0],
        "model": model,
        "shake": own.case.name,
        "armature": armature,
    }
    if isinstance(trace, str):
        return row | {"dropped": None} | absent((*SHAKE_COLUMNS, *GRASP, OFF), trace)
    row = summarize(case, trace) | row
    row |= absent(UNCOUNTED, "it is not counted in each engine")
    lost = "the cube is lost" if row["dropped"] else ""
    if reason := row.get("slip_mm_reason") or lost:
        return row | absent((*SHAKE_COLUMNS, *GRASP, OFF), reason)
    is_shaken = trace.phase == metrics.SHAKE
    hands_m = (each.poses[is_shaken, metrics.TCP, :3] for each in (trace, own.trace))
    path_off = {OFF: float(metrics.distance_rms_mm(*hands_m))}
    return row | grasp_columns(case, trace, path_off, "the engine does not say it")
