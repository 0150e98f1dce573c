"""Compare columns that sections compute from traces, paths and contacts with numbers
computed by hand, on synthetic runs.
"""

from dataclasses import replace
from types import SimpleNamespace

import mujoco
import numpy as np
import pytest
import warp as wp

from experiments import (
    contacts,
    error_runtime,
    hold,
    leave_out,
    newton_solvers,
    poses,
    stability,
    stiffness,
)
from experiments.cure import bodies, combinations, controls, turntable
from experiments.drivers.apart import apart
from experiments.drivers.contacts import Contacts
from experiments.drivers.scene import Trace as Shown
from experiments.engines import published, robot
from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED
from experiments.facts.trace import FRAME_COLUMNS, ContactRows, Trace
from experiments.leave_out.audit import Seen, _contact_items
from experiments.newton_solvers import box
from experiments.newton_solvers.stepper import weight_of_the_arm
from experiments.scenes import pick, slope
from experiments.scenes.pinch import pinch
from experiments.scenes.turntable import turntable as turning_box
from experiments.simulation.task import SHAKE

FRAME_RATE = 60
G = 9.81


def trace_of(cube_m, setup: int = 0, **columns) -> Trace:
    """Return a shake at 60 frames a second after some frames of setup.

    The hand is upright, and the cube is at these places relative to it.
    """
    cube_m = np.asarray(cube_m, dtype=float)
    where = np.tile([0.0, 0.0, 0.5, 0.0, 0.0, 0.0, 1.0], (len(cube_m), 6, 1))
    where[:, metrics.CUBE, :3] += cube_m
    statistics = np.zeros((len(cube_m), len(FRAME_COLUMNS)))
    for name, values in columns.items():
        statistics[:, FRAME_COLUMNS.index(name)] = values
    phase = np.where(np.arange(len(cube_m)) < setup, SHAKE - 1, SHAKE)
    return Trace(1.0 / FRAME_RATE, phase, where, statistics)


def along(axis: int, values) -> np.ndarray:
    return np.outer(values, np.eye(3)[axis])


# These columns belong to section stability.


def test_a_cube_leaves_with_the_speed_that_its_way_and_its_height_show():
    """Test a body that starts 2 mm deep in the ground: contact accelerates it to 1.2
    m/s upward. From the middle of a frame its speed is √(v² + 2 g h).
    """
    case = replace(AS_SHIPPED, start_overlap_m=2e-3)
    rises = 0.018 + 0.02 * np.arange(
        1, 31
    )  # 1.2 m/s from 18 mm on; contact ends at 20 mm
    trace = trace_of(np.zeros((30, 3)))
    trace.poses[:, metrics.CUBE, :3] = stability.cube_start(case)
    trace.poses[:, metrics.CUBE, 2] = rises
    trace.poses[20:, metrics.CUBE, 2] += 5.0  # outside of the 15 frames that count
    middle = 0.5 * (rises[14] + rises[13])
    assert stability.exit_speed_m_s(case, trace) == pytest.approx(
        np.sqrt(1.44 + 2.0 * G * (middle - 0.02))
    )
    held = replace(case, cube_in_hand=True)
    trace.poses[:, metrics.CUBE, :3] = stability.cube_start(held)
    trace.poses[2, metrics.CUBE, 2] -= (
        0.01  # from its start it moves down at 0.6 m/s, so no height is added
    )
    assert stability.exit_speed_m_s(held, trace) == pytest.approx(0.6)


def test_the_grip_is_that_at_the_end_of_the_hold_unless_the_cube_slides_out_of_it():
    """Test 91 frames of hold.

    The last frame but one and the nine before it count, and the cube may move by 5 mm.
    """
    force = np.where((np.arange(100) >= 80) & (np.arange(100) < 90), 24.0, 50.0)
    force[0], force[85] = 7.0, 99.0  # the median leaves this frame out
    for moved_m, grip_n in ((0.0049, 24.0), (0.0051, 7.0)):
        place = along(
            2,
            np.select(
                [np.arange(100) < 1, np.arange(100) > 50], [0.002, 0.002 + moved_m]
            ),
        )
        assert stability.grip_force_n(
            trace_of(place, 91, normal_force_n=force)
        ) == pytest.approx(grip_n)


