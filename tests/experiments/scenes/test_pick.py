"""Test a Panda's shake and a box on a slope: the setup, the counts and the law."""

from dataclasses import replace

import pytest

from experiments.scenes import pick, slope
from experiments.scenes.pick import Pick, hold, shake, shake_controls


def test_the_box_creeps_down_the_slope_as_predicted():
    for case in slope.CASES[::4]:
        measured, predicted = slope.creep(case).values()
        assert measured == pytest.approx(predicted, rel=0.01), case.case


def test_the_ball_is_dropped_as_published_and_creeps_as_predicted():
    case = Pick("", object="ball")
    controls = shake_controls(case, "full")[:1750, :1]  # one shake, for 7 s
    row = shake(case, controls, "cpu")
    assert row["lifted_count"] == 1 and row["last_drop_s"] == pytest.approx(
        6.022, abs=0.2
    )
    row = shake(replace(case, cone="elliptic", impratio=10.0), controls, "cpu")
    assert row["held_count"] == 1 and row["last_drop_s"] is None
    row = hold(Pick("", object="ball"))
    assert row["creep_mm_s"] == pytest.approx(row["forecast_creep_mm_s"], rel=0.05)
    assert 0.0 < row["margin_mm"] < 2e3 * pick.PAD_HEIGHT_M
