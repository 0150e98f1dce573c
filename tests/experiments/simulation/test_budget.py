"""The parts of the slip, predicted and measured."""

from dataclasses import replace

import numpy as np
import pytest

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED
from experiments.simulation.budget import Motion, measure_motion, predicted_mm
from experiments.simulation.simulation import simulate

SHORT = replace(AS_SHIPPED, cube_in_hand=True, frame_count=150)
"""The lift's time in the hand and 1 s of shake."""
H = 1.0 / 960.0
MOTION = Motion(
    bias_m_s=np.array([1.0, 0.5, -0.5]),
    damping_m_s=np.array([0.1, 0.0, 0.0]),
    load_m_s=np.array([0.0, 0.0, -0.02]),
    depth_m=2e-3,
    rounding_m=np.array([0.0, 0.0, 1e-4]),
    inverse_mass_1_kg=20.0,
)
"""Numbers to reckon with by hand."""


def test_the_parts_add_up_to_the_slip_through_c():
    motion = measure_motion(SHORT)
    cases = [replace(case, backend="mujoco") for case in (SHORT, replace(SHORT, contact_bias=True))]
    for case, trace in zip(cases, simulate(cases), strict=True):
        slip_mm = 1e3 * metrics.displacement(trace).vector_m[-1]
        predicted = sum(predicted_mm(replace(case, contacts="mujoco"), motion).values())
        assert predicted[[0, 2]] == pytest.approx(slip_mm[[0, 2]], abs=0.03)


def parts_mm(**changes) -> dict[str, np.ndarray]:
    return predicted_mm(replace(AS_SHIPPED, contacts="mujoco", **changes), MOTION)


def test_the_parts_are_as_by_hand_and_each_remedy_takes_its_own():
    inverse_b = 0.5 * 0.95 * 0.02
    parts = parts_mm()
    assert parts["left_out"] == pytest.approx([1e3 * inverse_b, 0.0, -500.0 * inverse_b])
    assert parts["step"] == pytest.approx([-500.0 * H, 0.0, 250.0 * H])
    assert parts["damping"] == pytest.approx([100.0 * inverse_b, 0.0, 0.0])
    assert parts["creep"] == pytest.approx([0.0, 0.0, 20.0 * inverse_b])
    assert parts["rounding"] == pytest.approx([0.0, 0.0, 0.1])
    assert not parts_mm(contact_bias=True)["left_out"].any()
    centred = parts_mm(contact_bias=True, bias_centred=True)
    assert centred["left_out"] + centred["step"] == pytest.approx(np.zeros(3), abs=1e-12)
    runge_kutta = parts_mm(integrator="rk4")
    assert not runge_kutta["step"].any() and not runge_kutta["damping"].any()
    assert not parts_mm(integrator="euler")["damping"].any()
    assert parts_mm(impratio=500.0)["creep"] == pytest.approx(0.1 * parts_mm()["creep"])
    assert not parts_mm(compensated=True)["rounding"].any()
