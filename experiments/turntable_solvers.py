"""The box on the turning table once more, with Newton's other solvers: which of them let it walk?

A solver that has the velocity at the contact vanish at the end of each step of h, and moves by one end's velocity, has
the box walk by h/2 of the acceleration ω² r that a step bends its path by: dr/dt = ± r ω² h / 2, less the shorter the
step. What does not go with the step is something else.
"""

from collections.abc import Callable
from dataclasses import dataclass

import newton
import numpy as np
import warp as wp
from newton import solvers
from tqdm import tqdm

from experiments.simulation.measurement import Conditions, Measurement, absent
from experiments.turntable import MASS_KG, RADIUS_M, SAMPLE_S, SETTLE_S, TURN_RAD_S

NEEDS_GPU = False
"""Read by ``measured_report.editions.devices``: the walk is the same on any machine, as far as its digits are said."""
STEPS_S = {"full": (0.002, 0.001), "quick": (0.002,)}
SECONDS = {"full": 4.0, "quick": 2.0}
TABLE_INERTIA = 1000.0
"""Of the table [kg m²], which keeps turning whatever the box does."""
HALF_EDGE_M, FOOT_M = 0.05, 0.01
FEET = [(x, y, -0.04) for x in (0.04, -0.04) for y in (0.04, -0.04)]
NUMBERS = ("growth_per_s", "end_radius_mm", "end_height_mm", "end_turn_mrad_s")


@dataclass(frozen=True)
class Solver:
    """One of Newton's solvers, as it comes."""

    name: str
    make: Callable[[newton.Model], solvers.SolverBase]


SOLVERS = [
    Solver("mujoco", lambda model: solvers.SolverMuJoCo(model, cone="elliptic", integrator="implicitfast")),
    Solver("xpbd", lambda model: solvers.SolverXPBD(model, angular_damping=0.0)),
    Solver("kamino", lambda model: solvers.SolverKamino(model)),
    Solver("featherstone", lambda model: solvers.SolverFeatherstone(model, angular_damping=0.0)),
    Solver("semi-implicit", lambda model: solvers.SolverSemiImplicit(model, angular_damping=0.0)),
    Solver("vbd", lambda model: solvers.SolverVBD(model)),
]


def measure(conditions: Conditions) -> Measurement:
    """A row for each solver and step; without numbers, and with the reason, where a solver cannot run the scene."""
    rows = []
    runs = [(solver, step_s) for solver in SOLVERS for step_s in STEPS_S[conditions.profile]]
    for solver, step_s in tqdm(runs, desc="turntable_solvers", unit="run", delay=3.0):
        row = {"case": f"{solver.name}-{1e3 * step_s:g}ms", "solver": solver.name, "step_ms": 1e3 * step_s}
        try:
            rows.append(row | run_columns(solver, step_s, SECONDS[conditions.profile], conditions.device))
        except Exception as error:  # each is a program of its own, and need not know all that the scene has
            reason = " ".join(str(error).split())[:120] or type(error).__name__
            rows.append(row | {"stays": None} | absent(NUMBERS, reason))
    return Measurement(rows)


def build(device: str) -> newton.Model:
    """The table, which turns about a hinge, and the box on four feet, both in their places and turning."""
    builder = newton.ModelBuilder()
    config = newton.ModelBuilder.ShapeConfig(density=0.0, mu=1.0)
    table = builder.add_link(mass=TABLE_INERTIA, inertia=wp.mat33(*np.diag([TABLE_INERTIA] * 3).ravel()))
    builder.add_articulation([builder.add_joint_revolute(-1, table, axis=(0.0, 0.0, 1.0))])
    builder.add_shape_box(table, hx=0.5, hy=0.5, hz=HALF_EDGE_M, cfg=config)
    inertia = MASS_KG / 3.0 * np.diag([HALF_EDGE_M**2 + 0.04**2, HALF_EDGE_M**2 + 0.04**2, 2.0 * HALF_EDGE_M**2])
    box = builder.add_link(mass=MASS_KG, inertia=wp.mat33(*inertia.ravel()))
    builder.add_articulation([builder.add_joint_free(child=box)])
    for place in FEET:
        builder.add_shape_sphere(box, xform=wp.transform(place, wp.quat_identity()), radius=FOOT_M, cfg=config)
    builder.color()  # VBD asks for it
    model = builder.finalize(device=device)
    joint_q, joint_qd = model.joint_q.numpy(), model.joint_qd.numpy()
    joint_q[1:4] = RADIUS_M, 0.0, 0.1
    joint_qd[:] = TURN_RAD_S, 0.0, TURN_RAD_S * RADIUS_M, 0.0, 0.0, 0.0, TURN_RAD_S
    model.joint_q.assign(joint_q)
    model.joint_qd.assign(joint_qd)
    return model


def run_columns(solver: Solver, step_s: float, seconds: float, device: str) -> dict[str, object]:
    """How fast the distance of the box from the axis grows, and whether it stays on the table."""
    with wp.ScopedDevice(device):
        model = build(device)
        states, control = (model.state(), model.state()), model.control()
        newton.eval_fk(model, model.joint_q, model.joint_qd, states[0])
        stepper, pipeline = solver.make(model), newton.CollisionPipeline(model, rigid_contact_max=len(FEET))
        contacts = pipeline.contacts()

        def two_steps() -> None:
            for here, there in (states, states[::-1]):
                pipeline.collide(here, contacts)
                here.clear_forces()
                stepper.step(here, there, control, contacts, step_s)

        paths = [states[0].body_q.numpy()[1, :3].copy()]
        for _ in range(round(seconds / SAMPLE_S)):
            for _ in range(round(SAMPLE_S / step_s / 2.0)):
                two_steps()
            paths.append(states[0].body_q.numpy()[1, :3].copy())
        turn = 1e3 * float(states[0].body_qd.numpy()[0, 5])
    path = np.array(paths, dtype=float)
    radius, time_s = np.hypot(path[:, 0], path[:, 1]), SAMPLE_S * np.arange(len(path))
    stays = bool(np.isfinite(path).all() and abs(path[-1, 2] - path[0, 2]) < FOOT_M and radius[-1] < 0.5)
    columns: dict[str, object] = {"stays": stays}
    if not np.isfinite(path).all():
        return columns | absent(NUMBERS, "a position is not finite")
    settled = time_s >= SETTLE_S
    growth = np.polyfit(time_s[settled], np.log(radius[settled]), 1)[0]
    ends = {
        "end_radius_mm": 1e3 * float(radius[-1]),
        "end_height_mm": 1e3 * float(path[-1, 2]),
        "end_turn_mrad_s": turn,
    }
    return columns | ends | {"growth_per_s": float(growth)}
