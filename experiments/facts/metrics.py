"""Compute the metrics of a trace, as the report defines them."""

from dataclasses import dataclass

import numpy as np

from experiments.facts.trace import ContactRows, Trace

SHAKE = 4  # phase of the task in which the metrics are measured
CUBE, TCP = 0, 1
MAIN_AXIS = np.array([1.0, 0.0, 0.0])  # the shake's main axis in the world
# distance from the TCP [m] beyond which the cube has left the grasp
DROP_DISTANCE = 0.08
SPAWN_HEIGHT = 0.02
SPAWN_HEIGHT_TOLERANCE = 0.005
"""Tolerance [m] around the spawn height within which the cube lies on the ground.

A cube that is held after the lift is 0.2 m higher.
"""


def rotate_inverse(quaternion: np.ndarray, vector: np.ndarray) -> np.ndarray:
    """Return ``vector`` rotated by the inverse of unit ``quaternion`` (x, y, z, w).

    The shapes are [..., 3] and [..., 4].
    """
    imaginary, real = -quaternion[..., :3], quaternion[..., 3:]
    twice = 2.0 * np.cross(imaginary, vector)
    return vector + real * twice + np.cross(imaginary, twice)


def relative_position(poses: np.ndarray, body: int, frame: int) -> np.ndarray:
    """Return the position [m] of ``body`` in the frame of another, [frames, 3].

    Args:
        poses: Position and quaternion of each body, shape [frames, bodies, 7].
    """
    poses = poses.astype(np.float64)
    return rotate_inverse(poses[:, frame, 3:], poses[:, body, :3] - poses[:, frame, :3])


@dataclass(frozen=True)
class Displacement:
    """The displacement of the cube in the TCP frame during the shake."""

    time_s: np.ndarray  # time since the first frame of the shake, shape [frames]
    vector_m: np.ndarray  # displacement in the axes of the TCP frame, shape [frames, 3]
    along_m: np.ndarray  # component along the shake's main axis, shape [frames]


def displacement(trace: Trace, body: int = CUBE, frame: int = TCP) -> Displacement:
    """Return the displacement of ``body`` in another body's frame over the shake.

    It is empty if the shake was never reached.
    """
    poses = trace.poses[trace.phase == SHAKE].astype(np.float64)
    if len(poses) == 0:
        return Displacement(np.zeros(0), np.zeros((0, 3)), np.zeros(0))
    position = relative_position(poses, body, frame)
    vector = position - position[0]
    axis = rotate_inverse(poses[0, frame, 3:], MAIN_AXIS)
    return Displacement(np.arange(len(poses)) * trace.frame_dt, vector, vector @ axis)


def slip_mm(moved: Displacement) -> float:
    """Return the length of the displacement in the last frame [mm]."""
    return 1e3 * float(np.linalg.norm(moved.vector_m[-1]))


def fit_line(moved: Displacement) -> tuple[float, float]:
    """Return the slope [m/s] and the offset [m] of a line fitted along the main axis."""
    slope, offset = np.polyfit(moved.time_s, moved.along_m, 1)
    return float(slope), float(offset)


def drift_mm_s(moved: Displacement) -> float:
    """Return the drift: the slope of the displacement along the main axis [mm/s].

    The line is fitted by least squares.
    """
    return 1e3 * fit_line(moved)[0]


def oscillation_mm(moved: Displacement) -> float:
    """Return the root mean square of the deviation from the fitted line [mm]."""
    slope, offset = fit_line(moved)
    return 1e3 * float(
        np.sqrt(np.mean((moved.along_m - slope * moved.time_s - offset) ** 2))
    )


def wander_mm(moved: Displacement) -> float:
    """Return the largest distance from the position at the start of the shake [mm]."""
    return 1e3 * float(np.linalg.norm(moved.vector_m, axis=1).max())


def cycle_drift_mm(moved: Displacement, frequency_hz: float) -> float:
    """Return the length of the mean displacement over a shake cycle [mm].

    The first cycle is left out. The whole motion repeats every two cycles of the main
    axis, so that the second cycle may reverse the motion of the first. Therefore only
    pairs of cycles count. The result is NaN if there is no pair after the first cycle.
    """
    pair_count = (
        int(np.floor((moved.time_s[-1] * frequency_hz - 1.0) / 2.0 + 1e-9))
        if len(moved.time_s)
        else 0
    )
    if pair_count < 1:
        return float("nan")
    ends = np.array([1.0, 1.0 + 2.0 * pair_count]) / frequency_hz
    first, last = np.stack(
        [np.interp(ends, moved.time_s, column) for column in moved.vector_m.T], axis=1
    )
    return 1e3 * float(np.linalg.norm(last - first)) / (2 * pair_count)


