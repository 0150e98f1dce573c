"""The shake itself in other engines: the arm that holds a cube, driven by the joint targets of a run in MuJoCo C.

What one engine lacks is taken from all: weight, and with it the ground; a friction of each body's own; what couples the
fingers, and friction in the joints. Where an engine has no armature it is added to the links that the joints move.
"""

import tempfile
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import numpy as np
import warp as wp

from experiments.engines.engine import Engine, run_apart
from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, Case
from experiments.facts.trace import FRAME_COLUMNS, Trace, first_failure
from experiments.simulation import scene
from experiments.simulation.measurement import SHAKE_COLUMNS, Conditions, absent, summarize
from experiments.simulation.simulation import Simulation
from experiments.simulation.task import FRAME_RATE

WEIGHTLESS = replace(AS_SHIPPED, backend="mujoco", gravity_m_s2=0.0, cube_mu=AS_SHIPPED.pad_mu)
SHAKES = {"3cm": 0.03, "10cm": 0.1, "held": 0.0}  # amplitudes [m]
TOLD = ("normal_force_n", "tangential_force_n", "penetration_m")
GRASP = ("creep_mm_per_cycle", "path_off_mm", "normal_force_n", "friction_share", "penetration_mm")
UNCOUNTED = ("peak_contact_count", "peak_constraint_count", "wall_s")
INERTIA = 'ixx="1e-7" iyy="1e-7" izz="1e-7" ixy="0" ixz="0" iyz="0"'
INERTIAL = f'<inertial><mass value="1e-4"/><inertia {INERTIA}/></inertial>'
"""Of a link that has none, to which some engines would give 1 kg."""


def rows(conditions: Conditions, models: Sequence[tuple[str, Engine, dict, str]]) -> list[dict[str, object]]:
    """Return a row for each shake in MuJoCo C and in each model: its name, engine, options, and where armature is."""
    frame_count = conditions.frame_count(AS_SHIPPED.frame_count)
    cases = [replace(WEIGHTLESS, frame_count=frame_count, shake_amplitude_m=each) for each in SHAKES.values()]
    references = [reference(case) for case in cases]
    shown: list[tuple[str, str, list]] = [("mujoco-c", "own", [trace for trace, _ in references])]
    for name, engine, options, armature in models:
        with tempfile.TemporaryDirectory() as folder:
            robot = Path(folder) / "robot.urdf"
            write_robot(robot, armature)
            scenes = [described(case, robot, targets) for case, (_, targets) in zip(cases, references, strict=True)]
            results = zip(run_apart(engine, [each | {"options": options} for each in scenes]), references, strict=True)
            traces = [result.get("reason") or traced(result, trace) for result, (trace, _) in results]
        shown.append((name, armature, traces))
    return [
        row_of(replace(case, name=f"{name}-shake-{shake}"), trace, own)
        | {"backend": name.partition("-")[0], "model": name, "shake": shake, "armature": armature}
        for name, armature, traces in shown
        for shake, case, trace, (own, _) in zip(SHAKES, cases, traces, references, strict=True)
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


def write_robot(path: Path, armature: str) -> None:
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
            inertial = robot.find(f"link[@name='{joint.find('child').get('link')}']/inertial")
            is_turning = joint.get("type") == "revolute"  # about z: a disc
            parts = (("inertia", "izz", 1.0), ("inertia", "ixx", 0.5), ("inertia", "iyy", 0.5))
            for tag, name, share in parts if is_turning else (("mass", "value", 1.0),):
                element = inertial.find(tag)
                element.set(name, str(float(element.get(name)) + share * added))
    robot.write(path)


def described(case: Case, robot: Path, targets: np.ndarray) -> dict[str, object]:
    """Describe the scene of a case and its step for an engine, with its joint targets."""
    mass, half = case.cube_density_kg_m3 * case.cube_edge_m**3, case.cube_edge_m / 2.0
    cube = {"mass_kg": mass, "inertia_kg_m2": [mass * case.cube_edge_m**2 / 6.0] * 3, "half_size": [half] * 3}
    cube |= {"feet": [], "foot_m": half, "place": scene.cube_start(case)}
    cube |= {"velocity": [0.0] * 3, "spin": [0.0] * 3}
    shake = {"robot": str(robot), "start": targets[0].tolist(), "targets": targets[1:].tolist(), "body": cube}
    shake |= {"tool": scene.TRACKED_BODIES[metrics.TCP], "supports": [], "friction": case.pad_mu, "gravity_m_s2": 0.0}
    shake |= {"ke": scene.TARGET_KE, "kd": scene.TARGET_KD, "effort": scene.EFFORT_LIMIT, "armature": scene.ARMATURE}
    return {"scene": shake | {"sample_s": 1.0 / FRAME_RATE}, "step_s": 1.0 / FRAME_RATE / case.substeps}


def traced(result: dict, run: Trace) -> Trace:
    """Return what an engine shows as a trace, in the phases of the run whose targets it had; NaN is not said."""
    poses, contacts = np.array(result["poses"], dtype=float), np.full((len(run.phase), len(FRAME_COLUMNS)), np.nan)
    contacts[:, [FRAME_COLUMNS.index(name) for name in TOLD]] = result["forces"]
    return Trace(run.frame_dt, run.phase, poses, contacts, first_failure(poses, None))


def row_of(case: Case, trace: Trace | str, run: Trace) -> dict[str, object]:
    """Make a row of a trace, or of the reason why there is none; ``run`` is the one whose targets it had."""
    if isinstance(trace, str):
        return {"case": case.name, "dropped": None} | absent((*SHAKE_COLUMNS, *GRASP), trace)
    row = summarize(case, trace)
    row |= absent(UNCOUNTED, "it is not counted in each engine")
    if reason := row.get("slip_mm_reason") or ("the cube is lost" if row["dropped"] else ""):
        return row | absent((*SHAKE_COLUMNS, *GRASP), reason)
    creep_mm = metrics.cycle_drift_mm(metrics.displacement(trace), case.shake_frequency_hz)
    places = (each.poses[each.phase == metrics.SHAKE, metrics.TCP, :3] for each in (trace, run))
    normal, tangential, depth = (trace.column(name)[trace.phase == metrics.SHAKE].mean() for name in TOLD)
    share = tangential / (case.pad_mu * normal) if normal > 0.0 else np.nan
    numbers = map(float, (creep_mm, metrics.distance_rms_mm(*places), normal, share, 1e3 * depth))
    row |= dict(zip(GRASP, numbers, strict=True))
    unsaid = [name for name in GRASP if not np.isfinite(row[name])]
    return row | absent(unsaid, "the engine does not say it")
