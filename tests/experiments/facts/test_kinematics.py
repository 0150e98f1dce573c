"""Compare forward kinematics with SciPy's rotations, and test the poses of the cube in
a kept run.
"""

import numpy as np
import pandas as pd
import pytest
from scipy.spatial.transform import Rotation

from experiments.facts import kept, kinematics

URDF = """<robot name="two"><link name="base"/><link name="arm"/><link name="slide"/><link name="tool"/>
<joint name="a" type="revolute"><parent link="base"/><child link="arm"/>
  <origin xyz="0.1 0.2 0.3" rpy="0.4 -0.5 0.6"/><axis xyz="0 0.6 0.8"/></joint>
<joint name="b" type="prismatic"><parent link="arm"/><child link="slide"/>
  <origin xyz="0 0 1" rpy="0 0 0.5"/><axis xyz="0 1 0"/></joint>
<joint name="c" type="fixed"><parent link="slide"/><child link="tool"/><origin xyz="1 0 0" rpy="0 0 0"/></joint>
</robot>"""


def pose(turn: Rotation, place) -> np.ndarray:
    return np.block(
        [[turn.as_matrix(), np.array(place, dtype=float)[:, None]], [np.eye(4)[3:]]]
    )


def test_links_are_where_scipy_turns_them(tmp_path):
    (tmp_path / "robot.urdf").write_text(URDF)
    joints, base = (
        kinematics.read_joints(tmp_path / "robot.urdf"),
        np.array([1.0, -2.0, 3.0]),
    )
    found = kinematics.link_poses(joints, np.array([(0.7, 0.3), (-2.0, 0.1)]), base)
    for frame, (angle, way) in enumerate([(0.7, 0.3), (-2.0, 0.1)]):
        turned = Rotation.from_euler("xyz", (0.4, -0.5, 0.6)) * Rotation.from_rotvec(
            angle * np.array([0.0, 0.6, 0.8])
        )
        arm = pose(Rotation.identity(), base) @ pose(turned, (0.1, 0.2, 0.3))
        slide = (
            arm
            @ pose(Rotation.from_euler("z", 0.5), (0.0, 0.0, 1.0))
            @ pose(Rotation.identity(), (0.0, way, 0.0))
        )
        np.testing.assert_allclose(found["arm"][frame], arm, atol=1e-12)
        np.testing.assert_allclose(found["slide"][frame], slide, atol=1e-12)
        np.testing.assert_allclose(
            found["tool"][frame],
            slide @ pose(Rotation.identity(), (1, 0, 0)),
            atol=1e-12,
        )


def test_poses_of_quaternions_are_scipys():
    turns, places = (
        Rotation.random(5, random_state=3),
        np.random.default_rng(3).normal(size=(5, 3)),
    )
    found = kinematics.quaternion_matrices(places, turns.as_quat())
    expected = np.array(
        [pose(turn, place) for turn, place in zip(turns, places, strict=True)]
    )
    np.testing.assert_allclose(found, expected, atol=1e-12)


def test_a_kept_run_knows_when_the_shake_began_and_where_the_cube_would_be_had_it_not_moved():
    """Test frames 30 to 33 at 60 frames a second, with a shake that begins at frame
    31.5. The cube is turned by 90° about z.
    """
    frames = pd.DataFrame(
        {"frame": [30, 31, 32, 33], **{name: [0.0] * 4 for name in kept.JOINTS}}
    )
    for name, values in zip(
        kept.CUBE_PLACE, ((1.0, 1.1, 1.2, 1.3), [2.0] * 4, [3.0] * 4), strict=True
    ):
        frames[name] = values
    for name, value in zip(
        kept.CUBE_TURN, (0.0, 0.0, np.sqrt(0.5), np.sqrt(0.5)), strict=True
    ):
        frames[name] = value
    for name, values in zip(
        kept.MOVED,
        ((np.nan, np.nan, 3.0, 6.0), (np.nan, np.nan, 4.0, 8.0), [0.0] * 4),
        strict=True,
    ):
        frames[name] = values
    for name in ("normal_force_n", "tangential_force_n", "penetration_mm"):
        frames[name] = 1.0
    assert len(kept.JOINTS) == 9
    row = {
        "base_x_m": 0.5,
        "base_y_m": 0.0,
        "base_z_m": 0.0,
        "frame_rate_hz": 60,
        "shake_start_s": 31.5 / 60.0,
    }
    run = kept.kept_run(row | {"cube_edge_m": 0.04, "left_grasp_s": 1.0 / 60.0}, frames)
    assert run.time_s * 60.0 == pytest.approx([-1.5, -0.5, 0.5, 1.5])
    assert run.slip_mm[2:] == pytest.approx([5.0, 10.0]) and run.shake_start == 2
    assert run.in_grasp().tolist() == [True, True, True, False]
    cube = pose(Rotation.from_euler("z", 90.0, degrees=True), (1.2, 2.0, 3.0))
    hand = run.links[kept.TCP][0]  # the cube does not move
    began = np.linalg.inv(hand) @ cube
    began[:3, 3] -= (0.003, 0.004, 0.0)
    np.testing.assert_allclose(run.begin_in_hand, began, atol=1e-12)
    np.testing.assert_allclose(run.start[3], hand @ began, atol=1e-12)
