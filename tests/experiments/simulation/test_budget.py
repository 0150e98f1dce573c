"""Compare the predicted parts of the slip with the measured ones."""

from dataclasses import replace
from types import SimpleNamespace

import mujoco
import numpy as np
import pytest
from scipy.optimize import brentq

from experiments import drift_law
from experiments.drivers.contacts import Contacts
from experiments.drivers.mjcf import numbers
from experiments.drivers.mujoco_c import InC
from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, Case
from experiments.facts.trace import Trace
from experiments.simulation import budget
from experiments.simulation.budget import (
    Motion,
    balanced_depth_m,
    contact_timeconst_s,
    friction_timeconst_s,
    measure_motion,
    predicted_mm,
    softness,
)
from experiments.simulation.simulation import simulate

SHORT = replace(AS_SHIPPED, cube_in_hand=True, frame_count=150)
"""Duration of the lift, in which the cube is in the hand, and of 1 s of shake."""
H = 1.0 / 960.0
MOTION = Motion(
    bias_m_s=np.array([1.0, 0.5, -0.5]),
    damping_m_s=np.array([0.1, 0.0, 0.0]),
    load_m_s=np.array([0.0, 0.0, -0.02]),
    depth_m=2e-3,
    rounding_m=np.array([0.0, 0.0, 1e-4]),
    inverse_mass_1_kg=20.0,
)
"""Simple numbers for calculations by hand."""


def test_the_parts_add_up_to_the_slip_through_c():
    motion = measure_motion(SHORT)
    cases = [
        replace(case, backend="mujoco")
        for case in (SHORT, replace(SHORT, contact_bias=True))
    ]
    for case, trace in zip(cases, simulate(cases), strict=True):
        slip_mm = 1e3 * metrics.displacement(trace).vector_m[-1]
        predicted = sum(predicted_mm(replace(case, contacts="mujoco"), motion).values())
        assert predicted[[0, 2]] == pytest.approx(slip_mm[[0, 2]], abs=0.03)


def parts_mm(**changes) -> dict[str, np.ndarray]:
    return predicted_mm(replace(AS_SHIPPED, contacts="mujoco", **changes), MOTION)


def test_the_parts_are_as_by_hand_and_each_remedy_takes_its_own():
    inverse_b = 0.5 * 0.95 * 0.02
    parts = parts_mm()
    assert parts["left_out"] == pytest.approx(
        [1e3 * inverse_b, 0.0, -500.0 * inverse_b]
    )
    assert parts["step"] == pytest.approx([-500.0 * H, 0.0, 250.0 * H])
    assert parts["damping"] == pytest.approx([100.0 * inverse_b, 0.0, 0.0])
    assert parts["creep"] == pytest.approx([0.0, 0.0, 20.0 * inverse_b])
    assert parts["rounding"] == pytest.approx([0.0, 0.0, 0.1])
    assert not parts_mm(contact_bias=True)["left_out"].any()
    centred = parts_mm(contact_bias=True, bias_centred=True)
    assert centred["left_out"] + centred["step"] == pytest.approx(
        np.zeros(3), abs=1e-12
    )
    runge_kutta = parts_mm(integrator="rk4")
    assert not runge_kutta["step"].any() and not runge_kutta["damping"].any()
    assert not parts_mm(integrator="euler")["damping"].any()
    assert parts_mm(impratio=500.0)["creep"] == pytest.approx(0.1 * parts_mm()["creep"])
    assert not parts_mm(compensated=True)["rounding"].any()


def on_the_plane(case: Case) -> Contacts:
    """Return a model of MuJoCo's C engine: a box that rests on a plane on four feet, in
    the material of a case's pads.
    """
    timeconst_s, dampratio = 2.0 / case.pad_kd, case.pad_kd / 2.0 / np.sqrt(case.pad_ke)
    solimp = numbers([0.7, case.pad_dmax, 1e-4, 0.5, 2.0])
    material = f'solref="{timeconst_s} {dampratio}" solimp="{solimp}" friction="{case.pad_mu} 0 0"'
    engine = InC(f"""<mujoco><option timestep="{H}" cone="{case.cone}" impratio="{case.impratio}"/>
      <default><geom {material}/></default><worldbody><geom type="plane" size="1 1 1"/>
      <body pos="0 0 0.02"><freejoint/><geom type="box" size="0.02 0.02 0.02" mass="2"/></body></worldbody></mujoco>""")
    for _ in range(1000):
        engine.advance()
    return engine.contacts()


