"""A Panda's shake, and a box on a slope: what is set up, what is counted, and the law."""

from unittest.mock import Mock

import numpy as np
import pytest

from experiments.scenes import pick, slope
from experiments.scenes.pick import Pick, hold, shake
from experiments.simulation.c_warnings import RunFailed
from experiments.simulation.mjcf_engines import InC
from measured_report.measuring.measurement import Conditions


def test_the_box_creeps_down_the_slope_as_predicted():
    for case in slope.CASES[::4]:
        measured, predicted = slope.creep_mm_s(case)
        assert measured == pytest.approx(predicted, rel=0.01), case.name


def test_the_panda_goes_where_it_is_told():
    assert pick.command(0.0) == pytest.approx([*pick.READY, pick.OPEN_M])
    assert pick.command(2.0) == pytest.approx([*pick.AT_OBJECT, pick.OPEN_M])
    assert pick.command(3.0) == pytest.approx([*pick.AT_OBJECT, 0.0])
    assert pick.command(9.0) == pytest.approx([*pick.LIFTED, 0.0])
    engine = InC(Pick("").mjcf())
    [world] = engine.worlds
    world.qpos[:7] = pick.AT_OBJECT
    engine.command(pick.command(2.0)[None])
    engine.advance()
    # With the fingers open around the cube, which lies on the floor.
    assert world.body("hand").xpos == pytest.approx([0.65, 0.0, 0.11], abs=0.02)


def test_the_ball_is_dropped_as_published_and_creeps_as_predicted():
    lifted, drop_s = shake(Pick("", object="ball"), [0], 7.0, "cpu")
    assert lifted.all() and drop_s == pytest.approx([6.022], abs=0.2)
    _, drop_s = shake(Pick("", object="ball", cone="elliptic", impratio=10.0), [0], 7.0, "cpu")
    assert np.isnan(drop_s).all()
    row = hold(Pick("", object="ball"))
    assert row["creep_mm_s"] == pytest.approx(row["forecast_creep_mm_s"], rel=0.05)
    assert 0.0 < row["margin_mm"] < 2e3 * pick.PAD_HEIGHT_M


def test_shakes_are_counted_or_have_a_reason(monkeypatch):
    row = pick.shake_columns(np.array([True, True, False]), np.array([5.0, np.nan, 4.0]))
    assert (row["lifted_count"], row["held_count"]) == (2, 1)
    assert (row["first_drop_s"], row["median_drop_s"], row["last_drop_s"]) == (4.0, 4.5, 5.0)
    row = pick.shake_columns(np.array([True]), np.array([np.nan]))
    assert row["median_drop_s"] is None and row["median_drop_s_reason"]
    monkeypatch.setattr(pick, "shake", Mock(side_effect=RunFailed("reset")))
    row = pick.shaken(Pick(""), Conditions("cpu", quick=True))
    assert row["held_count"] is row["lifted_count"] is row["median_drop_s"] is None
    assert row["held_count_reason"] == "reset"
