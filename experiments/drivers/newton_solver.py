"""Newton's own solvers: which a release offers, and a body on a table in each."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import newton
import numpy as np
import warp as wp
from newton import solvers

from experiments.drivers.scene import Scene, Trace
from experiments.simulation.simulation import captured

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


def build(scene: Scene, device: str) -> newton.Model:
    """Build a body on balls, and the table under it on a hinge."""
    builder = newton.ModelBuilder()
    [table] = scene.supports
    config = newton.ModelBuilder.ShapeConfig(density=0.0, mu=scene.friction)
    inertia = wp.mat33(*np.diag([table.inertia_kg_m2] * 3).ravel())
    turned = builder.add_link(mass=table.mass_kg, inertia=inertia)
    hinge = builder.add_joint_revolute(-1, turned, axis=table.axis)
    builder.add_articulation([hinge])
    hx, hy, hz = table.half_size_m
    builder.add_shape_box(turned, hx=hx, hy=hy, hz=hz, cfg=config)
    inertia = wp.mat33(*np.diag(scene.body.inertia_kg_m2).ravel())
    carried = builder.add_link(mass=scene.body.mass_kg, inertia=inertia)
    builder.add_articulation([builder.add_joint_free(child=carried)])
    for position in scene.body.feet:
        foot = wp.transform(position, wp.quat_identity())
        radius = scene.body.foot_m
        builder.add_shape_sphere(carried, xform=foot, radius=radius, cfg=config)
    builder.color()  # VBD asks for it
    model = builder.finalize(device=device)
    joint_q = model.joint_q.numpy()
    joint_q[1:4] = scene.body.position_m
    model.joint_q.assign(joint_q)
    model.joint_qd.assign(scene.qvel)
    model.set_gravity(scene.gravity_m_s2)
    # VBD takes from here where bodies come from.
    newton.eval_fk(model, model.joint_q, model.joint_qd, model)
    return model


def run(scene: Scene, variant: Variant, device: str) -> Trace:
    """Return the trace of the body; an exception is the solver's own."""
    with wp.ScopedDevice(device):
        model = build(scene, device)
        states = model.state(), model.state()
        control = model.control()
        options = {**OPTIONS.get(variant.solver, {}), **variant.options}
        solver = getattr(solvers, variant.solver)(model, **options)
        pipeline = newton.CollisionPipeline(
            model, rigid_contact_max=4, **variant.pipeline
        )
        contacts = pipeline.contacts()

        def advance() -> None:
            for number in range(round(scene.sample_s / scene.step_s)):
                state_in, state_out = states[:: 1 - 2 * (number % 2)]
                if number % (variant.steps_between_contacts or 1) == 0:
                    pipeline.collide(state_in, contacts)
                state_in.clear_forces()
                solver.step(state_in, state_out, control, contacts, scene.step_s)

        poses = [states[0].body_q.numpy()[1:].copy()]
        queue = advance  # the first time compiles, which must not be captured
        for _ in scene.targets:
            queue()
            poses.append(states[0].body_q.numpy()[1:].copy())
            if queue is advance and model.device.is_cuda:
                queue = captured(advance)
        return Trace(np.array(poses, dtype=float))
