"""The kept poses: measured, written and read again, they say where the cube is in the grasp."""

import numpy as np
import pytest

from experiments.facts.kept import kept_run
from experiments.poses import HELD, SHAKEN
from measured_report.records.record import load_record, trace_path
from measured_report.records.traces import load_trace


@pytest.fixture(scope="module")
def kept(poses_path):
    """Row and poses of each case."""
    rows = load_record(poses_path).rows
    return {row["case"]: (row, load_trace(trace_path(poses_path, row["case"]))) for row in rows}


@pytest.mark.parametrize("case", [*SHAKEN, HELD], ids=lambda case: case.name)
def test_forward_kinematics_of_the_kept_poses_gives_the_kept_displacement(kept, case):
    row, poses = kept[case.name]
    assert row["failure"] is None
    run = kept_run(row, poses)
    start = run.shake_start
    moved = 1e3 * (run.cube_in_hand[start:, :3, 3] - run.begin_in_hand[:3, 3])
    np.testing.assert_allclose(moved, run.moved_mm[start:], atol=0.01)
    assert np.ptp(moved, axis=0).max() > 0.05
    assert run.slip_mm[-1] == pytest.approx(row["slip_mm"], abs=1e-4)
    assert run.time_s[-1] == pytest.approx(row["shake_duration_s"])
    assert 0.0 <= run.time_s[start] < 0.1
