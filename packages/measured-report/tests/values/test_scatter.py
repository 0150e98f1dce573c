"""Test the variances of a column, and which rows keep their own variance."""

import math

import numpy as np
import pytest
from scipy import special, stats

from measured_report.values.noise import (
    Scatter,
    t_quantile,
)
from measured_report.values.scatter import (
    LEAST_FREEDOM,
    LEAST_SHARE,
    Fit,
    fit_of,
    left_out,
    prior_of,
)

ROUNDING = (1e-6) ** 2 / 12


def variances(
    freedom: int, strength: float, count: int = 4000, level: float = 2.0
) -> np.ndarray:
    """Draw sample variances around level · strength / χ², as in Smyth's model."""
    chance = np.random.default_rng(7)
    true = level * strength / chance.chisquare(strength, count)
    return true * chance.chisquare(freedom, count) / freedom


def drawn(deviations: np.ndarray, count: int, seed: int = 1) -> np.ndarray:
    """Draw this many measurements of numbers that are all 1."""
    chance = np.random.default_rng(seed)
    return chance.normal(1.0, deviations[:, None], (len(deviations), count))


@pytest.mark.parametrize(
    ("freedom", "strength"), [(1, 4.0), (2, 4.0), (5, 4.0), (5, 12.0), (6, 20.0)]
)
def test_the_strength_and_the_level_of_a_column_are_found(freedom, strength):
    sample = variances(freedom, strength)
    prior = prior_of(sample, np.full(4000, float(freedom)), np.ones(4000))
    assert prior.freedom == pytest.approx(strength, rel=0.5)
    assert prior.level == pytest.approx(2.0, rel=0.15)


def test_the_estimate_is_that_of_smyth():
    """Compare with the formulas of section 6.2, with 8 more rows that have the usual
    strength of 4.
    """
    sample = variances(3, 6.0, 200)
    prior = prior_of(sample, np.full(200, 3.0), np.ones(200))
    logs = np.log(sample) - special.digamma(1.5) + np.log(1.5)
    low, high = np.quantile(logs, [0.25, 0.75])
    logs = np.minimum(logs, high + 1.5 * (high - low))
    by_chance = special.polygamma(1, 1.5)
    squares = logs.var() * 200 + 8 * (by_chance + special.polygamma(1, 2.0))
    unlike = squares / 207 - by_chance
    assert special.polygamma(1, prior.freedom / 2) == pytest.approx(unlike)
    half = prior.freedom / 2
    level = np.exp(logs.mean() + special.digamma(half) - np.log(half))
    assert prior.level == pytest.approx(level)


def test_a_column_of_few_rows_is_taken_to_be_as_unlike_as_usual():
    """Test three equal variances, which have a weight of 2 in 10; rows of the usual
    strength have the rest.
    """
    few = prior_of(np.full(3, 2.0), np.full(3, 5.0), np.ones(3))
    by_chance = special.polygamma(1, 2.5)
    unlike = 8 / 10 * (by_chance + special.polygamma(1, 2.0)) - by_chance
    assert special.polygamma(1, few.freedom / 2) == pytest.approx(unlike, rel=1e-5)
    many = prior_of(np.full(400, 2.0), np.full(400, 5.0), np.ones(400))
    assert many.freedom == 100.0


@pytest.mark.parametrize("slope", [0.0, 1.0, 2.0])
def test_variances_grow_with_the_number_as_the_column_shows(slope):
    """Test that 1 µs and 62 µs in one column have different noise."""
    sizes = np.tile([1.0, 62.0], 200)
    sample = variances(4, 50.0, 400) * sizes**slope
    prior = prior_of(sample, np.full(400, 4.0), sizes)
    assert prior.slope == slope
    assert prior.level == pytest.approx(2.0, rel=0.2)
    variance, freedom = prior.of("a row", 62.0)
    assert variance == pytest.approx(prior.level * 62.0**slope)
    assert freedom == prior.freedom


def test_a_row_and_its_column_count_by_their_degrees_of_freedom():
    """Test that the measurements of a row in several editions are counted together."""
    samples = drawn(np.full(60, 0.1), 4)
    rows = [f"row {index % 30}" for index in range(60)]
    scatter = fit_of(samples, rows).scatter
    own = samples.var(axis=1, ddof=1)
    levels = own / samples.mean(axis=1) ** scatter.slope
    lent = scatter.freedom
    expected = (lent * scatter.level + 3 * levels[5] + 3 * levels[35]) / (lent + 6)
    assert scatter.rows["row 5"] == pytest.approx((expected, lent + 6))
    assert scatter.of("row 5", 1.0) == pytest.approx((expected, lent + 6))