@pytest.mark.parametrize(
    "changes",
    [
        {"impratio": 400.0},
        {"pad_ke": 2.5e5, "pad_kd": 1e3},
        {"pad_ke": 2.5e4, "pad_kd": 300.0},
        {"pad_dmax": 0.99},
    ]
    + [{"cone": "pyramidal"}, {"cone": "pyramidal", "impratio": 1.0, "pad_mu": 0.6}],
    ids=lambda changes: "-".join(map(str, changes.values())),
)
def test_softness_is_the_engines_own_where_a_box_rests(changes):
    """Return R of MuJoCo's rows, as ``mj_makeImpedance`` computes it, of one case
    divided by R of another.
    """
    other, case = (
        replace(AS_SHIPPED, pad_mu=changes.get("pad_mu", 1.0)),
        replace(AS_SHIPPED, **changes),
    )
    soft, own = on_the_plane(other), on_the_plane(case)
    assert softness(case, other, soft.depth_m) == pytest.approx(
        own.softness_1_kg / soft.softness_1_kg, rel=1e-3
    )
    assert own.damping_per_s == pytest.approx(
        2.0 / (case.pad_dmax * contact_timeconst_s(case))
    )


def test_a_depth_balances_the_pull():
    """Solve d(r) r = p (1 - d) / d with SciPy, for d on a parabola from 0.7 to 0.95
    over 0.1 mm.
    """

    def impedance(depth_m: float) -> float:
        x = min(depth_m / 1e-4, 1.0)
        return 0.7 + 0.25 * (2.0 * x * x if x < 0.5 else 1.0 - 2.0 * (1.0 - x) ** 2)

    for pull_m in (1e-6, 1e-4, 4e-4, 1e-2):
        expected = brentq(
            lambda r, pull=pull_m: impedance(r) * r - pull * (1.0 / impedance(r) - 1.0),
            0.0,
            1.0,
        )
        assert balanced_depth_m((0.7, 0.95, 1e-4, 0.5, 2.0), pull_m) == pytest.approx(
            expected
        )


def test_friction_rows_have_a_timeconst_of_their_own_where_kf_is_read(monkeypatch):
    """Test twice 1 / (kf w s), with w = 20 1/kg and the share s = 0.05 / 50 + 0.95.

    The result is at least two steps.
    """
    monkeypatch.setattr(budget, "kf_is_read", lambda: True)
    case = replace(AS_SHIPPED, pad_kf=0.5)
    assert friction_timeconst_s(case, 20.0) == pytest.approx(2.0 / (0.5 * 20.0 * 0.951))
    assert friction_timeconst_s(AS_SHIPPED, 20.0) == pytest.approx(2.0 * H)
    for changes in (
        {"pad_kf": -1.0},
        {"pad_kf": 0.0},
        {"cone": "pyramidal"},
        {"contacts": "mujoco"},
    ):
        assert friction_timeconst_s(replace(case, **changes), 20.0) == pytest.approx(
            0.02
        )
    monkeypatch.setattr(budget, "kf_is_read", lambda: False)
    assert friction_timeconst_s(case, 20.0) == pytest.approx(0.02)


