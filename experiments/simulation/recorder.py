"""Recording on the device: nothing comes back to the host before the end of the run."""

import numpy as np
import warp as wp
from mujoco_warp._src.types import vec5
from newton import Contacts
from newton.solvers import SolverMuJoCo

from experiments.facts.trace import FRAME_COLUMNS, ContactRows, Failure, Trace, first_failure
from experiments.simulation.c_warnings import failure_of
from experiments.simulation.scene import TRACKED_BODIES, Scene
from experiments.simulation.task import FRAME_RATE

NO_FRAME = np.iinfo(np.int32).max
FIELDS = "dist friction frame solref solreffriction solimp dim geom".split()
"""Arrays of the engines' contacts that are copied to the host."""
COUNT, LOADED, NORMAL, TANGENTIAL, CONE, PENETRATION, SLIDE = (wp.constant(i) for i in range(7))


@wp.kernel
def begin_frame(cursor: wp.array[int], contacts: wp.array3d[float]):
    world = wp.tid()
    frame = cursor[world]
    for column in range(contacts.shape[2]):
        contacts[frame, world, column] = 0.0


@wp.kernel
def watch_substep(
    cursor: wp.array[int],
    contact_count: wp.array[int],
    contact_capacity: int,
    constraint_count: wp.array[int],
    constraint_capacity: int,
    iteration_count: wp.array[int],
    peak_constraint: wp.array[int],
    peak_iteration: wp.array[int],
    contact_overflow: wp.array[int],
    constraint_overflow: wp.array[int],
):
    """Keep the peaks, and the first frame in which a buffer was too small. Contacts of all worlds share one buffer."""
    world = wp.tid()
    peak_constraint[world] = wp.max(peak_constraint[world], constraint_count[world])
    peak_iteration[world] = wp.max(peak_iteration[world], iteration_count[world])
    if contact_count[0] > contact_capacity:
        contact_overflow[world] = wp.min(contact_overflow[world], cursor[world])
    if constraint_count[world] > constraint_capacity:
        constraint_overflow[world] = wp.min(constraint_overflow[world], cursor[world])


@wp.func
def row_force(force: wp.array2d[float], world: int, address: int, dim: int, elliptic: bool, mu: float) -> wp.vec3:
    """Return the normal and two tangential forces of a contact from its constraint rows.

    With a pyramidal cone the rows are the pyramid's edges: their sum is the normal force and each tangential force is
    mu times the difference of two opposite edges (MuJoCo documentation, "Computation", friction cones).
    """
    result = wp.vec3(force[world, address], 0.0, 0.0)
    if dim >= 3:
        if elliptic:
            result = wp.vec3(force[world, address], force[world, address + 1], force[world, address + 2])
        else:
            a = force[world, address]
            b = force[world, address + 1]
            c = force[world, address + 2]
            d = force[world, address + 3]
            result = wp.vec3(a + b + c + d, mu * (a - b), mu * (c - d))
    return result


@wp.func
def row_slide(velocity: wp.array2d[float], world: int, address: int, elliptic: bool, mu: float) -> wp.vec2:
    """Return the velocities of the two friction rows; from a pyramid's edges as in ``row_force``."""
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
    """Add each live contact to the statistics of its world's frame."""
    contact = wp.tid()
    if contact >= contact_count[0]:
        return
    world = world_id[contact]
    frame = cursor[world]
    wp.atomic_add(contacts, frame, world, COUNT, 1.0)
    row = address[contact, 0]
    if row >= 0 and row < constraint_capacity - 3:
        forces = row_force(force, world, row, dim[contact], elliptic, friction[contact][0])
        normal = forces[0]
        if normal > 0.0:
            tangential = wp.length(wp.vec2(forces[1], forces[2]))
            wp.atomic_add(contacts, frame, world, LOADED, 1.0)
            wp.atomic_add(contacts, frame, world, NORMAL, normal)
            wp.atomic_add(contacts, frame, world, TANGENTIAL, tangential)
            wp.atomic_max(contacts, frame, world, CONE, tangential / (friction[contact][0] * normal))
            wp.atomic_max(contacts, frame, world, PENETRATION, -distance[contact])
            if dim[contact] >= 3:
                slide = row_slide(velocity, world, row, elliptic, friction[contact][0])
                along = axes[contact][1, 0] * slide[0] + axes[contact][2, 0] * slide[1]
                # The rows hold the velocity of the second geom against the first.
                wp.atomic_add(contacts, frame, world, SLIDE, wp.where(geom[contact][1] == cube, along, -along))


