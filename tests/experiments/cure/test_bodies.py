"""Other bodies and contacts than a grasp."""

import numpy as np
import pytest

from experiments.cure import bodies


@pytest.fixture(scope="module")
def paths() -> dict[tuple[str, str, str], np.ndarray]:
    """Half a second on the plane through C."""
    return {
        (motion.name, motion.body, variant): bodies.run_in_c(motion, variant, seconds=0.5)
        for motion in bodies.MOTIONS
        if motion.name in ("roll", "pivot", "slide")
        for variant in bodies.VARIANTS
    }


def test_how_bodies_roll_spin_and_slide(paths):
    plain, term, exact = (paths["roll", "sphere", variant][-1] for variant in bodies.VARIANTS)
    assert plain[0] == pytest.approx(0.5 * bodies.SPEED_M_S, rel=2e-3)
    assert term == pytest.approx(plain, abs=1e-9)
    assert abs(plain[2] - exact[2]) < 1e-4
    plain, term, exact = (paths["pivot", "sphere", variant][-1] for variant in ("plain", "term", "exact"))
    assert abs(plain[1]) < 1e-9 and abs(term[1]) > 1e-3 and abs(exact[1]) < 1e-4
    far = bodies.SPEED_M_S**2 / (2.0 * bodies.FRICTION * bodies.GRAVITY)
    for variant in ("plain", "term"):
        assert paths["slide", "mesh", variant][-1][0] == pytest.approx(far, rel=0.08)
