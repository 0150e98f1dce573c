"""The box on the turning table, on a slope and on a table that stands still, with each of Newton's solvers.

A solver that has the velocity at the contact vanish at the end of each step of h, and moves by one end's velocity, has
the box walk by h/2 of the acceleration ω² r that a step bends its path by: dr/dt = ± r ω² h / 2, less the shorter the
step. What does not go with the step is something else.
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
SECONDS = {"full": 4.0, "quick": 2.0}  # on the turning table
STANDING = ("slope", "still")  # scenes in which the table does not turn
STANDING_S = 2.0
SLOPE = 0.35  # tangent of the slope [rad/rad]; friction carries up to 1
FRAME_STEPS = 8  # steps of a frame, where contacts are found once a frame
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
"""Options by class; all others are as the solver comes. Steel drops constraint rows that do not fit."""
EXCUSED = {  # solvers that are not measured, and why; a record names them as well
    "SolverImplicitMPM": "it moves grains, and no rigid body",
    "SolverStyle3D": "it moves cloth, and no rigid body",
}


@dataclass(frozen=True)
class Variant:
    """A solver as it is run: its class, what differs from its options here, and how contacts are found."""

    name: str
    solver: str = "SolverSteel"
    options: Mapping[str, Any] = field(default_factory=dict)
    pipeline: Mapping[str, Any] = field(default_factory=dict)
    steps_between_contacts: int | None = None  # as the scene has it where left out


STEEL = (  # Steel with one thing changed at a time, here and in the shake
    Variant("steel-points", options={"friction_anchor_beta": 0.0}),
    Variant(
        "steel-matched",
        options={"contact_warmstart": True},
        pipeline={"contact_matching": "latest"},
    ),
)


def variants() -> list[Variant]:
    """List each rigid-body solver of the installed release, and Steel with one thing changed at a time."""
    names = [name for name in solver_classes() if name not in EXCUSED]
    of_steel = (
        [*STEEL, Variant("steel-frames", steps_between_contacts=FRAME_STEPS)]
        if "SolverSteel" in names
        else []
    )
    return [*(Variant(name_of(name), name) for name in names), *of_steel]


def solver_classes() -> list[str]:
    """Name the solvers that the installed release offers."""
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
    """Make a row for each solver that is not measured, with the reason."""
    excused = [name for name in solver_classes() if name in EXCUSED]
    return [
        {"case": name_of(solver), "of": solver, "stays": None}
        | absent([number_of("turntable")], EXCUSED[solver])
        for solver in excused
    ]


def rows_of(conditions: Conditions, variant: Variant) -> list[dict[str, object]]:
    """Make a row for each scene and step; without numbers, and with the reason, where it cannot run the scene."""
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
    except Exception as error:  # each is a program of its own, and need not know all that the scene has
        return row | {"stays": None} | absent([number_of(scene)], reason_of(error))


def reason_of(error: Exception) -> str:
    """Say in a line why a solver shows nothing."""
    return " ".join(str(error).split())[:120] or type(error).__name__


def number_of(scene: str) -> str:
    """Name what is measured in a scene: how fast the box walks outward, or creeps along the table that stands still."""
    return "creep_mm_s" if scene in STANDING else "growth_per_s"


def build(scene_name: str, device: str) -> newton.Model:
    """Build the turning box on four feet on a table that turns on a hinge or stands still; on a slope gravity leans."""
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
    builder.color()  # VBD asks for it
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
    newton.eval_fk(
        model, model.joint_q, model.joint_qd, model
    )  # VBD takes from here where bodies come from
    return model


def run(
    variant: Variant, scene: str, step_s: float, seconds: float, device: str
) -> np.ndarray:
    """Return the box's place [m] at each sample, shape [sample, 3]."""
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
        advance = (
            sample  # the first time compiles, which must not happen inside a capture
        )
        for _ in range(round(seconds / SAMPLE_S)):
            advance()
            path.append(states[0].body_q.numpy()[1, :3].copy())
            if advance is sample and model.device.is_cuda:
                advance = captured(sample)
        return np.array(path, dtype=float)


def columns(scene: str, path: np.ndarray) -> dict[str, object]:
    """Say how fast the box moves along the table, and whether it stays on it."""
    name = number_of(scene)
    if not np.isfinite(path).all():
        return {"stays": False} | absent([name], "a position is not finite")
    radius_m, settled = np.hypot(*path[:, :2].T), path[round(SETTLE_S / SAMPLE_S) :]
    stays = bool(abs(path[-1, 2] - path[0, 2]) < FOOT_M and radius_m[-1] < 0.5)
    if scene not in STANDING:
        return {"stays": stays, name: growth_per_s(radius_m, SETTLE_S)}
    velocity_m_s = np.polyfit(SAMPLE_S * np.arange(len(settled)), settled[:, :2], 1)[0]
    return {"stays": stays, name: 1e3 * float(np.hypot(*velocity_m_s))}
