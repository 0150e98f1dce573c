"""The classifier on hand-made traces: each class, each border between two, and the order of the tests."""

import numpy as np
import pytest

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED
from experiments.facts.classes import classify, creep_mm_s
from experiments.facts.trace import FRAME_COLUMNS, Failure, Trace

FRAME_DT = 1.0 / 60.0
FRAME_COUNT = 241
"""Four seconds: two periods of the shake, and the frame that they begin with."""
TIME_S = np.arange(FRAME_COUNT) * FRAME_DT
TOOL_DOWN = (1.0, 0.0, 0.0, 0.0)
HAND = np.array([0.0, -0.44, 0.22])
FLOOR_MM_S = 0.01
DRIVE_PEAK_M_S = 0.03 * 2.0 * np.pi * np.sqrt(1.0 + 1.3**2 + 0.525**2)
"""Peak of the shake as shipped, worked out from its three axes."""


def make_trace(cube_in_world_m, failure=None) -> Trace:
    """A shake with the hand still, and the cube at these places less HAND [m], shape [frames, 3]."""
    poses = np.zeros((len(cube_in_world_m), 6, 7))
    poses[:, :, 3:] = TOOL_DOWN
    poses[:, :, :3] = HAND
    poses[:, metrics.CUBE, :3] += cube_in_world_m
    phase = np.full(len(poses), metrics.SHAKE)
    return Trace(FRAME_DT, phase, poses, np.zeros((len(poses), len(FRAME_COLUMNS))), failure)


def along(axis: int, values_m) -> np.ndarray:
    place = np.zeros((len(values_m), 3))
    place[:, axis] = values_m
    return place


def creeping_at(rate_mm_s: float) -> np.ndarray:
    return along(0, 1e-3 * rate_mm_s * TIME_S)


def kicked_at(speed_m_s: float) -> np.ndarray:
    """Still, but for one frame in which it moves at that speed, there and back."""
    values = np.zeros(FRAME_COUNT)
    values[100] = speed_m_s * FRAME_DT
    return along(0, values)


def swinging(before_m: float, after_m: float) -> np.ndarray:
    """At 5 Hz, with one amplitude in the last but one second and another in the last."""
    amplitude = np.where(TIME_S < 3.0, before_m, after_m)
    return along(0, amplitude * np.sin(2.0 * np.pi * 5.0 * TIME_S))


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
        # Where two fit, the first counts.
        (BROKEN, OVERFLOW, "non-finite"),
        (kicked_at(100.0), OVERFLOW, "overflow"),
        (kicked_at(100.0) + GONE, None, "exploded"),
        (GONE + creeping_at(1.0), None, "dropped"),
        # On either side of each border.
        *((kicked_at(9.99 * DRIVE_PEAK_M_S), None, "holding"), (kicked_at(10.01 * DRIVE_PEAK_M_S), None, "exploded")),
        *((away(0.0799), None, "holding"), (away(0.0801), None, "dropped")),
        *((creeping_at(0.0099), None, "holding"), (creeping_at(0.0101), None, "creeping")),
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
    assert creep_mm_s(AS_SHIPPED, make_trace(creeping_at(0.3)[:31])) == pytest.approx(0.3)
    assert creep_mm_s(AS_SHIPPED, make_trace(creeping_at(0.3)[:1])) == 0.0
