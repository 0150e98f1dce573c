"""Step the worlds of a batch in MuJoCo Warp through Newton; record their contacts."""

import newton
import warp as wp
from mujoco_warp._src.types import vec5
from newton import CollisionPipeline, Contacts
from newton.solvers import SolverMuJoCo

from experiments.simulation.recorder import (
    CONE,
    COUNT,
    LOADED,
    NORMAL,
    PENETRATION,
    SLIDE,
    TANGENTIAL,
    Recorder,
    watch_substep,
)
from experiments.simulation.scene import Scene
from experiments.simulation.stepper import CONTACT_MAX, Stepper


@wp.func
def row_force(
    force: wp.array2d[float],
    world: int,
    address: int,
    dim: int,
    elliptic: bool,
    mu: float,
) -> wp.vec3:
    """Return the normal and two tangential forces of a contact from its rows.

    The rows of a pyramidal cone are the edges of the pyramid. Their sum is the normal
    force, and each tangential force is mu times the difference of two opposite edges
    (MuJoCo documentation, "Computation", friction cones).
    """
    result = wp.vec3(force[world, address], 0.0, 0.0)
    if dim >= 3:
        if elliptic:
            result = wp.vec3(
                force[world, address],
                force[world, address + 1],
                force[world, address + 2],
            )
        else:
            a = force[world, address]
            b = force[world, address + 1]
            c = force[world, address + 2]
            d = force[world, address + 3]
            result = wp.vec3(a + b + c + d, mu * (a - b), mu * (c - d))
    return result


@wp.func
def row_slide(
    velocity: wp.array2d[float], world: int, address: int, elliptic: bool, mu: float
) -> wp.vec2:
    """Return the velocities of the two friction rows.

    For a pyramidal cone they are computed from the edges as in ``row_force``.
    """
    result = wp.vec2(velocity[world, address + 1], velocity[world, address + 2])
    if not elliptic:
        first = velocity[world, address] - velocity[world, address + 1]
        second = velocity[world, address + 2] - velocity[world, address + 3]
        result = wp.vec2(first, second) / (2.0 * mu)
    return result


@wp.kernel
def record_contacts(
    cursor: wp.array[int],
    contact_count: wp.array[int],
    distance: wp.array[float],
    world_id: wp.array[int],
    dim: wp.array[int],
    friction: wp.array[vec5],
    axes: wp.array[wp.mat33],
    geom: wp.array[wp.vec2i],
    cube: int,
    address: wp.array2d[int],
    force: wp.array2d[float],
    velocity: wp.array2d[float],
    constraint_capacity: int,
    elliptic: bool,
    contacts: wp.array3d[float],
):
    """Add each live contact to the statistics of the frame in its world."""
    contact = wp.tid()
    if contact >= contact_count[0]:
        return
    world = world_id[contact]
    frame = cursor[world]
    wp.atomic_add(contacts, frame, world, COUNT, 1.0)
    row = address[contact, 0]
    if row >= 0 and row < constraint_capacity - 3:
        forces = row_force(
            force, world, row, dim[contact], elliptic, friction[contact][0]
        )
        normal = forces[0]
        if normal > 0.0:
            tangential = wp.length(wp.vec2(forces[1], forces[2]))
            wp.atomic_add(contacts, frame, world, LOADED, 1.0)
            wp.atomic_add(contacts, frame, world, NORMAL, normal)
            wp.atomic_add(contacts, frame, world, TANGENTIAL, tangential)
            wp.atomic_max(
                contacts,
                frame,
                world,
                CONE,
                tangential / (friction[contact][0] * normal),
            )
            wp.atomic_max(contacts, frame, world, PENETRATION, -distance[contact])
            if dim[contact] >= 3:
                slide = row_slide(velocity, world, row, elliptic, friction[contact][0])
                along = axes[contact][1, 0] * slide[0] + axes[contact][2, 0] * slide[1]
                # The rows contain the velocity of the second geom relative to the
                # first.
                wp.atomic_add(
                    contacts,
                    frame,
                    world,
                    SLIDE,
                    wp.where(geom[contact][1] == cube, along, -along),
                )