def test_a_long_run_creeps_by_so_much_a_cycle_in_its_first_and_its_last_tenth():
    """Test 42 s at 1 Hz, which are 21 pairs of cycles.

    The first pair is left out, and a tenth of the others are two pairs; x = t³ mm with
    t in hours.
    """
    time_s = np.arange(42 * FRAME_RATE + 1) / FRAME_RATE
    columns = stability.long_columns(
        trace_of(along(0, 1e-6 * time_s**3)), AS_SHIPPED, "creeping"
    )
    first, last = (6.0**3 - 2.0**3) / 4.0, (42.0**3 - 38.0**3) / 4.0
    found = [columns[f"increment_{each}_mm_per_cycle"] for each in ("first", "last")]
    assert found == pytest.approx([1e-3 * first, 1e-3 * last]) and columns[
        "shake_duration_s"
    ] == pytest.approx(42.0)
    table = stability.long_table(trace_of(np.outer(1e-3 * time_s, (2.0, 1.0, 0.0))))
    assert table["y_mm"] == pytest.approx(np.arange(43.0)) and table[
        "along_mm"
    ] == pytest.approx(2.0 * np.arange(43.0))


def test_of_repeats_the_worst_counts_and_their_spread_is_the_floor():
    assert stability.creep_floor_mm_s([(1.0, 1.5), (4.0, 4.2, 4.9)]) == pytest.approx(
        0.9
    )
    rows = [
        {"class": each, "creep_mm_s": creep}
        for each, creep in (("holding", 9.0), ("creeping", 1.0), ("creeping", 3.0))
    ]
    run = SimpleNamespace(case=AS_SHIPPED, family="steps", parameters={})
    worst = stability.worst(run, rows)
    assert (worst["creep_mm_s"], worst["classes"]) == (
        3.0,
        "creeping, creeping, holding",
    )


def test_what_is_observed_of_a_run_is_in_millimetres_and_as_a_share_of_what_friction_carries():
    case = replace(AS_SHIPPED, cube_in_hand=True, pad_mu=0.5, shake_amplitude_m=0.0)
    trace = trace_of(np.zeros((400, 3)), 91, normal_force_n=24.0, penetration_m=2e-3)
    row = stability.observe(case, trace, 0.0)
    assert (row["class"], row["penetration_mm"], row["step_ms"]) == (
        "holding",
        pytest.approx(2.0),
        pytest.approx(1e3 / 960),
    )
    assert row["load"] == pytest.approx(0.032 * G / (0.5 * 24.0))


# These columns belong to sections hold, poses, contacts, stiffness, error_runtime and
# leave_out.


def test_a_held_cube_creeps_down_the_tool_and_by_so_much_in_its_last_second():
    time_s = np.arange(3 * FRAME_RATE + 20) / FRAME_RATE
    place = along(2, 1e-3 * (2.0 * time_s + time_s**2))
    row = hold.creep(trace_of(place))
    assert row["creep_z_mm_s"] == pytest.approx(
        np.polyfit(time_s, 1e3 * place[:, 2], 1)[0]
    )
    assert row["increment_final_mm"] == pytest.approx(2.0 + 9.0 - 4.0)
    assert hold.creep(trace_of(-place))["increment_final_mm"] == pytest.approx(
        7.0
    )  # in the direction of its end
    assert hold.creep(trace_of(place[:60]))["creep_z_mm_s"] is None
    assert hold.LONG_FRAME_COUNT - hold.SETUP_FRAME_COUNT - 1 == 60 * FRAME_RATE