@wp.kernel
def end_frame(
    body_q: wp.array2d[wp.transform],
    tracked: wp.array[int],
    offset: wp.array[wp.transform],
    phase: wp.array[int],
    cursor: wp.array[int],
    poses: wp.array3d[wp.transform],
    phases: wp.array2d[int],
    contacts: wp.array3d[float],
):
    world = wp.tid()
    frame = cursor[world]
    for body in range(tracked.shape[0]):
        poses[frame, world, body] = body_q[world, tracked[body]] * offset[body]
    phases[frame, world] = phase[world]
    contacts[frame, world, SLIDE] /= wp.max(contacts[frame, world, LOADED], 1.0)
    # A viewer may run on beyond the last frame; then the last one is written again.
    cursor[world] = wp.min(frame + 1, phases.shape[0] - 1)


class Recorder:
    """Device buffers for a batch of ``world_count`` worlds and ``frame_count`` frames.

    Args:
        contacts: Newton's contact buffer, or None when MuJoCo generates the contacts.
    """

    def __init__(
        self, scene: Scene, solver: SolverMuJoCo, contacts: Contacts | None, world_count: int, frame_count: int
    ):
        device = scene.model.device
        self.solver = solver
        self.contacts_in = contacts
        self.names = _geom_names(scene, solver)
        self.cube_geom = self.names.index("cube")
        links = [scene.links[name] for name in TRACKED_BODIES]
        self.tracked = wp.array([link.body for link in links], dtype=int, device=device)
        self.offset = wp.array([link.pose for link in links], dtype=wp.transform, device=device)
        self.cursor = wp.zeros(world_count, dtype=int, device=device)
        self.poses = wp.zeros((frame_count, world_count, len(links)), dtype=wp.transform, device=device)
        self.phases = wp.zeros((frame_count, world_count), dtype=int, device=device)
        self.contacts = wp.zeros((frame_count, world_count, len(FRAME_COLUMNS)), dtype=float, device=device)
        self.peak_constraint = wp.zeros(world_count, dtype=int, device=device)
        self.peak_iteration = wp.zeros(world_count, dtype=int, device=device)
        self.contact_overflow = wp.full(world_count, NO_FRAME, dtype=int, device=device)
        self.constraint_overflow = wp.full(world_count, NO_FRAME, dtype=int, device=device)
        self.contact_rows: list[list[ContactRows]] = []
        self.failure_in_c: Failure | None = None

    def begin_frame(self) -> None:
        wp.launch(begin_frame, dim=self.cursor.shape, inputs=[self.cursor], outputs=[self.contacts])

    def watch_substep(self) -> None:
        if self.solver.use_mujoco_cpu:
            self._watch_c_substep()
            return
        data = self.solver.mjw_data
        wp.launch(
            watch_substep,
            dim=self.cursor.shape,
            inputs=[self.cursor, *self._contact_count(), data.nefc, data.njmax, data.solver_niter],
            outputs=[self.peak_constraint, self.peak_iteration, self.contact_overflow, self.constraint_overflow],
        )

    def end_frame(self, body_q: wp.array, phase: wp.array) -> None:
        if self.solver.use_mujoco_cpu:
            self._record_c_contacts()
        else:
            data = self.solver.mjw_data
            wp.launch(
                record_contacts,
                dim=data.naconmax,
                inputs=[self.cursor, data.nacon, data.contact.dist, data.contact.worldid, data.contact.dim]
                + [data.contact.friction, data.contact.frame, data.contact.geom, self.cube_geom]
                + [data.contact.efc_address, data.efc.force, data.efc.vel, data.njmax, is_elliptic(self.solver)],
                outputs=[self.contacts],
            )
        wp.launch(
            end_frame,
            dim=self.cursor.shape,
            inputs=[body_q, self.tracked, self.offset, phase],
            outputs=[self.cursor, self.poses, self.phases, self.contacts],
        )

    def keep_contact_rows(self, frame: int) -> None:
        """Copy every live contact of every world to the host; between frames only."""
        self.contact_rows.append(contact_rows(self.solver, len(self.cursor), frame, self.names))

    def traces(self, wall_s: float = 0.0, frame_count: int | None = None) -> list[Trace]:
        """Fetch the first ``frame_count`` frames, all for None, and cut them into one trace per world."""
        poses, phases, contacts = (array.numpy()[:frame_count] for array in (self.poses, self.phases, self.contacts))
        overflows = {"contact": self.contact_overflow.numpy(), "constraint": self.constraint_overflow.numpy()}
        peak_constraint, peak_iteration = self.peak_constraint.numpy(), self.peak_iteration.numpy()
        result = []
        for world in range(poses.shape[1]):
            seen = [
                Failure("overflow", int(frames[world]), f"the {name} buffer overflowed")
                for name, frames in overflows.items()
                if frames[world] != NO_FRAME
            ]
            first = min([*seen, *filter(None, [self.failure_in_c])], key=lambda failure: failure.frame, default=None)
            result.append(
                Trace(
                    frame_dt=1.0 / FRAME_RATE,
                    phase=phases[:, world],
                    poses=poses[:, world],
                    contacts=contacts[:, world],
                    failure=first_failure(poses[:, world], first),
                    peak_contact_count=int(contacts[:, world, 0].max()),
                    peak_constraint_count=int(peak_constraint[world]),
                    peak_iteration_count=int(peak_iteration[world]),
                    contact_rows=tuple(rows[world] for rows in self.contact_rows),
                    world_count=poses.shape[1],
                    wall_s=wall_s,
                )
            )
        return result

    def _contact_count(self) -> tuple[wp.array, int]:
        """Say where the generator of the contacts counts them, and the most that is sure to be all of them.

        Newton's conversion cuts the count to what fits, so what was lost shows only in Newton's own buffer. That one
        may have lost some as soon as it is full: the narrow phase then stops, and counts no further.
        """
        data = self.solver.mjw_data
        if self.contacts_in is None:
            return data.nacon, data.naconmax
        return self.contacts_in.rigid_contact_count, min(self.contacts_in.rigid_contact_max - 1, data.naconmax)

    def _watch_c_substep(self) -> None:
        data = self.solver.mj_data
        for peak, value in ((self.peak_constraint, data.nefc), (self.peak_iteration, data.solver_niter.max())):
            peak.numpy()[0] = max(peak.numpy()[0], value)
        self.failure_in_c = self.failure_in_c or failure_of(data, int(self.cursor.numpy()[0]))

    def _record_c_contacts(self) -> None:
        frame = int(self.cursor.numpy()[0])
        [rows] = contact_rows(self.solver, 1, frame, self.names)
        self.contacts.numpy()[frame, 0] = summarize_contacts(rows)