class WarpStepper(Stepper):
    """Step all worlds in MuJoCo Warp with Newton's solver."""

    def step(self, substep: int, control: newton.Control, step_s: float) -> None:
        case = self.case
        if (
            self.pipeline is not None
            and substep % (case.substeps // case.collide_count) == 0
        ):
            self.pipeline.collide(self.state, self.contacts)
        # Without a control, the engine keeps its targets.
        control = control if substep == 0 or case.state_sync else None
        self.solver.step(self.state, self.state, control, self.contacts, step_s)

    def _build_collision(self) -> tuple[CollisionPipeline | None, Contacts | None]:
        pipeline = newton.CollisionPipeline(
            self.model,
            broad_phase=self.case.broad_phase,
            reduce_contacts=True,
            rigid_contact_max=self.world_count * (self.case.contact_max or CONTACT_MAX),
        )
        return pipeline, pipeline.contacts()


class WarpRecorder(Recorder):
    """Record the contact forces of MuJoCo Warp and the use of its buffers."""

    def __init__(self, stepper: Stepper, frame_count: int):
        super().__init__(
            stepper.scene,
            stepper.solver,
            stepper.contacts,
            stepper.world_count,
            frame_count,
        )
        self.names = _geom_names(stepper.scene, stepper.solver)
        self.cube_geom = self.names.index("cube")

    def watch_substep(self) -> None:
        data = self.solver.mjw_data
        wp.launch(
            watch_substep,
            dim=self.cursor.shape,
            inputs=[
                self.cursor,
                *self._contact_count(),
                data.nefc,
                data.njmax,
                data.solver_niter,
            ],
            outputs=[
                self.peak_constraint,
                self.peak_iteration,
                self.contact_overflow,
                self.constraint_overflow,
            ],
        )

    def record_contacts(self) -> None:
        data = self.solver.mjw_data
        wp.launch(
            record_contacts,
            dim=data.naconmax,
            inputs=[
                self.cursor,
                data.nacon,
                data.contact.dist,
                data.contact.worldid,
                data.contact.dim,
            ]
            + [
                data.contact.friction,
                data.contact.frame,
                data.contact.geom,
                self.cube_geom,
            ]
            + [
                data.contact.efc_address,
                data.efc.force,
                data.efc.vel,
                data.njmax,
                is_elliptic(self.solver),
            ],
            outputs=[self.contacts],
        )

    def _contact_count(self) -> tuple[wp.array, int]:
        """Return the counter of contacts and the largest count without a loss.

        Newton's conversion reduces the count to the size of the buffer, so a loss shows
        only in Newton's own buffer. That buffer may have lost contacts as soon as it is
        full, because the narrow phase then stops counting.
        """
        data = self.solver.mjw_data
        if self.contacts_in is None:
            return data.nacon, data.naconmax
        return self.contacts_in.rigid_contact_count, min(
            self.contacts_in.rigid_contact_max - 1, data.naconmax
        )


def is_elliptic(solver: SolverMuJoCo) -> bool:
    return int(solver.mj_model.opt.cone) == 1


def _geom_names(scene: Scene, solver: SolverMuJoCo) -> list[str]:
    shapes = solver.mjc_geom_to_newton_shape.numpy()[0]
    shape_body, labels = scene.model.shape_body.numpy(), scene.model.body_label
    names, counts = [], {}  # type: list[str], dict[str, int]
    for shape in shapes:
        body = shape_body[shape] if shape >= 0 else -1
        name = labels[body].rsplit("/", 1)[-1] if body >= 0 else "ground"
        counts[name] = counts.get(name, 0) + 1
        names.append(f"{name} {counts[name]}" if "finger" in name else name)
    return names
