"""Run the box on a rotating, a sloped and a still table in Newton's solvers.

The path of the box is curved by the acceleration ω² r. If a solver makes the velocity
at the contact vanish at the end of each step of length h, and moves the box by the
velocity at one end of the step, the box drifts by h/2 of this acceleration: dr/dt = ± r
ω² h / 2. This drift decreases with the step. A drift that does not depend on the step
has another cause.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import newton
import numpy as np
import warp as wp
from newton import solvers

from experiments.cure.turntable import SAMPLE_S, SETTLE_S, growth_per_s
from experiments.newton_solvers.turntable import FOOT_M, GRAVITY_M_S2, turntable
from experiments.simulation.simulation import captured
from measured_report.measuring.measurement import Conditions, absent

STEPS_S = {"full": (0.002, 0.001), "quick": (0.002,)}
SECONDS = {"full": 4.0, "quick": 2.0}  # duration on the rotating table
STANDING = ("slope", "still")  # scenes in which the table does not rotate
STANDING_S = 2.0
SLOPE = 0.35  # tangent of the slope [rad/rad]; friction holds the box up to 1
FRAME_STEPS = 8  # steps of a frame, if contacts are detected once per frame
OPTIONS: Mapping[str, Mapping[str, Any]] = {
    "SolverMuJoCo": {"cone": "elliptic", "integrator": "implicitfast"},
    "SolverXPBD": {"angular_damping": 0.0},
    "SolverFeatherstone": {"angular_damping": 0.0},
    "SolverSemiImplicit": {"angular_damping": 0.0},
    "SolverSteel": {
        "articulation_constraint_max": 256,
        "free_body_constraint_max": 512,
    },
}
"""Options by class; all others are the defaults of the solver.

