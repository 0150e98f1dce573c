"""Test the law of the drift."""

from dataclasses import replace

import numpy as np
import pytest

from experiments import drift_law, stiffness
from experiments.facts.case import AS_SHIPPED, STIFF_PADS

H = 1.0 / 960.0
SLOPES = drift_law.Slopes(
    left_out=0.06, damping=-0.001, load=-0.002, depth_m=1.87e-3, inverse_mass_1_kg=1e-9
)
"""Simple numbers for calculations by hand."""


NO_KF = {"pad_kf": -1.0}
"""Test that the friction rows have a response of their own if the release reads kf."""


def test_the_law_is_as_by_hand():
    found = drift_law.predicted_columns(replace(AS_SHIPPED, **NO_KF), SLOPES)
    assert found["response_s"] == pytest.approx(0.95 * 0.02)
    assert found["left_out_mm_s"] == pytest.approx(60.0 * 0.0095)
    assert found["step_mm_s"] == pytest.approx(-30.0 * H)
    assert found["predicted_drift_mm_s"] == pytest.approx(
        60.0 * 0.0095 - 30.0 * H - 0.0095 + 0.019
    )
    stiff = drift_law.predicted_columns(replace(STIFF_PADS, **NO_KF), SLOPES)
    assert stiff["response_s"] == pytest.approx(0.95 * 2.0 * H)
    soft, stiff = (
        drift_law.predicted_columns(replace(AS_SHIPPED, pad_ke=ke, **NO_KF), SLOPES)[
            "creep_mm_s"
        ]
        for ke in (2.5e3, 2.5e6)
    )
    assert stiff > 5.0 * soft > 0.0
    failed = replace(
        SLOPES, left_out=np.nan, failure="in MuJoCo C the shake was never reached"
    )
    found = drift_law.predicted_columns(AS_SHIPPED, failed)
    assert (
        found["predicted_drift_mm_s"] is None
        and found["predicted_drift_mm_s_reason"] == failed.failure
    )
    for case in stiffness.cases("full"):
        assert np.isfinite(
            drift_law.predicted_columns(case, SLOPES)["predicted_drift_mm_s"]
        )
