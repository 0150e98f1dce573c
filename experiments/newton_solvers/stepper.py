"""Run the shake in any of Newton's solvers, with scene and task of ``simulation``.

Only MuJoCo's solver supports gravity compensation, so forces on the links carry the
weight of the arm. The other solvers also ignore the priority of geoms, and some do not
support links without mass.
"""

from collections.abc import Sequence

import newton
import numpy as np
import warp as wp
from newton import CollisionPipeline, Contacts, Model, solvers
from newton.solvers import SolverBase

from experiments.facts.case import Case
from experiments.newton_solvers.box import OPTIONS, Variant
from experiments.simulation.recorder import (
    CONE,
    COUNT,
    LOADED,
    NORMAL,
    PENETRATION,
    TANGENTIAL,
    Recorder,
    watch_substep,
)
from experiments.simulation.scene import FIXED_BODIES, Scene
from experiments.simulation.stepper import CONTACT_MAX, Stepper
from measured_report.measuring.measurement import absent


class SolverStepper(Stepper):
    """Step the shake with one of Newton's solvers.

    It uses the fields of a case that do not only concern MuJoCo.
    """

    @property
    def is_queued(self) -> bool:
        return True

    def __init__(self, variant: Variant, scene: Scene, cases: Sequence[Case]):
        self.variant = variant
        super().__init__(scene, cases)

    def build(self, state: newton.State, frame_count: int) -> None:
        super().build(state, frame_count)
        state_out = self.model.state()
        wp.copy(state_out.body_q, state.body_q)
        state.body_f = state_out.body_f = weight_of_the_arm(self)
        self.states = state, state_out

    def step(self, substep: int, control: newton.Control, step_s: float) -> None:
        """Queue a substep. The first state contains the result of every second substep."""
        last, between = (
            self.case.substeps - 1,
            self.variant.steps_between_contacts or self.case.substeps,
        )
        state_in, state_out = self.states[:: 1 - 2 * (substep % 2)]
        if substep % between == 0:
            self.pipeline.collide(state_in, self.contacts)
        options = (
            {"observables": self.observed} if self.observed and substep == last else {}
        )
        self.solver.step(state_in, state_out, control, self.contacts, step_s, **options)

    def row_peak(self) -> dict[str, object]:
        return absent(["peak_constraint_count"], "this solver does not count its rows")

    def _build_collision(self) -> tuple[CollisionPipeline, Contacts]:
        most = self.world_count * (self.case.contact_max or CONTACT_MAX)
        pipeline = CollisionPipeline(
            self.model,
            broad_phase=self.case.broad_phase,
            rigid_contact_max=most,
            **self.variant.pipeline,
        )
        return pipeline, pipeline.contacts()

    def _build_solver(self) -> SolverBase:
        # Some solvers keep the previous poses of the bodies.
        wp.copy(
            self.model.body_q,
            self.state.body_q,
        )
        self.model.body_color_groups = colours_of(self.model)
        return getattr(solvers, self.variant.solver)(self.model, **self._options())

    def _options(self) -> dict[str, object]:
        return {**OPTIONS.get(self.variant.solver, {}), **self.variant.options}

    def _build_recorder(self, frame_count: int) -> "SolverRecorder":
        self.observed = self._observe()
        return SolverRecorder(self, frame_count)

    def _observe(self) -> "SolverBase.Observables | None":
        """Request the forces of contacts if the solver and the release provide them."""
        if "contact_f" not in getattr(self.solver, "supported_observables", ()):
            return None
        return self.solver.observables(["contact_f"], contacts=self.contacts)


def weight_of_the_arm(stepper: Stepper) -> wp.array:
    """Return the forces that carry the weight of the moving links [N, N m], shape
    [bodies].
    """
    model, cube = stepper.model, stepper.scene.links["cube"].body
    names = [label.rsplit("/", 1)[-1] for label in model.body_label]
    carried = np.array([name not in FIXED_BODIES for name in names]).reshape(
        stepper.world_count, -1
    )
    carried[:, cube] = False
    gravity = np.array([case.gravity_m_s2 for case in stepper.cases])[:, None]
    forces = np.zeros((model.body_count, 6))
    forces[:, 2] = (carried * gravity).reshape(-1) * model.body_mass.numpy()
    return wp.array(forces, dtype=wp.spatial_vector, device=model.device)


