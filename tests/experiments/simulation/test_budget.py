"""The parts of the slip, predicted and measured."""

from dataclasses import replace

import mujoco
import numpy as np
import pytest

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, Case
from experiments.simulation.budget import Motion, measure_motion, predicted_mm, softness
from experiments.simulation.limits import solref
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
BLOCK = """
<mujoco>
  <option timestep="0.001" cone="{cone}" impratio="{impratio}" integrator="implicitfast"/>
  <default><geom friction="1" solref="{solref}" solimp="0.7 {dmax} 0.0001 0.5 2"/></default>
  <worldbody>
    <geom type="plane" size="1 1 1"/>
    <body pos="0 0 0.019"><freejoint/><geom type="box" size="0.02 0.02 0.02" mass="20"/></body>
  </worldbody>
</mujoco>
"""
"""As the pads: deeper than their solimp is wide."""


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


def regularization(case: Case) -> tuple[float, float]:
    """R of a block at rest on a plane in MuJoCo's C engine, for a direction of friction, and how deep it lies [m]."""
    timeconst, dampratio = solref(case.pad_ke, case.pad_kd)
    model = mujoco.MjModel.from_xml_string(
        BLOCK.format(cone=case.cone, impratio=case.impratio, solref=f"{timeconst} {dampratio}", dmax=case.pad_dmax)
    )
    data = mujoco.MjData(model)
    for _ in range(3000):
        mujoco.mj_step(model, data)
    of_cone = case.cone == "elliptic"
    r = data.efc_R[[contact.efc_address + of_cone for contact in data.contact]].mean()
    # Two rows of a pyramid share a direction: b v = R f / (2 μ²), of a cone's row b v = R f.
    return r if of_cone else r / 2.0, float(np.mean([-contact.dist for contact in data.contact]))


@pytest.mark.parametrize(
    "changes",
    [{}, {"impratio": 400.0}, {"cone": "pyramidal"}, {"cone": "pyramidal", "impratio": 400.0}]
    + [{"pad_ke": 2.5e4, "pad_kd": 300.0}, {"pad_ke": 2.5e4}, {"pad_dmax": 0.9999}],
)
def test_how_soft_the_friction_rows_are(changes):
    """A pyramid is softer the less it lets pads sink in, and so are stiff pads."""
    case = replace(AS_SHIPPED, **changes)
    (r, _), (shipped, depth_m) = regularization(case), regularization(AS_SHIPPED)
    assert softness(case, AS_SHIPPED, depth_m) == pytest.approx(r / shipped, rel=0.03)
