"""What measures: GPUs, and how many processes share one; kernels that several compile at once."""

import os
import subprocess
import sys

import pytest
import warp as wp

from measured_report.files.root import ROOT
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


@pytest.mark.slow
def test_processes_that_compile_into_one_cache_at_once_do_not_spoil_it(tmp_path):
    settings = {**os.environ, "WARP_CACHE_PATH": str(tmp_path)}
    command = [sys.executable, ROOT / "tests" / "kernels_at_once.py", tmp_path / "cuda"]

    both = [subprocess.Popen(command, env=settings, stdout=subprocess.PIPE, text=True) for _ in range(2)]
    assert [process.communicate()[0].strip() for process in both] == ["[0.0, 2.0, 4.0]"] * 2
    [folder] = (path for path in (tmp_path / wp.config.version).iterdir() if path.name.startswith("wp_"))
    assert sorted(path.suffix for path in folder.iterdir()) == [".cpp", ".meta", ".o"], "one of each, and no leavings"
    assert sorted(path.suffix for path in (tmp_path / "cuda").iterdir()) == [".cu", ".cubin", ".meta"]
