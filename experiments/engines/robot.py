"""The shake itself in other engines: the arm that holds a cube, driven by the joint targets of a run in MuJoCo C.

What one engine lacks is taken from all: weight, and with it the ground; a friction of each body's own; what couples the
fingers, and friction in the joints. Where an engine has no armature it is added to the links that the joints move.
"""

import tempfile
from collections.abc import Sequence
from dataclasses import replace
from typing import Any
from xml.etree import ElementTree

import numpy as np
import warp as wp

from experiments.drivers import engine
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
TOLD = ("normal_force_n", "tangential_force_n", "penetration_m")
GRASP = (
    "creep_mm_per_cycle",
    "path_off_mm",
    "normal_force_n",
    "friction_share",
    "penetration_mm",
)
UNCOUNTED = ("peak_contact_count", "peak_constraint_count", "wall_s")
INERTIA = 'ixx="1e-7" iyy="1e-7" izz="1e-7" ixy="0" ixz="0" iyz="0"'
INERTIAL = f'<inertial><mass value="1e-4"/><inertia {INERTIA}/></inertial>'
"""Of a link that has none, to which some engines would give 1 kg."""


def rows(conditions: Conditions, models: Sequence[Any]) -> list[dict[str, object]]:
    """Return a row for each shake in MuJoCo C and in each model that loads a robot."""
    base = replace(
        WEIGHTLESS, frame_count=conditions.frame_count(AS_SHIPPED.frame_count)
    )
    cases = [
        replace(base, shake_amplitude_m=amplitude) for amplitude in SHAKES.values()
    ]
    references = [reference(case) for case in cases]
    shown = [("mujoco-c", "own", [trace for trace, _ in references])]
    for model in filter(lambda model: model.armature, models):
        with tempfile.TemporaryDirectory() as folder:
            file = f"{folder}/robot.urdf"
            write_robot(file, model.armature)
            scenes = [
                scene_of(case, file, targets)
                for case, (_, targets) in zip(cases, references, strict=True)
            ]
            traces = [
                found if isinstance(found, str) else traced(found, own)
                for found, (own, _) in zip(
                    engine.run(scenes, model.engine), references, strict=True
                )
            ]
            shown.append((model.name, model.armature, traces))
    return [
        row_of(replace(case, name=f"{name}-shake-{shake}"), trace, own)
        | {
            "backend": name.partition("-")[0],
            "model": name,
            "shake": shake,
            "armature": armature,
        }
        for name, armature, traces in shown
        for shake, case, trace, (own, _) in zip(
            SHAKES, cases, traces, references, strict=True
        )
    ]


def reference(case: Case) -> tuple[Trace, np.ndarray]:
    """Run a case in MuJoCo C; return its trace and joints, at the start and as commanded, shape [1 + frames, dofs]."""
    simulation = Simulation([case], wp.get_device("cpu"))
    simulation.solver.mj_data.eq_active[:] = 0  # the fingers' coupling
    simulation.solver.mj_model.dof_frictionloss[:] = 0.0
    commanded = [simulation.joint_target.numpy()[0].copy()]
    for _ in range(case.frame_count):
        simulation.step()
        commanded.append(simulation.joint_target.numpy()[0].copy())
    [trace] = simulation.recorder.traces(0.0)
    return trace, np.array(commanded, dtype=float)[:, : scene.ROBOT_DOF_COUNT]


def write_robot(path: str, armature: str) -> None:
    """Write the robot's description for an engine that has armature itself (``own``), or gets it with the ``links``."""
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
            is_turning = joint.get("type") == "revolute"  # about z: a disc
            parts = (
                ("inertia", "izz", 1.0),
                ("inertia", "ixx", 0.5),
                ("inertia", "iyy", 0.5),
            )
            for tag, name, share in parts if is_turning else (("mass", "value", 1.0),):
                element = inertial.find(tag)
                element.set(name, str(float(element.get(name)) + share * added))
    robot.write(path)


def scene_of(case: Case, file: str, targets: np.ndarray) -> Scene:
    """Return a case as a scene, with the robot of a file and its joint targets."""
    mass_kg = case.cube_density_kg_m3 * case.cube_edge_m**3
    cube = Body(
        mass_kg=mass_kg,
        inertia_kg_m2=[mass_kg * case.cube_edge_m**2 / 6.0] * 3,
        position_m=scene.cube_start(case),
        foot_m=case.cube_edge_m
        / 2.0,  # which says how finely Drake's surfaces are made
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
        targets=targets[1:].tolist(),
        qpos=targets[0].tolist(),
        body=cube,
        robot=robot,
        friction=case.pad_mu,
        gravity_m_s2=ORIGIN,
    )


def traced(shown: Shown, run: Trace) -> Trace:
    """Return what an engine shows as a trace, in the phases of the run with its targets."""
    contacts = np.full((len(run.phase), len(FRAME_COLUMNS)), np.nan)
    contacts[:, [FRAME_COLUMNS.index(name) for name in TOLD]] = shown.forces
    poses = shown.poses[1:]
    return Trace(run.frame_dt, run.phase, poses, contacts, first_failure(poses, None))


def row_of(case: Case, trace: Trace | str, run: Trace) -> dict[str, object]:
    """Make a row of a trace, or of the reason why there is none; ``run`` is the one whose targets it had."""
    if isinstance(trace, str):
        return {"case": case.name, "dropped": None} | absent(
            (*SHAKE_COLUMNS, *GRASP), trace
        )
    row = summarize(case, trace)
    row |= absent(UNCOUNTED, "it is not counted in each engine")
    if reason := row.get("slip_mm_reason") or (
        "the cube is lost" if row["dropped"] else ""
    ):
        return row | absent((*SHAKE_COLUMNS, *GRASP), reason)
    creep_mm = metrics.cycle_drift_mm(
        metrics.displacement(trace), case.shake_frequency_hz
    )
    places = (
        each.poses[each.phase == metrics.SHAKE, metrics.TCP, :3]
        for each in (trace, run)
    )
    normal, tangential, depth = (
        trace.column(name)[trace.phase == metrics.SHAKE].mean() for name in TOLD
    )
    share = tangential / (case.pad_mu * normal) if normal > 0.0 else np.nan
    numbers = map(
        float, (creep_mm, metrics.distance_rms_mm(*places), normal, share, 1e3 * depth)
    )
    row |= dict(zip(GRASP, numbers, strict=True))
    unsaid = [name for name in GRASP if not np.isfinite(row[name])]
    return row | absent(unsaid, "the engine does not say it")
