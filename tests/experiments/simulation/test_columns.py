"""Test by hand how times, contacts and rows become numbers of a record, without a
simulation.
"""

from dataclasses import replace
from types import SimpleNamespace

import mujoco
import numpy as np
import pytest
import warp as wp

from experiments import error_runtime, speed, upgrade
from experiments.drivers.contacts import Contacts
from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, STIFF_PADS
from experiments.facts.trace import FRAME_COLUMNS, ContactRows, Failure, Trace
from experiments.simulation import (
    frame_benchmark,
    measurement,
    recorder,
    stepper_c,
    stepper_warp,
    timing,
)
from experiments.simulation.measurement import Conditions
from experiments.simulation.paired_timing import PairedTimes
from experiments.simulation.task import SHAKE

TIMES = PairedTimes(np.arange(101.0), 1.0 + 0.01 * np.arange(101.0), 1.4, 0.02)
"""Test that the p-th percentile of the numbers 0, 1, …, 100 is p."""
HELD = Trace(
    1.0 / 60.0,
    np.full(1, 4),
    np.tile([0.0, 0.0, 0.3, 0.0, 0.0, 0.0, 1.0], (1, 2, 1)),
    np.empty((1, 7)),
)


def test_times_are_medians_with_the_5th_and_the_95th_percentile():
    row = frame_benchmark.time_columns(TIMES)
    assert (
        row["frame_ms"],
        row["frame_ms_p5"],
        row["frame_ms_p95"],
        row["repeat_count"],
    ) == (50.0, 5.0, 95.0, 101)
    assert (row["frame_ratio"], row["ratio_resolution"]) == (1.4, 0.02)
    assert (row["frame_ratio_p5"], row["frame_ratio_p95"]) == pytest.approx(
        (1.05, 1.95)
    )
    # 60 frames of 50 ms for a second; 8 worlds by 16 substeps in 50 ms; 20 frames a second are a third of real time.
    assert error_runtime.time_columns(None, TIMES)["ms_per_s"] == 3000.0
    assert frame_benchmark.world_rate(AS_SHIPPED, 8, TIMES) == pytest.approx(
        {"world_substeps_per_s": 2560.0}
    )
    assert speed.with_rates({"frame_ms": 50.0})["frames_per_s"] == pytest.approx(20.0)
    assert speed.with_rates({"frame_ms": 50.0})["realtime_factor"] == pytest.approx(
        1.0 / 3.0
    )


def test_a_time_counts_where_the_cube_is_held_and_the_solver_has_iterations_left():
    case = replace(AS_SHIPPED, iterations=15)
    assert timing.invalid_reason(case, replace(HELD, peak_iteration_count=14)) is None
    assert "all of its 15" in timing.invalid_reason(
        case, replace(HELD, peak_iteration_count=15)
    )
    far = HELD.poses.copy()
    far[0, 0, 0] = 0.1
    assert (
        timing.invalid_reason(case, replace(HELD, poses=far))
        == "the cube left the grasp"
    )
    assert timing.wall_time([replace(HELD, wall_s=2.5), HELD]) == {"wall_s": 2.5}
    failed = replace(
        HELD, failure=Failure("overflow", 3, "the contact buffer overflowed")
    )
    assert timing.wall_time([HELD, failed])["wall_s"] is None


@pytest.mark.parametrize(
    ("worlds", "is_cuda", "count"), [(1, True, 4), (2048, True, 4), (4096, True, 2)]
)
@pytest.mark.parametrize("many", [False, True])
def test_a_block_is_of_as_many_frames_as_its_worlds_leave_and_tells_the_mean(
    monkeypatch, worlds, is_cuda, count, many
):
    if many:
        worlds, is_cuda, count = (16384, True, 1) if count > 2 else (1, False, 1)
    ran, put = [], []
    device = SimpleNamespace(is_cuda=is_cuda)
    simulation = SimpleNamespace(
        world_count=worlds,
        device=device,
        vary=lambda _: None,
        parts=[],
        part_beside=None,
    )
    monkeypatch.setattr(
        frame_benchmark, "run_frames", lambda _, frames: ran.append(frames)
    )
    monkeypatch.setattr(frame_benchmark, "batch_invalid_reason", lambda _: None)
    monkeypatch.setattr(frame_benchmark, "elapsed_ms", lambda _, run: run() or 12.0)
    frames = frame_benchmark.Frames(
        simulation, AS_SHIPPED, SimpleNamespace(put=lambda *each: put.append(each))
    )
    assert frames(5) == 12.0 / count and ran == [3, count] and put[-1][-1] == 5


