"""Test the limits by hand, and the extreme cases with the real engine."""

from dataclasses import replace

import numpy as np
import pytest

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED
from experiments.facts.classes import classify
from experiments.simulation import limits
from experiments.simulation.scene import CUBE_IN_HAND
from experiments.simulation.simulation import simulate
from experiments.stability.families import BASE, GRIP_MU, PADS, SHAKE_MU, closed_m
from report.sections.stability.claims import MU

STIFF = replace(BASE, **PADS["stiff"])


def test_the_limits_are_as_by_hand():
    assert limits.solref(2.5e3, 100.0) == pytest.approx((0.02, 1.0))
    # Two steps of 1/960 s are 2.083 ms, which is 2 / 960.
    assert limits.is_clamped(replace(BASE, pad_kd=961.0))
    assert not limits.is_clamped(replace(BASE, pad_kd=959.0))
    assert not limits.is_clamped(replace(BASE, pad_kd=961.0, refsafe=False))
    assert not limits.is_clamped(replace(BASE, pad_kd=961.0, pad_direct=True))
    still = replace(BASE, shake_amplitude_m=0.0)
    assert limits.target_demand_m_s2(still) == pytest.approx(9.81)
    # 32 g at 9.81 m/s² on two pads that press with 1.57 N together, with μ = 0.1: this
    # is twice the friction that they can carry.
    assert limits.friction_load(
        replace(still, pad_mu=0.1), 9.81, 1.5696
    ) == pytest.approx(2.0, rel=1e-4)
    # As shipped k = 1 / (0.95 * 0.02)², so an overlap of 1 mm gives a speed of 1e-3 /
    # 0.019 m/s.
    assert limits.exit_bound_m_s(replace(BASE, start_overlap_m=1e-3)) == pytest.approx(
        1e-3 / 0.019
    )
    # Two steps of 1/60 s are longer than the timeconst.
    slow = replace(BASE, start_overlap_m=1e-3, substeps=1)
    assert limits.exit_bound_m_s(slow) == pytest.approx(1e-3 / (0.95 / 30.0))
    assert closed_m(0.04, 12.008) == pytest.approx(AS_SHIPPED.finger_closed_m)
    assert MU == {"shake": SHAKE_MU, "grip": GRIP_MU}


@pytest.fixture(scope="module")
def extremes() -> dict[str, tuple]:
    """Run very different cases as worlds of one batch, with half a second of shake
    each.
    """
    changes = {
        "stiff": {},
        "frictionless": {"pad_mu": 0.0},
        "direct": {
            "pad_direct": True,
            "pad_ke": 960.0**2,
            "pad_kd": 2.0 * 960.0,
            "pad_kf": -1.0,
        },
        "unstable": {"pad_direct": True, "pad_ke": 1e8, "pad_kd": 2e4},
        "upward": {"gravity_m_s2": -9.81},
        "large": {"cube_edge_m": 0.08, "finger_closed_m": closed_m(0.08, 12.0)},
        "shifted": {"cube_offset_m": 5e-4},
    }
    cases = [
        replace(STIFF, name=name, frame_count=122, **change)
        for name, change in changes.items()
    ]
    traces = simulate(cases, device="cpu")
    assert {trace.world_count for trace in traces} == {len(cases)}
    return {case.name: (case, trace) for case, trace in zip(cases, traces, strict=True)}


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("stiff", "creeping"),
        ("frictionless", "dropped"),
        ("direct", "exploded"),
        ("unstable", "non-finite"),
    ]
    + [("upward", "creeping"), ("large", "creeping")],
)
def test_how_extreme_cases_end(extremes, name, expected):
    assert classify(*extremes[name], 1e-4) == expected


def test_a_cube_starts_in_the_hand_with_its_grip_and_weight(extremes):
    _, trace = extremes["stiff"]
    np.testing.assert_allclose(
        trace.poses[0, metrics.CUBE, :3], CUBE_IN_HAND, atol=2e-4
    )
    assert trace.column("normal_force_n")[2:9] == pytest.approx(24.0, abs=0.2)
    _, shifted = extremes["shifted"]
    assert shifted.poses[5, metrics.CUBE, 0] - trace.poses[
        5, metrics.CUBE, 0
    ] == pytest.approx(5e-4, abs=1e-5)
    _, trace = extremes["large"]
    fingers = trace.poses[60, 3:5, :3]
    assert np.linalg.norm(fingers[0] - fingers[1]) == pytest.approx(0.08, abs=1e-4)
    # 256 g need 2.5 N of friction, and 24 N of grip give μ times as much. The
    # tangential force is the weight.
    assert trace.column("tangential_force_n")[60] == pytest.approx(
        0.256 * 9.81, rel=0.02
    )
