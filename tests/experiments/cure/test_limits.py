"""The cure at the limits of the grasp, and over the map of shakes."""

import pytest

from experiments import envelope
from experiments.cure import SIDES, limits
from experiments.envelope import MAP_SIZE, map_cells
from experiments.facts.variants import BEST


@pytest.mark.parametrize("profile", ["full", "quick"])
def test_limits_try_each_run_in_each_variant_once(profile):
    names = [
        limits.case_of(probe, variant, 300).name for probe in limits.probes(profile) for variant in limits.VARIANTS
    ]
    assert len(set(names)) == len(names)
    best = limits.case_of(limits.probes(profile)[0], "best", 300)
    assert {name: getattr(best, name) for name in BEST} == BEST


def test_the_map_with_the_cure_is_that_of_the_envelope():
    sizes = [(case.shake_amplitude_m, case.shake_frequency_hz) for case in map_cells(SIDES, MAP_SIZE["quick"])]
    assert sizes * 2 == [
        (case.shake_amplitude_m, case.shake_frequency_hz) for case in map_cells(envelope.SIDES, MAP_SIZE["quick"])
    ]
    assert all(case.contact_bias for case in map_cells(SIDES, MAP_SIZE["quick"]))