def test_each_round_starts_from_a_state_of_its_pads_and_eight_of_them_come_round(
    monkeypatch,
):
    warm, put = object.__new__(frame_benchmark.WarmState), []
    warm.states = list("abcdefgh")
    monkeypatch.setattr(
        frame_benchmark, "put_in_state_of", lambda *each: put.append(each[1:])
    )
    for number, case in ((0, AS_SHIPPED), (7, STIFF_PADS), (9, STIFF_PADS)):
        warm.put(None, case, number)
    assert put == [("a", 0), ("h", 1), ("b", 1)]


def test_a_call_is_timed_in_milliseconds_and_buffers_in_bytes_of_a_world(monkeypatch):
    clock = iter((2.0, 2.25))
    monkeypatch.setattr(timing.time, "perf_counter", lambda: next(clock))
    assert timing.elapsed_ms(wp.get_device("cpu"), lambda: None) == 250.0
    one, two = (
        wp.zeros(10, dtype=float, device="cpu"),
        wp.zeros(5, dtype=wp.vec3, device="cpu"),
    )
    held = SimpleNamespace(one=one, same=one, count=3)
    data = SimpleNamespace(contact=held, efc=SimpleNamespace(two=two), nworld=4)
    assert (
        timing.buffer_bytes_per_world(SimpleNamespace(mjw_data=data), None)
        == (40 + 60) // 4
    )
    assert (
        timing.buffer_bytes_per_world(
            SimpleNamespace(mjw_data=data), SimpleNamespace(own=wp.clone(two))
        )
        == 160 // 4
    )


def test_quick_runs_are_cut_and_three_looks_are_a_quarter_of_a_cycle_apart():
    assert [
        Conditions("cpu", quick=quick).frame_count(900) for quick in (False, True)
    ] == [900, 420]
    # The middle is between 212, where the shake begins, and 900; 15 of 60 frames are a
    # quarter of a second.
    assert Conditions("cpu", quick=False).contact_frames() == (541, 556, 571)
    # 1.5 s of lift, 0.75 s of grasp, 1 s of descent and 0.25 s of approach are 210 frames, and each end has one more.
    assert abs(measurement.SETUP_FRAME_COUNT - 60 * (1.5 + 0.75 + 1.0 + 0.25)) <= 2


def test_a_shake_is_summed_up_by_cycle():
    """Test 2 mm/s along x with 1 mm/s² from the start: 2.5, 3.5 and 4.5 mm in whole
    cycles of a second.
    """
    time_s = np.arange(200) / 60.0
    poses = np.tile([0.0, 0.0, 0.3, 0.0, 0.0, 0.0, 1.0], (210, 2, 1))
    poses[10:, metrics.CUBE, 0] = 1e-3 * (2.0 * time_s + 0.5 * time_s**2)
    phase = np.repeat([3, SHAKE], [10, 200])
    row = measurement.summarize(
        AS_SHIPPED, Trace(1.0 / 60.0, phase, poses, np.zeros((210, len(FRAME_COLUMNS))))
    )
    names = (
        "increment_mean_mm",
        "increment_last_mm",
        "cycle_count",
        "shake_start_s",
        "shake_duration_s",
        "slip_mm",
    )
    end_s = 199.0 / 60.0
    expected = (3.5, 4.5, 3, 10.0 / 60.0, end_s, 2.0 * end_s + 0.5 * end_s**2)
    assert [row[name] for name in names] == pytest.approx(expected)
    assert row["dropped"] is False and row["wander_mm"] == pytest.approx(row["slip_mm"])


