"""Error against run time: the metrics by hand, and the reference against the real scene."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
import warp as wp

from experiments import error_runtime
from experiments.error_runtime.settings import FRAME_COUNT, PADS, native_of, reference_of, setting, settings
from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, FIXED
from experiments.facts.trace import FRAME_COLUMNS, Failure, Trace
from experiments.simulation import timing
from experiments.simulation.reference import NativeShake, pilot_at_shake, starts_of

FRAME_DT = 1.0 / 60.0


def moved(vector_mm) -> metrics.Displacement:
    vector = 1e-3 * np.asarray(vector_mm, dtype=float)
    return metrics.Displacement(np.arange(len(vector)) * FRAME_DT, vector, vector[:, 0])


def test_cycle_drift_takes_pairs_of_cycles_after_the_first_and_distance_the_root_mean_square():
    seconds = np.arange(241) * FRAME_DT
    # The first cycle moves by 9 mm and the others by 3 and 4 mm in x and z; what returns every two cycles cancels.
    steady = np.where(seconds < 1.0, 9.0 * seconds, 9.0 + 3.0 * (seconds - 1.0))
    returning = np.sin(np.pi * seconds)
    drift = metrics.cycle_drift_mm(moved(np.stack([steady, returning, 4.0 * seconds], axis=1)), 1.0)
    assert drift == pytest.approx(5.0)
    for frame_count in (0, 121, 180):
        assert np.isnan(metrics.cycle_drift_mm(moved(np.zeros((frame_count, 3))), 1.0)), "no pair of cycles"
    path = np.zeros((2, 3))
    other = np.array([[0.003, 0.0, 0.004], [0.0, 0.001, 0.0]])
    assert metrics.distance_rms_mm(path, other) == pytest.approx(np.sqrt((25.0 + 1.0) / 2.0))


def trace(**changes) -> Trace:
    poses = np.zeros((3, 6, 7))
    poses[:, :, 2] = 0.2
    return replace(
        Trace(FRAME_DT, np.full(3, metrics.SHAKE), poses, np.zeros((3, len(FRAME_COLUMNS))), peak_iteration_count=14),
        **changes,
    )


def test_a_run_counts_only_when_nothing_went_wrong():
    dropped = trace()
    dropped.poses[-1, metrics.CUBE, 2] = 0.02
    overflow = Failure("overflow", 1, "the contact buffer overflowed")
    assert timing.invalid_reason(AS_SHIPPED, trace()) is None
    assert "iterations" in timing.invalid_reason(AS_SHIPPED, trace(peak_iteration_count=15))
    assert "grasp" in timing.invalid_reason(AS_SHIPPED, dropped)
    assert timing.invalid_reason(AS_SHIPPED, trace(failure=overflow)) == overflow.detail


@pytest.mark.parametrize("profile", ["full", "quick"])
def test_every_point_has_its_own_name_and_its_like_in_c(profile):
    points = settings(profile, cpu_too=True)
    assert len({point.case.name for point in points}) == len(points)
    assert {native_of(point) for point in points} <= set(points)


@pytest.fixture(scope="module")
def pilot():
    return pilot_at_shake(PADS.values(), wp.get_device("cpu"))


@pytest.fixture(scope="module")
def shakes(pilot):
    """One setting of each pads in Warp, with its traces and the states from which C starts."""
    points = [setting(base, pads, "newton", "substeps") for pads, base in PADS.items()]
    simulations = {point: error_runtime.WarpShake(point, pilot, pilot.device) for point in points}
    starts = dict(zip(PADS, starts_of(pilot, FRAME_COUNT), strict=True))  # runs the pilot on
    return error_runtime.run_shakes(simulations), starts


def test_warp_and_c_agree_from_the_same_state(shakes):
    traces, starts = shakes
    for point, of_warp in traces.items():
        of_c = NativeShake(native_of(point).case, starts[point.pads]).run()
        assert len(of_warp.phase) == len(of_c.phase) == FRAME_COUNT
        assert (of_warp.phase == metrics.SHAKE).all()
        np.testing.assert_allclose(of_warp.poses[0, : of_c.poses.shape[1]], of_c.poses[0], atol=2e-5)
        assert error_runtime.distance_mm(of_warp, of_c) < 0.02


def test_the_shipped_integrator_converges_to_the_reference_at_first_order(shakes):
    _, starts = shakes

    def run(point):
        return NativeShake(point.case, starts["as-shipped"]).run()

    points = [setting(replace(AS_SHIPPED, substeps=n), "as-shipped", "newton", "substeps") for n in (8, 16, 32)]
    reference = run(reference_of(points[0], 64))
    errors = [error_runtime.distance_mm(run(native_of(point)), reference) for point in points]
    assert [a / b for a, b in pairwise(errors)] == pytest.approx([2.0, 2.0], rel=0.05)
    assert error_runtime.distance_mm(run(reference_of(points[0], 32)), reference) < 1e-4 * errors[-1]


def test_the_model_in_c_has_the_timeconst_of_the_pads_and_merged_links_where_they_were(shakes):
    _, starts = shakes
    timeconst = {
        pads: NativeShake(replace(base, backend="mujoco"), starts[pads]).pad_timeconst_s for pads, base in PADS.items()
    }
    assert timeconst == pytest.approx({"as-shipped": 0.02, "stiff": 0.002})
    _, starts = shakes
    start = starts["stiff"]
    own, merged = (
        NativeShake(replace(case, backend="mujoco", frame_count=2), start).run() for case in (PADS["stiff"], FIXED)
    )
    np.testing.assert_allclose(merged.poses, own.poses, atol=1e-5)
