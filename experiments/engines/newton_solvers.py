"""The box on the turning table with Newton's solvers: which of them let it walk?

A solver that has the velocity at the contact vanish at the end of each step of h, and moves by one end's velocity, has
the box walk by h/2 of the acceleration ω² r that a step bends its path by: dr/dt = ± r ω² h / 2, less the shorter the
step. What does not go with the step is something else.
"""

from collections.abc import Mapping
from typing import Any

import newton
import numpy as np
import warp as wp
from newton import solvers
from tqdm import tqdm

from experiments.cure.turntable import SAMPLE_S, SETTLE_S
from experiments.engines.scenes import FOOT_M, turntable
from measured_report.measuring.measurement import Conditions, absent

STEPS_S = {"full": (0.002, 0.001), "quick": (0.002,)}
SECONDS = {"full": 4.0, "quick": 2.0}
NUMBERS = ("growth_per_s", "end_radius_mm")
SOLVERS: Mapping[str, tuple[str, Mapping[str, Any]]] = {
    "mujoco": ("SolverMuJoCo", {"cone": "elliptic", "integrator": "implicitfast"}),
    "xpbd": ("SolverXPBD", {"angular_damping": 0.0}),
    "kamino": ("SolverKamino", {}),
    "featherstone": ("SolverFeatherstone", {"angular_damping": 0.0}),
    "semi-implicit": ("SolverSemiImplicit", {"angular_damping": 0.0}),
    "vbd": ("SolverVBD", {}),
}
"""Class and options by name; the rest is as the solver comes."""


def rows(conditions: Conditions) -> list[dict[str, object]]:
    """Make a row for each solver and step; without numbers, and with the reason, where it cannot run the scene."""
    found = []
    runs = [(solver, step_s) for solver in SOLVERS for step_s in STEPS_S[conditions.profile]]
    for solver, step_s in tqdm(runs, desc="Newton's solvers", unit="run", delay=3.0):
        row = {"case": f"{solver}-{1e3 * step_s:g}ms", "solver": solver, "step_ms": 1e3 * step_s}
        try:
            found.append(row | columns(run(solver, step_s, SECONDS[conditions.profile], conditions.device)))
        except Exception as error:  # each is a program of its own, and need not know all that the scene has
            reason = " ".join(str(error).split())[:120] or type(error).__name__
            found.append(row | {"stays": None} | absent(NUMBERS, reason))
    return found


def build(device: str) -> newton.Model:
    """Build the table, which turns about a hinge, and the box on four feet, both in their places and turning."""
    scene, builder = turntable(0.0), newton.ModelBuilder()
    box, [table] = scene["body"], scene["supports"]
    config = newton.ModelBuilder.ShapeConfig(density=0.0, mu=scene["friction"])
    turned = builder.add_link(mass=table["mass_kg"], inertia=wp.mat33(*np.diag([table["inertia_kg_m2"]] * 3).ravel()))
    builder.add_articulation([builder.add_joint_revolute(-1, turned, axis=table["axis"])])
    hx, hy, hz = table["half_size"]
    builder.add_shape_box(turned, hx=hx, hy=hy, hz=hz, cfg=config)
    carried = builder.add_link(mass=box["mass_kg"], inertia=wp.mat33(*np.diag(box["inertia_kg_m2"]).ravel()))
    builder.add_articulation([builder.add_joint_free(child=carried)])
    for place in box["feet"]:
        foot = wp.transform(place, wp.quat_identity())
        builder.add_shape_sphere(carried, xform=foot, radius=box["foot_m"], cfg=config)
    builder.color()  # VBD asks for it
    model = builder.finalize(device=device)
    joint_q = model.joint_q.numpy()
    joint_q[1:4] = box["place"]
    model.joint_q.assign(joint_q)
    model.joint_qd.assign(scene["qvel"])
    return model


def run(solver: str, step_s: float, seconds: float, device: str) -> np.ndarray:
    """Return the box's place [m] at each sample, shape [sample, 3]."""
    with wp.ScopedDevice(device):
        model = build(device)
        states, control = (model.state(), model.state()), model.control()
        newton.eval_fk(model, model.joint_q, model.joint_qd, states[0])
        name, options = SOLVERS[solver]
        stepper = getattr(solvers, name)(model, **options)
        pipeline = newton.CollisionPipeline(model, rigid_contact_max=4)
        contacts = pipeline.contacts()
        path = [states[0].body_q.numpy()[1, :3].copy()]
        for _ in range(round(seconds / SAMPLE_S)):
            for _ in range(round(SAMPLE_S / step_s / 2.0)):
                for here, there in (states, states[::-1]):
                    pipeline.collide(here, contacts)
                    here.clear_forces()
                    stepper.step(here, there, control, contacts, step_s)
            path.append(states[0].body_q.numpy()[1, :3].copy())
        return np.array(path, dtype=float)


def columns(path: np.ndarray) -> dict[str, object]:
    """Say how fast the distance of the box from the axis grows, and whether it stays on the table."""
    if not np.isfinite(path).all():
        return {"stays": False} | absent(NUMBERS, "a position is not finite")
    radius, time_s = np.hypot(path[:, 0], path[:, 1]), SAMPLE_S * np.arange(len(path))
    settled = time_s >= SETTLE_S
    return {
        "stays": bool(abs(path[-1, 2] - path[0, 2]) < FOOT_M and radius[-1] < 0.5),
        "end_radius_mm": 1e3 * float(radius[-1]),
        "growth_per_s": float(np.polyfit(time_s[settled], np.log(radius[settled]), 1)[0]),
    }
