"""GPUs to measure on, and how many processes share one."""

from measured_report.measuring import machine
from measured_report.measuring.machine import Gpu, gpus

LISTING = "0, GPU-a, 144000, NVIDIA H200\n1, GPU-b, [N/A], NVIDIA GB10\nno devices"


def test_gpus_are_those_that_this_process_may_use(monkeypatch):
    monkeypatch.setattr(machine, "said", lambda *command: LISTING)
    monkeypatch.delenv("CUDA_VISIBLE_DEVICES", raising=False)
    assert gpus() == [Gpu("GPU-a", 144000, "NVIDIA H200"), Gpu("GPU-b", 0, "NVIDIA GB10")]
    for allowed, names in {"1": ["GPU-b"], "GPU-a, 1": ["GPU-a", "GPU-b"], "": []}.items():
        monkeypatch.setenv("CUDA_VISIBLE_DEVICES", allowed)
        assert [gpu.uuid for gpu in gpus()] == names
