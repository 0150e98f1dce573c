"""What a run leaves behind, as plain arrays on the host."""

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
"""Contact statistics of a frame, taken in its last substep: how many contacts there are and how many carry force, sums
of normal and of tangential force, largest tangential force over friction times normal force (1 = sliding), largest
penetration, and the mean velocity of the loaded contacts' friction rows along the shake's main axis."""


@dataclass(frozen=True)
class ContactRows:
    """The solver's live contacts of one world at the end of one frame."""

    frame: int
    geom: np.ndarray  # names of the two geoms, shape [n, 2]
    distance_m: np.ndarray  # negative where the geoms overlap, shape [n]
    friction: np.ndarray  # sliding friction, shape [n]
    solref: np.ndarray  # timeconst [s] and dampratio, shape [n, 2]
    solreffriction: np.ndarray
    """timeconst [s] and dampratio of the friction rows, shape [n, 2]; 0, 0 where they take ``solref``."""
    solimp: np.ndarray  # shape [n, 5]
    dim: np.ndarray  # contact dimension, shape [n]
    force_n: np.ndarray  # normal and two tangential forces, shape [n, 3]; 0 where the contact is not in the solver
    residual_m: np.ndarray
    """Position residual of the normal and both friction rows, shape [n, 3]; NaN where there is no row."""
    velocity_m_s: np.ndarray  # velocity of the normal and both friction rows, shape [n, 3]; NaN where there is no row
    reference_m_s2: np.ndarray
    """Acceleration that the rows aim at, shape [n, 3]; NaN where there is no row, and with a pyramidal cone."""
    slide_m_s: np.ndarray
    """Velocity of the cube against the other geom along the shake's main axis, from the friction rows, shape [n]."""


@dataclass(frozen=True)
class Failure:
    """Why a world's numbers can't be used from some frame on."""

    kind: str  # ``non-finite`` or ``overflow``
    frame: int
    detail: str

    def __str__(self) -> str:
        return f"{self.detail} in frame {self.frame}"


@dataclass(frozen=True)
class Trace:
    """One world, frame by frame. Poses are position [m] and quaternion (x, y, z, w) in the world."""

    frame_dt: float  # duration of a frame [s]
    phase: np.ndarray  # task phase of each frame, shape [frames]
    poses: np.ndarray  # poses of ``scene.TRACKED_BODIES`` at the end of each frame, shape [frames, bodies, 7]
    contacts: (
        np.ndarray
    )  # FRAME_COLUMNS of each frame, shape [frames, len(FRAME_COLUMNS)]
    failure: Failure | None = None  # the first thing that went wrong, if anything did
    peak_contact_count: int = 0  # most contacts of this world in any frame
    peak_constraint_count: int = 0  # most constraint rows of this world in any substep
    peak_iteration_count: int = 0  # most solver iterations of this world in any substep
    contact_rows: tuple[ContactRows, ...] = field(
        default=()
    )  # the frames of which all contacts were asked for
    world_count: int = 1  # worlds that were simulated together
    wall_s: float = 0.0  # wall time of the whole batch: all frames, without building, compiling and capturing

    def column(self, name: str) -> np.ndarray:
        """Return one of FRAME_COLUMNS over time, shape [frames]."""
        return self.contacts[:, FRAME_COLUMNS.index(name)]


def first_failure(poses: np.ndarray, seen: Failure | None) -> Failure | None:
    """Return the earlier of what the recorder saw and the first frame with a pose that is not finite.

    Args:
        poses: Shape [frames, bodies, 7].
        seen: A failure that the recorder saw, or None.
    """
    bad = ~np.isfinite(poses).all(axis=(1, 2))
    if not bad.any():
        return seen
    non_finite = Failure("non-finite", int(bad.argmax()), "a body's pose is not finite")
    if seen is not None and seen.frame <= non_finite.frame:
        return seen
    return non_finite