def colours_of(model: Model) -> list[wp.array]:
    """Return two groups of bodies without joints within a group.

    VBD moves the bodies of a group at the same time.
    """
    depth = {-1: 0}
    for parent, child in zip(
        model.joint_parent.numpy(), model.joint_child.numpy(), strict=True
    ):
        depth[child] = depth[parent] + 1
    is_odd = np.array([depth[body] % 2 for body in range(model.body_count)], dtype=bool)
    return [
        wp.array(np.flatnonzero(group), dtype=int, device=model.device)
        for group in (is_odd, ~is_odd)
    ]


@wp.func
def place(body: int, point: wp.vec3, body_q: wp.array[wp.transform]):
    """Return the world position of a point, which may be fixed to a body."""
    pose = wp.transform_identity()
    if body >= 0:
        pose = body_q[body]
    return wp.transform_point(pose, point)


@wp.kernel
def record_contacts(
    cursor: wp.array[int],
    contact_count: wp.array[int],
    shape0: wp.array[int],
    shape1: wp.array[int],
    point0: wp.array[wp.vec3],
    point1: wp.array[wp.vec3],
    margin0: wp.array[float],
    margin1: wp.array[float],
    axis: wp.array[wp.vec3],
    force: wp.array[wp.spatial_vector],
    shape_world: wp.array[int],
    shape_body: wp.array[int],
    body_q: wp.array[wp.transform],
    friction: wp.array[float],
    contacts: wp.array3d[float],
):
    """Add each live contact to the statistics of the frame in its world.

    The friction of a patch is stored in one of its contacts.
    """
    contact = wp.tid()
    if contact >= wp.min(contact_count[0], axis.shape[0]):
        return
    first = shape0[contact]
    second = shape1[contact]
    normal = axis[contact]
    world = wp.max(shape_world[first], shape_world[second])
    frame = cursor[world]
    wp.atomic_add(contacts, frame, world, COUNT, 1.0)
    pressing = float(0.0)
    is_told = contact < force.shape[0]
    if is_told:
        total = wp.spatial_top(force[contact])
        pressing = -wp.dot(total, normal)
        tangential = wp.length(total + pressing * normal)
        wp.atomic_add(contacts, frame, world, TANGENTIAL, tangential)
        if pressing > 0.0:
            limit = 0.5 * (friction[first] + friction[second]) * pressing
            wp.atomic_add(contacts, frame, world, LOADED, 1.0)
            wp.atomic_add(contacts, frame, world, NORMAL, pressing)
            wp.atomic_max(contacts, frame, world, CONE, tangential / limit)
    if pressing > 0.0 or not is_told:
        a = place(shape_body[first], point0[contact], body_q)
        b = place(shape_body[second], point1[contact], body_q)
        distance = wp.dot(normal, b - a) - margin0[contact] - margin1[contact]
        wp.atomic_max(contacts, frame, world, PENETRATION, -distance)


class SolverRecorder(Recorder):
    """Record the same contact data as for MuJoCo, except for the sliding velocity."""

    def __init__(self, stepper: SolverStepper, frame_count: int):
        super().__init__(
            stepper.scene,
            stepper.solver,
            stepper.contacts,
            stepper.world_count,
            frame_count,
        )
        self.stepper = stepper
        self.no_rows = wp.zeros(
            stepper.world_count, dtype=int, device=stepper.model.device
        )

    def watch_substep(self) -> None:
        """Watch Newton's contact buffer, which may lose contacts when it is full."""
        found = self.contacts_in
        wp.launch(
            watch_substep,
            dim=self.cursor.shape,
            inputs=[
                self.cursor,
                found.rigid_contact_count,
                found.rigid_contact_max - 1,
                self.no_rows,
                0,
                self.no_rows,
            ],
            outputs=[
                self.peak_constraint,
                self.peak_iteration,
                self.contact_overflow,
                self.constraint_overflow,
            ],
        )

    def record_contacts(self) -> None:
        model: Model = self.stepper.model
        pairs, observed = self.contacts_in, self.stepper.observed
        forces = (
            observed.contact_f
            if observed
            else wp.empty(0, dtype=wp.spatial_vector, device=model.device)
        )
        wp.launch(
            record_contacts,
            dim=pairs.rigid_contact_max,
            inputs=[
                self.cursor,
                pairs.rigid_contact_count,
                pairs.rigid_contact_shape0,
                pairs.rigid_contact_shape1,
            ]
            + [pairs.rigid_contact_point0, pairs.rigid_contact_point1]
            + [
                pairs.rigid_contact_margin0,
                pairs.rigid_contact_margin1,
                pairs.rigid_contact_normal,
                forces,
            ]
            + [
                model.shape_world,
                model.shape_body,
                self.stepper.state.body_q,
                model.shape_material_mu,
            ],
            outputs=[self.contacts],
        )