def test_a_cube_has_left_the_grasp_when_it_is_8_cm_away_and_every_sixth_frame_is_kept():
    way = np.where(np.arange(62) < 40, 0.0799, 0.0801)
    trace = trace_of(
        along(0, way), 10, penetration_m=1e-3, normal_force_n=np.arange(62.0)
    )
    assert poses.left_grasp(trace)["left_grasp_s"] == pytest.approx(30.0 / FRAME_RATE)
    stays = poses.left_grasp(trace_of(along(0, way[:40])))
    assert stays == {
        "left_grasp_s": None,
        "left_grasp_s_reason": "the cube stays in the grasp",
    }
    table = poses.pose_table(
        trace, np.tile(np.arange(62.0)[:, None], (1, len(poses.COORDINATES))), 6
    )
    assert table["frame"].tolist() == [1, 7, 13, 19, 25, 31, 37, 43, 49, 55, 61]
    assert np.isnan(table["x_mm"][:2]).all() and table["x_mm"][2:] == pytest.approx(
        [0.0] * 5 + [0.2] * 4
    )
    assert table["penetration_mm"] == pytest.approx(1.0) and table[
        "normal_force_n"
    ] == pytest.approx(table["frame"])
    assert table[poses.COORDINATES[0]] == pytest.approx(table["frame"])


def test_rows_of_the_strongest_contact_are_in_millimetres():
    force = np.array([(1.0, 9.0, 9.0), (2.0, 0.3, -0.4)])
    arrays = {
        "residual_m": 1e-3 * force,
        "velocity_m_s": 2e-3 * force,
        "reference_m_s2": force,
        "force_n": force,
    }
    arrays |= {
        "distance_m": np.array([1e-3, -2e-3]),
        "slide_m_s": np.array([0.1, 0.2]),
        "friction": np.ones(2),
    }
    arrays |= {
        "solref": np.array([(3.0, 4.0), (5.0, 6.0)]),
        "solreffriction": force[:, :2],
        "dim": np.ones(2),
    }
    rows = ContactRows(
        frame=3, geom=np.full((2, 2), "pad"), solimp=np.zeros((2, 5)), **arrays
    )
    found = contacts.constraint_rows("case", rows)
    assert [row["force_n"] for row in found] == [2.0, 0.3, -0.4]
    assert [row["residual_mm"] for row in found] == pytest.approx([2.0, 0.3, -0.4])
    assert [row["velocity_mm_s"] for row in found] == pytest.approx([4.0, 0.6, -0.8])
    table = contacts.contact_table(rows)
    assert (
        table["distance_mm"][1],
        table["slide_mm_s"][1],
        table["tangential_force_n"][1],
    ) == pytest.approx((-2, 200, 0.5))
    assert (table["timeconst_s"][1], table["dampratio"][1]) == (5.0, 6.0)


def test_the_term_predicts_a_slide_of_its_sum_over_b(monkeypatch):
    """Test 2 m/s² for 4 s after the setup, multiplied by 1/b, with b = 2 / (0.95 · 20
    ms).
    """
    count, end = contacts.TWO_PERIODS_FRAME_COUNT, 241
    trace = trace_of(np.zeros((count, 3)), count - end, slide_m_s=0.1)
    monkeypatch.setattr(contacts, "_in_c", lambda _: SimpleNamespace(step=lambda: None))
    monkeypatch.setattr(contacts, "_trace", lambda _: trace)
    monkeypatch.setattr(contacts, "mean_along_shake_m_s2", lambda _: 2.0)
    row = contacts.predicted_row(AS_SHIPPED)
    assert row["predicted_slide_mm"] == pytest.approx(2e3 * 0.0095 * end / FRAME_RATE)
    assert row["slide_mm"] == pytest.approx(1e2 * end / FRAME_RATE)


