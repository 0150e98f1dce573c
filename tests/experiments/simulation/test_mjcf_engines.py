"""MJCF in three engines: the step that contacts are clamped to, and runs that blow up."""

import math

import pytest

from experiments.scenes.capsule import Pinch
from experiments.simulation.c_warnings import RunFailed
from experiments.simulation.mjcf_engines import ENGINES


@pytest.mark.parametrize("name", ENGINES)
def test_a_run_that_blows_up_fails(name, tmp_path, monkeypatch):
    """MuJoCo's C engine would go on from the beginning."""
    monkeypatch.chdir(tmp_path)  # where it keeps a log of it
    engine = ENGINES[name](Pinch("").mjcf(), 1, "cpu")
    engine.advance()
    if name == "c":
        engine.worlds[0].qvel[0] = math.inf
    else:
        engine.data.qvel.fill_(math.inf)
    with pytest.raises(RunFailed):
        engine.advance()
