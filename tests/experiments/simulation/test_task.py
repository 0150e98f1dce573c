"""Test the targets of hand and fingers in each phase by means of the task's kernels."""

import numpy as np
import pytest
import warp as wp
from scipy.spatial.transform import Rotation, Slerp

from experiments.simulation import task

CUBE, START, CLOSED_M = np.array([0.1, -0.4, 0.02]), np.array([0.3, 0.2, 0.5]), -0.01
TURN = Rotation.from_euler("xyz", (3.0, 0.2, 0.4))
DOWN = Rotation.from_quat((1.0, 0.0, 0.0, 0.0))
SECONDS = (0.25, 1.0, 0.75, 1.5)


def array(values, dtype=float):
    return wp.array(values, dtype=dtype, device="cpu")


def pose(place, turn=DOWN) -> wp.transform:
    return wp.transform(place, wp.quat(*turn.as_quat()))


def planned(phase: int, time_s: float, in_hand: bool = False):
    """Return position and rotation of the target, and the fingers' target, in the frame
    that ends at this time of a phase.
    """
    place, turn, finger = (
        array([(0.0, 0.0, 0.0)], wp.vec3),
        array([(0.0,) * 4], wp.vec4),
        array([0.0]),
    )
    inputs = [
        array([[pose(CUBE)]], wp.transform),
        0,
        array([pose(START, TURN)], wp.transform),
        array([phase], int),
    ]
    inputs += [
        array(SECONDS),
        array([0.05]),
        array([2.0]),
        array([in_hand], bool),
        array([CLOSED_M]),
    ]
    goal = array([wp.transform_identity()], wp.transform)
    outputs = [array([time_s - 1.0 / 60.0]), goal, place, turn, finger]
    wp.launch(task.set_targets, dim=1, inputs=inputs, outputs=outputs, device="cpu")
    return (
        place.numpy()[0],
        Rotation.from_quat(turn.numpy()[0]),
        finger.numpy()[0],
        goal.numpy()[0, :3],
    )


@pytest.mark.parametrize("share", [0.2, 0.7, 1.0, 1.4])
@pytest.mark.parametrize(
    ("phase", "goal", "end", "fingers"),
    [(0, CUBE + (0.0, 0.0, 0.1), DOWN, (0.035, 0.035)), (1, CUBE, DOWN, (0.035, 0.035))]
    + [
        (2, START, TURN, (0.035, -0.01)),
        (3, START + (0.0, 0.0, 0.2), TURN, (-0.01, -0.01)),
    ],
)
def test_each_phase_goes_to_its_goal_along_a_smooth_step(
    phase, goal, end, fingers, share
):
    """Test the smooth step 3 s² − 2 s³ in a phase, which is over at s = 1.4."""
    place, turn, finger, found = planned(phase, share * SECONDS[phase])
    s = np.polyval((-2.0, 3.0, 0.0, 0.0), min(share, 1.0))
    np.testing.assert_allclose(found, goal, atol=1e-6)
    np.testing.assert_allclose(place, START + s * (goal - START), atol=1e-6)
    assert (
        turn.inv() * Slerp((0.0, 1.0), Rotation.concatenate([TURN, end]))(s)
    ).magnitude() < 2e-3
    assert finger == pytest.approx(fingers[0] + s * (fingers[1] - fingers[0]), abs=1e-6)


def test_a_cube_in_the_hand_is_not_lifted_and_the_shake_is_three_sines_of_its_own_time():
    np.testing.assert_allclose(planned(3, 1.5, in_hand=True)[0], START, atol=1e-6)
    for time_s in (0.05, 0.3, 7.0):
        angle = 2.0 * np.pi * 2.0 * time_s
        way = 0.05 * np.array(
            [np.sin(angle), 0.65 * np.sin(2.0 * angle), 0.35 * np.sin(1.5 * angle)]
        )
        place, turn, finger, _ = planned(4, time_s)
        np.testing.assert_allclose(place, START + way, atol=2e-6)
        assert (turn.inv() * TURN).magnitude() < 1e-6 and finger == pytest.approx(
            CLOSED_M
        )


@pytest.mark.parametrize(
    ("off_m", "turned_deg", "time_s", "in_hand", "ends"),
    [
        (0.0049, 1.9, 1.0, False, True),
        (0.0051, 0.0, 1.0, False, False),
        (0.0, 2.1, 1.0, False, False),
    ]
    + [
        (0.0, 0.0, 0.99, False, False),
        (0.5, 40.0, 1.0, True, True),
        (0.0, -1.9, 1.5, False, True),
    ],
)
def test_a_phase_ends_when_its_time_is_up_and_the_hand_is_there(
    off_m, turned_deg, time_s, in_hand, ends
):
    """Test the limits of 5 mm and 2°.

    A cube that is in the hand from the start does not wait for them.
    """
    reached = pose(
        CUBE + (off_m, 0.0, 0.0),
        Rotation.from_euler("y", turned_deg, degrees=True) * DOWN,
    )
    phase, elapsed, start = (
        array([1], int),
        array([time_s]),
        array([wp.transform_identity()], wp.transform),
    )
    inputs = [
        array([[reached]], wp.transform),
        0,
        wp.transform_identity(),
        array(SECONDS),
        array([in_hand], bool),
    ]
    inputs += [
        array([pose(CUBE)], wp.transform),
        array([np.arange(9.0)]),
        array([0.02]),
    ]
    target = wp.zeros((1, 9), dtype=float, device="cpu")
    wp.launch(
        task.apply_targets,
        dim=1,
        inputs=inputs,
        outputs=[target, phase, elapsed, start],
        device="cpu",
    )
    assert (phase.numpy()[0], elapsed.numpy()[0]) == (
        (2, 0.0) if ends else (1, pytest.approx(time_s))
    )
    assert target.numpy()[0] == pytest.approx([*range(7), 0.02, 0.02])
    assert start.numpy()[0, 0] == pytest.approx(reached[0] if ends else 0.0)
