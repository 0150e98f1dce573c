"""Test that a state is passed on completely, and that a time counts only if no error
occurred.
"""

from dataclasses import replace

import numpy as np
import pytest
import warp as wp

from experiments.facts.case import LEAN, RUN_TIME_FIELDS, CaseError
from experiments.simulation.simulation import Simulation
from experiments.simulation.timing import put_in_state_of, run_frames

FRAME_COUNT = 10
SHAKING = 100
"""Number of frames after which a cube that starts in the hand is shaken."""
VARIED = {
    "ik_iterations": 24,
    "ik_beside": False,
    "state_sync": True,
    "sensors": False,
    "limits": False,
}


def test_a_varied_simulation_runs_as_one_that_was_built_so():
    assert VARIED.keys() == set(RUN_TIME_FIELDS)
    base = replace(LEAN, frame_count=FRAME_COUNT)
    shake = Simulation([replace(base, cube_in_hand=True)], wp.get_device("cpu"))
    run_frames(shake, SHAKING)

    def poses_from(simulation: Simulation) -> np.ndarray:
        put_in_state_of(simulation, shake)
        simulation.recorder.cursor.zero_()
        run_frames(simulation, FRAME_COUNT)
        return simulation.recorder.poses.numpy().copy()

    varied = Simulation([base] * 2, shake.device)
    first = poses_from(varied)
    case = replace(base, name="varied", **VARIED)
    varied.vary(case)
    assert np.array_equal(
        poses_from(varied), poses_from(Simulation([case] * 2, shake.device))
    )
    for unused in (
        {},
        {"sensors": False},
        {"limits": False},
    ):  # stages that do not change any bit
        varied.vary(replace(base, name=f"but {unused}", **unused))
        assert np.array_equal(poses_from(varied), first)
    with pytest.raises(CaseError, match="gap takes a simulation of its own"):
        shake.vary(replace(LEAN, name="gap", cube_gap_m=0.01))
