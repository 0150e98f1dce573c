"""Test the motion of the hand, computed from recorded joint positions."""

import numpy as np
import pandas as pd
import pytest
from deriving import assert_found

from experiments.facts.kept import DESCRIPTION, JOINTS, TCP
from experiments.facts.kinematics import link_poses, read_joints
from experiments.facts.metrics import SHAKE


def test_a_hand_that_swings_about_the_base_moves_on_an_arc_about_it():
    """Test a hand that swings by 0.02 rad, twice in a second, about a vertical axis."""
    swing, turn = 0.02, 2 * np.pi * 2.0
    time_s = np.arange(304) / 50.0
    run = pd.DataFrame(0.0, index=range(len(time_s)), columns=list(JOINTS))
    place = link_poses(read_joints(DESCRIPTION), run.to_numpy()[:1], np.zeros(3))[TCP]
    radius = place[0, 0, 3]
    run["joint_1_rad"] = swing * np.sin(turn * time_s)
    run["phase"] = SHAKE
    cells = {"as-shipped": {"frame_rate_hz": 50.0, "shake_frequency_hz": 2.0}}
    expected = {
        "speed_squared": pytest.approx((radius * swing * turn) ** 2 / 2, rel=0.01),
        "arc": pytest.approx(radius, rel=0.01),
        "amplitude_across": pytest.approx(1e3 * radius * swing, rel=0.01),
        "rate_across": pytest.approx(2.0),
        "rate_along": pytest.approx(4.0),
        "amplitude_up": pytest.approx(0.0, abs=1e-9),
    }
    assert_found("poses", cells, frame=run, expected=expected)
