"""Test the scene with the term that friction rows leave out, in worlds of one batch and
in MuJoCo's C engine.
"""

from dataclasses import replace

import numpy as np
import pytest

from experiments.facts import metrics
from experiments.facts.case import LEAN
from experiments.simulation.reference import ENGINES_AGREE
from experiments.simulation.simulation import simulate

SHORT = replace(LEAN, cube_in_hand=True, frame_count=180, **ENGINES_AGREE)
"""Duration of the lift, in which the cube is in the hand, and of 1.5 s of shake."""
BIAS = replace(SHORT, name="term", contact_bias=True)


@pytest.fixture(scope="module")
def slips() -> dict[str, np.ndarray]:
    """Return the motion of the cube in the TCP frame [mm] in worlds of one batch and in
    C.
    """
    cases = [SHORT, BIAS, replace(BIAS, name="centred", bias_centred=True)]
    cases += [
        replace(case, name=f"{case.name}-c", backend="mujoco") for case in (SHORT, BIAS)
    ]
    traces = simulate(cases, device="cpu")
    return {
        case.name: 1e3 * metrics.displacement(trace).vector_m[-1]
        for case, trace in zip(cases, traces, strict=True)
    }


def test_each_world_has_the_term_that_its_case_asks_for_in_warp_as_in_c(slips):
    assert slips["lean"][0] > 0.5
    assert 0.08 < -slips["term"][0] < 0.16
    assert abs(slips["centred"][0]) < abs(slips["term"][0])
    for name in ("lean", "term"):
        assert slips[f"{name}-c"] == pytest.approx(slips[name], abs=0.02)