def distance_rms_mm(position_m: np.ndarray, reference_m: np.ndarray) -> float:
    """Return the root mean square distance between two paths [mm]."""
    return 1e3 * float(
        np.sqrt(np.mean(np.sum((position_m - reference_m) ** 2, axis=1)))
    )


def cube_height_m(trace: Trace) -> float:
    """Return the height of the cube's centre in the last frame [m]."""
    return float(trace.poses[-1, CUBE, 2])


def is_dropped(trace: Trace) -> bool:
    """Return whether the cube ends far from the TCP or on the ground."""
    cube, tcp = (
        trace.poses[-1, CUBE, :3].astype(np.float64),
        trace.poses[-1, TCP, :3].astype(np.float64),
    )
    on_ground = cube[2] < SPAWN_HEIGHT + SPAWN_HEIGHT_TOLERANCE
    return bool(np.linalg.norm(cube - tcp) > DROP_DISTANCE or on_ground)


def shake_mean(trace: Trace, column: str) -> float:
    """Return the mean of a frame statistic over the shake, without NaN."""
    return float(np.nanmean(trace.column(column)[trace.phase == SHAKE]))


def slide_mm(trace: Trace) -> float:
    """Return the slide along the main axis over the shake [mm].

    This is the integrated velocity of the loaded friction rows.
    """
    return 1e3 * float(
        trace.column("slide_m_s")[trace.phase == SHAKE].sum() * trace.frame_dt
    )


def total_drift_mm(moved: Displacement) -> float:
    """Return the length of the fitted drift in 3D over the whole shake [mm]."""
    slope = np.polyfit(moved.time_s, moved.vector_m, 1)[0]
    return 1e3 * float(np.linalg.norm(slope) * moved.time_s[-1])


@dataclass(frozen=True)
class Grasp:
    """Numbers about the contacts that carry force in one frame."""

    row_count: int  # all live contacts, loaded or not
    loaded_row_count: int
    normal_force_n: float  # sum over the loaded contacts
    tangential_force_n: float
    # Largest ratio of tangential force to friction times normal force; 1 means sliding.
    cone_use: float
    penetration_mm: float  # mean over the loaded contacts
    # mean ratio of normal force to penetration of the loaded contacts
    stiffness_n_m: float
    timeconst_s: float
    dampratio: float
    # Timeconst of solreffriction; 0 if the friction rows use the timeconst of the
    # normal row.
    friction_timeconst_s: float
    friction_dampratio: float
    friction: float
    dmin: float
    dmax: float
    dim: int
    # Largest position residual of a loaded contact's normal row.
    normal_residual_mm: float
    # Largest position residual of a loaded contact's friction rows.
    friction_residual_mm: float
    normal_velocity_mm_s: float  # largest velocity of those normal rows


def grasp(rows: ContactRows) -> Grasp | None:
    """Return numbers about the loaded contacts in a frame, or None if there are none.

    The solver parameters belong to the contact with the largest force.
    """
    normal = rows.force_n[:, 0]
    loaded = normal > 0.0
    if not loaded.any():
        return None
    tangential = np.linalg.norm(rows.force_n[loaded, 1:], axis=1)
    penetration = -rows.distance_m[loaded]
    residual, velocity = (
        1e3 * np.abs(rows.residual_m[loaded]),
        1e3 * np.abs(rows.velocity_m_s[loaded, 0]),
    )
    strongest = int(normal.argmax())
    return Grasp(
        row_count=len(normal),
        loaded_row_count=int(loaded.sum()),
        normal_force_n=float(normal[loaded].sum()),
        tangential_force_n=float(tangential.sum()),
        cone_use=float((tangential / (rows.friction[loaded] * normal[loaded])).max()),
        penetration_mm=1e3 * float(penetration.mean()),
        stiffness_n_m=float((normal[loaded] / penetration).mean()),
        timeconst_s=float(rows.solref[strongest, 0]),
        dampratio=float(rows.solref[strongest, 1]),
        friction_timeconst_s=float(rows.solreffriction[strongest, 0]),
        friction_dampratio=float(rows.solreffriction[strongest, 1]),
        friction=float(rows.friction[strongest]),
        dmin=float(rows.solimp[strongest, 0]),
        dmax=float(rows.solimp[strongest, 1]),
        dim=int(rows.dim[strongest]),
        normal_residual_mm=float(residual[:, 0].max()),
        friction_residual_mm=float(residual[:, 1:].max()),
        normal_velocity_mm_s=float(velocity.max()),
    )
