"""Classify how a run ends by its trace, and compute its creep in each cycle."""

import numpy as np

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, Case
from experiments.facts.trace import Trace

CLASSES = ("non-finite", "overflow", "exploded", "dropped", "creeping", "holding")
"""The classes in the order of their tests, the worst first."""
STABLE = ("creeping", "holding")

# A cube that is faster than the drive's peak speed by this factor has exploded.
DRIVE_RATIO = 10.0
DRIVE_SHAPE = np.array([1.0, 1.3, 0.525])
"""Peak speed of each axis of the shake over A ω.

The targets are x = sin ωt, y = 0.65 sin 2ωt and z = 0.35 sin 1.5ωt. Their speeds peak
together at t = 0.
"""
GROWTH_RATIO = 2.0
"""A cube whose energy relative to the hand grows by this factor in a cycle has exploded
…
"""
# … unless its speed is below this fraction of the drive's peak
GROWTH_SPEED_RATIO = 0.1


def classify(case: Case, trace: Trace, creep_floor_mm_s: float) -> str:
    """Return the first of CLASSES that applies.

    Args:
        creep_floor_mm_s: Smallest creep that can be distinguished from zero [mm/s].
    """
    if not is_finite(trace):
        return "non-finite"
    if trace.failure is not None:
        return "overflow"
    if is_exploded(case, trace):
        return "exploded"
    if metrics.is_dropped(trace):
        return "dropped"
    return "creeping" if creep_mm_s(case, trace) > creep_floor_mm_s else "holding"


def is_finite(trace: Trace) -> bool:
    """Return whether every pose of every frame is finite."""
    return bool(np.isfinite(trace.poses).all())


def drive_peak_m_s(case: Case) -> float:
    """Return the largest speed of the shake's target [m/s].

    If the arm is held still, return the speed of the default shake instead.
    """
    shaken = case if case.shake_amplitude_m > 0.0 else AS_SHIPPED
    rate = 2.0 * np.pi * shaken.shake_frequency_hz
    return float(shaken.shake_amplitude_m * rate * np.linalg.norm(DRIVE_SHAPE))


def is_exploded(case: Case, trace: Trace) -> bool:
    """Return whether the cube has exploded.

    This means that it is much faster than the drive, or that its energy grows over a
    cycle while it is in the grasp.
    """
    peak = drive_peak_m_s(case)
    return bool(
        excess_speed_m_s(case, trace).max() > DRIVE_RATIO * peak
        or is_energy_growing(case, trace)
    )


def excess_speed_m_s(case: Case, trace: Trace) -> np.ndarray:
    """Return the cube's speed without its fall [m/s], shape [frames - 1].

    The fall begins at frame 0.
    """
    energy = excess_energy(
        trace.poses[:, metrics.CUBE, :3], case.gravity_m_s2, trace.frame_dt
    )
    return np.sqrt(2.0 * energy)


def excess_energy(
    position_m: np.ndarray, gravity_m_s2: float, frame_dt: float
) -> np.ndarray:
    """Return the kinetic energy per mass minus the work of gravity [J/kg].

    The result has the shape [frames - 1] and is never negative. It is zero for a free
    fall, because 1/2 v² = g h. If gravity slows the body, the whole kinetic energy
    counts.

    Args:
        position_m: Shape [frames, 3].
    """
    position = position_m.astype(np.float64)
    velocity = np.diff(position, axis=0) / frame_dt
    middle = 0.5 * (position[1:] + position[:-1])
    work = -gravity_m_s2 * (middle[:, 2] - position[0, 2])
    return np.maximum(0.0, 0.5 * (velocity**2).sum(axis=1) - np.maximum(0.0, work))


def is_energy_growing(case: Case, trace: Trace) -> bool:
    """Return whether the cube's energy relative to the hand doubles in the last cycle.

    The last two shake cycles are compared. The cube must be in the grasp in both, and
    slow motion does not count.
    """
    cycle = round(1.0 / (case.shake_frequency_hz * trace.frame_dt))
    poses = trace.poses[trace.phase == metrics.SHAKE][-2 * cycle - 1 :].astype(
        np.float64
    )
    if len(poses) < 2 * cycle + 1:
        return False
    position = poses[:, metrics.CUBE, :3] - poses[:, metrics.TCP, :3]
    if np.linalg.norm(position, axis=1).max() > metrics.DROP_DISTANCE:
        return False
    energy = excess_energy(position, case.gravity_m_s2, trace.frame_dt)
    before, after = energy[:cycle].mean(), energy[cycle:].mean()
    is_fast = np.sqrt(2.0 * after) > GROWTH_SPEED_RATIO * drive_peak_m_s(case)
    return bool(is_fast and after >= GROWTH_RATIO * before)


def creep_mm_s(case: Case, trace: Trace) -> float:
    """Return the speed of the cube in the grasp over the last period [mm/s].

    The period is 2/f, after which the targets of all three axes repeat, so that
    oscillations cancel. If the shake is shorter than a period, all of it is used.
    """
    moved = metrics.displacement(trace)
    period = min(
        round(2.0 / (case.shake_frequency_hz * trace.frame_dt)), len(moved.time_s) - 1
    )
    if period < 1:
        return 0.0
    change = moved.vector_m[-1] - moved.vector_m[-1 - period]
    return 1e3 * float(np.linalg.norm(change)) / (period * trace.frame_dt)


def cycle_increments(
    time_s: np.ndarray, along: np.ndarray, frequency_hz: float
) -> np.ndarray:
    """Return the change along the main axis over each full cycle, shape [cycles].

    The first cycle starts with the first frame. Positions are interpolated linearly, so
    that a cycle need not be a whole number of frames.

    Args:
        time_s: Time since the first frame of the shake, shape [frames].
        along: Displacement along the axis, shape [frames]; the result has
            the same unit.
    """
    cycle_count = int(np.floor(time_s[-1] * frequency_hz + 1e-9))
    return np.diff(np.interp(np.arange(cycle_count + 1) / frequency_hz, time_s, along))
