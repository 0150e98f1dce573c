"""Test that a time counts only if the run meets the requirements of its case.

The real scene is made to fail.
"""

import gc
from dataclasses import replace

import numpy as np
import pytest
import warp as wp

from experiments.facts.case import AS_SHIPPED, Case
from experiments.simulation import frame_benchmark
from experiments.simulation.frame_benchmark import (
    TIMED,
    WarmState,
    time_cases,
    warm_state,
)
from experiments.simulation.simulation import Simulation
from experiments.simulation.timing import batch_invalid_reason

SMALL = replace(AS_SHIPPED, name="small", constraint_max=12)
OVERFLOW = "not timed: the constraint buffer overflowed"
NO_MEMORY = RuntimeError("Failed to allocate 1024 bytes on device 'cpu'")
DEVICE_FAULT = RuntimeError("CUDA error 719: unspecified launch failure")


@pytest.fixture(scope="module", autouse=True)
def warm() -> WarmState:
    gc.freeze()  # objects that exist already; between cases the timed simulation is searched
    return warm_state("cpu")


def test_what_goes_wrong_in_any_world_counts_until_another_case_is_run(warm):
    two = Simulation([replace(AS_SHIPPED, frame_count=1)] * 2, warm.device)
    warm.put(two, AS_SHIPPED)
    two.step()
    assert batch_invalid_reason(two) is None
    two.solver.mjw_data.qvel.numpy()[1, -1] = np.nan
    two.step()
    assert batch_invalid_reason(two) == "a body's pose is not finite"
    two.recorder.constraint_overflow.numpy()[0] = 0
    warm.put(two, AS_SHIPPED)
    two.step()
    assert batch_invalid_reason(two) is None


def test_a_variant_whose_buffers_overflow_has_no_time_and_no_memory():
    cpu = wp.get_device("cpu")
    found = time_cases([AS_SHIPPED, SMALL], 2, cpu, cap_s=0.0)
    assert (
        found["as-shipped"]["frame_ms"] > 0.0
        and found["as-shipped"]["buffer_bytes_per_world"] > 0
    )
    assert [found["small"][name] for name in TIMED] == [None] * len(TIMED)
    assert found["small"]["frame_ms_reason"] == OVERFLOW


def refusing(error: Exception, most: int = 0) -> type[Simulation]:
    """Stands for a simulation with a limited number of worlds."""

    class Refusing(Simulation):
        def __init__(self, cases: list[Case], device: wp.Device, **ways):
            if len(cases) > most:
                raise error
            super().__init__(cases, device)

    return Refusing


def test_only_too_little_memory_is_why_a_variant_has_no_time(monkeypatch):
    cpu = wp.get_device("cpu")
    monkeypatch.setattr(frame_benchmark, "Simulation", refusing(NO_MEMORY, most=1))
    assert time_cases([AS_SHIPPED], 2, cpu)["as-shipped"]["frame_ms_reason"] == str(
        NO_MEMORY
    )
    monkeypatch.setattr(frame_benchmark, "Simulation", refusing(DEVICE_FAULT, most=1))
    with pytest.raises(RuntimeError, match="CUDA error 719"):
        time_cases([AS_SHIPPED], 2, cpu)
