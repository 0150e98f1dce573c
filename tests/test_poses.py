"""The kept poses: measured, written and read again, they say where the cube is in the grasp."""

import numpy as np
import pandas as pd
import pytest
from newton.viewer import ViewerNull

from experiments.measurement import Conditions
from experiments.poses import HELD, SHAKEN, measure
from experiments.replay import Replay
from experiments.scene import body_index
from report.kept import kept_run
from report.kinematics import quaternion_matrices
from report.records.traces import load_trace, trace_path, write_traces


@pytest.fixture(scope="module")
def kept(tmp_path_factory):
    """Row and poses of each case of a quick measurement, the poses as they come back from their file."""
    measurement = measure(Conditions(device="cpu", quick=True))
    record = tmp_path_factory.mktemp("results") / "poses.json"
    write_traces(record, {name: pd.DataFrame(table) for name, table in measurement.traces.items()})
    return {row["case"]: (row, load_trace(trace_path(record, row["case"]))) for row in measurement.rows}


@pytest.mark.parametrize("case", [*SHAKEN, HELD], ids=lambda case: case.name)
def test_forward_kinematics_of_the_kept_poses_gives_the_kept_displacement(kept, case):
    row, poses = kept[case.name]
    assert row["failure"] is None
    run = kept_run(row, poses)
    start = run.shake_start
    position = run.cube_in_hand[start:, :3, 3]
    # What is kept is zero in the first frame of the shake, which need not be one of those that are kept.
    moved = 1e3 * (position - position[0]) + run.moved_mm[start]
    np.testing.assert_allclose(moved, run.moved_mm[start:], atol=0.01)
    assert np.ptp(moved, axis=0).max() > 0.05
    assert run.slip_mm[-1] == pytest.approx(row["slip_mm"], abs=1e-4)
    assert run.time_s[-1] == pytest.approx(row["shake_duration_s"])
    assert 0.0 <= run.time_s[start] < 0.1


def test_which_frames_are_kept(kept):
    for row, poses in kept.values():
        step = 6 if row["case"] == HELD.name else 1
        assert row["kept_frame_step"] == step
        assert (np.diff(poses["frame"]) == step).all()
        assert poses["frame"].iloc[-1] == row["frame_count"] - 1
        assert poses["frame"].iloc[0] < step


def test_newton_shows_the_run_as_it_was_kept(kept):
    row, poses = kept["as-shipped"]
    replay = Replay(ViewerNull(num_frames=1), poses.tail(3))
    for _ in range(3):
        replay.step()
        replay.render()
    shown, run = replay.state_0.body_q.numpy(), kept_run(row, poses)
    for body in ("fr3_link4", "fr3_hand_tcp", "fr3_rightfinger"):
        position, quaternion = np.split(shown[None, body_index(replay.model, body)], [3], axis=1)
        np.testing.assert_allclose(run.links[body][-1], quaternion_matrices(position, quaternion)[0], atol=1e-5)
    np.testing.assert_allclose(run.cube[-1, :3, 3], shown[body_index(replay.model, "cube"), :3], atol=1e-6)