@pytest.mark.parametrize("cone", ["elliptic", "pyramidal"])
def test_contacts_act_together_as_springs_side_by_side(cone):
    """Test three contacts: one that the solver ignores, and two with forces of 3 and 5
    N, whose friction rows have a D of 2 and 6.
    """
    option = SimpleNamespace(
        cone=int(cone == "elliptic"), timestep=0.002, disableflags=0
    )
    solref, solimp = (
        [(0.02, 1.0), (0.02, 1.0), (0.01, 1.0)],
        [(0.9, 0.95, 0.001, 0.5, 2.0)] * 3,
    )
    if cone == "elliptic":
        rows, force = [-1, 0, 3], [3.0, 9.0, 9.0, 5.0, 9.0, 9.0]
        stiffness = [50.0, 2.0, 2.0, 50.0, 6.0, 6.0]
    else:  # D of an edge is 2 / (2 μ²) or 6 / (2 μ²); the forces of the edges add up
        rows, force = [-1, 0, 4], [1.0, 1.0, 0.5, 0.5, 2.0, 1.0, 1.0, 1.0]
        stiffness = [4.0] * 4 + [48.0] * 4
    friction = [(9.0,), (0.5,), (0.25,)]
    arguments = (rows, friction, solref, solimp, [-9.0, -1e-3, -3e-3], force, stiffness)
    found = Contacts.of(SimpleNamespace(opt=option), *arguments)
    assert (found.count, found.normal_n, found.depth_m) == pytest.approx((2, 8.0, 2e-3))
    assert found.softness_1_kg == pytest.approx(1.0 / 8.0)
    assert found.damping_per_s == pytest.approx(
        2.0 / (0.95 * 0.02)
    )  # the smallest, which belongs to the longer timeconst
    assert Contacts.of(
        SimpleNamespace(opt=option), [-1, -1, -1], *arguments[1:]
    ) == Contacts(0, 0.0, 0.0, 0.0, 0.0)
    assert found.creep_m_s(0.4) == pytest.approx(0.4 / 8.0 * 0.0095)


def rows_of(cone: str, geoms: tuple[int, int]) -> ContactRows:
    """Test two contacts.

    The first has no row; the second has 6 N along its normal and 0.8 and −0.6 N, 0.2
    and −0.1 m/s along its tangents.
    """
    axes = np.array([[(0.0, 0.0, 1.0), (0.6, 0.8, 0.0), (-0.8, 0.6, 0.0)]] * 2)
    field = {
        "frame": axes.reshape(2, 9),
        "friction": np.full((2, 5), 0.5),
        "geom": np.array([geoms, geoms]),
    }
    field |= {"dist": np.array([-9.0, -1e-3]), "dim": np.array([3, 3])}
    field |= {name: np.zeros((2, 2)) for name in ("solref", "solreffriction")} | {
        "solimp": np.zeros((2, 5))
    }
    if cone == "elliptic":
        force, velocity = [7.0, 6.0, 0.8, -0.6], [7.0, 0.01, 0.2, -0.1]
    else:  # μ (a − b) is the force and (a − b) / (2 μ) the velocity
        force, velocity = [7.0, 2.4, 0.8, 0.8, 2.0], [7.0, 0.11, -0.09, -0.04, 0.06]
    rows = [
        np.array(each)
        for each in (force, np.arange(5.0), velocity, -np.array(velocity))
    ]
    return stepper_c._rows_of_world(
        field, np.array([-1, 1]), rows, 3, ["ground", "cube"], cone == "elliptic"
    )


@pytest.mark.parametrize("cone", ["elliptic", "pyramidal"])
def test_rows_are_taken_apart_and_summed_up(cone):
    found = rows_of(cone, (0, 1))
    np.testing.assert_allclose(
        found.force_n, [(0.0, 0.0, 0.0), (6.0, 0.8, -0.6)], atol=1e-12
    )
    np.testing.assert_allclose(found.velocity_m_s[1, 1:], (0.2, -0.1), atol=1e-12)
    slide_m_s = 0.6 * 0.2 + 0.8 * 0.1
    assert found.slide_m_s[1] == pytest.approx(slide_m_s)
    assert rows_of(cone, (1, 0)).slide_m_s[1] == pytest.approx(-slide_m_s)
    summed = dict(zip(FRAME_COLUMNS, stepper_c.summarize_contacts(found), strict=True))
    expected = {
        "contact_count": 2,
        "loaded_count": 1,
        "normal_force_n": 6.0,
        "tangential_force_n": 1.0,
    }
    assert summed == pytest.approx(
        expected
        | {"cone_use": 1.0 / 3.0, "penetration_m": 1e-3, "slide_m_s": slide_m_s}
    )
    # The rows are set to −b v with b = 1 here; the faster row determines it.
    if cone == "elliptic":
        loaded = replace(
            found,
            **{
                name: getattr(found, name)[1:]
                for name in vars(found)
                if name != "frame"
            },
        )
        faster = replace(loaded, reference_m_s2=np.array([[9.0, -30.0, 9.0]]))
        assert upgrade.row_columns(faster)["friction_damping_per_s"] == pytest.approx(
            150.0
        )


