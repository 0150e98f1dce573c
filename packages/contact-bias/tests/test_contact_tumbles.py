"""Tests of the benchmark: the starts of the bodies, and the counts of pairs."""

import mujoco
import numpy as np
import pytest

import contact_tumbles


def test_pairs_are_counted_by_which_of_them_gains_or_rises_and_a_world_that_breaks_down_gains():
    energies = np.array([[0.5, 1.02, 1.02, 1.0], [1.009, 1.011, 1.0, np.inf]])
    row = contact_tumbles.row_of(
        "box",
        0.002,
        energies,
        np.array([[0.0, 0.0, 0.0, 0.0], [0.0, 0.002, 0.0, -0.002]]),
    )
    counts = {name: cell for name, cell in row.items() if name.endswith("_count")}
    assert counts == {"pair_count": 4, "plain_gain_count": 2, "exact_gain_count": 2} | {
        "plain_alone_count": 1, "exact_alone_count": 1, "higher_count": 1, "lower_count": 1
    }  # fmt: skip
    assert (row["plain_most_energy"], row["exact_most_energy"]) == (
        1.02,
        contact_tumbles.BROKEN,
    )


def test_a_world_that_ends_without_a_number_voids_no_other():
    start = np.array([[[3.0, 2.0], [3.0, 2.0]]])
    most = np.array([[[3.0, np.inf], [5.0, 2.0]]])
    last = np.ones((1, 2, 2))
    last[0, 0, 1] = np.nan
    last[0, 1, 0] = 0.5
    assert np.array_equal(
        contact_tumbles.relative(start, most, last), [[[1.0, np.inf], [2.0, 1.0]]]
    )


@pytest.mark.parametrize("body", ["cone", "coin-on-block"])
def test_bodies_are_put_down_or_dropped(body):
    model = contact_tumbles.model_of(body)
    data = mujoco.MjData(model)
    for index, (data.qpos[:], data.qvel[:]) in enumerate(
        contact_tumbles.starts_of(model, 3)
    ):
        gaps = []
        for deeper_m in (-1e-4, 2e-4):
            data.qpos[-5] -= deeper_m
            mujoco.mj_forward(model, data)
            gaps.append(
                min(
                    (
                        contact.dist
                        for contact in data.contact
                        if model.ngeom - 1 in contact.geom
                    ),
                    default=1.0,
                )
            )
        assert -2e-4 < gaps[1] < 1e-6 if index < 9 else gaps == [1.0, 1.0]
        assert gaps[0] == 1.0
        assert 2.0 <= np.linalg.norm(data.qvel[-3:]) <= 40.0 or index >= 9
    assert index == 11
