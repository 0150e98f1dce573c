"""Test runs of MJCF scenes that blow up in several engines."""

import math

import pytest
from stepping import BALL

from experiments.drivers.mjcf import ENGINES
from experiments.simulation.c_warnings import RunFailed


@pytest.mark.parametrize("name", ["c", "warp"])
def test_a_run_that_blows_up_fails(name, tmp_path, monkeypatch):
    """Test that a run fails instead of continuing. MuJoCo's C engine would restart it."""
    monkeypatch.chdir(tmp_path)  # the engine writes a log there
    engine = ENGINES[name](BALL, 1, "cpu")
    engine.advance()
    if name == "c":
        engine.worlds[0].qvel[0] = math.inf
    else:
        engine.data.qvel.fill_(math.inf)
    with pytest.raises(RunFailed):
        engine.advance()
