"""The kept poses: measured, written and read again, they say where the cube is in the grasp."""

import newton
import numpy as np
import pytest
import warp as wp

from experiments.facts.case import AS_SHIPPED
from experiments.facts.kept import CUBE_PLACE, CUBE_TURN, JOINTS, kept_run
from experiments.facts.kinematics import quaternion_matrices
from experiments.poses import HELD, SHAKEN
from experiments.simulation.scene import body_index, build_scene
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


def test_newton_has_the_links_where_the_forward_kinematics_has_them(kept):
    row, poses = kept["as-shipped"]
    newton.use_coord_layout_targets = True
    model = build_scene([AS_SHIPPED], wp.get_device("cpu")).model
    state, run = model.state(), kept_run(row, poses)
    state.joint_q.assign(poses[[*JOINTS, *CUBE_PLACE, *CUBE_TURN]].to_numpy("float32")[-1])
    newton.eval_fk(model, state.joint_q, state.joint_qd, state)
    shown = state.body_q.numpy()
    for body in ("fr3_link4", "fr3_hand_tcp", "fr3_rightfinger"):
        position, quaternion = np.split(shown[None, body_index(model, body)], [3], axis=1)
        np.testing.assert_allclose(run.links[body][-1], quaternion_matrices(position, quaternion)[0], atol=1e-5)
    np.testing.assert_allclose(run.cube[-1, :3, 3], shown[body_index(model, "cube"), :3], atol=1e-6)
