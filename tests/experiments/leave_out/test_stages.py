"""Stages of the engine: their kernels, and that nothing changes without those that are not used."""

from dataclasses import replace

import numpy as np
import pytest
import warp as wp

from experiments.facts.case import AS_SHIPPED, LEAN
from experiments.leave_out.stages import count_launches, element_of, stage_rows
from experiments.simulation.simulation import simulate
from experiments.simulation.timing import in_the_shake


def test_stages_that_are_not_used_change_no_bit():
    off = ({}, {"sensors": False}, {"limits": False})
    short = replace(LEAN, cube_in_hand=True, frame_count=100)  # 10 of them in the shake
    cases = [replace(short, name=str(change), **change) for change in off]
    kept, *others = simulate(cases, device="cpu")
    for case, trace in zip(cases[1:], others, strict=True):
        assert np.array_equal(trace.poses, kept.poses), case.name


def test_stages_their_kernels_and_what_they_are_for():
    pilot = in_the_shake([AS_SHIPPED], wp.get_device("cpu"))
    kept = count_launches(pilot)
    assert sum(kept.values()) > 80
    pilot.vary(replace(AS_SHIPPED, sensors=False, limits=False))
    off = count_launches(pilot)
    pilot.vary(AS_SHIPPED)
    assert not any("limit" in stage or "sensor_acc" in stage for stage in off)
    assert sum(off.values()) < sum(kept.values())
    rows = stage_rows(pilot, "cpu")
    assert sum(row["kernel_share"] for row in rows) == pytest.approx(1.0)
    assert len({row["case"] for row in rows}) == len(rows)
    assert all(row["element_count"] is not None or row["element_count_reason"] for row in rows)
    found = {row["stage"]: row["of"] for row in rows if row["of"]}
    assert found and all(element_of(stage) == element for stage, element in found.items())
    assert element_of("sensor.sensor_acc") == "nsensor" and element_of("constraint.limit_slide_hinge") == "njnt"
    assert element_of("sensor.energy_pos") is None, "energy is measured in the module of the sensors"
    assert element_of("smooth.camlight") is None, "of cameras and of lights"
