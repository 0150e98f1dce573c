"""A state is handed on whole, and a time counts only where nothing went wrong."""

from dataclasses import replace

import numpy as np
import pytest
import warp as wp

from experiments.facts.case import AS_SHIPPED, RUN_TIME_FIELDS, CaseError
from experiments.simulation.simulation import Simulation
from experiments.simulation.timing import in_the_shake, put_in_state_of, run_frames

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
