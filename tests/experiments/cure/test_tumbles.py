"""Bodies that tumble: how worlds are counted."""

import numpy as np

from experiments.cure import tumbles


def test_a_world_that_breaks_down_is_counted_with_those_that_gain():
    left = np.tile([0.5, 1.005, 1.02, np.nan, np.inf], (len(tumbles.VARIANTS), 1))
    row = tumbles.row_of("box", 0.002, left)
    assert {row[f"{name}_gain_count"] for name in tumbles.VARIANTS} == {3} and row["world_count"] == 5
