"""A kept run in Newton's viewer: the poses of a trace of section poses, frame by frame."""

from pathlib import Path

import newton
import pandas as pd
import warp as wp

from experiments.facts.case import AS_SHIPPED, CaseError
from experiments.poses import CUBE_POSE, JOINTS
from experiments.simulation.scene import build_scene
from experiments.simulation.task import FRAME_RATE
from measured_report.files.atomic import RecordError
from measured_report.records.traces import load_trace


class Replay:
    """What ``newton.examples.run`` drives in place of the simulation: one kept frame a step, and from the last one the
    first again."""

    def __init__(self, viewer, poses: pd.DataFrame):
        newton.use_coord_layout_targets = True
        self.viewer = viewer
        self.frames = poses["frame"].to_numpy()
        self.coordinates = poses[[*JOINTS, *CUBE_POSE]].to_numpy("float32")
        self.model = build_scene([AS_SHIPPED], wp.get_device()).model
        self.state_0 = self.model.state()
        self.index = -1
        viewer.set_model(self.model)

    def step(self) -> None:
        self.index = (self.index + 1) % len(self.frames)
        self.state_0.joint_q.assign(self.coordinates[self.index])
        newton.eval_fk(self.model, self.state_0.joint_q, self.state_0.joint_qd, self.state_0)

    def render(self) -> None:
        self.viewer.begin_frame(self.frames[self.index] / FRAME_RATE)
        self.viewer.log_state(self.state_0)
        self.viewer.end_frame()

    def test_final(self) -> None:
        """Return there is nothing to fail: what was kept is shown as it is."""


def load_poses(path: Path) -> pd.DataFrame:
    """Return the kept poses of a run; CaseError when the file holds none."""
    try:
        poses = load_trace(path)
    except RecordError as error:
        raise CaseError(f"--replay {path}: {error}") from None
    missing = [column for column in ("frame", *JOINTS, *CUBE_POSE) if column not in poses]
    if missing or poses.empty:
        raise CaseError(f"--replay {path} holds no poses, as results/newton-*/poses.*.csv.gz do")
    return poses
