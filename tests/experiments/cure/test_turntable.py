"""The box on the turntable."""

import pytest

from experiments.cure import turntable
from experiments.simulation.c_warnings import RunFailed


@pytest.mark.parametrize("name", ["plain", "rk4", "noslip", "pyramidal", "half-timeconst", "term", "term-rk4"])
def test_the_box_on_the_turntable_goes_as_the_law_says(name):
    case = next(case for case in turntable.CASES if case.name == f"{name}-c")
    run = turntable.run_in_c(case, 3.0)
    growth = turntable.growth_columns(run)["growth_per_s"]
    assert growth == pytest.approx(turntable.predicted_growth_per_s(case, run), rel=0.005)


def test_a_turntable_that_blows_up_has_no_growth(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # where MuJoCo keeps a log of it
    with pytest.raises(RunFailed, match="reset"):
        turntable.run_in_c(turntable.Turntable("", "c", options={"gravity": (0.0, 0.0, -1e12)}), 0.1)
