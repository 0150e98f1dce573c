"""GPUs to measure on, and how many processes share one."""

from measured_report.measuring import machine
from measured_report.measuring.machine import Gpu, gpus, share_count

LISTING = "0, GPU-a, 144000, NVIDIA H200\n1, GPU-b, [N/A], NVIDIA GB10\nno devices"


def test_gpus_are_those_that_this_process_may_use(monkeypatch):
    monkeypatch.setattr(machine, "said", lambda *command: LISTING)
    monkeypatch.delenv("CUDA_VISIBLE_DEVICES", raising=False)
    assert gpus() == [Gpu("GPU-a", 144000, "NVIDIA H200"), Gpu("GPU-b", 0, "NVIDIA GB10")]
    for allowed, names in {"1": ["GPU-b"], "GPU-a, 1": ["GPU-a", "GPU-b"], "": []}.items():
        monkeypatch.setenv("CUDA_VISIBLE_DEVICES", allowed)
        assert [gpu.uuid for gpu in gpus()] == names


def test_more_processes_share_a_gpu_where_a_daemon_lets_them(tmp_path, monkeypatch):
    monkeypatch.setenv(machine.MPS, str(tmp_path))
    monkeypatch.setattr(machine.os, "cpu_count", lambda: 24)
    large, small, untold = (Gpu("", size, "") for size in (144_000, 6_000, 0))
    assert [share_count(gpu) for gpu in (large, small, untold)] == [4, 2, 1]
    (tmp_path / "control").touch()
    assert [share_count(gpu) for gpu in (large, small, untold)] == [16, 2, 1]
    assert share_count(large, 8) == 3, "a core each"
