"""Test the box on the turntable."""

import numpy as np
import pytest

from experiments.cure import turntable
from experiments.cure.turntable import SETTLE_S, VARIANTS, Variant
from experiments.simulation.c_warnings import RunFailed
from experiments.simulation.measurement import Conditions

CONDITIONS = Conditions(device="cpu", quick=True)


@pytest.mark.parametrize(
    "name",
    ["plain", "rk4", "noslip", "pyramidal", "half-timeconst", "term", "term-rk4"],
)
def test_the_box_on_the_turntable_goes_as_the_law_says(name):
    row = turntable.row_of("c", name, CONDITIONS)
    assert row["growth_per_s"] == pytest.approx(
        row["predicted_growth_per_s"], rel=0.005
    )
    assert row["loaded_contact_count"] == 4


def test_a_growth_is_that_of_what_has_settled():
    time_s = turntable.SAMPLE_S * np.arange(40)
    radius_m = np.where(time_s < SETTLE_S, 0.0005, 0.2 * np.exp(0.03 * time_s))
    assert turntable.growth_per_s(radius_m, SETTLE_S) == pytest.approx(0.03)


def test_a_turntable_that_blows_up_has_no_growth(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)  # MuJoCo writes a log there
    heavy = Variant(options={"gravity": "0 0 -1e12"})
    with pytest.raises(RunFailed, match="reset"):
        turntable.run("c", heavy.mjcf, 0.1, "cpu")
    monkeypatch.setitem(VARIANTS, "heavy", heavy)
    assert "reset" in turntable.row_of("c", "heavy", CONDITIONS)["growth_per_s_reason"]
