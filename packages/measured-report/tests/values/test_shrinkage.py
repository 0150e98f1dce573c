"""Shrinkage: the strength that a column's variances show, and what is none of the column."""

import numpy as np
import pytest

pytest.importorskip("scipy", reason="the extra test has it")

from scipy import special, stats

from measured_report.values.noise import deviations_of
from measured_report.values.shrinkage import (
    digamma,
    left_out,
    moderated,
    prior_of,
    trigamma,
    trigamma_inverse,
)


@pytest.mark.parametrize("x", [0.5, 1.0, 1.5, 3.7, 50.0])
def test_gamma_s_derivatives_are_those_of_scipy(x):
    assert digamma(x) == pytest.approx(special.digamma(x), abs=1e-8)
    assert trigamma(x) == pytest.approx(special.polygamma(1, x), abs=1e-8)
    assert trigamma_inverse(float(trigamma(x))) == pytest.approx(x, rel=1e-6)


def variances(
    freedom: int, strength: float, count: int = 4000, level: float = 2.0
) -> np.ndarray:
    """Sample variances whose own are level · strength / χ² of the strength, as Smyth has them."""
    chance = np.random.default_rng(7)
    true = level * strength / chance.chisquare(strength, count)
    return true * chance.chisquare(freedom, count) / freedom


@pytest.mark.parametrize(
    ("freedom", "strength"), [(1, 4.0), (2, 4.0), (5, 4.0), (5, 12.0), (6, 20.0)]
)
def test_a_column_s_strength_and_level_are_found(freedom, strength):
    drawn = variances(freedom, strength)
    prior = prior_of(drawn, np.full(len(drawn), float(freedom)), np.ones(len(drawn)))
    assert prior.freedom == pytest.approx(
        strength, rel=0.5
    ) and prior.level == pytest.approx(2.0, rel=0.15)


def test_a_column_of_few_rows_is_taken_to_be_as_unlike_as_usual():
    """Three variances alike: 8 rows of strength 4 and 2 of none unlike weigh 0.8 and 0.2 of the variances of logs."""
    few = prior_of(np.array([2.0, 2.0, 2.0]), np.full(3, 5.0), np.ones(3))
    by_chance = special.polygamma(1, 2.5)
    unlike = 8 / 10 * (by_chance + special.polygamma(1, 2.0)) - by_chance
    assert special.polygamma(1, few.freedom / 2) == pytest.approx(unlike, rel=1e-5)
    many = prior_of(np.full(400, 2.0), np.full(400, 5.0), np.ones(400))
    assert many.freedom == 100.0


@pytest.mark.parametrize("slope", [0.0, 1.0, 2.0])
def test_variances_go_with_the_size_of_the_number_as_they_are_seen_to(slope):
    """1 µs and 62 µs in one column: the noise of one is none of the other."""
    sizes = np.tile([1.0, 62.0], 200)
    prior = prior_of(variances(4, 50.0, 400) * sizes**slope, np.full(400, 4.0), sizes)
    assert prior.slope == slope and prior.level == pytest.approx(2.0, rel=0.2)


def test_a_variance_counts_with_its_column_s_by_their_degrees_of_freedom():
    raw, freedoms = variances(4, 6.0), np.full(4000, 4.0)
    after = moderated(raw, freedoms, np.ones(4000))
    prior = prior_of(raw, freedoms, np.ones(4000))
    tame = after.lent > 0
    expected = (prior.freedom * prior.level + 4 * raw) / (prior.freedom + 4)
    assert after.variances[tame] == pytest.approx(expected[tame]) and after.freedoms[
        tame
    ] == pytest.approx(prior.freedom + 4)
    assert tame.mean() > 0.99


def test_what_is_wild_keeps_its_own_and_changes_nothing_for_the_others():
    tame = variances(3, 30.0, 60)
    wild = np.append(tame[1:], 1e6)
    plain, odd = (
        moderated(each, np.full(60, 3.0), np.ones(60)) for each in (tame, wild)
    )
    assert odd.variances[-1] == 1e6 and odd.freedoms[-1] == 3.0
    assert odd.variances[:-1] == pytest.approx(plain.variances[1:], rel=0.2)


def test_numbers_that_agree_to_the_last_bit_have_the_noise_of_rounding():
    agree = moderated(np.zeros(20), np.full(20, 2.0), np.full(20, 5.0))
    assert agree.variances == pytest.approx((5e-6) ** 2 / 12)
    some = moderated(
        np.append(np.zeros(16), variances(2, 8.0, 4)),
        np.full(20, 2.0),
        np.full(20, 5.0),
    )
    assert (
        some.variances[:16] == pytest.approx((5e-6) ** 2 / 12, rel=1e-6)
        and some.variances[16:].min() > 0.01
    )


def test_each_measurement_is_held_against_the_mean_of_the_others():
    """Of 1, 2, 3 and 10 the last is 8 from the mean of the others, whose deviation is 1: t is 8 / √(4/3)."""
    samples = np.array([[1.0, 2.0, 3.0, 10.0], [1.0, 2.0, 3.0, np.nan]])
    nothing = np.zeros(2)
    scores = left_out(samples, nothing, nothing, nothing)
    assert scores[0, 3] == pytest.approx(deviations_of(8 / (4 / 3) ** 0.5, 2.0))
    assert scores[1, 2] == pytest.approx(
        deviations_of(1.5 / (0.5 * 3 / 2) ** 0.5, 1.0)
    ) and np.isnan(scores[1, 3])
    lent = left_out(samples, np.array([6.0, 0.0]), np.array([9.0, 0.0]), nothing)
    assert lent[0, 3] == pytest.approx(
        deviations_of(8 / ((2 * 1 + 6 * 9) / 8 * 4 / 3) ** 0.5, 8.0)
    )
    least = left_out(samples, nothing, nothing, np.array([8.0, 0.0]))
    assert least[0, 3] == 0.0
    assert stats.norm.sf(deviations_of(3.182, 3.0)) == pytest.approx(0.025, rel=0.01)