def test_what_rows_leave_out_along_the_shake_is_the_mean_of_what_is_loaded(monkeypatch):
    """Test a mean of 2 and -4; in the second contact the cube is the first body.

    Contacts that are idle, ignored by the solver or without the cube do not count.
    """
    rows, geoms = (0, 2, 4, -1, 6), ((5, 7), (7, 5), (5, 7), (5, 7), (5, 6))
    found = [
        SimpleNamespace(efc_address=row, geom=geom)
        for row, geom in zip(rows, geoms, strict=True)
    ]
    values = dict(zip(map(id, found), (2.0, 4.0, 90.0, 90.0, 90.0), strict=True))
    monkeypatch.setattr(
        contacts,
        "velocity_product",
        lambda _, __, each: (np.array([values[id(each)], 9, 9]), None),
    )
    monkeypatch.setattr(contacts, "_at_end_of_step", lambda *_: None)
    data = SimpleNamespace(
        contact=found, efc_force=np.array([1.0, 0, 1.0, 0, 0, 0, 1.0, 0, 0, 1.0])
    )
    simulation = SimpleNamespace(solver=SimpleNamespace(mj_model=None, mj_data=data))
    simulation.recorder = SimpleNamespace(cube_geom=7)
    assert contacts.mean_along_shake_m_s2(simulation) == pytest.approx(
        (2.0 - 4.0) / 2.0
    )


def test_swept_pads_are_critically_damped_or_have_the_default_damping():
    swept = [case for case in stiffness.cases("full") if case.name.startswith("sweep")]
    ratios = {
        case.name.endswith("kd-100"): case.pad_kd / 2.0 / case.pad_ke**0.5
        for case in swept
    }
    assert ratios[False] == pytest.approx(1.0) and len(swept) == 80
    assert {case.pad_kd for case in swept if case.name.endswith("kd-100")} == {100.0}
    for case in stiffness.cases("quick")[:4]:
        assert case.pad_kd / 2.0 / case.pad_ke**0.5 == pytest.approx(1.0, abs=0.06)


def test_runs_are_apart_and_slip_by_so_much():
    time_s = np.arange(181) / FRAME_RATE
    still, moved = (
        trace_of(np.zeros((181, 3))),
        trace_of(along(0, 3e-3 * time_s) + along(1, np.full(181, 4e-3))),
    )
    row = error_runtime.errors(moved, still)
    assert row["grasp_error_mm_per_cycle"] == pytest.approx(3.0)
    assert row["numerical_error_mm"] == pytest.approx(
        np.sqrt(16.0 + 9.0 * np.mean(time_s**2))
    )
    shake = SimpleNamespace(pad_timeconst_s=0.02)
    point = error_runtime.settings("quick", cpu_too=False)[0]
    row = error_runtime.describe(
        replace(point, case=replace(point.case, substeps=4)), still, shake
    )
    assert (row["substep_ms"], row["timeconst_ms"]) == pytest.approx(
        (1e3 / 240.0, 20.0)
    )
    assert (
        leave_out.mean_slip(
            [{"failure": None, "slip_mm": each} for each in (1.0, 2.0, 6.0)]
        )["slip_mm"]
        == 3.0
    )


