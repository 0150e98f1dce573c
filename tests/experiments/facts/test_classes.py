"""Test the classifier on handmade traces: each class, each border between two classes,
and the order of the tests.
"""

from dataclasses import replace

import numpy as np
import pytest

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED
from experiments.facts.classes import (
    classify,
    creep_mm_s,
    cycle_increments,
    drive_peak_m_s,
    excess_energy,
)
from experiments.facts.trace import FRAME_COLUMNS, Failure, Trace

FRAME_DT = 1.0 / 60.0
FRAME_COUNT = 241
"""Times of four seconds: two periods of the shake, and the frame before them [s]."""
TIME_S = np.arange(FRAME_COUNT) * FRAME_DT
TOOL_DOWN = (1.0, 0.0, 0.0, 0.0)
HAND = np.array([0.0, -0.44, 0.22])
FLOOR_MM_S = 0.01
DRIVE_PEAK_M_S = 0.03 * 2.0 * np.pi * np.sqrt(1.0 + 1.3**2 + 0.525**2)
"""Peak acceleration of the shake as shipped, computed from its three axes."""


def make_trace(cube_in_world_m, failure=None) -> Trace:
    """Return a shake with the hand still and the cube at these places relative to HAND
    [m], shape [frames, 3].
    """
    poses = np.zeros((len(cube_in_world_m), 6, 7))
    poses[:, :, 3:] = TOOL_DOWN
    poses[:, :, :3] = HAND
    poses[:, metrics.CUBE, :3] += cube_in_world_m
    phase = np.full(len(poses), metrics.SHAKE)
    return Trace(
        FRAME_DT, phase, poses, np.zeros((len(poses), len(FRAME_COLUMNS))), failure
    )


def along(axis: int, values_m) -> np.ndarray:
    place = np.zeros((len(values_m), 3))
    place[:, axis] = values_m
    return place


def creeping_at(rate_mm_s: float) -> np.ndarray:
    return along(0, 1e-3 * rate_mm_s * TIME_S)


def kicked_at(speed_m_s: float) -> np.ndarray:
    """Return places that are constant except in one frame, in which the cube moves away
    and back at this speed.
    """
    values = np.zeros(FRAME_COUNT)
    values[100] = speed_m_s * FRAME_DT
    return along(0, values)


def swinging(before_m: float, after_m: float) -> np.ndarray:
    """Return a swing at 5 Hz with one amplitude in the last second but one, and another
    in the last second.
    """
    amplitude = np.where(TIME_S < 3.0, before_m, after_m)
    return along(0, amplitude * np.sin(2.0 * np.pi * 5.0 * TIME_S))


SPEED = 2.0 * np.sin(np.pi * 5.0 / 60.0) / np.sqrt(2.0) / FRAME_DT
"""Root mean square of the speed of a swing at the frames, divided by its amplitude
[1/s].
"""
BRISK_M = 0.1 * DRIVE_PEAK_M_S / SPEED
"""Amplitude of a swing with a tenth of the drive's speed."""


def outcome(place, failure=None, case=AS_SHIPPED) -> str:
    return classify(case, make_trace(place, failure), FLOOR_MM_S)


OVERFLOW = Failure("overflow", 3, "the contact buffer overflowed")
GONE = along(2, np.interp(TIME_S, (1.0, 1.5), (0.0, -0.1)))
BROKEN = along(0, np.where(TIME_S < 3.0, 0.0, np.nan))
FALLEN = along(2, -np.minimum(0.2, 0.5 * 9.81 * np.maximum(0.0, TIME_S - 1.0) ** 2))


def away(distance_m: float) -> np.ndarray:
    return along(0, np.full(FRAME_COUNT, distance_m))


@pytest.mark.parametrize(
    ("place", "failure", "expected"),
    [
        (BROKEN, None, "non-finite"),
        (creeping_at(0.0), OVERFLOW, "overflow"),
        (kicked_at(100.0), None, "exploded"),
        (swinging(1e-3, 0.01), None, "exploded"),
        (FALLEN, None, "dropped"),
        (creeping_at(1.0), None, "creeping"),
        (creeping_at(0.0), None, "holding"),
        # If two classes apply, the first one counts.
        (BROKEN, OVERFLOW, "non-finite"),
        (kicked_at(100.0), OVERFLOW, "overflow"),
        (kicked_at(100.0) + GONE, None, "exploded"),
        (GONE + creeping_at(1.0), None, "dropped"),
        # These runs are on either side of each border.
        *(
            (kicked_at(9.99 * DRIVE_PEAK_M_S), None, "holding"),
            (kicked_at(10.01 * DRIVE_PEAK_M_S), None, "exploded"),
        ),
        *((away(0.0799), None, "holding"), (away(0.0801), None, "dropped")),
        *(
            (away(0.0695) + swinging(1e-3, 0.01), None, "exploded"),
            (away(0.075) + swinging(1e-3, 0.01), None, "holding"),
        ),
        *(
            (swinging(5e-3, 7.0e-3), None, "holding"),
            (swinging(5e-3, 7.1e-3), None, "exploded"),
        ),  # the amplitude grows by √2
        *(
            (swinging(0.0, 0.99 * BRISK_M), None, "holding"),
            (swinging(0.0, 1.01 * BRISK_M), None, "exploded"),
        ),
        (
            swinging(1e-3, 0.01)[-120:],
            None,
            "creeping",
        ),  # one frame less than two cycles
        (swinging(1e-3, 0.01)[-121:], None, "exploded"),
        *(
            (creeping_at(0.0099), None, "holding"),
            (creeping_at(0.0101), None, "creeping"),
        ),
    ],
)
def test_each_class(place, failure, expected):
    assert outcome(place, failure) == expected
    trace = make_trace(place, failure)
    trace.poses[-1, 5, 6] = np.inf
    assert classify(AS_SHIPPED, trace, FLOOR_MM_S) == "non-finite", "one pose is enough"


