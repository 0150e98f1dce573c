"""The audit is a program for any scene, and without stages that are not used nothing changes."""

from dataclasses import replace

import numpy as np

from experiments.facts.case import LEAN
from experiments.simulation.simulation import simulate


def test_stages_that_are_not_used_change_no_bit():
    off = ({}, {"sensors": False}, {"limits": False})
    short = replace(LEAN, cube_in_hand=True, frame_count=100)  # 10 of them in the shake
    cases = [replace(short, name=str(change), **change) for change in off]
    kept, *others = simulate(cases, device="cpu")
    for case, trace in zip(cases[1:], others, strict=True):
        assert np.array_equal(trace.poses, kept.poses), case.name