def test_a_row_measured_once_has_the_scatter_of_its_column():
    samples = drawn(np.full(40, 0.1), 4)
    samples[7, 1:] = np.nan
    scatter = fit_of(samples, range(40)).scatter
    assert scatter.of(7, 1.0) == (scatter.level, scatter.freedom)
    assert scatter.level == pytest.approx(0.01, rel=0.3)
    assert scatter.of(7, 1.0) == scatter.of("of another edition", 1.0)


def test_a_wild_row_keeps_its_own_variance_and_changes_no_other():
    tame = drawn(np.full(60, 0.1), 4)
    plain = fit_of(tame, range(60)).scatter
    odd = tame.copy()
    odd[-1] = [0.0, 40.0, 90.0, 7.0]
    fit = fit_of(odd, range(60))
    scatter = fit.scatter
    assert scatter.of(59, fit.values[59]) == pytest.approx((odd[-1].var(ddof=1), 3.0))
    for row in range(59):
        variance, _ = scatter.of(row, 1.0)
        assert variance == pytest.approx(plain.of(row, 1.0)[0], rel=0.25)


def test_an_outlier_is_moved_to_five_deviations_of_its_row():
    """Test the numbers 1 to 7 and 100, whose median is 4.5 and whose deviation is
    1.4826 times 2.
    """
    samples = np.array([[1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 100.0]])
    fit = fit_of(samples, ["a"], Scatter(1e-9, 0.0, 4.0))
    assert fit.values[0] == pytest.approx((28 + 4.5 + 14.826) / 8)
    assert fit.is_outlier.tolist() == [[False] * 7 + [True]]
    usual = fit_of(samples, ["a"], Scatter(400.0, 0.0, 4.0))
    assert usual.values[0] == 16.0, "the column scatters as much"
    pair = fit_of(samples[:, -2:], ["a"], Scatter(1e-9, 0.0, 4.0))
    assert pair.values[0] == 53.5, "two do not show which one is off"


def test_numbers_that_agree_to_the_last_bit_have_the_noise_of_rounding():
    agree = fit_of(np.full((20, 3), 5.0), range(20)).scatter
    assert agree.of(3, 5.0)[0] == pytest.approx(25 * ROUNDING)
    some = np.vstack([np.full((16, 3), 5.0), drawn(np.full(4, 0.1), 3)])
    scatter = fit_of(some, range(20)).scatter
    assert scatter.of(19, 1.0)[0] > 1e-3


def test_two_rows_that_scatter_count_unless_most_others_repeat():
    """Test two rows that scatter: they are a fifth of ten rows, and less than a tenth
    of 30 rows.
    """
    noisy = drawn(np.full(2, 0.1), 3)
    some = fit_of(np.vstack([np.full((8, 3), 5.0), noisy]), range(10)).scatter
    assert 1e-4 < some.level < 0.1
    few = fit_of(np.vstack([np.full((28, 3), 5.0), noisy]), range(30)).scatter
    assert few.level == pytest.approx(ROUNDING)


def test_a_number_close_to_zero_does_not_make_its_row_noisy_elsewhere():
    """Test a row that is about 1e-6 in one edition and 1.0 in another."""
    samples = drawn(np.full(60, 0.01), 4)
    samples[59] = [1e-6, 2e-6, -1e-6, 3e-6]
    scatter = fit_of(samples, [*range(59), 58]).scatter
    assert scatter.of(58, 1.0)[0] < 0.02**2
    small = samples[59].mean()
    own = samples[59].var(ddof=1)
    assert scatter.of(58, small)[0] == pytest.approx(own, rel=0.3)
    assert scatter.key(58, 0.9 * LEAST_SHARE) != scatter.key(58, 1.1 * LEAST_SHARE)


def test_a_small_number_of_a_column_with_large_ones_scatters_like_itself():
    """Test errors of 1 and of 1e-5 in one column. Both have a noise of 1 %."""
    chance = np.random.default_rng(3)
    sizes = np.repeat([1.0, 1e-5], 30)
    samples = sizes[:, None] * chance.normal(1.0, 0.01, (60, 4))
    variance, _ = fit_of(samples, range(60)).scatter.of(45, 1e-5)
    assert variance == pytest.approx(1e-14, rel=0.9)


def test_variances_that_have_nothing_in_common_leave_a_finite_quantile():
    wild = 10.0 ** np.linspace(-12, 12, 200)
    prior = prior_of(wild, np.full(200, 3.0), np.ones(200))
    assert prior.freedom == LEAST_FREEDOM
    assert math.isfinite(t_quantile(0.999, prior.freedom))