def test_an_audit_counts_what_is_used():
    """Test memory for 10 contacts and 40 rows in each world.

    At most 4 and 30 of them are used, so three quarters of the memory are used.
    """
    seen = Seen(
        contact_counts=[2, 4],
        loaded_counts=[1, 2],
        peaks={"nefc": 30, "nl": 1, "ne": 0},
    )
    held = SimpleNamespace(one=wp.zeros(100, dtype=float, device="cpu"))
    data = SimpleNamespace(
        naconmax=20, nworld=2, njmax=40, contact=held, efc=SimpleNamespace()
    )
    scene = SimpleNamespace(solver=SimpleNamespace(mjw_data=data), contacts=None)
    found = [(item.present, item.used) for item in _contact_items(scene, seen)]
    assert found == [(3.0, 1.5), (10, 4), (40, 30), (200, 150.0)]
    arrays = {
        "nacon": [4],
        "nefc": [31],
        "nl": [0],
        "ne": [2],
        "actuator_force": [[0.0, 3.0]],
    }
    arrays |= {"ten_length": [[1.0]], "sensordata": [[1.0]], "worldid": [0, 0, 1, 0, 0]}
    arrays |= {
        "geom": [[1, 0], [0, 2], [2, 2], [1, 2], [0, 0]],
        "efc_address": [[0], [1], [0], [-1], [0]],
    }
    shown = {
        name: SimpleNamespace(numpy=lambda each=each: np.array(each))
        for name, each in arrays.items()
    }
    efc = SimpleNamespace(force=SimpleNamespace(numpy=lambda: np.array([[5.0, 0.0]])))
    data = SimpleNamespace(
        naconmax=20, contact=SimpleNamespace(**shown), efc=efc, **shown
    )
    shapes = SimpleNamespace(numpy=lambda: np.array([[10, 11, 12]]))
    seen.look(
        SimpleNamespace(
            solver=SimpleNamespace(mjw_data=data, mjc_geom_to_newton_shape=shapes)
        )
    )
    assert (seen.pairs_near, seen.pairs_loaded) == (
        {(10, 11), (10, 12), (11, 12)},
        {(10, 11)},
    )
    assert (seen.contact_counts[-1], seen.loaded_counts[-1], seen.actuators_moved) == (
        3,
        1,
        {1},
    )
    assert seen.peaks == {"nefc": 31, "nl": 1, "ne": 2}
    seen.outputs["sensordata"] = [
        np.array([1.0, 2.0, 3.0]),
        np.array([1.0, 2.0, 4.0]),
        np.array([1.0, 0.0, 3.0]),
    ]
    assert seen.changed_count("sensordata") == 2


# These columns belong to section cure and to scenes.


@pytest.mark.parametrize(
    ("variant", "rate"),
    [
        # r ω² ((1 + R m) / b − h / 2), ω = 2, b = 100, R m = 0.3 · 0.2, h = 2 ms; less 5 ω² / b², which is 0.2 %.
        (turntable.Variant(), 4.0 * (0.0106 - 0.001)),
        (turntable.Variant(options={"integrator": "rk4"}), 4.0 * 0.0106),
        (turntable.Variant(options={"timestep": 0.001}), 4.0 * (0.0106 - 0.0005)),
        (turntable.Variant(options={"noslip_iterations": 10}), 4.0 * (0.01 - 0.001)),
        (turntable.Variant(contact_bias=True), 4.0 * (0.0006 - 0.001)),
        (turntable.Variant(contact_bias=True, bias_centred=True), 4.0 * 0.0006),
    ],
)
def test_the_box_on_the_turntable_is_predicted_as_by_hand(variant, rate):
    touched = Contacts(
        count=4, normal_n=2.0, softness_1_kg=0.3, damping_per_s=100.0, depth_m=1e-3
    )
    assert turntable.predicted_growth_per_s(variant, touched) == pytest.approx(
        0.998 * rate
    )


def test_what_moves_along_an_arc_creeps_on_hinges_whether_it_turns_or_not_and_not_on_slides():
    conditions = SimpleNamespace(profile="quick", device="cpu")
    drifts = {
        motion: controls.row_of(motion, "c", conditions)["drift_mm_s"]
        for motion in controls.ON_AN_ARC
    }
    mean_m_s2 = (0.03 * 2.0 * np.pi) ** 2 / (
        2.0 * controls.PLACE_M
    )  # relative to the square of the speed divided by the radius
    assert drifts["hinge"] == pytest.approx(
        1e3 * mean_m_s2 * (0.95 * 0.02 / 2.0 - 0.002 / 2.0), rel=0.03
    )
    assert drifts["two-hinges"] == pytest.approx(drifts["hinge"], rel=0.03)
    assert drifts["two-slides"] == pytest.approx(0.0, abs=1e-3)


