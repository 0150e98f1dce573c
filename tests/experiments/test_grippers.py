"""Test grasps with a gripper of two sliding fingers in place of a model of Menagerie."""

import numpy as np
import pytest

from experiments import grippers
from experiments.grippers import hands
from measured_report.files.errors import UsageError
from measured_report.measuring.measurement import Conditions

FINGER = """
<body name="{name}" pos="{x} 0 0.1">
  <joint name="{name}" type="slide" axis="{axis} 0 0" damping="20"/>
  <geom type="box" size="0.005 0.01 0.02" mass="0.1"/>
</body>"""
MODEL = f"""
<mujoco>
  <option cone="elliptic" impratio="10"/>
  <worldbody>
    <body name="palm">
      <geom type="box" size="0.05 0.02 0.01" mass="0.3"/>
      {FINGER.format(name="left", x=-0.04, axis=1)}
      {FINGER.format(name="right", x=0.04, axis=-1)}
    </body>
  </worldbody>
  <actuator>
    <position name="squeeze_left" joint="left" kp="500"/>
    <position name="squeeze_right" joint="right" kp="500"/>
  </actuator>
  <keyframe><key qpos="0 0"/></keyframe>
</mujoco>"""


@pytest.fixture
def hand(tmp_path, monkeypatch):
    """Return a hand whose model is in the cache of the package."""
    folder = tmp_path / "models" / "own-0123"
    folder.mkdir(parents=True)
    (folder / "own.xml").write_text(MODEL)
    (folder / ".complete").touch()
    monkeypatch.setenv("MENAGERIE_CACHE_DIR", str(tmp_path))
    closed = {"squeeze_left": 0.04, "squeeze_right": 0.04}
    return hands.Hand("own", "own", "0123", "own", (0.0, 0.0, -0.1), closed)


@pytest.mark.parametrize("kind", ["cube", "can"])
def test_a_hand_that_squeezes_holds_an_object_in_the_shake(hand, kind):
    held = grippers.hold(grippers.scene_of(hand, kind, "firm", 1.0), "c", "cpu")
    assert held["moved_mm"] < 1.0
    assert not held["dropped"]
    assert held["contact_count"] >= 4


def test_a_cup_is_wider_at_its_rim(hand):
    model = grippers.spec_of(hand, "cup", "published").compile()
    height_m, width_m = np.ptp(model.mesh_vert[:, [2, 0]], axis=0).tolist()
    assert sorted([height_m, width_m]) == pytest.approx([0.044, 0.06], rel=0.02)


def test_a_hand_that_does_not_close_drops_the_object(hand):
    limp = hands.Hand("own", "own", "0123", "own", (0.0, 0.0, -0.1), {})
    dropped = grippers.hold(grippers.scene_of(limp, "cube", "rule", 1.0), "c", "cpu")
    assert dropped["dropped"]
    assert dropped["moved_mm"] == 20.0


def test_the_base_follows_the_path_of_the_shake_test(hand):
    scene = grippers.scene_of(hand, "cube", "published", 1.0)
    shaken = np.asarray(scene.targets)[500:750, :3]
    assert shaken[:, 0].max() == pytest.approx(0.03, rel=1e-3)
    assert shaken[:, 1].max() == pytest.approx(0.65 * 0.03, rel=1e-3)
    assert not np.asarray(scene.targets)[:500, :3].any()


def test_a_model_that_cannot_be_downloaded_is_a_reason_and_no_error(
    tmp_path, monkeypatch
):
    def offline(name, requirements):
        raise UsageError(f"{name} cannot be installed: offline")

    monkeypatch.setenv("MENAGERIE_CACHE_DIR", str(tmp_path))
    monkeypatch.setattr(hands, "python_with", offline)
    quick = Conditions("cpu", quick=True)
    for row in grippers.rows_of(hands.HANDS[0], "cube", "published", quick):
        assert row["moved_mm"] is None
        assert row["moved_mm_reason"] == "menagerie cannot be installed: offline"
