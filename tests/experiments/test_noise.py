"""The same batch twice: what a release cannot do is a fact about it, and what goes wrong is none."""

import pytest

from experiments import noise
from experiments.simulation.measurement import Conditions

NOT_COMPILED = Exception("CPU kernel build failed with error code -1")
DEVICE_FAULT = RuntimeError("CUDA error 719: unspecified launch failure")


def test_only_what_a_release_cannot_compile_is_a_fact_about_it(monkeypatch):
    def raising(error):
        def build(*_):
            raise error

        return build

    quick = Conditions("cpu", quick=True)
    monkeypatch.setattr(noise, "engine_has_it", lambda: True)
    monkeypatch.setattr(noise, "Deterministic", raising(NOT_COMPILED))
    assert noise.measure_likeness(quick, "all")["slip_mm_reason"] == str(NOT_COMPILED)
    monkeypatch.setattr(noise, "Deterministic", raising(DEVICE_FAULT))
    with pytest.raises(RuntimeError, match="CUDA error 719"):
        noise.measure_likeness(quick, "all")