def test_controls_creep_along_their_walls_and_turn_as_hard_as_the_shake(monkeypatch):
    """Test 0.03 m at 1 Hz, which has a peak acceleration of 1.18 m/s², as has a point
    that turns at 2 rad/s, 0.296 m from the axis.
    """
    turned_m_s2 = controls.PLACE_M * 2.0**2
    assert turned_m_s2 == pytest.approx(0.03 * (2.0 * np.pi) ** 2)
    time_s = 0.1 * np.arange(31)
    path = np.stack(
        [
            0.3 + np.where(time_s < 0.95, 9.0, 0.002 * time_s),
            0.0 * time_s,
            0.0 * time_s,
        ],
        axis=1,
    )
    touched = Contacts(4, 2.0, 0.3, 100.0, 1e-3)
    monkeypatch.setattr(controls.turntable, "run", lambda *_: (path, touched))
    conditions = SimpleNamespace(profile="quick", device="cpu")
    assert controls.row_of("straight", "c", conditions)["drift_mm_s"] == pytest.approx(
        2.0
    )
    turned = controls.row_of("turning", "c", conditions)
    assert turned["growth_per_s"] == pytest.approx(0.002 / 0.304, rel=2e-3)
    motion = next(each for each in bodies.MOTIONS if each.place == "table")
    with pytest.raises(bodies.RunFailed):
        bodies.columns_of(motion, np.array([(0.3, 0.0, 0.0), (0.4, 0.31, 0.0)]))
    on_plane = bodies.columns_of(
        bodies.MOTIONS[0], np.array([(0.1, 0.2, 0.3), (9.0, 9.0, 9.0), (0.2, 0.4, 0.2)])
    )
    assert list(on_plane.values()) == pytest.approx([100.0, 200.0, -100.0])


def test_combinations_are_all_but_those_that_no_engine_has_and_kf_is_taken_out_in_contacts_of_newton(
    monkeypatch,
):
    """Test 2 pads, 3 shakes and 2 positions with 4 terms for both Euler integrators,
    and with 2 terms for RK4, which does not use the centre.
    """
    monkeypatch.setattr(combinations, "kf_is_read", lambda: True)
    for quick, shakes in ((False, [0.0, 0.03, 0.1]), (True, [0.0, 0.03])):
        found = {
            kind: combinations.cases(kind, quick) for kind in combinations.CONTACTS
        }
        off = {
            kind: [case.shake_amplitude_m for case in cases if case.pad_kf == -1.0]
            for kind, cases in found.items()
        }
        assert off == {"newton": shakes, "mujoco": [], "pyramidal": []}
        counts = (
            [2 * 2 * 4 * 2 + 2, 0, 0]
            if quick
            else [12 * (4 * 4 + 2 * 2) + 3, 12 * (3 * 4 + 2), 12 * (3 * 4 + 2)]
        )
        assert [len(cases) for cases in found.values()] == counts


def test_on_the_slope_gravity_leans_by_its_tilt():
    model = mujoco.MjModel.from_xml_string(slope.CASES[0].mjcf())
    assert model.opt.gravity == pytest.approx([G * np.sin(0.1), 0.0, -G * np.cos(0.1)])


def test_the_arm_goes_from_pose_to_pose_and_drops_are_counted():
    poses_at = {
        0.0: pick.READY,
        0.5: np.add(pick.READY, pick.LIFTED) / 2.0,
        1.0: pick.LIFTED,
        2.0: pick.AT_OBJECT,
    }
    poses_at |= {3.0: pick.AT_OBJECT, 4.0: pick.LIFTED, 9.0: pick.LIFTED}
    fingers = {0.0: 0.04, 2.0: 0.04, 2.5: 0.02, 3.0: 0.0, 9.0: 0.0}
    for time_s, arm in poses_at.items():
        assert pick.pick_controls(time_s)[:7] == pytest.approx(arm)
    assert pick.pick_controls(np.array(list(fingers)))[:, 7] == pytest.approx(
        list(fingers.values())
    )


