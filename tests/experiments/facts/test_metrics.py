"""Test metrics on handmade traces; the expected numbers are computed by hand."""

import numpy as np
import pytest
from scipy.spatial.transform import Rotation
from scipy.stats import linregress

from experiments.facts import metrics
from experiments.facts.trace import (
    FRAME_COLUMNS,
    ContactRows,
    Failure,
    Trace,
    first_failure,
)

FRAME_DT = 1.0 / 60.0
TOOL_DOWN = (1.0, 0.0, 0.0, 0.0)
SETUP_FRAME_COUNT = 3


def make_trace(cube_in_tcp, tcp_position=(0.1, -0.4, 0.2)) -> Trace:
    """Return a trace with the cube at ``cube_in_tcp`` [m], shape [frames, 3], and the
    tool pointing down.
    """
    cube_in_tcp = np.asarray(cube_in_tcp, dtype=float)
    frame_count = SETUP_FRAME_COUNT + len(cube_in_tcp)
    poses = np.zeros((frame_count, 6, 7), dtype=np.float32)
    poses[:, :, 3:] = TOOL_DOWN
    poses[:, metrics.TCP, :3] = tcp_position
    # Pointing down is a rotation by 180° about x: y and z of the tool are -y and -z of
    # the world.
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
    np.testing.assert_allclose(
        moved.vector_m, [(0, 0, 0), (0.001, 0.002, 0.006)], atol=1e-7
    )
    np.testing.assert_allclose(moved.along_m, [0, 0.001], atol=1e-7)
    np.testing.assert_allclose(moved.time_s, [0, FRAME_DT])
    still, moving = make_trace(along_x([0, 1, 2])), make_trace(along_x([0, 1, 2]))
    shift = np.linspace(0.0, 0.03, len(moving.poses))[:, None]
    moving.poses[:, : metrics.TCP + 1, 0] += shift
    np.testing.assert_allclose(
        metrics.displacement(moving).vector_m,
        metrics.displacement(still).vector_m,
        atol=1e-7,
    )
    moved = displacement(np.zeros((0, 3)))
    assert moved.time_s.size == moved.along_m.size == 0


def test_slip_is_the_length_in_the_last_frame_and_wander_the_largest():
    moved = displacement([(0, 0, 0), (0.009, 0, 0), (0.002, 0.003, 0.006)])
    assert (metrics.slip_mm(moved), metrics.wander_mm(moved)) == pytest.approx(
        (7.0, 9.0), abs=1e-3
    )


@pytest.mark.parametrize(
    ("frame_count", "rate_mm_s", "swing_mm"), [(121, 0.5, 0.0), (600, 2.0, 1.0)]
)
def test_drift_is_the_slope_and_oscillation_the_root_mean_square_about_it(
    frame_count, rate_mm_s, swing_mm
):
    seconds = np.arange(frame_count) * FRAME_DT
    moved = displacement(
        along_x(rate_mm_s * seconds + swing_mm * np.cos(2 * np.pi * seconds))
    )
    assert metrics.drift_mm_s(moved) == pytest.approx(
        rate_mm_s, abs=1e-2 if swing_mm else 1e-3
    )
    assert metrics.oscillation_mm(moved) == pytest.approx(
        swing_mm / np.sqrt(2), abs=1e-2 if swing_mm else 1e-3
    )


@pytest.mark.parametrize(
    ("cube_in_tcp", "tcp_height", "dropped"),
    [
        ((0.0, 0.0, 0.0), 0.2, False),
        ((0.0, 0.0, 0.079), 0.2, False),
        ((0.0, 0.0, 0.081), 0.2, True),
    ]
    + [((0.0, 0.0, 0.0), 0.0249, True), ((0.0, 0.0, 0.0), 0.0251, False)],
)
def test_dropped_far_from_the_tool_or_on_the_ground(cube_in_tcp, tcp_height, dropped):
    trace = make_trace([cube_in_tcp], tcp_position=(0.0, -0.4, tcp_height))
    assert metrics.is_dropped(trace) is dropped
    assert metrics.cube_height_m(trace) == pytest.approx(
        tcp_height - cube_in_tcp[2], abs=1e-6
    )


