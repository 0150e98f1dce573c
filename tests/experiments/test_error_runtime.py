"""Test the reference for error against run time with the real scene."""

from dataclasses import replace

import numpy as np
import pytest
import warp as wp

from experiments import error_runtime
from experiments.error_runtime.settings import PADS, native_of, setting, settings
from experiments.facts import metrics
from experiments.facts.case import FIXED
from experiments.simulation.reference import NativeShake, pilot_at_shake

CASES = {pads: replace(base, cube_in_hand=True) for pads, base in PADS.items()}
"""Cases whose shake begins early, because the cube starts in the hand."""
FRAME_COUNT = 60
"""Number of frames of the shake."""


@pytest.mark.parametrize("profile", ["full", "quick"])
def test_every_point_has_its_own_name_and_its_like_in_c(profile):
    points = settings(profile, cpu_too=True)
    assert len({point.case.name for point in points}) == len(points)
    assert {native_of(point) for point in points} <= set(points)


@pytest.fixture(scope="module")
def shakes():
    """Return one setting for each kind of pads in Warp, with its traces and the
    initial states of C.
    """
    pilot = pilot_at_shake(CASES.values(), wp.get_device("cpu"))
    points = [setting(case, pads, "newton", "substeps") for pads, case in CASES.items()]
    points = [
        replace(point, case=replace(point.case, frame_count=FRAME_COUNT))
        for point in points
    ]
    simulations = {
        point: error_runtime.in_warp(point, pilot, pilot.device) for point in points
    }
    starts = error_runtime.starts_by_pads(pilot, FRAME_COUNT)  # the pilot runs on
    return error_runtime.run_shakes(simulations), starts


def test_warp_and_c_agree_from_the_same_state(shakes):
    traces, starts = shakes
    for point, of_warp in traces.items():
        of_c = NativeShake(
            replace(native_of(point).case, frame_count=FRAME_COUNT), starts[point.pads]
        ).run()
        assert len(of_warp.phase) == len(of_c.phase) == FRAME_COUNT
        assert (of_warp.phase == metrics.SHAKE).all()
        np.testing.assert_allclose(
            of_warp.poses[0, : of_c.poses.shape[1]], of_c.poses[0], atol=2e-5
        )
        assert error_runtime.distance_mm(of_warp, of_c) < 0.02


def test_the_model_in_c_has_the_timeconst_of_the_pads_and_merged_links_where_they_were(
    shakes,
):
    _, starts = shakes
    timeconst = {
        pads: NativeShake(replace(base, backend="mujoco"), starts[pads]).pad_timeconst_s
        for pads, base in PADS.items()
    }
    assert timeconst == pytest.approx({"as-shipped": 0.02, "stiff": 0.002})
    cases = [
        replace(case, backend="mujoco", frame_count=2)
        for case in (PADS["stiff"], FIXED)
    ]
    own, merged = (NativeShake(case, starts["stiff"]).run() for case in cases)
    np.testing.assert_allclose(merged.poses, own.poses, atol=1e-5)
