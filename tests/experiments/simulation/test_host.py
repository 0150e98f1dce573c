"""Tests of what the simulator does with the machine that it measures on."""

from conftest import program

COMPILED = """
from experiments.simulation import host
import warp as wp
print([name for name, module in wp._src.context.user_modules.items() if "newton" in name or "mujoco" in name
       if module.options["enable_backward"]])
"""


def test_what_measures_compiles_no_gradients():
    done = program("-c", COMPILED)
    assert done.stdout.splitlines()[-1:] == ["[]"], done.stderr
