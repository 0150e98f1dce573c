"""Compare the theory of runs with numbers computed by hand, and with accelerations that
are differences of the motion of target and hand.
"""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED
from experiments.facts.trace import FRAME_COLUMNS, Trace
from experiments.simulation import limits
from experiments.stability import families
from experiments.stability.families import BASE

G = 9.81


@pytest.mark.parametrize(("amplitude_m", "frequency_hz"), [(0.03, 1.0), (0.05, 2.5)])
def test_the_demand_is_the_largest_acceleration_of_the_target_along_the_pads(
    amplitude_m, frequency_hz
):
    time_s = np.linspace(0.0, 2.0 / frequency_hz, 20_001)
    angle = 2.0 * np.pi * frequency_hz * time_s
    ways = amplitude_m * np.sin(angle), 0.35 * amplitude_m * np.sin(1.5 * angle)
    x, z = (np.gradient(np.gradient(way, time_s), time_s)[2:-2] for way in ways)
    case = replace(
        AS_SHIPPED, shake_amplitude_m=amplitude_m, shake_frequency_hz=frequency_hz
    )
    assert limits.target_demand_m_s2(case) == pytest.approx(
        np.hypot(x, G + z).max(), rel=1e-4
    )


@pytest.mark.parametrize(("turn", "expected"), [(0.0, np.hypot(4.0, G)), (90.0, G)])
def test_the_demand_of_a_hand_leaves_out_what_its_pads_press(turn, expected):
    """Test a motion of 4 m/s² along x after a larger one.

    In the turned hand x is the direction in which the pads press.
    """
    dt, rate = 1e-3, 2.0 * np.pi
    time_s = dt * np.arange(5001)
    poses = np.zeros((len(time_s), 2, 7))
    poses[:, metrics.TCP, 0] = (
        np.where(time_s < 2.99, 9.0, 4.0) / rate**2 * np.sin(rate * time_s)
    )
    poses[:, metrics.TCP, 3:] = Rotation.from_euler("z", turn, degrees=True).as_quat()
    trace = Trace(
        dt,
        np.full(len(time_s), metrics.SHAKE),
        poses,
        np.zeros((len(time_s), len(FRAME_COLUMNS))),
    )
    assert limits.demand_m_s2(AS_SHIPPED, trace) == pytest.approx(expected, rel=1e-4)
    for frame, is_seen in (
        (2998, False),
        (2999, True),
    ):  # of the 2002 positions that 2000 accelerations need
        jerk = poses.copy()
        jerk[frame, metrics.TCP, 2] = 1.0
        assert (
            limits.demand_m_s2(AS_SHIPPED, replace(trace, poses=jerk)) > 1e5
        ) is is_seen


def test_loads_and_exits_are_as_by_hand():
    # 0.5 kg at 4 m/s² on pads that press with 10 N together: 2 N divided by μ · 10 N. A
    # μ below mjMINMU, 1e-5, counts as 1e-5.
    case = replace(AS_SHIPPED, cube_density_kg_m3=4000.0, cube_edge_m=0.05, pad_mu=0.25)
    assert limits.cube_mass_kg(case) == pytest.approx(0.5)
    assert limits.friction_load(case, 4.0, 10.0) == pytest.approx(0.8)
    assert limits.friction_load(replace(case, pad_mu=0.0), 4.0, 10.0) == pytest.approx(
        2e4
    )
    # From the ground: the mean of 2 / kd and kd / (2 √ke) of the cube, 2.5 ms and √2, and of the ground, 20 ms and 1.
    ground = replace(AS_SHIPPED, start_overlap_m=2e-3)
    root_k = 1.0 / (0.95 * 0.01125 * 0.5 * (1.0 + np.sqrt(2.0)))
    assert limits.exit_bound_m_s(ground) == pytest.approx(2e-3 * root_k)
    assert limits.reference_stiffness(0.01, 2.0, 0.02, 0.5) == pytest.approx(
        2500.0
    )  # 1 / (0.5 · 0.02 · 2)²
    assert limits.reference_stiffness(0.03, 2.0, 0.02, 0.5) == pytest.approx(
        1.0 / 0.03**2
    )
    assert limits.step_s(replace(AS_SHIPPED, substeps=5)) == pytest.approx(1.0 / 300.0)


