"""Metrics of a trace: pure functions of arrays, in the definitions that the report gives."""

from dataclasses import dataclass

import numpy as np

from experiments.trace import Trace

SHAKE = 4
"""Task phase in which everything is measured."""
CUBE, TCP = 0, 1
MAIN_AXIS = np.array([1.0, 0.0, 0.0])
"""The shake's main axis in the world."""
DROP_DISTANCE = 0.08
"""Farther [m] than this from the TCP the cube has left the grasp."""
SPAWN_HEIGHT = 0.02
SPAWN_HEIGHT_TOLERANCE = 0.005
"""At its spawn height within this [m] the cube lies on the ground: a cube held after the lift is 0.2 m higher."""


def rotate_inverse(quaternion: np.ndarray, vector: np.ndarray) -> np.ndarray:
    """Rotate ``vector`` by the inverse of unit ``quaternion`` (x, y, z, w); shapes [..., 4] and [..., 3]."""
    imaginary, real = -quaternion[..., :3], quaternion[..., 3:]
    twice = 2.0 * np.cross(imaginary, vector)
    return vector + real * twice + np.cross(imaginary, twice)


def relative_position(poses: np.ndarray, body: int, frame: int) -> np.ndarray:
    """Position [m] of ``body`` in the frame of another body, shape [frames, 3]. ``poses`` has shape [frames, bodies, 7]."""
    poses = poses.astype(np.float64)
    return rotate_inverse(poses[:, frame, 3:], poses[:, body, :3] - poses[:, frame, :3])


@dataclass(frozen=True)
class Displacement:
    """The cube in the TCP frame since the first frame of the shake."""

    time_s: np.ndarray
    """Time since the first frame of the shake, shape [frames]."""
    vector_m: np.ndarray
    """Displacement in the axes of the TCP frame, shape [frames, 3]."""
    along_m: np.ndarray
    """Component along the shake's main axis, shape [frames]."""


def displacement(trace: Trace, body: int = CUBE, frame: int = TCP) -> Displacement:
    """Displacement of ``body`` in the frame of another body over the shake; empty if the shake was never reached."""
    poses = trace.poses[trace.phase == SHAKE].astype(np.float64)
    if len(poses) == 0:
        return Displacement(np.zeros(0), np.zeros((0, 3)), np.zeros(0))
    position = relative_position(poses, body, frame)
    vector = position - position[0]
    axis = rotate_inverse(poses[0, frame, 3:], MAIN_AXIS)
    return Displacement(np.arange(len(poses)) * trace.frame_dt, vector, vector @ axis)


def slip_mm(moved: Displacement) -> float:
    """Length of the displacement in the last frame [mm]."""
    return 1e3 * float(np.linalg.norm(moved.vector_m[-1]))


def fit_line(moved: Displacement) -> tuple[float, float]:
    """Least-squares slope [m/s] and value at time 0 [m] of the component along the main axis."""
    slope, offset = np.polyfit(moved.time_s, moved.along_m, 1)
    return float(slope), float(offset)


def drift_mm_s(moved: Displacement) -> float:
    """Least-squares slope of the component along the main axis over the whole shake [mm/s]."""
    return 1e3 * fit_line(moved)[0]


def oscillation_mm(moved: Displacement) -> float:
    """Root mean square of what is left about the fitted line [mm]."""
    slope, offset = fit_line(moved)
    return 1e3 * float(np.sqrt(np.mean((moved.along_m - slope * moved.time_s - offset) ** 2)))


def wander_mm(moved: Displacement) -> float:
    """Largest distance from the position in the first frame of the shake [mm]."""
    return 1e3 * float(np.linalg.norm(moved.vector_m, axis=1).max())


def cycle_increments_mm(moved: Displacement, frequency_hz: float) -> np.ndarray:
    """Change along the main axis over each full shake cycle, at the phase of the first frame [mm], shape [cycles].

    Between frames the component is interpolated linearly, so a cycle need not be a whole number of frames.
    """
    cycle_count = int(np.floor(moved.time_s[-1] * frequency_hz + 1e-9))
    at = np.interp(np.arange(cycle_count + 1) / frequency_hz, moved.time_s, moved.along_m)
    return 1e3 * np.diff(at)


def cube_height_m(trace: Trace) -> float:
    """Height of the cube's centre in the last frame [m]."""
    return float(trace.poses[-1, CUBE, 2])


def is_dropped(trace: Trace) -> bool:
    """Whether the cube ends far from the TCP, or on the ground."""
    cube, tcp = trace.poses[-1, CUBE, :3].astype(np.float64), trace.poses[-1, TCP, :3].astype(np.float64)
    on_ground = cube[2] < SPAWN_HEIGHT + SPAWN_HEIGHT_TOLERANCE
    return bool(np.linalg.norm(cube - tcp) > DROP_DISTANCE or on_ground)