def summarize_contacts(rows: ContactRows) -> np.ndarray:
    """Return what ``record_contacts`` adds up on the device, for one set of contacts; shape [len(FRAME_COLUMNS)]."""
    normal = rows.force_n[:, 0]
    loaded = normal > 0.0
    tangential = np.linalg.norm(rows.force_n[loaded, 1:], axis=1)
    return np.array(
        [
            len(normal),
            loaded.sum(),
            normal[loaded].sum(),
            tangential.sum(),
            (tangential / (rows.friction[loaded] * normal[loaded])).max(initial=0.0),
            (-rows.distance_m[loaded]).max(initial=0.0),
            rows.slide_m_s[loaded].sum(),  # end_frame turns the sum into the mean
        ]
    )


def contact_rows(solver: SolverMuJoCo, world_count: int, frame: int, names: list[str]) -> list[ContactRows]:
    """Copy the live contacts of either engine to the host, by world."""
    if solver.use_mujoco_cpu:
        data, count = solver.mj_data, solver.mj_data.ncon
        host = {name: np.array(getattr(data.contact, name)) for name in FIELDS}
        address, world_id = np.asarray(data.contact.efc_address).reshape(count), np.zeros(count, dtype=int)
        efc = [np.array(rows)[None] for rows in (data.efc_force, data.efc_pos, data.efc_vel, data.efc_aref)]
    else:
        data = solver.mjw_data
        count = min(int(data.nacon.numpy()[0]), data.naconmax)
        host = {name: np.array(getattr(data.contact, name).numpy()[:count]) for name in FIELDS}
        address, world_id = data.contact.efc_address.numpy()[:count, 0], data.contact.worldid.numpy()[:count]
        efc = [rows.numpy() for rows in (data.efc.force, data.efc.pos, data.efc.vel, data.efc.aref)]
    found = []
    for world in range(world_count):
        mine = world_id == world
        fields, rows = {name: values[mine] for name, values in host.items()}, [each[world] for each in efc]
        found.append(_rows_of_world(fields, address[mine], rows, frame, names, is_elliptic(solver)))
    return found