def test_families_ask_for_the_forces_that_their_names_say():
    """Test a finger's drive of 400 N/m.

    The grip must press with twice m |a| / μ because it has two pads.
    """
    demand = limits.target_demand_m_s2(AS_SHIPPED)
    needed_n = 0.032 * demand / 0.1 / 2.0
    press_n = {
        probe.parameters["grip_ratio"]: 400.0
        * (0.02 + 2e-5 - probe.case.finger_closed_m)
        for probe in families.grips("full")
    }
    assert press_n == pytest.approx({ratio: ratio * needed_n for ratio in press_n})
    assert {probe.case.pad_mu for probe in families.grips("full")} == {0.1}
    # Two fingers carry twice the m |a| / μ that both need together, and one newton
    # more; the drives are limited to 100 N.
    assert families.carrying_force_n(2.0) == pytest.approx(2.0 * demand + 1.0)
    assert families.carrying_force_n(10.0) == 100.0
    for probe in families.masses("full"):
        mass = probe.parameters["cube_mass_kg"]
        assert limits.cube_mass_kg(probe.case) == pytest.approx(mass)
        force = 400.0 * (0.02002 - probe.case.finger_closed_m)
        assert force == pytest.approx(min(mass * demand + 1.0, 100.0))
    for probe in families.sizes("full"):
        edge, case = 1e-3 * probe.parameters["cube_edge_mm"], probe.case
        force = (
            12.008
            if probe.parameters["grip"] == "as-shipped"
            else 500.0 * edge**3 * demand + 1.0
        )
        assert case.cube_edge_m == pytest.approx(edge)
        assert 400.0 * (edge / 2.0 + 2e-5 - case.finger_closed_m) == pytest.approx(
            min(force, 100.0)
        )
    # Two pads at the shipped grip of 12 N each carry 1.4 times the weight of 32 g at
    # rest.
    load = limits.friction_load(
        replace(AS_SHIPPED, pad_mu=families.SHAKE_MU), G, 24.016
    )
    assert 1.0 / load == pytest.approx(1.43, abs=5e-3)


def test_grids_and_steps_have_the_damping_that_they_say():
    for probe in families.grids("full"):
        ke, kd = probe.case.pad_ke, probe.case.pad_kd
        assert kd == (
            100.0 if probe.family == "ke-kd-100" else pytest.approx(2.0 * np.sqrt(ke))
        )
        assert probe.parameters["clamped"] == (
            2.0 / kd < 2.0 / 60.0 / probe.case.substeps
        )
    assert {len(families.grids("full")), len(families.GRID_KE["full"])} == {400, 25}
    for probe in families.without_clamp("full"):
        timeconst_s, dampratio = (
            2.0 / probe.case.pad_kd,
            probe.case.pad_kd / 2.0 / np.sqrt(probe.case.pad_ke),
        )
        assert (timeconst_s * 960.0, dampratio) == pytest.approx(
            (probe.parameters["timeconst_steps"], 1.0)
        )
        assert probe.case.pad_direct != (not probe.case.refsafe)
    ladders = (
        families.STEPS,
        families.GRIPS,
        families.FRICTIONS,
        families.EDGES_M,
        families.OVERLAPS_M,
    )
    for ladder in (
        *(each["full"] for each in ladders),
        families.SHAKES["full"][:11],
        families.SHAKES["full"][11:],
    ):
        assert sorted(set(ladder)) == list(ladder)
    # 90 frames and the first one are 1.5 s of hold. The shake repeats after 2 s, which
    # are 120 frames and the first one.
    assert (families.HOLD_FRAME_COUNT, *families.SHAKE_FRAME_COUNT.values()) == (
        91,
        241,
        121,
    )
    assert [count - 92 for count in families.LONG_FRAME_COUNT.values()] == [
        600 * 60,
        6 * 60,
    ] and BASE.cube_in_hand
