"""What stands around the cure: the law of the drift, its limits, other bodies, other solvers."""

from dataclasses import replace

import numpy as np
import pytest

from experiments import cure_bodies, cure_envelope, cure_limits, drift_law, stiffness
from experiments.cure import BEST
from experiments.envelope import MAP_SIZE, map_cells
from experiments.facts.case import AS_SHIPPED, STIFF_PADS

H = 1.0 / 960.0
SLOPES = drift_law.Slopes(left_out=0.06, damping=-0.001, load=-0.002, depth_m=1.87e-3, inverse_mass_1_kg=1e-9)
"""To reckon with by hand."""


NO_KF = {"pad_kf": -1.0}
"""Where the release reads kf, the friction rows have a response of their own."""


def test_the_law_is_as_by_hand():
    found = drift_law.predicted_columns(replace(AS_SHIPPED, **NO_KF), SLOPES)
    assert found["response_s"] == pytest.approx(0.95 * 0.02)
    assert found["left_out_mm_s"] == pytest.approx(60.0 * 0.0095)
    assert found["step_mm_s"] == pytest.approx(-30.0 * H)
    assert found["predicted_drift_mm_s"] == pytest.approx(60.0 * 0.0095 - 30.0 * H - 0.0095 + 0.019)
    stiff = drift_law.predicted_columns(replace(STIFF_PADS, **NO_KF), SLOPES)
    assert stiff["response_s"] == pytest.approx(0.95 * 2.0 * H)
    soft, stiff = (
        drift_law.predicted_columns(replace(AS_SHIPPED, pad_ke=ke, **NO_KF), SLOPES)["creep_mm_s"]
        for ke in (2.5e3, 2.5e6)
    )
    assert stiff > 5.0 * soft > 0.0
    failed = replace(SLOPES, left_out=np.nan, failure="in MuJoCo C the shake was never reached")
    found = drift_law.predicted_columns(AS_SHIPPED, failed)
    assert found["predicted_drift_mm_s"] is None and found["predicted_drift_mm_s_reason"] == failed.failure
    for case in stiffness.cases("full"):
        assert np.isfinite(drift_law.predicted_columns(case, SLOPES)["predicted_drift_mm_s"])


@pytest.mark.parametrize("profile", ["full", "quick"])
def test_limits_try_each_run_in_each_way_once(profile):
    names = [
        cure_limits.case_of(probe, way, 300).name for probe in cure_limits.probes(profile) for way in cure_limits.WAYS
    ]
    assert len(set(names)) == len(names)
    best = cure_limits.case_of(cure_limits.probes(profile)[0], "best", 300)
    assert {name: getattr(best, name) for name in BEST} == BEST


def test_the_map_with_the_cure_is_that_of_the_envelope():
    cells = map_cells(cure_envelope.SIDES, MAP_SIZE["quick"])
    places = [(case.shake_amplitude_m, case.shake_frequency_hz) for case in cells]
    half = len(cells) // 2
    assert places[:half] == places[half:] and len(set(places)) == half == MAP_SIZE["quick"] ** 2
    assert all(case.contact_bias for case in cells)


@pytest.fixture(scope="module")
def paths() -> dict[tuple[str, str, str], np.ndarray]:
    """Half a second on the plane through C."""
    return {
        (motion.name, motion.body, way): cure_bodies.run_in_c(motion, way, seconds=0.5)
        for motion in cure_bodies.MOTIONS
        if motion.name in ("roll", "pivot", "slide")
        for way in cure_bodies.WAYS
    }


def test_how_bodies_roll_spin_and_slide(paths):
    plain, term, full, exact = (paths["roll", "sphere", way][-1] for way in cure_bodies.WAYS)
    assert plain[0] == pytest.approx(0.5 * cure_bodies.SPEED_M_S, rel=2e-3)
    assert term == pytest.approx(plain, abs=1e-9)
    assert plain[2] - full[2] > 1e-3 and abs(plain[2] - exact[2]) < 1e-4
    plain, term, exact = (paths["pivot", "sphere", way][-1] for way in ("plain", "term", "exact"))
    assert abs(plain[1]) < 1e-9 and abs(term[1]) > 1e-3 and abs(exact[1]) < 1e-4
    far = cure_bodies.SPEED_M_S**2 / (2.0 * cure_bodies.FRICTION * cure_bodies.GRAVITY)
    for way in ("plain", "term"):
        assert paths["slide", "mesh", way][-1][0] == pytest.approx(far, rel=0.08)