def test_drops_are_counted_from_when_the_object_should_be_up(monkeypatch):
    """Test four objects: one never rises, one is dropped, one is dropped and rises
    again, and one is held.
    """
    heights = np.full((8, 4, 3), 0.2)
    heights[:, 0] = heights[4:, 1] = heights[6, 2] = 0.02
    shown = iter([*heights])
    world = SimpleNamespace(
        command=lambda _: None, advance=lambda: None, body=lambda: (next(shown), None)
    )
    monkeypatch.setitem(pick.ENGINES, "c", lambda *_: world)
    case = pick.Pick("", timestep=1.0)  # upward after the second sample of 2 s
    row = pick.shake(case, np.zeros((9, 4, 8)), "cpu")
    assert list(row.values()) == [3, 1, 4.0, 12.0, 16.0]


# These columns belong to other engines and to Newton's own solvers.


def test_bodies_have_the_inertia_that_mujoco_gives_their_shapes():
    made = turning_box(0.002, 1.0).body
    model = mujoco.MjModel.from_xml_string(turntable.MJCF)
    assert (
        made.inertia_kg_m2 == pytest.approx(model.body_inertia[-1])
        and made.mass_kg == model.body_mass[-1]
    )
    made = pinch(0.002, 1.0).body
    rod = (
        f'<geom type="cylinder" size="0.004 0.02" zaxis="0 1 0" mass="{made.mass_kg}"/>'
    )
    shape = mujoco.MjModel.from_xml_string(
        f"<mujoco><worldbody><body>{rod}</body></worldbody></mujoco>"
    )
    assert made.inertia_kg_m2 == pytest.approx(
        np.array(shape.body_inertia[1])[[0, 2, 1]]
    )
    cube = robot.scene_of(
        robot.Reference(replace(AS_SHIPPED, cube_edge_m=0.06), None, np.zeros((2, 9))),
        "",
    ).body
    box_ = f'<geom type="box" size="0.03 0.03 0.03" mass="{500.0 * 0.06**3}"/>'
    shape = mujoco.MjModel.from_xml_string(
        f"<mujoco><worldbody><body>{box_}</body></worldbody></mujoco>"
    )
    assert (
        cube.inertia_kg_m2 == pytest.approx(shape.body_inertia[1])
        and cube.half_size_m == [0.03] * 3
    )


def test_drives_of_engines_apart():
    arm = SimpleNamespace(ke=400.0, kd=40.0, effort=[5.0, 100.0, 3.0])
    forces = apart.drive(arm, [0.02, 0.1, 0.0], [0.01, 0.2, 0.1], [0.05, -0.5, 0.0])
    assert forces == pytest.approx([4.0 - 2.0, -40.0 + 20.0, -3.0])


def test_a_box_walks_by_its_radius_or_creeps_by_its_way_along_a_table_that_stands():
    time_s = 0.1 * np.arange(21)
    path = np.stack(
        [0.2 * np.exp(0.03 * time_s), 0.0 * time_s, 0.1 + 0.0 * time_s], axis=1
    )
    assert box.columns("turntable", path) == {
        "stays": True,
        "growth_per_s": pytest.approx(0.03),
    }
    path[:, :2] = 0.2 + np.outer(time_s, (0.003, 0.004)) + (time_s < 0.95)[:, None]
    assert box.columns("still", path) == {
        "stays": True,
        "creep_mm_s": pytest.approx(5.0),
    }
    for drop_m, stays in ((0.0099, True), (0.0101, False)):
        path[-1, 2] = 0.1 - drop_m
        assert box.columns("slope", path)["stays"] is stays


