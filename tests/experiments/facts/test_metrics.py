"""Metrics on hand-made traces: the numbers on the right are done by hand."""

import numpy as np
import pytest

from experiments.facts import metrics
from experiments.facts.trace import FRAME_COLUMNS, Failure, Trace, first_failure

FRAME_DT = 1.0 / 60.0
TOOL_DOWN = (1.0, 0.0, 0.0, 0.0)
SETUP_FRAME_COUNT = 3


def make_trace(cube_in_tcp, tcp_position=(0.1, -0.4, 0.2)) -> Trace:
    """A trace whose cube is at ``cube_in_tcp`` [m], shape [frames, 3], with the tool pointing down."""
    cube_in_tcp = np.asarray(cube_in_tcp, dtype=float)
    frame_count = SETUP_FRAME_COUNT + len(cube_in_tcp)
    poses = np.zeros((frame_count, 6, 7), dtype=np.float32)
    poses[:, :, 3:] = TOOL_DOWN
    poses[:, metrics.TCP, :3] = tcp_position
    # Pointing down is half a turn about x: y and z of the tool are -y and -z of the world.
    poses[:, metrics.CUBE, :3] = tcp_position
    poses[SETUP_FRAME_COUNT:, metrics.CUBE, :3] += cube_in_tcp * (1.0, -1.0, -1.0)
    phase = np.full(frame_count, metrics.SHAKE)
    phase[:SETUP_FRAME_COUNT] = metrics.SHAKE - 1
    return Trace(FRAME_DT, phase, poses, np.zeros((frame_count, len(FRAME_COLUMNS))))


def along_x(values_mm) -> np.ndarray:
    return np.outer(1e-3 * np.asarray(values_mm), (1.0, 0.0, 0.0))


def displacement(cube_in_tcp) -> metrics.Displacement:
    return metrics.displacement(make_trace(cube_in_tcp))


def test_displacement_is_in_the_tool_frame_and_starts_with_the_shake():
    moved = displacement([(0.001, 0.002, 0.003), (0.002, 0.004, 0.009)])
    np.testing.assert_allclose(moved.vector_m, [(0, 0, 0), (0.001, 0.002, 0.006)], atol=1e-7)
    np.testing.assert_allclose(moved.along_m, [0, 0.001], atol=1e-7)
    np.testing.assert_allclose(moved.time_s, [0, FRAME_DT])
    still, moving = make_trace(along_x([0, 1, 2])), make_trace(along_x([0, 1, 2]))
    shift = np.linspace(0.0, 0.03, len(moving.poses))[:, None]
    moving.poses[:, : metrics.TCP + 1, 0] += shift
    np.testing.assert_allclose(metrics.displacement(moving).vector_m, metrics.displacement(still).vector_m, atol=1e-7)
    moved = displacement(np.zeros((0, 3)))
    assert moved.time_s.size == moved.along_m.size == 0


def test_slip_is_the_length_in_the_last_frame_and_wander_the_largest():
    moved = displacement([(0, 0, 0), (0.009, 0, 0), (0.002, 0.003, 0.006)])
    assert (metrics.slip_mm(moved), metrics.wander_mm(moved)) == pytest.approx((7.0, 9.0), abs=1e-3)


@pytest.mark.parametrize(("frame_count", "rate_mm_s", "swing_mm"), [(121, 0.5, 0.0), (600, 2.0, 1.0)])
def test_drift_is_the_slope_and_oscillation_the_root_mean_square_about_it(frame_count, rate_mm_s, swing_mm):
    seconds = np.arange(frame_count) * FRAME_DT
    moved = displacement(along_x(rate_mm_s * seconds + swing_mm * np.cos(2 * np.pi * seconds)))
    assert metrics.drift_mm_s(moved) == pytest.approx(rate_mm_s, abs=1e-2 if swing_mm else 1e-3)
    assert metrics.oscillation_mm(moved) == pytest.approx(swing_mm / np.sqrt(2), abs=1e-2 if swing_mm else 1e-3)


@pytest.mark.parametrize(
    ("cube_in_tcp", "tcp_height", "dropped"),
    [((0.0, 0.0, 0.0), 0.2, False), ((0.0, 0.0, 0.079), 0.2, False), ((0.0, 0.0, 0.081), 0.2, True)]
    + [((0.0, 0.0, 0.0), 0.021, True), ((0.0, 0.0, 0.0), 0.026, False)],
)
def test_dropped_far_from_the_tool_or_on_the_ground(cube_in_tcp, tcp_height, dropped):
    trace = make_trace([cube_in_tcp], tcp_position=(0.0, -0.4, tcp_height))
    assert metrics.is_dropped(trace) is dropped
    assert metrics.cube_height_m(trace) == pytest.approx(tcp_height - cube_in_tcp[2], abs=1e-6)


def test_the_first_failure_counts():
    poses = make_trace(np.zeros((5, 3))).poses
    assert first_failure(poses, None) is None
    poses[4, 0, 0] = np.nan
    assert first_failure(poses, None) == Failure("non-finite", 4, "a body's pose is not finite")
    early, late = (Failure("overflow", frame, "the contact buffer overflowed") for frame in (4, 5))
    assert first_failure(poses, early) is early
    assert first_failure(poses, late).kind == "non-finite"
