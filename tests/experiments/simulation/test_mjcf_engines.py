"""MJCF in three engines: the step that contacts are clamped to, and runs that blow up."""

import math

import numpy as np
import pytest

from experiments.scenes.capsule import Pinch
from experiments.simulation.c_warnings import RunFailed
from experiments.simulation.mjcf_engines import ENGINES


def test_the_model_through_newton_has_the_step_that_it_runs_with():
    """b of its contacts is clamped to two of them."""
    mjcf = Pinch("", timeconst_s=0.004).mjcf().replace('timestep="0.002"', 'timestep="0.003"')
    engines = [ENGINES[name](mjcf, 1, "cpu") for name in ("c", "newton")]
    for engine in engines:
        engine.command(np.array([[0.003, -0.003]]))
        for _ in range(20):
            engine.advance()
    there, through_newton = (engine.contacts().damping_per_s for engine in engines)
    assert through_newton == pytest.approx(there) and there == pytest.approx(2.0 / 0.95 / 0.006)


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