def test_a_step_adds_what_a_turning_hand_leaves_out_and_what_damping_in_the_step_takes():
    """Test a cube at rest, 0.5 m along x from a hinge with I = 2 kg m² and c = 4 N m s
    that turns at 3 rad/s; h = 10 ms. Relative to the hand the cube has J̇ q̇ = ω² r
    along x and the velocity -ω r along y. The acceleration of the joint is -c ω / I,
    but with the damping in the inertia it is -c ω / (I + h c).
    """
    model = mujoco.MjModel.from_xml_string("""<mujoco>
      <option timestep="0.01" integrator="implicitfast" gravity="0 0 0"/><worldbody>
      <body><joint axis="0 0 1" damping="4"/><inertial pos="0 0 0" mass="1" diaginertia="2 2 2"/></body>
      <body pos="0.5 0 0"><freejoint/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body>
      </worldbody></mujoco>""")
    run, data = object.__new__(budget.Watched), mujoco.MjData(model)
    run.hand, run.cube, run.cube_geom, run.axes, run.sums = (
        1,
        2,
        0,
        np.eye(3),
        np.zeros((4, 3)),
    )
    run.rate, run.jacobian = np.zeros((3, model.nv)), np.zeros((2, 3, model.nv))
    data.qvel[0] = 3.0
    run._step(mujoco.mj_step, model, data)
    after = 3.0 - 0.01 * 12.0 / 2.04
    assert run.sums[0] / 0.01 == pytest.approx([4.5, 0.0, 0.0])
    assert run.sums[1] / 0.01 == pytest.approx(
        [0.0, -0.5 * (12.0 / 2.0 - 12.0 / 2.04), 0.0]
    )
    assert run.sums[3] / 0.01 == pytest.approx([0.01 * 4.5, -0.5 * after, 0.0])


def test_the_load_is_the_mean_of_what_rows_yield_to_the_cube():
    """Test R f of 2 · (3, 1) and 2 · (1, -1) along y and z.

    In the second contact the cube is the first body, and a third contact is idle.
    """
    frame = np.eye(3).ravel()
    contacts = [(0, (5, 7)), (3, (7, 5)), (6, (5, 7)), (0, (5, 6)), (-1, (5, 7))]
    force, run = (
        np.array([9.0, 3.0, 1.0, 9.0, 1.0, -1.0, 0.0, 8.0, 8.0]),
        object.__new__(budget.Watched),
    )
    run.cube_geom, found = 7, []
    for depth, (row, geom) in enumerate(contacts):
        found.append(
            SimpleNamespace(
                efc_address=row,
                geom=geom,
                frame=frame,
                includemargin=0.5,
                dist=0.5 - depth,
            )
        )
    load = run._load(
        SimpleNamespace(contact=found, efc_force=force, efc_R=np.full(9, 2.0))
    )
    assert (
        load == pytest.approx([0.0, 0.5 * (6.0 - 2.0), 0.5 * (2.0 + 2.0)])
        and run.depth_m == 0.5
    )


class Sums(SimpleNamespace):
    """Return the sums of ``Watched`` for 2 frames before the shake and 61 frames of it,
    with the hand turned by 90° about z.
    """

    def __init__(self, _):
        poses = np.zeros((63, 2, 7))
        poses[:, metrics.TCP, 3:] = 0.0, 0.0, np.sqrt(0.5), np.sqrt(0.5)
        poses[-1, metrics.CUBE, 0] = 0.5  # along the hand's -y
        trace = Trace(1.0 / 60.0, np.array([3, 3, *[4] * 61]), poses, np.empty((63, 0)))
        frames = (
            np.tile(
                [[(0.0, -each, 0.0)] for each in (1.0, 2.0, 3.0, 4.0)], (63, 1, 1, 1)
            ).reshape(63, 4, 3)
            / 60.0
        )
        super().__init__(
            frames=frames, shaking=np.arange(2, 63), trace=trace, failure=None
        )
        self.depth_m, self.inverse_mass_1_kg = 1e-3, 20.0


def test_sums_count_from_the_end_of_the_first_frame_of_the_shake(monkeypatch):
    """Test 60 frames of 1/60 s each with 1, 2, 3 and 4 m/s along the hand's -y, and as
    slopes along the world's x.
    """
    monkeypatch.setattr(budget, "Watched", Sums)
    monkeypatch.setattr(drift_law, "Watched", Sums)
    motion = measure_motion(AS_SHIPPED)
    found = motion.bias_m_s, motion.damping_m_s, motion.load_m_s
    np.testing.assert_allclose(
        found, [(0.0, -each, 0.0) for each in (1.0, 2.0, 3.0)], atol=1e-12
    )
    np.testing.assert_allclose(
        motion.rounding_m, (0.0, -0.5 + 4.0 - 0.5 * H, 0.0), atol=1e-12
    )
    slopes = drift_law.measure_slopes(AS_SHIPPED)
    assert (slopes.left_out, slopes.damping, slopes.load) == pytest.approx(
        (1.0, 2.0, 3.0)
    )