def test_a_box_is_sampled_each_tenth_of_a_second_from_its_place_on(monkeypatch):
    """Test a solver that moves the box by 1 mm along the table in each step.

    Contacts are computed before every fourth of ten steps.
    """
    found = []

    def step(here, there, *_):
        places = here.body_q.numpy()
        places[1, 0] += 1e-3
        there.body_q.assign(places)

    monkeypatch.setattr(
        box.solvers, "SolverMuJoCo", lambda *_, **options: SimpleNamespace(step=step)
    )
    pipeline = SimpleNamespace(
        contacts=lambda: None, collide=lambda *_: found.append(0)
    )
    monkeypatch.setattr(box.newton, "CollisionPipeline", lambda *_, **options: pipeline)
    path = box.run(
        box.Variant("", "SolverMuJoCo", steps_between_contacts=4),
        "still",
        0.01,
        0.3,
        "cpu",
    )
    assert path == pytest.approx(
        np.outer([0.0, 0.01, 0.02, 0.03], [1.0, 0.0, 0.0]) + [0.2, 0.0, 0.1]
    )
    assert len(found) == 3 * 3


def test_gravity_leans_on_the_slope_by_a_tangent_of_035_and_arms_carry_their_weight():
    gravity = box.build("slope", "cpu").gravity.numpy().reshape(-1, 3)[0]
    assert np.linalg.norm(gravity) == pytest.approx(G) and -gravity[0] / gravity[
        2
    ] == pytest.approx(0.35)
    labels = ["base", "arm/fr3_link1", "cube"] * 2
    model = SimpleNamespace(
        body_label=labels,
        body_count=6,
        device="cpu",
        body_mass=wp.array([1.0, 2.0, 3.0] * 2),
    )
    scene = SimpleNamespace(links={"cube": SimpleNamespace(body=2)})
    cases = [AS_SHIPPED, replace(AS_SHIPPED, gravity_m_s2=2.0)]
    forces = weight_of_the_arm(
        SimpleNamespace(model=model, scene=scene, world_count=2, cases=cases)
    ).numpy()
    assert (
        forces[:, 2] == pytest.approx([0.0, 2.0 * G, 0.0, 0.0, 4.0, 0.0])
        and not forces[:, [0, 1, 3, 4, 5]].any()
    )


def test_a_row_of_a_solver_has_the_means_of_the_shake():
    """Test a cube that moves at 1 mm/s.

    Pads with μ = 0.5 press with 30 N and carry 6 N, which is 0.4 of their friction; the
    hand moves 3 cm to each side.
    """
    time_s = np.arange(301) / FRAME_RATE
    trace = trace_of(
        along(0, 1e-3 * time_s),
        normal_force_n=30.0,
        tangential_force_n=6.0,
        penetration_m=2e-3,
    )
    trace.poses[:, :2, 0] += 0.03 * np.sin(2.0 * np.pi * time_s)[:, None]
    row = newton_solvers.row_of("xpbd", "3cm", replace(AS_SHIPPED, pad_mu=0.5), trace)
    names = (
        "creep_mm_per_cycle",
        "friction_share",
        "normal_force_n",
        "penetration_mm",
        "hand_amplitude_mm",
    )
    assert [row[name] for name in names] == pytest.approx([1.0, 0.4, 30.0, 2.0, 30.0])


def test_what_others_published_is_measured_over_its_own_times(monkeypatch):
    """Test a body that sinks at 5 mm/s, and ten times as fast in its first second."""
    speed_m_s = np.repeat([0.05, 0.005], [50, 100])
    height_m = np.cumsum([0.0, *(-0.02 * speed_m_s)])
    falling = Shown(np.outer(height_m, [0.0, 0.0, 1.0])[:, None])
    monkeypatch.setattr(published, "run_here", lambda scene, *_: falling)
    assert published.press(SimpleNamespace(device="cpu"), "c")[
        "creep_mm_s"
    ] == pytest.approx(5.0)