def test_few_rows_keep_their_own_variance_and_lend_their_mean_to_others():
    """Test variances of 0.02 around 1.1 and around 2.2, and a row that has none."""
    samples = np.array([[1.0, 1.2], [2.1, 2.3], [4.0, np.nan]])
    scatter = fit_of(samples, "abc").scatter
    assert scatter.of("a", 1.1) == pytest.approx((0.02, 1.0))
    mean = (0.02 / 1.21 + 0.02 / 4.84) / 2
    assert scatter.of("c", 4.0) == pytest.approx((16 * mean, 2.0))


def test_a_row_that_repeats_well_in_one_edition_can_be_wild_in_another():
    """Test a variance of 14 times that of its column, and one of zero."""
    general = Scatter(1e-4, 0.0, 100.0)
    samples = np.array([[1.0, 1.0], [1.0, 1.0 + np.sqrt(2.8e-3)]])
    scatter = fit_of(samples, "aa", general).scatter
    assert scatter.of("a", 1.0) == pytest.approx((1.4e-3 / 2, 2.0))
    apart = fit_of(samples, "ab", general).scatter
    assert apart.of("a", 1.0) == pytest.approx((1e-4 * 100 / 101, 101.0))


def test_a_count_on_which_all_measurements_agree_is_certain():
    """Test counts of 8 and of about 10, where the relative variance is about 0.01."""
    general = Scatter(0.01, 2.0, 4.0)
    scatter = fit_of(np.array([[8.0, 8.0], [9.0, 11.0]]), "ab", general).scatter
    assert scatter.of("a", 8.0) == pytest.approx((64 * ROUNDING, 1.0))
    assert scatter.of("b", 10.0) == pytest.approx((100 * (0.04 + 0.02) / 5, 5.0))


def test_a_column_with_two_rows_scatters_as_it_does_elsewhere():
    samples = drawn(np.full(2, 0.1), 3)
    general = Scatter(0.04, 0.0, 8.0)
    scatter = fit_of(samples, range(2), general).scatter
    assert (scatter.level, scatter.freedom) == (0.04, 8.0)
    own = samples[0].var(ddof=1)
    assert scatter.of(0, 1.0) == pytest.approx(((8 * 0.04 + 2 * own) / 10, 10.0))


@pytest.mark.parametrize(("lent", "level"), [(6.0, 9.0), (0.0, 0.0)])
def test_each_measurement_is_predicted_by_the_others(lent, level):
    """Test the numbers 1, 2, 3 and 10; the mean of the first three is 2.

    The squares of the first three add up to 2, and those of all four to 50; the
    column's deviation applies.
    """
    samples = np.array([[1.0, 2.0, 3.0, 10.0]])
    with_row = (lent * level + 50) / (lent + 3)
    scatter = Scatter(level, 0.0, lent, {"a": (with_row, lent + 3)})
    fit = Fit(scatter, samples, np.zeros((1, 4), bool))
    distances, errors, freedoms = left_out(samples, ["a"], fit)
    assert distances[0] == pytest.approx([4.0, 8 / 3, 4 / 3, 8.0], abs=1e-5)
    variance = (lent * level + 2) / (lent + 2)
    assert errors[0, 3] == pytest.approx((variance * 4 / 3) ** 0.5)
    assert freedoms[0, 3] == lent + 2


def test_nothing_is_predicted_without_a_second_measurement():
    samples = np.array([[1.0, np.nan], [1.0, 2.0]])
    scatter = Scatter(1.0, 0.0, 4.0, {"b": (0.5, 1.0)})
    fit = Fit(scatter, samples, np.zeros((2, 2), bool))
    assert np.isnan(left_out(samples, ["a", "b"], fit)[0]).all()


@pytest.mark.parametrize("count", [2, 3, 5, 8])
def test_intervals_cover_the_truth_and_what_is_left_out(count):
    """Draw rows whose deviations differ as much as those of a real column."""
    covered = []
    predicted = []
    for seed in range(12):
        chance = np.random.default_rng(seed)
        deviations = 0.1 * np.sqrt(8 / chance.chisquare(8, 40))
        samples = drawn(deviations, count, seed)
        fit = fit_of(samples, range(40))
        for row, value in enumerate(fit.values):
            variance, freedom = fit.scatter.of(row, abs(value))
            reach = stats.t.ppf(0.975, freedom) * (variance / count) ** 0.5
            covered.append(abs(value - 1) <= reach)
        distances, errors, freedoms = left_out(samples, range(40), fit)
        within = stats.t.ppf(0.975, freedoms) * errors
        predicted.append(distances <= within)
    assert 0.92 <= np.mean(covered) <= 0.98
    assert 0.93 <= np.mean(predicted) <= 0.98
