"""Test differences between releases in the release that is installed."""

from dataclasses import replace

import pytest

from experiments.facts.case import AS_SHIPPED
from experiments.simulation.simulation import simulate
from experiments.upgrade import REFSAFE_TIMECONST_S, row_columns
from newton_lint.newton_models.compat import kf_is_read

GRASPED = 20
"""Frame in which the cube has settled in the grasp."""


@pytest.fixture(scope="module")
def rows() -> dict[str, dict[str, object]]:
    """Return the live contact rows of the grasp as the release computes them, and with
    a given timeconst of the friction rows.
    """
    short = replace(AS_SHIPPED, cube_in_hand=True, frame_count=GRASPED + 1)
    cases = [
        short,
        replace(short, name="kf-10", pad_kf=10.0),
        replace(short, name="kf-negative", pad_kf=-1.0),
    ]
    cases += [
        replace(short, name=name, friction_timeconst_override_s=s)
        for name, s in (("off", 0.0), ("on", 0.01))
    ]
    traces = simulate(cases, device="cpu", contact_frames=(GRASPED,))
    return {
        case.name: row_columns(trace.contact_rows[0])
        for case, trace in zip(cases, traces, strict=True)
    }


def damping_per_s(timeconst_s: float) -> float:
    """Compare with b = 2 / (dmax timeconst) from MuJoCo's documentation, "Computation",
    solver parameters.
    """
    return 2.0 / (0.95 * timeconst_s)


@pytest.mark.slow
def test_what_damps_the_friction_rows(rows):
    for name in ("off", "kf-negative"):
        assert rows[name]["friction_timeconst_s"] == 0.0
        assert rows[name]["timeconst_s"] == pytest.approx(0.02)
        assert rows[name]["friction_damping_per_s"] == pytest.approx(
            damping_per_s(0.02), rel=1e-4
        )
    assert rows["on"]["timeconst_s"] == pytest.approx(0.02)
    assert rows["on"]["friction_timeconst_s"] == pytest.approx(0.01)
    assert rows["on"]["friction_damping_per_s"] == pytest.approx(
        damping_per_s(0.01), rel=1e-4
    )
    timeconst = rows["kf-10"]["friction_timeconst_s"]
    assert (timeconst > REFSAFE_TIMECONST_S) == kf_is_read()
    assert rows["as-shipped"]["friction_timeconst_s"] == pytest.approx(
        timeconst / 100.0, rel=0.01
    )
    effective = (
        max(rows["as-shipped"]["friction_timeconst_s"], REFSAFE_TIMECONST_S)
        if kf_is_read()
        else 0.02
    )
    assert rows["as-shipped"]["friction_damping_per_s"] == pytest.approx(
        damping_per_s(effective), rel=1e-4
    )