def test_creep_is_the_change_over_the_last_period_or_all_of_a_short_shake():
    early = along(0, np.where(TIME_S < 1.0, 0.0, 5e-3))
    swing = along(2, 1e-3 * np.sin(np.pi * TIME_S))
    place = early + swing + creeping_at(0.3) + along(1, 1e-3 * 0.4 * TIME_S)
    assert creep_mm_s(AS_SHIPPED, make_trace(place)) == pytest.approx(0.5)
    assert creep_mm_s(AS_SHIPPED, make_trace(creeping_at(0.3)[:31])) == pytest.approx(
        0.3
    )
    assert creep_mm_s(AS_SHIPPED, make_trace(creeping_at(0.3)[:1])) == 0.0
    late = along(0, np.where(TIME_S < 3.5, 0.0, 5e-3))
    faster = replace(AS_SHIPPED, shake_frequency_hz=2.0)  # the period is one second
    assert creep_mm_s(faster, make_trace(late)) == pytest.approx(5.0)
    assert creep_mm_s(faster, make_trace(late)) == 2.0 * creep_mm_s(
        AS_SHIPPED, make_trace(late)
    )
    assert classify(AS_SHIPPED, make_trace(creeping_at(0.0)), 0.0) == "holding"


@pytest.mark.parametrize(("amplitude_m", "frequency_hz"), [(0.03, 1.0), (0.1, 2.5)])
def test_the_drive_is_never_faster_than_its_peak(amplitude_m, frequency_hz):
    """Compare the peak with the differentiated path of the target over two periods."""
    time_s = np.linspace(-1.0 / frequency_hz, 1.0 / frequency_hz, 200_001)
    angle = 2.0 * np.pi * frequency_hz * time_s
    target = amplitude_m * np.stack(
        [np.sin(angle), 0.65 * np.sin(2.0 * angle), 0.35 * np.sin(1.5 * angle)]
    )
    speed = np.linalg.norm(np.gradient(target, time_s, axis=1), axis=0)
    case = replace(
        AS_SHIPPED, shake_amplitude_m=amplitude_m, shake_frequency_hz=frequency_hz
    )
    assert drive_peak_m_s(case) == pytest.approx(speed.max(), rel=1e-6)
    assert drive_peak_m_s(replace(case, shake_amplitude_m=0.0)) == pytest.approx(
        DRIVE_PEAK_M_S
    )


@pytest.mark.parametrize("gravity", [9.81, -9.81, 0.0])
@pytest.mark.parametrize(
    "start", [(0.0, 0.0, 0.0), (3.0, 0.0, 0.0), (0.0, 4.0, -1.0), (0.0, 0.0, 2.0)]
)
def test_what_falls_keeps_the_energy_that_it_began_with(gravity, start):
    """Test a thrown cube: its energy is v²/2 while gravity accelerates it, and only its
    kinetic energy while it slows down.
    """
    dt = 1e-3
    time_s = dt * np.arange(101)[:, None]
    place = 5.0 + time_s * start - 0.5 * gravity * time_s**2 * (0.0, 0.0, 1.0)
    velocity = start - gravity * (time_s[1:] - 0.5 * dt) * (0.0, 0.0, 1.0)
    kinetic = 0.5 * (velocity**2).sum(axis=1)
    slowed = np.sign(gravity) * (place[1:, 2] + place[:-1, 2] - 10.0) > 0.0
    expected = np.where(slowed, kinetic, 0.5 * np.square(start).sum())
    np.testing.assert_allclose(excess_energy(place, gravity, dt), expected, atol=2e-5)


def test_increments_are_those_of_whole_cycles_between_frames_too():
    time_s = np.linspace(0.0, 3.0, 181)
    np.testing.assert_allclose(
        cycle_increments(time_s, time_s**2, 1.0), [1.0, 3.0, 5.0]
    )
    found = cycle_increments(time_s, time_s**2, 0.7)  # 2.1 cycles of 10/7 s
    np.testing.assert_allclose(found, [100.0 / 49.0, 300.0 / 49.0], rtol=1e-4)