Steel drops constraint rows that do not fit.
"""
# solvers that are not measured, with the reason, which is also in the record
EXCUSED = {
    "SolverImplicitMPM": "it moves grains, and no rigid body",
    "SolverStyle3D": "it moves cloth, and no rigid body",
}


@dataclass(frozen=True)
class Variant:
    """Describe a solver with its class, its options and its contact detection."""

    name: str
    solver: str = "SolverSteel"
    options: Mapping[str, Any] = field(default_factory=dict)
    pipeline: Mapping[str, Any] = field(default_factory=dict)
    steps_between_contacts: int | None = None  # None uses the value of the scene


STEEL = (  # Steel with one change at a time, here and in the shake
    Variant("steel-points", options={"friction_anchor_beta": 0.0}),
    Variant(
        "steel-matched",
        options={"contact_warmstart": True},
        pipeline={"contact_matching": "latest"},
    ),
)


def variants() -> list[Variant]:
    """Return the rigid-body solvers of the release, and Steel with single changes."""
    names = [name for name in solver_classes() if name not in EXCUSED]
    of_steel = (
        [*STEEL, Variant("steel-frames", steps_between_contacts=FRAME_STEPS)]
        if "SolverSteel" in names
        else []
    )
    return [*(Variant(name_of(name), name) for name in names), *of_steel]


def solver_classes() -> list[str]:
    """Return the names of the solvers in the installed release."""
    offered = {name: getattr(solvers, name) for name in solvers.__all__}
    base = solvers.SolverBase
    return [
        name
        for name, kind in offered.items()
        if isinstance(kind, type) and issubclass(kind, base) and kind is not base
    ]


def name_of(solver: str) -> str:
    name = re.sub(r"(?<=[a-z])(?=[A-Z])", "-", solver.removeprefix("Solver"))
    return name.lower().replace("mu-jo-co", "mujoco")


def excused_rows() -> list[dict[str, object]]:
    """Return a row for each solver that is not measured, with the reason."""
    excused = [name for name in solver_classes() if name in EXCUSED]
    return [
        {"case": name_of(solver), "of": solver, "stays": None}
        | absent([number_of("turntable")], EXCUSED[solver])
        for solver in excused
    ]


def rows_of(conditions: Conditions, variant: Variant) -> list[dict[str, object]]:
    """Return a row for each scene and step.

    If the solver cannot run the scene, the row contains the reason instead of numbers.
    """
    seconds, (long_s, *shorter_s) = (
        SECONDS[conditions.profile],
        STEPS_S[conditions.profile],
    )
    runs = [("turntable", step_s, seconds) for step_s in (long_s, *shorter_s)]
    runs += [(scene, long_s, STANDING_S) for scene in STANDING]
    return [row_of(variant, *run, conditions.device) for run in runs]


def row_of(
    variant: Variant, scene: str, step_s: float, seconds: float, device: str
) -> dict[str, object]:
    end = scene if scene in STANDING else f"{1e3 * step_s:g}ms"
    row = {
        "case": f"{variant.name}-{end}",
        "solver": variant.name,
        "of": variant.solver,
        "step_ms": 1e3 * step_s,
    }
    try:
        path = run(variant, scene, step_s, seconds, device)
        return row | columns(scene, path)
    # Each solver is a separate program that may not support all features of the scene.
    except Exception as error:
        return row | {"stays": None} | absent([number_of(scene)], reason_of(error))


def reason_of(error: Exception) -> str:
    """Return a line with the reason why a solver has no result."""
    return " ".join(str(error).split())[:120] or type(error).__name__


def number_of(scene: str) -> str:
    """Return the name of the measured number in a scene.

    It is the growth of the radius on the rotating table, and the creep on the slope and
    the still table.
    """
    return "creep_mm_s" if scene in STANDING else "growth_per_s"


def build(scene_name: str, device: str) -> newton.Model:
    """Return the model of a box on four feet on a table.

    The table rotates on a hinge or stands still. On the slope, gravity is tilted.
    """
    scene, builder = turntable(0.0), newton.ModelBuilder()
    box, [table] = scene["body"], scene["supports"]
    config = newton.ModelBuilder.ShapeConfig(density=0.0, mu=scene["friction"])
    turned = builder.add_link(
        mass=table["mass_kg"],
        inertia=wp.mat33(*np.diag([table["inertia_kg_m2"]] * 3).ravel()),
    )
    builder.add_articulation(
        [builder.add_joint_revolute(-1, turned, axis=table["axis"])]
    )
    hx, hy, hz = table["half_size"]
    builder.add_shape_box(turned, hx=hx, hy=hy, hz=hz, cfg=config)
    carried = builder.add_link(
        mass=box["mass_kg"], inertia=wp.mat33(*np.diag(box["inertia_kg_m2"]).ravel())
    )
    builder.add_articulation([builder.add_joint_free(child=carried)])
    for position in box["feet"]:
        foot = wp.transform(position, wp.quat_identity())
        builder.add_shape_sphere(carried, xform=foot, radius=box["foot_m"], cfg=config)
    builder.color()  # VBD requires it
    model = builder.finalize(device=device)
    joint_q = model.joint_q.numpy()
    joint_q[1:4] = box["place"]
    model.joint_q.assign(joint_q)
    if scene_name == "turntable":
        model.joint_qd.assign(scene["qvel"])
    if scene_name == "slope":
        model.set_gravity(
            (
                GRAVITY_M_S2 * SLOPE / np.hypot(1.0, SLOPE),
                0.0,
                -GRAVITY_M_S2 / np.hypot(1.0, SLOPE),
            )
        )
    # VBD reads the previous poses of the bodies from here.
    newton.eval_fk(
        model,
        model.joint_q,
        model.joint_qd,
        model,
    )
    return model


def run(
    variant: Variant, scene: str, step_s: float, seconds: float, device: str
) -> np.ndarray:
    """Return the positions of the box at each sample [m], shape [sample, 3]."""
    with wp.ScopedDevice(device):
        model = build(scene, device)
        states, control = (model.state(), model.state()), model.control()
        options = {**OPTIONS.get(variant.solver, {}), **variant.options}
        stepper = getattr(solvers, variant.solver)(model, **options)
        pipeline = newton.CollisionPipeline(
            model, rigid_contact_max=4, **variant.pipeline
        )
        contacts = pipeline.contacts()

        def sample() -> None:
            for number in range(round(SAMPLE_S / step_s)):
                state_in, state_out = states[:: 1 - 2 * (number % 2)]
                if number % (variant.steps_between_contacts or 1) == 0:
                    pipeline.collide(state_in, contacts)
                state_in.clear_forces()
                stepper.step(state_in, state_out, control, contacts, step_s)

        path = [states[0].body_q.numpy()[1, :3].copy()]
        # The first call compiles, which is not allowed during a capture.
        advance = sample
        for _ in range(round(seconds / SAMPLE_S)):
            advance()
            path.append(states[0].body_q.numpy()[1, :3].copy())
            if advance is sample and model.device.is_cuda:
                advance = captured(sample)
        return np.array(path, dtype=float)


def columns(scene: str, path: np.ndarray) -> dict[str, object]:
    """Return the speed of the box along the table, and whether the box stays on it."""
    name = number_of(scene)
    if not np.isfinite(path).all():
        return {"stays": False} | absent([name], "a position is not finite")
    radius_m, settled = np.hypot(*path[:, :2].T), path[round(SETTLE_S / SAMPLE_S) :]
    stays = bool(abs(path[-1, 2] - path[0, 2]) < FOOT_M and radius_m[-1] < 0.5)
    if scene not in STANDING:
        return {"stays": stays, name: growth_per_s(radius_m, SETTLE_S)}
    velocity_m_s = np.polyfit(SAMPLE_S * np.arange(len(settled)), settled[:, :2], 1)[0]
    return {"stays": stays, name: 1e3 * float(np.hypot(*velocity_m_s))}
