"""Test how the simulator uses the machine on which it measures."""

import pytest
from toys import program

from experiments.simulation import host, nvidia
from experiments.simulation.nvidia import VISIBLE, accelerators, share_count
from measured_report.files.errors import ReportError
from measured_report.measuring.host import Accelerator
from measured_report.measuring.machine import measuring_device

FIRST = """
import sys
import warp as wp

class Told:
    def find_spec(name, *_):
        if name in ("newton", "mujoco_warp"):
            sys.exit(f"{name} comes with enable_backward={wp.config.enable_backward}")

sys.meta_path.insert(0, Told)
from experiments.simulation import host
"""
"""Program that stops at the import of the first module with kernels, which reads the
setting.
"""


def test_what_measures_compiles_no_gradients():
    assert program("-c", FIRST).stderr.endswith(" comes with enable_backward=False\n")


@pytest.mark.parametrize(("newton", "is_old"), [("1.3.1", True), ("1.7.0", False)])
def test_only_a_release_that_is_too_old_is_called_so(monkeypatch, newton, is_old):
    packages = {"newton": newton, "mujoco-warp": "4.0.0"}
    monkeypatch.setattr(host, "package_versions", lambda: packages)
    monkeypatch.setattr(host, "compile_first", lambda kind: "no module named x")
    with pytest.raises(ReportError) as error:
        host.prepare("cpu")
    assert f"newton {newton}, mujoco-warp 4.0.0 cannot run" in str(error.value)
    assert ("1.4.0 is the oldest that can" in str(error.value)) == is_old


SHARED = [
    (16, 81920, 1, False, 4),
    (16, 81920, 1, True, 16),
    (64, 81920, 1, True, 16),
    (3, 81920, 1, False, 3),
]
SHARED += [
    (16, 6144, 1, True, 3),
    (16, 6143, 1, True, 2),
    (16, 0, 1, True, 1),
    (15, 81920, 4, True, 3),
]
SHARED += [(7, 81920, 8, True, 1)]


@pytest.mark.parametrize(("cores", "mib", "gpus", "has_daemon", "count"), SHARED)
def test_a_gpu_is_shared_by_as_many_as_have_memory(
    monkeypatch, tmp_path, cores, mib, gpus, has_daemon, count
):
    monkeypatch.setattr("os.cpu_count", lambda: cores)
    monkeypatch.setenv(nvidia.MPS, str(tmp_path if has_daemon else tmp_path / "none"))
    (tmp_path / "control").touch()
    assert share_count(Accelerator("A GPU", mib, {}), gpus) == count


def test_gpus_are_those_that_the_process_may_use(monkeypatch):
    listing = "0, GPU-a, 81559, NVIDIA H100 80GB, HBM3\n1, GPU-b, [N/A], NVIDIA GB10\nno devices"
    monkeypatch.setattr(nvidia, "said", lambda *_: listing)
    both = [Accelerator("NVIDIA H100 80GB, HBM3", 81559, {VISIBLE: "GPU-a"})]
    both.append(Accelerator("NVIDIA GB10", 0, {VISIBLE: "GPU-b"}))
    for allowed, found in {"1": both[1:], "GPU-a, GPU-b": both, "": []}.items():
        monkeypatch.setenv(VISIBLE, allowed)
        assert accelerators() == found and measuring_device(None, "full") == (
            "cuda" if found else None
        ), allowed
