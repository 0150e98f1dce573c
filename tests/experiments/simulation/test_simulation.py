"""Test calibration, batches and failing runs with the real scene and the real engine."""

from dataclasses import replace

import numpy as np
import pytest
import warp as wp
from conftest import tracked_mm

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, STIFF_PADS, Case, CaseError
from experiments.facts.trace import Failure
from experiments.simulation.simulation import Simulation, simulate
from measured_report.files.root import ROOT
from newton_lint.newton_models.compat import kf_is_read

FRAME_COUNT = 272
"""Duration of the setup and 1 s of shake."""


@pytest.fixture(scope="module")
def batch() -> dict[str, tuple[Case, object]]:
    """Run different cases as worlds of one batch on Warp's CPU device."""
    other = replace(
        AS_SHIPPED,
        name="other",
        cube_gap_m=0.005,
        cube_density_kg_m3=250.0,
        shake_frequency_hz=2.0,
    )
    cases = [
        replace(case, frame_count=FRAME_COUNT)
        for case in (AS_SHIPPED, STIFF_PADS, other)
    ]
    traces = simulate(cases, device="cpu")
    assert {trace.world_count for trace in traces} == {len(cases)}
    return {case.name: (case, trace) for case, trace in zip(cases, traces, strict=True)}


@pytest.mark.parametrize("name", ["as-shipped", "stiff-pads"])
def test_calibration_on_the_cpu_device(batch, name):
    trace = batch[name][1]
    assert trace.failure is None
    expected = tracked_mm(
        ROOT / f"results/newton-{'1.8.0' if kf_is_read() else '1.4.0'}",
        name,
        FRAME_COUNT,
    )
    assert metrics.slip_mm(metrics.displacement(trace)) == pytest.approx(
        expected, abs=0.01
    )


def test_a_world_of_a_batch_is_the_case_alone(batch):
    frame_count = 230
    case, together = batch["other"]
    [alone] = simulate([replace(case, frame_count=frame_count)], device="cpu")
    np.testing.assert_array_equal(alone.phase, together.phase[:frame_count])
    assert alone.phase[-1] == metrics.SHAKE
    np.testing.assert_allclose(alone.poses, together.poses[:frame_count], atol=2e-6)
    np.testing.assert_array_equal(
        alone.column("contact_count"), together.column("contact_count")[:frame_count]
    )


@pytest.mark.parametrize(
    ("change", "buffer", "frames"),
    [({"contact_max": 8}, "contact", {0}), ({"constraint_max": 12}, "constraint", {0})],
)
def test_an_overflow_is_marked_with_its_frame(change, buffer, frames):
    [trace] = simulate(
        [replace(AS_SHIPPED, frame_count=max(frames) + 2, **change)], device="cpu"
    )
    assert trace.failure in [
        Failure("overflow", frame, f"the {buffer} buffer overflowed")
        for frame in frames
    ]


def test_a_state_that_is_not_finite_is_marked_in_its_world_alone_and_so_is_one_that_mujoco_resets():
    simulation = Simulation(
        [replace(AS_SHIPPED, frame_count=6)] * 2, wp.get_device("cpu")
    )
    for frame in range(6):
        if frame == 4:
            simulation.solver.mjw_data.qvel.numpy()[1, -1] = np.nan
        simulation.step()
    good, bad = simulation.recorder.traces()
    assert good.failure is None
    assert (bad.failure.kind, bad.failure.frame) == ("non-finite", 4)
    simulation = Simulation(
        [replace(AS_SHIPPED, backend="mujoco", frame_count=3)], wp.get_device("cpu")
    )
    simulation.step()
    speeds = simulation.state.joint_qd.numpy()
    speeds[0] = 1e20
    simulation.state.joint_qd.assign(speeds)
    simulation.step()
    [trace] = simulation.recorder.traces(frame_count=2)
    assert np.isfinite(trace.poses).all()
    assert (
        trace.failure.kind == "non-finite"
        and trace.failure.frame == 1
        and "reset" in str(trace.failure)
    )


@pytest.mark.parametrize(
    "change",
    [
        {"shake_amplitude_m": -0.01},
        {"shake_frequency_hz": 0.0},
        {"pad_ke": float("nan")},
        {"pad_ke": 0.0},
    ]
    + [{"substeps": 0}, {"collide_count": 3}],
)
def test_a_case_that_makes_no_sense_is_refused(change):
    with pytest.raises(CaseError, match=next(iter(change))):
        replace(AS_SHIPPED, **change)
