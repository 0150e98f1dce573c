"""A pinched capsule: what is set up, and the laws that it is held against."""

from dataclasses import replace

import pytest

from experiments.scenes.capsule import PAD_MASS_KG, Pinch, sink
from experiments.simulation.mjcf_engines import InC, ThroughNewton

RECIPE = Pinch("recipe")


def test_the_capsule_sinks_as_published_and_with_noslip_by_no_law():
    row = sink(RECIPE, 2.0, "cpu")
    assert row["creep_mm_s"] == pytest.approx(0.15499, rel=0.001)
    assert row["normal_force_n"] == pytest.approx(12.4, abs=0.1)
    assert row["loaded_contact_count"] == 4
    assert sink(replace(RECIPE, noslip_iterations=10), 0.1, "cpu")["predicted_creep_mm_s"] == 0.0


@pytest.mark.parametrize("changes", [{}, {"impratio": 100.0}, {"cone": "pyramidal", "impratio": 1.0}])
def test_a_capsule_within_the_pads_sinks_by_the_law_alone(changes):
    row = sink(replace(RECIPE, half_length_m=0.02, **changes), 0.2, "cpu")
    assert row["creep_mm_s"] == pytest.approx(row["predicted_creep_mm_s"], rel=1e-3)
    assert row["creep_mm_s"] == pytest.approx(row["forecast_creep_mm_s"], rel=1e-3)


def test_newton_sets_the_capsule_up_as_it_is_authored_but_for_the_pads_inverse_mass():
    plain, newton = InC(RECIPE.mjcf()).model, ThroughNewton(RECIPE.mjcf()).model
    for name in ("geom_solref", "geom_solimp", "geom_friction", "actuator_gainprm", "dof_damping", "body_mass"):
        assert getattr(newton, name) == pytest.approx(getattr(plain, name), rel=1e-5), name
    assert newton.opt.impratio == pytest.approx(plain.opt.impratio)
    assert plain.body_invweight0[1, 0] == pytest.approx(1.0 / PAD_MASS_KG)
    assert newton.body_invweight0[1, 0] == pytest.approx(1.0 / PAD_MASS_KG / 3.0)
