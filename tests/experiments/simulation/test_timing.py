"""A state is handed on whole, and a time counts only where nothing went wrong."""

from dataclasses import replace

import numpy as np
import pytest
import warp as wp

from experiments.facts import metrics
from experiments.facts.case import AS_SHIPPED, RUN_TIME_FIELDS, CaseError
from experiments.facts.trace import FRAME_COLUMNS, Failure, Trace
from experiments.simulation.simulation import Simulation
from experiments.simulation.timing import in_the_shake, invalid_reason, put_in_state_of, run_frames

FRAME_COUNT = 10
VARIED = {"ik_iterations": 24, "ik_beside": False, "state_sync": True, "sensors": False, "limits": False}


def test_a_varied_simulation_runs_as_one_that_was_built_so():
    assert VARIED.keys() == set(RUN_TIME_FIELDS)
    shake = in_the_shake([AS_SHIPPED], wp.get_device("cpu"))
    base = replace(AS_SHIPPED, frame_count=FRAME_COUNT)

    def poses_from(simulation: Simulation) -> np.ndarray:
        put_in_state_of(simulation, shake)
        simulation.recorder.cursor.zero_()
        run_frames(simulation, FRAME_COUNT)
        return simulation.recorder.poses.numpy().copy()

    varied = Simulation([base] * 2, shake.device)
    first = poses_from(varied)
    for name, value in VARIED.items():
        case = replace(base, name=name, **{name: value})
        varied.vary(case)
        assert np.array_equal(poses_from(varied), poses_from(Simulation([case] * 2, shake.device))), name
    varied.vary(base)
    assert np.array_equal(poses_from(varied), first)
    with pytest.raises(CaseError, match="gap takes a simulation of its own"):
        shake.vary(replace(AS_SHIPPED, name="gap", cube_gap_m=0.01))


def test_a_run_counts_only_when_nothing_went_wrong():
    poses = np.zeros((3, 6, 7))
    poses[:, :, 2] = 0.2
    columns = np.zeros((3, len(FRAME_COLUMNS)))
    good = Trace(1.0 / 60.0, np.full(3, metrics.SHAKE), poses, columns, peak_iteration_count=14)
    dropped = replace(good, poses=poses.copy())
    dropped.poses[-1, metrics.CUBE, 2] = 0.02
    overflow = Failure("overflow", 1, "the contact buffer overflowed")
    assert invalid_reason(AS_SHIPPED, good) is None
    assert "iterations" in invalid_reason(AS_SHIPPED, replace(good, peak_iteration_count=15))
    assert "grasp" in invalid_reason(AS_SHIPPED, dropped)
    assert invalid_reason(AS_SHIPPED, replace(good, failure=overflow)) == overflow.detail
