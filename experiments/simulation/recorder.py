"""Record runs on the device, and copy the data to the host after the run."""

import numpy as np
import warp as wp
from newton import Contacts
from newton.solvers import SolverMuJoCo

from experiments.facts.trace import (
    FRAME_COLUMNS,
    ContactRows,
    Failure,
    Trace,
    first_failure,
)
from experiments.simulation.scene import TRACKED_BODIES, Scene
from experiments.simulation.task import FRAME_RATE

NO_FRAME = np.iinfo(np.int32).max
COUNT, LOADED, NORMAL, TANGENTIAL, CONE, PENETRATION, SLIDE = (
    wp.constant(i) for i in range(7)
)


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
    """Record the peaks of the buffers, and the first frame in which a buffer was too
    small. The contacts of all worlds share one buffer.
    """
    world = wp.tid()
    peak_constraint[world] = wp.max(peak_constraint[world], constraint_count[world])
    peak_iteration[world] = wp.max(peak_iteration[world], iteration_count[world])
    if contact_count[0] > contact_capacity:
        contact_overflow[world] = wp.min(contact_overflow[world], cursor[world])
    if constraint_count[world] > constraint_capacity:
        constraint_overflow[world] = wp.min(constraint_overflow[world], cursor[world])


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
    # A viewer may run beyond the last frame, which is then overwritten.
    cursor[world] = wp.min(frame + 1, phases.shape[0] - 1)


class Recorder:
    """Device buffers for ``world_count`` worlds and ``frame_count`` frames.

    A subclass beside each stepper records the contacts of its solver.

    Args:
        contacts: Newton's contact buffer, or None if MuJoCo generates the contacts.
    """

    cube_geom: int

    def __init__(
        self,
        scene: Scene,
        solver: SolverMuJoCo,
        contacts: Contacts | None,
        world_count: int,
        frame_count: int,
    ):
        device = scene.model.device
        self.solver = solver
        self.contacts_in = contacts
        links = [scene.links[name] for name in TRACKED_BODIES]
        self.tracked = wp.array([link.body for link in links], dtype=int, device=device)
        self.offset = wp.array(
            [link.pose for link in links], dtype=wp.transform, device=device
        )
        self.cursor = wp.zeros(world_count, dtype=int, device=device)
        self.poses = wp.zeros(
            (frame_count, world_count, len(links)), dtype=wp.transform, device=device
        )
        self.phases = wp.zeros((frame_count, world_count), dtype=int, device=device)
        self.contacts = wp.zeros(
            (frame_count, world_count, len(FRAME_COLUMNS)), dtype=float, device=device
        )
        self.peak_constraint = wp.zeros(world_count, dtype=int, device=device)
        self.peak_iteration = wp.zeros(world_count, dtype=int, device=device)
        self.contact_overflow = wp.full(world_count, NO_FRAME, dtype=int, device=device)
        self.constraint_overflow = wp.full(
            world_count, NO_FRAME, dtype=int, device=device
        )
        self.contact_rows: list[list[ContactRows]] = []
        self.failure_in_c: Failure | None = None

    def watch_substep(self) -> None:
        """Record the use of the buffers."""

    def record_contacts(self) -> None:
        """Add the contact forces to the statistics of the frame."""

    def keep_contact_rows(self, frame: int) -> None:
        """Copy every live contact of every world to the host. This is possible only
        between frames.
        """

    def begin_frame(self) -> None:
        wp.launch(
            begin_frame,
            dim=self.cursor.shape,
            inputs=[self.cursor],
            outputs=[self.contacts],
        )

    def end_frame(self, body_q: wp.array, phase: wp.array) -> None:
        self.record_contacts()
        wp.launch(
            end_frame,
            dim=self.cursor.shape,
            inputs=[body_q, self.tracked, self.offset, phase],
            outputs=[self.cursor, self.poses, self.phases, self.contacts],
        )

    def traces(
        self, wall_s: float = 0.0, frame_count: int | None = None
    ) -> list[Trace]:
        """Return one trace for each world, with the first ``frame_count`` frames.

        None returns all frames.
        """
        poses, phases, contacts = (
            array.numpy()[:frame_count]
            for array in (self.poses, self.phases, self.contacts)
        )
        overflows = {
            "contact": self.contact_overflow.numpy(),
            "constraint": self.constraint_overflow.numpy(),
        }
        peak_constraint, peak_iteration = (
            self.peak_constraint.numpy(),
            self.peak_iteration.numpy(),
        )
        result = []
        for world in range(poses.shape[1]):
            seen = [
                Failure("overflow", int(frames[world]), f"the {name} buffer overflowed")
                for name, frames in overflows.items()
                if frames[world] != NO_FRAME
            ]
            first = min(
                [*seen, *filter(None, [self.failure_in_c])],
                key=lambda failure: failure.frame,
                default=None,
            )
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
