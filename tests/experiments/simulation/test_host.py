"""Tests of what the simulator does with the machine that it measures on."""

from toys import program

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
"""Ends where the first module with kernels is imported, which takes the setting over."""


def test_what_measures_compiles_no_gradients():
    assert program("-c", FIRST).stderr.endswith(" comes with enable_backward=False\n")
