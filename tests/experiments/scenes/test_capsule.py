"""Test the setup of a pinched capsule, and the laws with which it is compared."""

from dataclasses import replace

import pytest

from experiments.scenes.capsule import Pinch, sink

RECIPE = Pinch("recipe")


def test_the_capsule_sinks_as_published_and_with_noslip_by_no_law():
    row = sink(RECIPE, 2.0, "cpu")
    assert row["creep_mm_s"] == pytest.approx(0.15499, rel=0.001)
    assert row["normal_force_n"] == pytest.approx(12.4, abs=0.1)
    assert row["loaded_contact_count"] == 4
    assert (
        sink(replace(RECIPE, noslip_iterations=10), 0.1, "cpu")["predicted_creep_mm_s"]
        == 0.0
    )


@pytest.mark.parametrize(
    "changes", [{}, {"impratio": 100.0}, {"cone": "pyramidal", "impratio": 1.0}]
)
def test_a_capsule_within_the_pads_sinks_by_the_law_alone(changes):
    row = sink(replace(RECIPE, half_length_m=0.02, **changes), 0.2, "cpu")
    assert row["creep_mm_s"] == pytest.approx(row["predicted_creep_mm_s"], rel=1e-3)
    assert row["creep_mm_s"] == pytest.approx(row["forecast_creep_mm_s"], rel=1e-3)
