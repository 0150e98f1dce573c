"""Test rows from the results of other engines, an engine that is missing, and Newton's
solvers.
"""

import math
import sys
from dataclasses import replace
from xml.etree import ElementTree

import numpy as np
import pytest

from experiments import engines
from experiments.drivers import engine
from experiments.drivers.scene import Scene, Trace
from experiments.engines import published, robot
from experiments.facts.trace import Trace as FrameTrace
from experiments.scenes.turntable import turntable
from experiments.simulation.measurement import Conditions
from measured_report.files.errors import UsageError


def shown(path) -> Trace:
    return Trace(np.asarray(path)[:, None])


def test_rows_of_what_an_engine_answers():
    """Test a box that grows by 1 %/s, a capsule that sinks by 2 mm/s, and runs that are
    lost, not finite or missing.
    """
    time_s = np.arange(41) * engines.SAMPLE_S
    walking = np.stack(
        [0.2 * np.exp(0.01 * time_s), 0.0 * time_s, 0.1 + 0.0 * time_s], axis=1
    )
    assert engines.columns("turntable", shown(walking)) == {
        "growth_per_s": pytest.approx(0.01)
    }
    sinking = np.stack([0.0 * time_s, 0.0 * time_s, -0.002 * time_s], axis=1)
    assert engines.columns("pinch", shown(sinking)) == {
        "creep_mm_s": pytest.approx(2.0)
    }
    falling = walking - np.outer(time_s, [0.0, 0.0, 0.01])
    for path, reason in (
        (falling, "not on the table"),
        (np.full((41, 3), np.nan), "not finite"),
    ):
        row = engines.columns("turntable", shown(path))
        assert row["growth_per_s"] is None and reason in row["growth_per_s_reason"]
    late = sinking * (
        time_s[:, None] > 3.95
    )  # only the last position, 8 mm down, shows it: 20 mm are allowed
    assert engines.columns("pinch", shown(2.4 * late))["creep_mm_s"] > 0.0
    assert (
        engines.columns("pinch", shown(2.6 * late))["creep_mm_s_reason"]
        == "the capsule is lost"
    )
    assert (
        engines.columns("pinch", "no such contact")["creep_mm_s_reason"]
        == "no such contact"
    )


def test_an_engine_that_cannot_be_installed_or_ends_is_a_reason_and_no_error(
    monkeypatch,
):
    def offline(name, requirements):
        raise UsageError(f"{name} cannot be installed: offline")

    scene = turntable(0.002, 0.1)
    monkeypatch.setattr(engine, "python_with", offline)
    assert (
        engine.run([scene] * 2, engines.DART)
        == ["engine-dart cannot be installed: offline"] * 2
    )
    monkeypatch.setattr(
        engine, "python_with", lambda *_: sys.executable
    )  # this Python does not have dartpy
    [reason] = engine.run([scene], engines.DART)
    assert "dartpy" in reason


QUICK = Conditions("cpu", quick=True)
SCRIPT = """
from apart import World

def load(scene):
    place = [0.0, 0.0, 0.0]

    def step(target):
        place[2] += 1 / target[0]

    return World(step, lambda: [place], lambda: [(3.0, 1.0, 1e-3), (4.0, -0.5, 2e-3)])
"""


def test_a_scene_is_sampled_after_its_steps_and_what_goes_wrong_in_it_leaves_the_others(
    tmp_path, monkeypatch
):
    (tmp_path / "world.py").write_text(SCRIPT)
    monkeypatch.setattr(engine, "python_with", lambda *_: sys.executable)
    own = engine.Engine("own", "", str(tmp_path / "world.py"), ())
    reason, trace = engine.run(
        [Scene(0.02, 0.1, [[number], [2.0]]) for number in (0, 1.0)], own
    )
    assert "division by zero" in reason
    assert trace.path_m[:, 2] == pytest.approx([0.0, 5.0, 7.5])
    assert trace.forces == pytest.approx(np.array([[7.0, 0.5, 2e-3]] * 2))


def test_the_critical_friction_is_the_weight_over_what_the_fingers_press_with(
    monkeypatch,
):
    """Test by hand that 350 N/m times half an edge are 7 N, and that an engine that
    cannot run the scene gives a reason.
    """
    row = published.hold(QUICK, published.in_c)
    assert row["critical_friction"] == pytest.approx(0.064 * 9.81 / 7.0, rel=0.01)
    monkeypatch.setattr(published, "run", lambda *_: ["offline"])
    with pytest.raises(ValueError, match="offline"):
        published.hold(QUICK, published.in_motrixsim)


def test_a_robot_whose_engine_has_no_armature_gets_it_with_its_links(tmp_path):
    masses = {}
    for armature in ("own", "links"):
        robot.write_robot(tmp_path / "robot.urdf", armature)
        links = ElementTree.parse(tmp_path / "robot.urdf").iter("link")
        parts = {link.get("name"): link.find("inertial") for link in links}
        masses[armature] = {
            name: (
                float(part.find("mass").get("value")),
                float(part.find("inertia").get("izz")),
            )
            for name, part in parts.items()
        }
    added = {
        name: np.subtract(links, masses["own"][name])
        for name, links in masses["links"].items()
    }
    assert added["fr3_link4"] == pytest.approx((0.0, 0.3))
    assert added["fr3_rightfinger"] == pytest.approx((0.15, 0.0))
    assert added["fr3_hand"] == pytest.approx((0.0, 0.0))


def test_rows_of_a_shake_that_an_engine_shows():
    """Test a cube that moves by 1 mm/s in the tool, a cube that is lost, and an engine
    that fails.
    """
    poses = np.tile([0.0, 0.0, 0.3, 0.0, 0.0, 0.0, 1.0], (301, 2, 1))
    frames = FrameTrace(1 / 60, np.full(301, 4), poses, np.empty(0))
    own = robot.Reference(replace(robot.WEIGHTLESS, name="3cm"), frames, np.empty(0))
    moved = poses.copy()
    moved[:, 0, 0] += 1e-3 * np.arange(301) / 60
    forces = np.array([[20.0, 5.0, math.nan]] * 301)
    found = Trace(
        np.concatenate([poses[:1], moved]), forces
    )  # the first pose is before the first frame
    row = robot.row_of("dart", "links", own, robot.traced(found, frames))
    names = ("case", "backend", "model", "shake", "armature")
    assert [row[name] for name in names] == [
        "dart-shake-3cm",
        "dart",
        "dart",
        "3cm",
        "links",
    ]
    numbers = [
        row[name]
        for name in (
            "slip_mm",
            "drift_mm_s",
            "creep_mm_per_cycle",
            "friction_share",
            "path_off_mm",
        )
    ]
    assert numbers == pytest.approx((5.0, 1.0, 1.0, 0.25, 0.0))
    assert row["penetration_mm"] is None and row["penetration_mm_reason"]
    found.poses[-1, 0, 2] = 0.02
    lost = robot.row_of("dart", "links", own, robot.traced(found, frames))
    assert (lost["slip_mm"], lost["dropped"], lost["slip_mm_reason"]) == (
        None,
        True,
        "the cube is lost",
    )
    assert (
        robot.row_of("dart", "links", own, "no such engine")["slip_mm_reason"]
        == "no such engine"
    )