def _rows_of_world(field, address, efc, frame: int, names: list[str], elliptic: bool) -> ContactRows:
    """Take apart the constraint rows of one world's contacts."""
    all_force, all_residual, all_velocity, all_reference = efc
    axes, friction = field["frame"].reshape(-1, 3, 3), field["friction"][:, 0]
    force, residual, velocity, reference = np.zeros((len(address), 3)), *np.full((3, len(address), 3), np.nan)
    for i, row in enumerate(address):
        if row < 0:
            continue
        residual[i], velocity[i] = all_residual[row : row + 3], all_velocity[row : row + 3]
        if elliptic:
            force[i], reference[i] = all_force[row : row + 3], all_reference[row : row + 3]
        else:
            a, b, c, d = all_force[row : row + 4]
            force[i] = a + b + c + d, friction[i] * (a - b), friction[i] * (c - d)
            a, b, c, d = all_velocity[row : row + 4]
            velocity[i, 1:] = (a - b) / (2.0 * friction[i]), (c - d) / (2.0 * friction[i])
    sign = np.where([names[second] == "cube" for _, second in field["geom"]], 1.0, -1.0)
    return ContactRows(
        frame=frame,
        geom=np.array([[names[g] for g in pair] for pair in field["geom"]]).reshape(-1, 2),
        distance_m=field["dist"],
        friction=friction,
        **{name: field[name] for name in ("solref", "solreffriction", "solimp", "dim")},
        force_n=force,
        residual_m=residual,
        velocity_m_s=velocity,
        reference_m_s2=reference,
        slide_m_s=sign * (axes[:, 1:, 0] * velocity[:, 1:]).sum(axis=1),
    )


def is_elliptic(solver: SolverMuJoCo) -> bool:
    return int(solver.mj_model.opt.cone) == 1


def _geom_names(scene: Scene, solver: SolverMuJoCo) -> list[str]:
    shapes = solver.mjc_geom_to_newton_shape.numpy()[0]
    shape_body, labels = scene.model.shape_body.numpy(), scene.model.body_label
    names, seen = [], {}
    for shape in shapes:
        body = shape_body[shape] if shape >= 0 else -1
        name = labels[body].rsplit("/", 1)[-1] if body >= 0 else "ground"
        seen[name] = seen.get(name, 0) + 1
        names.append(f"{name} {seen[name]}" if "finger" in name else name)
    return names