def test_the_first_failure_counts():
    poses = make_trace(np.zeros((5, 3))).poses
    assert first_failure(poses, None) is None
    poses[4, 0, 0] = np.nan
    assert first_failure(poses, None) == Failure(
        "non-finite", 4, "a body's pose is not finite"
    )
    early, late = (
        Failure("overflow", frame, "the contact buffer overflowed") for frame in (4, 5)
    )
    assert first_failure(poses, early) is early
    assert first_failure(poses, late).kind == "non-finite"


def test_vectors_are_turned_back_as_scipy_turns_them():
    turns, vectors = (
        Rotation.random(20, random_state=0),
        np.random.default_rng(0).normal(size=(20, 3)),
    )
    found = metrics.rotate_inverse(turns.as_quat(), vectors)
    np.testing.assert_allclose(found, turns.inv().apply(vectors), atol=1e-12)


def test_the_displacement_is_that_in_the_hand_and_along_the_axis_as_the_hand_had_it_when_the_shake_began():
    random = np.random.default_rng(1)
    turns, hand, in_hand = (
        Rotation.random(4, random_state=1),
        random.normal(size=(4, 3)),
        random.normal(size=(4, 3)),
    )
    poses = random.normal(size=(5, 4, 7))
    poses[1:, 3, :3], poses[1:, 3, 3:] = hand, turns.as_quat()
    poses[1:, 2, :3] = hand + turns.apply(in_hand)
    trace = Trace(
        FRAME_DT, np.array([3, 4, 4, 4, 4]), poses, np.zeros((5, len(FRAME_COLUMNS)))
    )
    moved = metrics.displacement(trace, body=2, frame=3)
    np.testing.assert_allclose(moved.vector_m, in_hand - in_hand[0], atol=1e-12)
    np.testing.assert_allclose(
        moved.along_m, (in_hand - in_hand[0]) @ turns[0].as_matrix()[0], atol=1e-12
    )


def test_lines_are_fitted_as_scipy_fits_them():
    vector = np.random.default_rng(2).normal(size=(50, 3))
    moved = metrics.Displacement(0.5 + 0.1 * np.arange(50), vector, vector[:, 0])
    lines = [linregress(moved.time_s, column) for column in vector.T]
    assert metrics.fit_line(moved) == pytest.approx(
        (lines[0].slope, lines[0].intercept)
    )
    length = (
        1e3 * np.linalg.norm([line.slope for line in lines]) * 5.4
    )  # the last time is 5.4 s
    assert metrics.total_drift_mm(moved) == pytest.approx(length)


@pytest.mark.parametrize(
    ("cycles", "frequency_hz"),
    [(3.0, 1.0), (4.9, 1.0), (5.0, 1.0), (6.3, 2.0), (3.5, 0.7)],
)
def test_the_drift_of_a_cycle_is_that_of_whole_pairs_after_the_first(
    cycles, frequency_hz
):
    """Test 5 mm per cycle, with a swing that cancels in each pair, a jump in the first
    cycle, and one after the last pair.
    """
    time_s = np.linspace(0.0, cycles / frequency_hz, 2001)
    cycle, end = time_s * frequency_hz, {3: 3, 4: 3, 5: 5, 6: 5}[int(cycles)]
    along = np.outer(5.0 * cycle, (0.6, 0.8, 0.0)) + np.outer(
        np.sin(np.pi * cycle), (0.0, 0.0, 7.0)
    )
    along += 50.0 * ((cycle > 0.4)[:, None] + (cycle > end + 0.05)[:, None])
    moved = metrics.Displacement(time_s, 1e-3 * along, time_s)
    assert metrics.cycle_drift_mm(moved, frequency_hz) == pytest.approx(5.0, rel=1e-4)


def test_without_a_pair_after_the_first_cycle_there_is_no_drift_of_a_cycle():
    for cycles in (1.0, 2.99):
        time_s = np.linspace(0.0, cycles, 200)
        assert np.isnan(
            metrics.cycle_drift_mm(
                metrics.Displacement(time_s, np.ones((200, 3)), time_s), 1.0
            )
        )
    assert np.isnan(metrics.cycle_drift_mm(displacement(np.zeros((0, 3))), 1.0))


