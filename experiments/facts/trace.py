"""Define the trace of a run as arrays on the host."""

from dataclasses import dataclass, field

import numpy as np

FRAME_COLUMNS = (
    "contact_count",
    "loaded_count",
    "normal_force_n",
    "tangential_force_n",
    "cone_use",
    "penetration_m",
    "slide_m_s",
)
"""Contact statistics of the last substep of a frame.

These are the number of contacts and of loaded contacts, the sums of normal and
tangential forces, the largest ratio of tangential force to friction times normal force
(1 means sliding), the largest penetration, and the mean velocity of the loaded
contacts' friction rows along the shake's main axis.
"""


@dataclass(frozen=True)
class ContactRows:
    """The solver's live contacts of one world at the end of one frame."""

    frame: int
    geom: np.ndarray  # names of the two geoms, shape [n, 2]
    distance_m: np.ndarray  # negative if the geoms overlap, shape [n]
    friction: np.ndarray  # sliding friction, shape [n]
    solref: np.ndarray  # timeconst [s] and dampratio, shape [n, 2]
    solreffriction: np.ndarray
    """timeconst [s] and dampratio of the friction rows, shape [n, 2]; 0, 0 if they use
    ``solref``.
    """
    solimp: np.ndarray  # shape [n, 5]
    dim: np.ndarray  # contact dimension, shape [n]
    # Normal and two tangential forces, shape [n, 3]; 0 if the solver does not use the
    # contact.
    force_n: np.ndarray
    residual_m: np.ndarray
    """Position residual of the normal row and both friction rows, shape [n, 3].

    It is NaN if there is no row.
    """
    # Velocity of the normal and both friction rows, shape [n, 3]. It is NaN without a
    # row.
    velocity_m_s: np.ndarray
    reference_m_s2: np.ndarray
    """Acceleration to which the rows are set, shape [n, 3].

    It is NaN if there is no row and for a pyramidal cone.
    """
    slide_m_s: np.ndarray
    """Velocity of the cube relative to the other geom along the main axis of the shake,
    shape [n]. It is computed from the friction rows.
    """


@dataclass(frozen=True)
class Failure:
    """Describe why the numbers of a world cannot be used after some frame."""

    kind: str  # ``non-finite`` or ``overflow``
    frame: int
    detail: str

    def __str__(self) -> str:
        return f"{self.detail} in frame {self.frame}"


@dataclass(frozen=True)
class Trace:
    """The frames of one world.

    Poses consist of position [m] and quaternion (x, y, z, w) in the world.
    """

    frame_dt: float  # duration of a frame [s]
    phase: np.ndarray  # task phase of each frame, shape [frames]
    # Poses of ``scene.TRACKED_BODIES`` at the end of each frame, shape [frames, bodies,
    # 7].
    poses: np.ndarray
    # FRAME_COLUMNS of each frame, shape [frames, len(FRAME_COLUMNS)].
    contacts: np.ndarray
    failure: Failure | None = None  # the first failure, if there is one
    peak_contact_count: int = 0  # largest number of contacts in any frame
    peak_constraint_count: int = 0  # largest number of constraint rows in any substep
    peak_iteration_count: int = 0  # largest number of solver iterations in any substep
    # The requested frames with all their contacts.
    contact_rows: tuple[ContactRows, ...] = field(default=())
    world_count: int = 1  # number of worlds that were simulated together
    # Wall time of all frames in the batch, without building, compiling and capturing.
    wall_s: float = 0.0

    def column(self, name: str) -> np.ndarray:
        """Return one of FRAME_COLUMNS over time, shape [frames]."""
        return self.contacts[:, FRAME_COLUMNS.index(name)]


def first_failure(poses: np.ndarray, seen: Failure | None) -> Failure | None:
    """Return the earlier of a recorded failure and the first non-finite pose.

    Args:
        poses: Shape [frames, bodies, 7].
        seen: A failure that the recorder found, or None.
    """
    bad = ~np.isfinite(poses).all(axis=(1, 2))
    if not bad.any():
        return seen
    non_finite = Failure("non-finite", int(bad.argmax()), "a body's pose is not finite")
    if seen is not None and seen.frame <= non_finite.frame:
        return seen
    return non_finite
