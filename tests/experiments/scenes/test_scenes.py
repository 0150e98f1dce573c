"""Other people's grasps: what is set up, what is measured of it, and the laws that it is held against."""

import math
from dataclasses import replace

import numpy as np
import pytest

from experiments import forecast, pick
from experiments.scenes import capsule, panda
from experiments.scenes.pick import OBJECTS, Pick, Picked, hold, shake
from experiments.scenes.slope import creep_mm_s
from experiments.simulation.c_warnings import RunFailed
from experiments.simulation.measurement import Conditions
from experiments.simulation.mjcf_engines import ENGINES, InC, ThroughNewton
from newton_lint.newton_models.compat import warp_has_noslip

RECIPE = capsule.Pinch("recipe")


def test_the_capsule_sinks_as_published_and_with_noslip_by_no_law():
    sinking = capsule.run(RECIPE, 2.0, "cpu")
    assert sinking.mean_m_s == pytest.approx(154.99e-6, rel=0.001)
    assert sinking.contacts.normal_n == pytest.approx(12.4, abs=0.1)
    assert sinking.contacts.count == 4
    case = replace(RECIPE, noslip_iterations=10)
    assert capsule.columns(case, capsule.run(case, 0.1, "cpu"))["predicted_creep_mm_s"] == 0.0


@pytest.mark.parametrize("changes", [{}, {"impratio": 100.0}, {"cone": "pyramidal", "impratio": 1.0}])
def test_a_capsule_within_the_pads_sinks_by_the_law_alone(changes):
    case = replace(RECIPE, half_length_m=0.02, **changes)
    row = capsule.columns(case, capsule.run(case, 0.2, "cpu"))
    assert row["creep_mm_s"] == pytest.approx(row["predicted_creep_mm_s"], rel=1e-3)
    assert row["creep_mm_s"] == pytest.approx(row["forecast_creep_mm_s"], rel=1e-3)


def test_newton_sets_the_capsule_up_as_it_is_authored_but_for_the_pads_inverse_mass():
    plain, newton = InC(RECIPE.mjcf()).model, ThroughNewton(RECIPE.mjcf()).model
    for name in ("geom_solref", "geom_solimp", "geom_friction", "actuator_gainprm", "dof_damping", "body_mass"):
        assert getattr(newton, name) == pytest.approx(getattr(plain, name), rel=1e-5), name
    assert newton.opt.impratio == pytest.approx(plain.opt.impratio)
    assert plain.body_invweight0[1, 0] == pytest.approx(1.0 / capsule.PAD_MASS_KG)
    assert newton.body_invweight0[1, 0] == pytest.approx(1.0 / capsule.PAD_MASS_KG / 3.0)


def test_newton_runs_no_noslip_that_the_file_asks_for_and_so_the_law_has_a_creep():
    if not warp_has_noslip():
        pytest.skip("the section measures no such run")
    case = replace(RECIPE, engine="newton", noslip_iterations=10)
    row = capsule.columns(case, capsule.run(case, 0.1, "cpu"))
    assert row["steady_creep_mm_s"] == pytest.approx(row["predicted_creep_mm_s"], rel=0.01)


def test_the_model_through_newton_has_the_step_that_it_runs_with():
    """b of its contacts is clamped to two of them."""
    mjcf = replace(RECIPE, timeconst_s=0.004).mjcf().replace('timestep="0.002"', 'timestep="0.003"')
    engines = [ENGINES[name](mjcf, 1, "cpu") for name in ("c", "newton")]
    for engine in engines:
        engine.command(np.array([[0.003, -0.003]]))
        for _ in range(20):
            engine.advance()
    there, through_newton = (engine.contacts().damping_per_s for engine in engines)
    assert through_newton == pytest.approx(there) and there == pytest.approx(2.0 / 0.95 / 0.006)


@pytest.mark.parametrize("name", ENGINES)
def test_a_run_that_blows_up_fails(name, tmp_path, monkeypatch):
    """MuJoCo's C engine would go on from the beginning."""
    monkeypatch.chdir(tmp_path)  # where it keeps a log of it
    engine = ENGINES[name](RECIPE.mjcf(), 1, "cpu")
    engine.advance()
    if name == "c":
        engine.worlds[0].qvel[0] = math.inf
    else:
        engine.data.qvel.fill_(math.inf)
    with pytest.raises(RunFailed):
        engine.advance()


def test_the_box_creeps_down_the_slope_as_predicted():
    for case in forecast.CASES[::4]:
        measured, predicted = creep_mm_s(case)
        assert measured == pytest.approx(predicted, rel=0.01), case.name


def test_the_panda_goes_where_it_is_told():
    assert panda.command(0.0) == pytest.approx([*panda.READY, panda.OPEN_M])
    assert panda.command(2.0) == pytest.approx([*panda.AT_OBJECT, panda.OPEN_M])
    assert panda.command(3.0) == pytest.approx([*panda.AT_OBJECT, 0.0])
    assert panda.command(9.0) == pytest.approx([*panda.LIFTED, 0.0])
    engine = InC(panda.mjcf(OBJECTS["cube"], ""))
    [world] = engine.worlds
    world.qpos[:7] = panda.AT_OBJECT
    engine.command(panda.command(2.0)[None])
    engine.advance()
    # With the fingers open around the cube, which lies on the floor.
    assert world.body("hand").xpos == pytest.approx([0.65, 0.0, 0.11], abs=0.02)


def test_the_ball_is_dropped_as_published_and_creeps_as_predicted():
    published = shake(Pick("", object="ball"), [0], 7.0, "cpu")
    assert published.lifted.all() and published.drop_s == pytest.approx([6.022], abs=0.2)
    elliptic = shake(Pick("", object="ball", cone="elliptic", impratio=10.0), [0], 7.0, "cpu")
    assert np.isnan(elliptic.drop_s).all()
    held = hold(Pick("", object="ball"))
    assert held.creep_m_s == pytest.approx(held.forecast_m_s, rel=0.05)
    assert 0.0 < held.margin_m < 2.0 * panda.PAD_HALF_SIZE_M[2]


def test_shakes_are_counted_or_have_a_reason(tmp_path, monkeypatch):
    row = pick.shake_columns(Picked(np.array([True, True, False]), np.array([5.0, np.nan, 4.0])))
    assert (row["lifted_count"], row["held_count"]) == (2, 1)
    assert (row["first_drop_s"], row["median_drop_s"], row["last_drop_s"]) == (4.0, 4.5, 5.0)
    row = pick.shake_columns(Picked(np.array([True]), np.array([np.nan])))
    assert row["median_drop_s"] is None and row["median_drop_s_reason"]
    monkeypatch.chdir(tmp_path)  # where MuJoCo keeps a log of it
    row = pick.shaken(Pick("", timestep_s=0.01, integrator="RK4"), Conditions("cpu", quick=True))
    assert row["held_count"] is row["lifted_count"] is row["median_drop_s"] is None
    assert "reset" in row["held_count_reason"]


def test_every_grasp_is_a_case_of_its_own():
    cases = pick.cases()
    assert len({case.name for case in cases}) == len({replace(case, name="") for case in cases}) == len(cases)