def test_paths_are_apart_by_the_root_of_the_mean_square():
    apart = np.array(
        [(3.0, 4.0, 0.0), (0.0, 0.0, 5.0), (0.0, 0.0, 0.0), (0.0, 0.0, 0.0)]
    )
    assert metrics.distance_rms_mm(
        1e-3 * apart + 1.0, np.ones((4, 3))
    ) == pytest.approx(5.0 / np.sqrt(2.0))


def test_what_a_cube_does_on_its_way_does_not_drop_it():
    assert not metrics.is_dropped(
        make_trace([(0.0, 0.0, 0.0), (0.0, 0.0, 0.2), (0.0, 0.0, 0.0)])
    )


def test_frame_statistics_count_in_the_shake_alone():
    trace = make_trace(np.zeros((4, 3)))
    trace.contacts[:] = 1e3 * np.arange(len(FRAME_COLUMNS))
    trace.contacts[SETUP_FRAME_COUNT:, FRAME_COLUMNS.index("slide_m_s")] = (
        0.1,
        0.2,
        -0.03,
        0.03,
    )
    trace.contacts[SETUP_FRAME_COUNT:, FRAME_COLUMNS.index("loaded_count")] = (
        1.0,
        np.nan,
        3.0,
        8.0,
    )
    assert metrics.slide_mm(trace) == pytest.approx(300.0 / 60.0)
    assert metrics.shake_mean(trace, "loaded_count") == pytest.approx(4.0)


def test_a_grasp_is_summed_up_over_what_is_loaded_with_the_parameters_of_the_strongest():
    """Test four contacts: the first has no force, the third has the largest force, and
    the second is nearest to sliding.
    """
    force = np.array(
        [(0.0, 9.0, 9.0), (2.0, 0.6, 0.8), (10.0, 3.0, -4.0), (4.0, 0.0, 0.0)]
    )
    rows = ContactRows(
        frame=7,
        geom=np.full((4, 2), "pad"),
        distance_m=np.array([-9.0, -1.0, -2.0, -3.0]) * 1e-3,
        friction=np.array([0.1, 0.8, 1.0, 0.5]),
        solref=np.arange(8.0).reshape(4, 2),
        solreffriction=10.0 + np.arange(8.0).reshape(4, 2),
        solimp=np.arange(20.0).reshape(4, 5),
        dim=np.array([1, 3, 4, 6]),
        force_n=force,
        residual_m=1e-3
        * np.array(
            [(90.0, 90.0, 90.0), (-1.0, 0.2, 0.1), (0.5, -4.0, 3.0), (0.0, 0.0, 0.0)]
        ),
        velocity_m_s=1e-3
        * np.array(
            [(90.0, 90.0, 90.0), (0.1, 0.2, -6.0), (-7.0, 5.0, 3.0), (0.0, 0.0, 0.0)]
        ),
        reference_m_s2=np.zeros((4, 3)),
        slide_m_s=np.zeros(4),
    )
    found = metrics.grasp(rows)
    assert (found.row_count, found.loaded_row_count, found.dim) == (4, 3, 4)
    assert (found.normal_force_n, found.tangential_force_n) == pytest.approx(
        (16.0, 1.0 + 5.0)
    )
    assert found.cone_use == pytest.approx(1.0 / (0.8 * 2.0))
    assert found.penetration_mm == pytest.approx(2.0)
    assert found.stiffness_n_m == pytest.approx(
        (2.0 / 1e-3 + 10.0 / 2e-3 + 4.0 / 3e-3) / 3.0
    )
    assert (
        found.timeconst_s,
        found.dampratio,
        found.friction_timeconst_s,
        found.friction_dampratio,
    ) == (4, 5, 14, 15)
    assert (found.friction, found.dmin, found.dmax) == (1.0, 10.0, 11.0)
    assert (found.normal_residual_mm, found.friction_residual_mm) == pytest.approx(
        (1.0, 4.0)
    )
    assert found.normal_velocity_mm_s == pytest.approx(7.0)
