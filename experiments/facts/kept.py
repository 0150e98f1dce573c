"""A kept run of section poses with the poses of its links and its cube."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import pandas as pd

from experiments.facts.kinematics import link_poses, quaternion_matrices, read_joints
from measured_report.files.root import ROOT

DESCRIPTION = ROOT / "assets/fr3.urdf"
TCP = "fr3_hand_tcp"
JOINTS = (
    *(f"joint_{number}_rad" for number in range(1, 8)),
    "left_finger_m",
    "right_finger_m",
)
CUBE_PLACE = tuple(f"cube_{axis}_m" for axis in "xyz")
CUBE_TURN = tuple(f"cube_q{part}" for part in "xyzw")
MOVED = tuple(f"{axis}_mm" for axis in "xyz")


@dataclass(frozen=True)
class KeptRun:
    """The kept frames of a run.

    Poses are matrices in the world [m], shape [frames, 4, 4].
    """

    # time since the start of the shake, negative before, shape [frames]
    time_s: np.ndarray
    joints: np.ndarray  # positions of the joints [rad or m], shape [frames, 9]
    links: Mapping[str, np.ndarray]
    cube: np.ndarray
    cube_in_hand: np.ndarray  # pose of the cube in the TCP frame, shape [frames, 4, 4]
    moved_mm: np.ndarray
    """The stored displacement in the TCP frame since the start of the shake.

    It has the shape [frames, 3], and is NaN before the shake.
    """
    contact: Mapping[str, np.ndarray]
    """``normal_force_n``, ``tangential_force_n`` and ``penetration_mm``, all of shape
    [frames].
    """
    cube_edge_m: float
    # Time in the shake at which the cube leaves the grasp; None if it never does.
    left_grasp_s: float | None

    @property
    def slip_mm(self) -> np.ndarray:
        """Return the length of the displacement, shape [frames]. It is NaN before the
        shake.
        """
        return np.linalg.norm(self.moved_mm, axis=1)

    @property
    def shake_start(self) -> int:
        """Return the index of the first kept frame of the shake."""
        return int(np.argmax(np.isfinite(self.slip_mm)))

    @property
    def begin_in_hand(self) -> np.ndarray:
        """Return the cube's pose in the TCP frame at the start, shape [4, 4].

        The start of the shake need not be a kept frame.
        """
        pose = self.cube_in_hand[self.shake_start].copy()
        pose[:3, 3] -= 1e-3 * self.moved_mm[self.shake_start]
        return pose

    @property
    def start(self) -> np.ndarray:
        """Return the pose of the cube if it had not slipped during the shake.

        Shape [frames, 4, 4].
        """
        return self.links[TCP] @ self.begin_in_hand

    def in_grasp(self) -> np.ndarray:
        """Return whether the cube is still in the grasp, shape [frames]."""
        return self.time_s < (
            np.inf if self.left_grasp_s is None else self.left_grasp_s
        )


def kept_run(row: Mapping[str, Any], poses: pd.DataFrame) -> KeptRun:
    """Return the run that a row of section poses describes. Its trace is stored beside
    the record.
    """
    joints = poses[list(JOINTS)].to_numpy()
    links = link_poses(
        read_joints(DESCRIPTION),
        joints,
        np.array([row[f"base_{axis}_m"] for axis in "xyz"]),
    )
    cube = quaternion_matrices(
        poses[list(CUBE_PLACE)].to_numpy(), poses[list(CUBE_TURN)].to_numpy()
    )
    return KeptRun(
        time_s=poses["frame"].to_numpy() / row["frame_rate_hz"] - row["shake_start_s"],
        joints=joints,
        links=links,
        cube=cube,
        cube_in_hand=np.linalg.inv(links[TCP]) @ cube,
        moved_mm=poses[list(MOVED)].to_numpy(),
        contact={
            name: poses[name].to_numpy()
            for name in ("normal_force_n", "tangential_force_n", "penetration_mm")
        },
        cube_edge_m=row["cube_edge_m"],
        left_grasp_s=row["left_grasp_s"],
    )
