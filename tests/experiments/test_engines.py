"""Other engines: rows of what an engine answers, an engine that is not there, and Newton's solvers."""

import json
import math
import subprocess
import sys
from dataclasses import replace
from xml.etree import ElementTree

import numpy as np
import pytest

from experiments import engines
from experiments.engines import engine, published, robot
from measured_report.files.errors import UsageError
from measured_report.files.root import ROOT


def test_rows_of_what_an_engine_answers():
    """A box that grows by 1 %/s, a capsule that sinks by 2 mm/s, and what is lost, not finite or not run."""
    time_s = np.arange(41) * engines.SAMPLE_S
    walking = np.stack([0.2 * np.exp(0.01 * time_s), 0.0 * time_s, 0.1 + 0.0 * time_s], axis=1)
    assert engines.growth_per_s({"path": walking.tolist()}) == pytest.approx(0.01)
    sinking = np.stack([0.0 * time_s, 0.0 * time_s, -0.002 * time_s], axis=1)
    assert engines.creep_mm_s({"path": sinking.tolist()}) == pytest.approx(2.0)
    falling = walking - np.outer(time_s, [0.0, 0.0, 0.01])
    for path, reason in ((falling, "not on the table"), (np.full((41, 3), np.nan), "not finite")):
        with pytest.raises(ValueError, match=reason):
            engines.growth_per_s({"path": path.tolist()})
    late = sinking * (time_s[:, None] > 3.95)  # the last place, 8 mm down, says it alone: 20 mm may be
    assert engines.creep_mm_s({"path": (2.4 * late).tolist()}) > 0.0
    with pytest.raises(ValueError, match="capsule is lost"):
        engines.creep_mm_s({"path": (2.6 * late).tolist()})
    with pytest.raises(ValueError, match="no such contact"):
        engines.creep_mm_s({"reason": "no such contact"})


def test_an_engine_that_cannot_be_installed_or_ends_is_a_reason_and_no_error(tmp_path, monkeypatch):
    def offline(name, requirements):
        raise UsageError(f"{name} cannot be installed: offline")

    monkeypatch.setattr(engine, "python_with", offline)
    assert engine.run_apart(engines.DART, [{}, {}]) == [{"reason": "engine-dart cannot be installed: offline"}] * 2
    monkeypatch.setattr(engine, "python_with", lambda *_: sys.executable)  # which has no dartpy
    [result] = engine.run_apart(engines.DART, [{}])
    assert "dartpy" in result["reason"]


def test_what_goes_wrong_in_one_run_leaves_the_others(tmp_path):
    asked = [{"scene": scene, "step_s": 0, "options": {}} for scene in (0, 2)]
    (tmp_path / "asked").write_text(json.dumps(asked))
    (tmp_path / "run.py").write_text("from apart import sampled\nrun = lambda scene, step_s: 1 / scene")
    places = [tmp_path / name for name in ("run.py", "asked", "answer")]
    subprocess.run([sys.executable, ROOT / engine.APART, *places], check=True)
    assert json.loads((tmp_path / "answer").read_text()) == [{"reason": "division by zero"}, 0.5]


def test_the_critical_friction_is_the_weight_over_what_the_fingers_press_with(monkeypatch):
    """By hand: 350 N/m times half an edge are 7 N; an engine that cannot run it is a reason."""
    shown = published.hold(published.in_c)
    assert shown["critical_friction"] == pytest.approx(0.064 * 9.81 / 7.0, rel=0.01)
    monkeypatch.setattr(published, "run_apart", lambda *_: [{"reason": "offline"}])
    with pytest.raises(ValueError, match="offline"):
        published.hold(published.in_motrixsim)


def test_a_robot_whose_engine_has_no_armature_gets_it_with_its_links(tmp_path):
    masses = {}
    for armature in ("own", "links"):
        robot.write_robot(tmp_path / "robot.urdf", armature)
        links = ElementTree.parse(tmp_path / "robot.urdf").iter("link")
        parts = {link.get("name"): link.find("inertial") for link in links}
        masses[armature] = {
            name: (float(part.find("mass").get("value")), float(part.find("inertia").get("izz")))
            for name, part in parts.items()
        }
    added = {name: np.subtract(links, masses["own"][name]) for name, links in masses["links"].items()}
    assert added["fr3_link4"] == pytest.approx((0.0, 0.3))
    assert added["fr3_rightfinger"] == pytest.approx((0.15, 0.0))
    assert added["fr3_hand"] == pytest.approx((0.0, 0.0))


def test_rows_of_a_shake_that_an_engine_shows():
    """A cube that moves by 1 mm/s in the tool, one that is lost, and an engine that fails."""
    case = replace(robot.WEIGHTLESS, name="shown")
    own = robot.Trace(1 / 60, np.full(301, 4), np.tile([0.0, 0.0, 0.3, 0.0, 0.0, 0.0, 1.0], (301, 2, 1)), np.empty(0))
    poses = own.poses.copy()
    poses[:, 0, 0] += 1e-3 * np.arange(301) / 60
    shown = {"poses": poses.tolist(), "forces": [[20.0, 5.0, math.nan]] * 301}
    row = robot.row_of(case, robot.traced(shown, own), own)
    numbers = [row[name] for name in ("slip_mm", "drift_mm_s", "creep_mm_per_cycle", "friction_share", "path_off_mm")]
    assert numbers == pytest.approx((5.0, 1.0, 1.0, 0.25, 0.0))
    assert row["penetration_mm"] is None and row["penetration_mm_reason"]
    poses[-1, 0, 2] = 0.02
    lost = robot.row_of(case, robot.traced(shown | {"poses": poses.tolist()}, own), own)
    assert (lost["slip_mm"], lost["dropped"], lost["slip_mm_reason"]) == (None, True, "the cube is lost")
    assert robot.row_of(case, "no such engine", own)["slip_mm_reason"] == "no such engine"
