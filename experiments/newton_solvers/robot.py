"""The shake in any of Newton's solvers: scene, task and recording are those of ``simulation``.

Only MuJoCo's solver knows gravity compensation, so forces on the arm's links carry its weight. The others read no geom
priority either, and links without mass are more than some of them can do.
"""

from collections.abc import Sequence

import newton
import numpy as np
import warp as wp
from newton import Contacts, Model, solvers
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
    end_frame,
    watch_substep,
)
from experiments.simulation.scene import FIXED_BODIES
from experiments.simulation.simulation import CONTACT_MAX, Simulation


class SolverSimulation(Simulation):
    """A simulation with one of Newton's solvers: of its cases it reads what is not MuJoCo's alone."""

    def __init__(self, variant: Variant, cases: Sequence[Case], device: wp.Device):
        self.variant = variant
        super().__init__(cases, device)

    def _build_collision(self) -> tuple[newton.CollisionPipeline, Contacts]:
        most = self.world_count * (self.case.contact_max or CONTACT_MAX)
        pipeline = newton.CollisionPipeline(
            self.model, broad_phase=self.case.broad_phase, rigid_contact_max=most, **self.variant.pipeline
        )
        return pipeline, pipeline.contacts()

    def _build_state(self) -> None:
        super()._build_state()
        self.observed = self._observe()
        self.recorder = self._build_recorder()
        other = self.model.state()
        wp.copy(other.body_q, self.state.body_q)
        self.state.body_f = other.body_f = weight_of_the_arm(self)
        self.states = self.state, other

    def _build_recorder(self) -> "SolverRecorder":
        return SolverRecorder(self)

    def _build_solver(self) -> SolverBase:
        wp.copy(self.model.body_q, self.state.body_q)  # where bodies come from, for a solver that keeps it
        self.model.body_color_groups = colours_of(self.model)
        solver = getattr(solvers, self.variant.solver)(self.model, **self._options())
        # What a simulation and its recorder ask of MuJoCo's solver: geoms are the shapes of a world.
        solver.use_mujoco_cpu = False
        shapes = np.arange(self.model.shape_count // self.world_count)[None]
        solver.mjc_geom_to_newton_shape = wp.array(shapes, dtype=int, device="cpu")
        return solver

    def _options(self) -> dict[str, object]:
        return {**OPTIONS.get(self.variant.solver, {}), **self.variant.options}

    def _observe(self) -> "SolverBase.Observables | None":
        """Ask for the forces of contacts, where solver and release tell them."""
        if "contact_f" not in getattr(self.solver, "supported_observables", ()):
            return None
        return self.solver.observables(["contact_f"], contacts=self.contacts)

    def queue_physics(self) -> None:
        """Queue collisions, substeps and recording of one frame; an even number of substeps ends where it began."""
        last, between = self.case.substeps - 1, self.variant.steps_between_contacts or self.case.substeps
        self.recorder.begin_frame()
        for substep in range(self.case.substeps):
            here, there = self.states[:: 1 - 2 * (substep % 2)]
            if substep % between == 0:
                self.pipeline.collide(here, self.contacts)
            told = {"observables": self.observed} if self.observed and substep == last else {}
            self.solver.step(here, there, self.control, self.contacts, self.substep_dt, **told)
            self.recorder.watch_substep()
        self.recorder.end_frame(self.body_q, self.task.phase)


def weight_of_the_arm(simulation: Simulation) -> wp.array:
    """Return forces that carry the weight of each moving link of the arms [N, N m], shape [bodies]."""
    model, cube = simulation.model, simulation.scene.links["cube"].body
    names = [label.rsplit("/", 1)[-1] for label in model.body_label]
    carried = np.array([name not in FIXED_BODIES for name in names]).reshape(simulation.world_count, -1)
    carried[:, cube] = False
    gravity = np.array([case.gravity_m_s2 for case in simulation.cases])[:, None]
    forces = np.zeros((model.body_count, 6))
    forces[:, 2] = (carried * gravity).reshape(-1) * model.body_mass.numpy()
    return wp.array(forces, dtype=wp.spatial_vector, device=model.device)


def colours_of(model: Model) -> list[wp.array]:
    """Return two groups of bodies, in neither of which two are joined; VBD moves those of a group at once."""
    depth = {-1: 0}
    for parent, child in zip(model.joint_parent.numpy(), model.joint_child.numpy(), strict=True):
        depth[child] = depth[parent] + 1
    is_odd = np.array([depth[body] % 2 for body in range(model.body_count)], dtype=bool)
    return [wp.array(np.flatnonzero(group), dtype=int, device=model.device) for group in (is_odd, ~is_odd)]


@wp.func
def place(body: int, point: wp.vec3, body_q: wp.array[wp.transform]):
    """Return where a point of a body, or of the world, is in the world."""
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
    """Add each live contact to the statistics of its world's frame; friction of a patch is on one of its contacts."""
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
    """Records of contacts what is recorded of MuJoCo's, but for how fast they slide."""

    def __init__(self, simulation: SolverSimulation):
        of = simulation
        super().__init__(of.scene, of.solver, of.contacts, of.world_count, of.case.frame_count)
        self.simulation = simulation
        self.no_rows = wp.zeros(of.world_count, dtype=int, device=of.device)

    def watch_substep(self) -> None:
        """Watch Newton's buffer of contacts, which may have lost some as soon as it is full."""
        found = self.simulation.contacts
        wp.launch(
            watch_substep,
            dim=self.cursor.shape,
            inputs=[self.cursor, found.rigid_contact_count, found.rigid_contact_max - 1, self.no_rows, 0, self.no_rows],
            outputs=[self.peak_constraint, self.peak_iteration, self.contact_overflow, self.constraint_overflow],
        )

    def end_frame(self, body_q: wp.array, phase: wp.array) -> None:
        model: Model = self.simulation.model
        found, observed = self.simulation.contacts, self.simulation.observed
        forces = observed.contact_f if observed else wp.empty(0, dtype=wp.spatial_vector, device=model.device)
        wp.launch(
            record_contacts,
            dim=found.rigid_contact_max,
            inputs=[self.cursor, found.rigid_contact_count, found.rigid_contact_shape0, found.rigid_contact_shape1]
            + [found.rigid_contact_point0, found.rigid_contact_point1]
            + [found.rigid_contact_margin0, found.rigid_contact_margin1, found.rigid_contact_normal, forces]
            + [model.shape_world, model.shape_body, self.simulation.state.body_q, model.shape_material_mu],
            outputs=[self.contacts],
        )
        wp.launch(
            end_frame,
            dim=self.cursor.shape,
            inputs=[body_q, self.tracked, self.offset, phase],
            outputs=[self.cursor, self.poses, self.phases, self.contacts],
        )