@pytest.mark.parametrize("cone", ["elliptic", "pyramidal"])
@pytest.mark.parametrize("geoms", [(0, 1), (1, 0)])
def test_the_device_adds_up_what_the_host_does(cone, geoms):
    """Test the same contact in two worlds. Only the second world counts. Another
    contact is ignored by the solver.
    """

    def array(values, dtype=float):
        return wp.array(values, dtype=dtype, device="cpu")

    expected, contacts = (
        rows_of(cone, geoms),
        wp.zeros((1, 2, 7), dtype=float, device="cpu"),
    )
    force, velocity = (
        [9.0, 6.0, 0.8, -0.6, 0.0, 0.0, 0.0, 0.0],
        [9.0, 0.01, 0.2, -0.1, 0.0, 0.0, 0.0, 0.0],
    )
    if cone == "pyramidal":
        force, velocity = (
            [9.0, 2.4, 0.8, 0.8, 2.0, 0.0, 0.0, 0.0],
            [9.0, 0.11, -0.09, -0.04, 0.06, 0.0, 0.0, 0.0],
        )
    axes = np.array([[(0.0, 0.0, 1.0), (0.6, 0.8, 0.0), (-0.8, 0.6, 0.0)]] * 3)
    inputs = [
        array([0, 0], int),
        array([3], int),
        array([-9.0, -1e-3, -5e-4]),
        array([1, 1, 1], int),
    ]
    inputs += [
        array([3, 3, 3], int),
        array(np.full((3, 5), 0.5), stepper_warp.vec5),
        array(axes, wp.mat33),
    ]
    inputs += [array([geoms] * 3, wp.vec2i), 1, array([[-1], [1], [1]], int)]
    inputs += [
        array([[0.0] * 8, force]),
        array([[0.0] * 8, velocity]),
        8,
        cone == "elliptic",
    ]
    wp.launch(
        stepper_warp.record_contacts,
        dim=3,
        inputs=inputs,
        outputs=[contacts],
        device="cpu",
    )
    summed = stepper_c.summarize_contacts(expected)
    assert contacts.numpy()[0, 1] == pytest.approx(
        summed * (1.5, 2, 2, 2, 1, 1, 2), rel=1e-5
    )
    cursor, phases = array([0, 0], int), wp.zeros((1, 2), dtype=int, device="cpu")
    bodies, poses = (
        wp.zeros(shape, dtype=wp.transform, device="cpu")
        for shape in ((2, 1), (1, 2, 1))
    )
    ends = [
        bodies,
        array([0], int),
        array([wp.transform_identity()], wp.transform),
        array([4, 4], int),
    ]
    wp.launch(
        recorder.end_frame,
        dim=2,
        inputs=ends,
        outputs=[cursor, poses, phases, contacts],
        device="cpu",
    )
    assert contacts.numpy()[0, :, 6] == pytest.approx(
        [0.0, summed[6]], rel=1e-5
    )  # the mean of both


def test_an_engine_that_warned_has_failed_for_what_it_warned_of():
    data = mujoco.MjData(mujoco.MjModel.from_xml_string("<mujoco/>"))
    assert stepper_c.failure_of(data, 3) is None
    data.warning[mujoco.mjtWarning.mjWARN_CNSTRFULL].number = 1
    assert stepper_c.failure_of(data, 3) == Failure(
        "overflow", 3, "the constraint buffer overflowed"
    )
