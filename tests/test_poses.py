"""The kept poses: measured, written and read again, they say where the cube is in the grasp."""

import numpy as np
import pandas as pd
import pytest
import warp as wp
from newton.viewer import ViewerNull

from experiments.measurement import Conditions
from experiments.poses import CUBE_POSE, HELD, JOINTS, SHAKEN, measure
from experiments.replay import Replay
from experiments.scene import body_index
from report import ROOT
from report.kinematics import link_poses, quaternion_matrices, read_joints, relative_poses
from report.traces import load_trace, trace_path, write_traces

SHAKE = 4


@pytest.fixture(scope="module")
def kept(tmp_path_factory):
    """Row and poses of each case of a quick measurement, the poses as they come back from their file."""
    measurement = measure(Conditions(device="cpu", quick=True))
    record = tmp_path_factory.mktemp("results") / "poses.json"
    write_traces(record, {name: pd.DataFrame(table) for name, table in measurement.traces.items()})
    return {row["case"]: (row, load_trace(trace_path(record, row["case"]))) for row in measurement.rows}


def links_of(row, poses):
    base = np.array([row[f"base_{axis}_m"] for axis in "xyz"])
    return link_poses(read_joints(ROOT / "assets/fr3.urdf"), poses[list(JOINTS)].to_numpy(), base)


@pytest.mark.parametrize("case", [*SHAKEN, HELD], ids=lambda case: case.name)
def test_forward_kinematics_of_the_kept_poses_gives_the_kept_displacement(kept, case):
    row, poses = kept[case.name]
    assert row["failure"] is None
    pose = poses[list(CUBE_POSE)].to_numpy()
    cube = quaternion_matrices(pose[:, :3], pose[:, 3:])
    position = relative_poses(cube, links_of(row, poses)["fr3_hand_tcp"])[:, :3, 3]
    displacement = poses[["x_mm", "y_mm", "z_mm"]].to_numpy()
    # What is kept is zero in the first frame of the shake, which is none of the kept ones of a run that keeps few.
    shaken = np.flatnonzero(poses["phase"] == SHAKE)
    moved = 1e3 * (position[shaken] - position[shaken[0]]) + displacement[shaken[0]]
    np.testing.assert_allclose(moved, displacement[shaken], atol=0.01)
    assert np.linalg.norm(displacement[-1]) == pytest.approx(row["slip_mm"], abs=1e-4)
    assert np.isnan(displacement[: shaken[0]]).all()


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
    shown = replay.state_0.body_q.numpy()
    for body in ("fr3_link4", "fr3_hand_tcp", "fr3_rightfinger"):
        pose = links_of(row, poses.tail(1))[body][0]
        x, y, z, qx, qy, qz, qw = shown[body_index(replay.model, body)]
        np.testing.assert_allclose(
            pose, quaternion_matrices(np.array([[x, y, z]]), np.array([[qx, qy, qz, qw]]))[0], atol=1e-5
        )
    cube = wp.transform(*shown[body_index(replay.model, "cube")])
    np.testing.assert_allclose(cube.p, poses[["cube_x_m", "cube_y_m", "cube_z_m"]].iloc[-1], atol=1e-6)
