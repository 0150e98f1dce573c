"""A hand that swings a capsule: the scene, what is measured of it, and the law that it is held against."""

import math
from dataclasses import replace

import mujoco
import numpy as np
import pytest

from experiments.scenes import hand
from experiments.scenes.hand import Grasp, Look, Swung, rate_s, swing
from experiments.simulation.mjcf_engines import Contacts, InC

PLAIN = Grasp("")
TOUCHED = Contacts(count=10, normal_n=100.0, softness_1_kg=0.005, damping_per_s=0.0, depth_m=0.0)


def test_the_closed_hand_touches_the_capsule_all_around_and_nothing_else():
    engine = InC(PLAIN.mjcf(0.002))
    model, [world] = engine.model, engine.worlds
    assert (model.nu, model.nv) == (17, 23)
    for pair in range(300):
        engine.command(hand.command((pair + 0.5) * 0.004)[None])
        engine.advance()
    capsule = model.ngeom - 1
    assert all(capsule in pair for pair in world.contact.geom)
    fingers = {model.body(model.geom_bodyid[geom]).name.split("_")[0] for geom in world.contact.geom.ravel()}
    assert fingers == {"finger0", "finger1", "finger2", "finger3", "thumb", "palm", "capsule"}
    assert engine.contacts().normal_n > 20.0 * hand.WEIGHT_N


def test_a_capsule_that_moves_with_the_hand_stays_in_its_place():
    engine = InC(PLAIN.mjcf(0.002))
    [world] = engine.worlds
    start = Look.at(engine)
    assert start.place_m == pytest.approx([0.0, 0.0, hand.RADIUS_M + hand.GAP_M])
    world.qpos[:2], world.qvel[0] = (0.5 * math.pi, math.pi), -3.0
    world.qpos[engine.free[0]] = 0.01, hand.REACH_M + 0.02, -0.03
    look = Look.at(engine)
    # A quarter turn takes outward to y, and upside down to the sides and down.
    assert look.place_m == pytest.approx([0.02, 0.01, 0.03])
    assert look.radius_m == pytest.approx(np.hypot(0.01, hand.REACH_M + 0.02))
    assert look.rate_rad_s == -3.0


@pytest.mark.parametrize(
    ("changes", "step_s"),
    [({}, 0.0005), ({}, 0.002), ({}, 0.008), ({"integrator": "RK4"}, 0.004), ({"timeconst_s": 0.02}, 0.008)],
)
def test_the_capsule_slips_by_the_law(changes, step_s):
    swung = swing(replace(PLAIN, **changes), step_s, 1.0, "cpu")
    assert swung.failure is None
    assert swung.slip_m == pytest.approx(swung.law_slip_m, rel=0.03)


def test_the_longest_step_that_holds_depends_on_what_the_rows_leave_out():
    assert swing(PLAIN, 0.014, 3.0, "cpu").failure is None
    assert swing(PLAIN, 0.016, 3.0, "cpu").failure == "dropped"
    cured = swing(replace(PLAIN, contact_bias=True), 0.016, 3.0, "cpu")
    assert cured.failure is None and cured.slip_m < 0.005
    assert mujoco.get_mjcb_control() is None, "which is one for all models"


def test_other_engines_slip_as_far():
    there, *others = (swing(Grasp("", engine), 0.008, 0.5, "cpu").slip_m for engine in ("c", "warp", "newton"))
    assert others == pytest.approx([there, there], rel=0.01)


def test_the_law_s_rate():
    # dmax of half of two steps, less half a step where the step is semi-implicit, and the load's share.
    load = hand.MASS_KG * TOUCHED.softness_1_kg * 0.95 * 0.008
    assert rate_s(PLAIN, 0.008, TOUCHED) == pytest.approx(0.45 * 0.008 + load)
    assert rate_s(replace(PLAIN, integrator="RK4"), 0.008, TOUCHED) == pytest.approx(0.95 * 0.008 + load)
    assert rate_s(replace(PLAIN, contact_bias=True), 0.008, TOUCHED) == pytest.approx(load)
    assert rate_s(replace(PLAIN, timeconst_s=0.02), 0.008, TOUCHED) > 0.0095 - 0.004
    assert math.isnan(rate_s(PLAIN, 0.008, replace(TOUCHED, count=0)))


def run_to(limit_ms: float):
    """A run that holds up to a step, and slips by the law in proportion to its logarithm."""

    def run(step_ms: float) -> Swung:
        law_m = hand.REACH_M * math.expm1(step_ms / limit_ms * math.log1p(hand.LOST_M / hand.REACH_M))
        return Swung(None if step_ms <= limit_ms else "dropped", law_m, law_m, hand.REACH_M, TOUCHED)

    return run


def test_the_largest_step_is_closed_in_upon_where_there_is_one():
    run = run_to(10.0)
    runs = {step: run(step) for step in (1.0, 4.0, 16.0, 64.0)}
    row = hand.largest_columns(runs, run, 0.01)
    assert row["largest_step_ms"] <= 10.0 < row["failing_step_ms"] <= 1.01 * row["largest_step_ms"]
    assert row["predicted_largest_step_ms"] == pytest.approx(10.0)
    for limit_ms, reason in ((0.5, "no step"), (100.0, "16 ms")):
        run = run_to(limit_ms)
        row = hand.largest_columns({step: run(step) for step in (1.0, 16.0)}, run, 0.01)
        assert row["largest_step_ms"] is None and reason in row["largest_step_ms_reason"]


def test_a_run_that_fails_has_no_slip():
    row = hand.run_columns(8.0, Swung("dropped", 0.1, 0.1, 0.5, TOUCHED))
    assert row["is_held"] is False and row["slip_mm"] is None and "8 ms" in row["slip_mm_reason"]
    row = hand.run_columns(8.0, Swung(None, 0.01, 0.02, 0.5, TOUCHED))
    assert row["is_held"] and (row["slip_mm"], row["predicted_slip_mm"]) == (10.0, 20.0)


def test_every_setting_is_one_of_its_own():
    settings = hand.SETTINGS
    assert len({grasp.name for grasp in settings}) == len({replace(grasp, name="") for grasp in settings})
