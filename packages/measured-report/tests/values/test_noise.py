"""Test intervals and statistical tests with numbers from tables, from SciPy or computed
by hand.
"""

import math
import operator
import pickle
from functools import partial
from statistics import fmean

import numpy as np
import pytest

pytest.importorskip("hypothesis", reason="the extra test has it")

from hypothesis import given
from hypothesis import strategies as st
from scipy import stats

from measured_report.files.errors import ReportError
from measured_report.values.noise import (
    Estimate,
    binomial_noise,
    chance_of,
    discoveries,
    exceeds_chance,
    exceeds_share,
    fenced,
    t_quantile,
    variance_of,
)
from measured_report.values.quantities import (
    PERCENT,
    Quantity,
    Value,
    combined,
    extreme_noise,
    noise_of,
    samples_of,
)

SIZES = st.floats(1e-12, 1e12)


@pytest.mark.parametrize("freedom", [1.0, 1.5, 2.0, 3.0, 7.0, 100.0, math.inf])
@pytest.mark.parametrize("share", [0.9, 0.95, 0.999])
def test_quantiles_and_chances_are_those_of_student_s_t(freedom, share):
    quantile = t_quantile(share, freedom)
    assert quantile == pytest.approx(stats.t.ppf((1 + share) / 2, freedom))
    chances = chance_of(np.array([2 * quantile]), 2.0, freedom)
    assert chances == pytest.approx([1 - share])


def test_a_chance_is_of_the_difference_in_standard_errors():
    normal, student, none, exact = chance_of(
        np.array([3.92, 5.0, 0.0, 1e-9]),
        np.array([2.0, 1.0, 1.0, 0.0]),
        np.array([math.inf, 10.0, 5.0, 5.0]),
    )
    assert normal == pytest.approx(0.05, rel=1e-3)  # 1.96 of a normal distribution
    assert student == pytest.approx(2 * stats.t.sf(5.0, 10), rel=1e-3)
    assert none == 1.0 and exact < 1e-20


def test_the_chances_that_count_are_those_of_benjamini_and_hochberg():
    """Test ten probabilities at 1 %: the third may be 0.003 and the fourth 0.004.

    A smaller probability that follows a larger one counts, too.
    """
    chances = [0.0005, 0.0021, 0.0029, 0.02, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0]
    assert discoveries(chances) == 0.0029 and discoveries(chances[::-1]) == 0.0029
    adjusted = stats.false_discovery_control(chances)
    assert [chance <= discoveries(chances) for chance in chances] == [
        each <= 0.01 for each in adjusted
    ]
    assert (
        discoveries([0.002, 0.5, 0.6]) == 0.002
        and discoveries([0.004, 0.5, 0.6]) == 0.0
    )
    assert discoveries([]) == 0.0


def test_an_outlier_is_moved_to_five_deviations_of_the_middle_half():
    """Test the median 4.5 of 1 to 7 and 100.

    Half of the numbers are within 2 of it, and five times 1.4826 times 2 is 14.826.
    """
    assert fenced([1, 2, 3, 4, 5, 6, 7, 100]) == pytest.approx(
        [1, 2, 3, 4, 5, 6, 7, 4.5 + 14.826]
    )
    assert fenced([-100, 2, 3, 4, 5, 6, 7, 8])[0] == pytest.approx(4.5 - 14.826)
    assert fenced([1, 2, 3, 4, 100]) == [1, 2, 3, 4, 100], (
        "too few to tell which is one"
    )
    assert fenced([5.0] * 7 + [9.0]) == [5.0] * 7 + [9.0], "no deviation to count in"
    assert variance_of([2, 4, 4, 4, 5, 5, 7, 9]) == pytest.approx(32 / 7)


def test_a_count_of_rare_events_is_held_against_poisson_and_binomial():
    for count in range(1, 12):
        by_chance = stats.poisson.sf(count - 1, 2.5)
        assert exceeds_chance(count, 2.5) == (by_chance < 0.01)
        by_share = stats.binom.sf(count - 1, 12, 0.3)
        assert exceeds_share(count, 12, 0.3) == (by_share < 0.01)
    assert not exceeds_chance(0, 0.0)
    assert not exceeds_share(0, 12, 0.3)
    assert exceeds_chance(1, 0.005), "which chance gives in 0.5 % of comparisons"


@pytest.mark.parametrize(
    ("successes", "trials", "end"),
    [
        (81, 263, 0.3662),
        (15, 148, 0.1605),
        (0, 20, 0.1611),
        (1, 29, 0.1718),
        (20, 20, 1 - 0.1611),
    ],
)
def test_the_noise_of_a_share_is_of_wilson_s_interval(successes, trials, end):
    """Compare with Newcombe (1998), Statistics in Medicine 17, 857-872, table I, method
    3; the last interval follows by symmetry.
    """
    share = successes / trials
    assert binomial_noise(share, trials) == pytest.approx(abs(end - share), abs=5e-5)


def test_the_noise_of_a_mean_is_its_confidence_interval():
    """Test costs of 23.3, 22.6 and 23.3 %.

    Their deviation is 0.404 %, and with t = 4.303 the noise of their mean is ±1.00 %.
    """
    costs = [23.3, 22.6, 23.3]
    noise = Estimate(fmean(costs), variance_of(costs), freedom=2.0, count=3.0).noise
    assert noise == pytest.approx(stats.t.ppf(0.975, 2) * stats.sem(costs), rel=0.01)
    assert noise == pytest.approx(1.0, rel=0.05)
    known = Estimate(5.0, variance=0.04, freedom=20.0, count=4.0)
    assert known.noise == pytest.approx(stats.t.ppf(0.975, 20) * 0.1)
    assert Estimate(5.0, variance=0.04, count=4.0).noise == pytest.approx(
        0.196, rel=1e-3
    )
    assert Estimate(5.0, variance=1e-8, freedom=20.0, least=0.01).noise == 0.01
    assert Estimate(5.0).noise == Estimate(5.0).written_noise == 0.0
    assert (
        known.written_noise == known.noise
        and Estimate(5.0, least=1e-9).written_noise == 0.0025
    )


def noise_by(function, *numbers):
    return noise_of(
        function, [Quantity(value, "1", "", noise=noise) for value, noise in numbers]
    )


def test_a_derived_number_has_the_noise_of_its_sources_in_squares():
    assert noise_by(lambda a, b: a - b, (5.0, 0.3), (1.0, 0.4)) == pytest.approx(0.5)
    assert noise_by(lambda a, b: a / b, (10.0, 0.0), (2.0, 0.5)) == pytest.approx(
        10 / 1.5 - 5
    ), "the farther way"
    assert noise_by(
        lambda *numbers: sum(numbers) / 4, *[(1.0, 0.2)] * 4
    ) == pytest.approx(0.1)


@given(SIZES, SIZES, st.floats(1e-6, 0.5), st.floats(1e-6, 0.5))
def test_a_ratio_carries_the_noise_of_both_parts(above, below, share, other):
    noise = noise_by(lambda a, b: a / b, (above, share * above), (below, other * below))
    assert noise >= 0.999 * max(share, other) * above / below


def times(*samples: float | None, noise: float = 1.0) -> Quantity:
    """Return a time from several measurements."""
    value = fmean(sample for sample in samples if sample is not None)
    return Quantity(value, "ms", "a", noise=noise, samples=samples, is_shared=True)


SLOW = times(10.0, 11.0, 12.0)
HALF = times(5.0, 5.5, 6.0)
UNLIKE = times(5.0, 5.6, 6.0)


def test_the_host_cancels_in_a_ratio_that_three_measurements_have():
    assert (SLOW / HALF).noise == pytest.approx(5e-4 * 2), "no more than is written"
    longest = combined(lambda a, b: float(a > 1.99 * b), SLOW, HALF)
    assert longest.noise == pytest.approx(5e-4), "whatever the host"


def test_a_difference_of_times_has_the_interval_of_paired_measurements():
    pairs = zip(SLOW.samples, UNLIKE.samples, strict=True)
    interval = stats.t.ppf(0.975, 2) * stats.sem([a - b for a, b in pairs])
    assert (SLOW - UNLIKE).noise == pytest.approx(interval)
    missing = times(10.0, 11.0, 12.0, None) - times(5.0, 5.6, 6.0, 5.7)
    assert missing.samples[-1] is None
    assert missing.noise == pytest.approx(interval), "of those that have both"


def test_a_number_measured_once_adds_its_own_noise_to_that_of_times():
    """Test a number with one exact half in each measurement: 3 ± 0.4 and a paired
    difference.
    """
    alone = Quantity(3.0, "ms", "b", noise=0.4)
    paired = (SLOW - UNLIKE).noise
    assert (SLOW - UNLIKE - alone).noise == pytest.approx(math.hypot(paired, 0.4))


def test_a_term_that_occurs_twice_is_one_operand_across_editions():
    known = partial(Quantity, unit="mm", noise=0.3)
    largest = combined(max, known(5.0, source="a"), known(1.0, source="b"))
    same = combined(lambda a, b: a - b, largest, largest, across=True)
    assert same.noise == 0.0


def test_two_measurements_do_not_show_what_times_have_in_common():
    difference = times(10.0, 11.0) - times(5.0, 5.5)
    assert difference.noise == pytest.approx(2**0.5)
    physics = partial(Quantity, unit="mm", source="a", noise=1.0)
    a = physics(11.0, samples=SLOW.samples)
    b = physics(5.5, samples=HALF.samples)
    assert (a - b).noise == pytest.approx(2**0.5), "nor have slips anything in common"


def test_a_number_without_noise_leaves_a_derived_one_without():
    unknown = Quantity(2.0, "mm", "a")
    assert noise_of(operator.neg, [unknown]) is None
    assert noise_of(operator.neg, [Quantity(2.0, "mm", "a", noise=0.0)]) == 0.0
    least = noise_of(operator.neg, [Quantity(2.0, "mm", "a", noise=1e-9)])
    assert least == pytest.approx(0.001), "of which digits are written"


def test_a_value_says_what_each_of_its_measurements_gave():
    known = Quantity(2.0, "mm", "a", noise=0.2, samples=(1.9, 2.0, 2.1, None))
    assert "in 3 measurements 1.9, 2, 2.1" in Value(**vars(known)).bare
    assert "measurements" not in known.bare
    assert samples_of(min, [known, Quantity(2.0, "mm", "b", noise=0.0)]) == [
        1.9,
        2.0,
        2.0,
        None,
    ]


def test_the_interval_of_an_extreme_holds_for_each_that_may_be_it():
    """Test that five errors stay below 2.319 deviations in 95 % of all cases, because
    0.9898⁵ = 0.95.
    """
    five = extreme_noise(max, [1.0] * 5, [0.2] * 5)
    assert five == pytest.approx(0.2 * 2.319 / 1.96, rel=1e-3)
    assert stats.norm.cdf(2.319) ** 5 == pytest.approx(0.95, abs=1e-4)
    one = extreme_noise(min, [1.0, 3.0, 4.0], [0.2, 0.2, 0.2])
    assert one == pytest.approx(0.2), "no other number is near"
    wide = extreme_noise(max, [1.0, 0.5], [0.1, 2.0])
    assert wide == pytest.approx(1.5), "the second may be as large as 2.5"


def test_a_combined_extreme_has_the_noise_of_an_extreme_and_none_without_its_parts():
    numbers = [
        Quantity(value, "mm", f"toy.json#/rows/{index}/a_mm", noise=noise)
        for index, (value, noise) in enumerate([(1.0, 0.1), (0.5, 2.0)])
    ]
    assert combined(max, *numbers).noise == pytest.approx(1.5)
    unknown = Quantity(0.9, "mm", "toy.json#/rows/2/a_mm")
    assert combined(max, *numbers, unknown).noise is None


@pytest.mark.parametrize("choose", [max, min])
def test_the_truth_of_an_extreme_of_24_equal_rows_is_within_its_noise(choose):
    chance = np.random.default_rng(24)
    truth = 5.0
    noise = 1.96 * 0.1
    inside = []
    for numbers in chance.normal(truth, 0.1, (2000, 24)).tolist():
        reach = extreme_noise(choose, numbers, [noise] * 24)
        inside.append(abs(choose(numbers) - truth) <= reach)
    assert 0.93 <= np.mean(inside) <= 0.97


@pytest.mark.parametrize("apart", [0.0, 0.05, 0.1, 0.2, 0.4])
def test_the_truth_of_an_extreme_of_unlike_rows_is_within_its_noise(apart):
    chance = np.random.default_rng(3)
    truths = np.array([5.0, 5.0 - apart, 5.0 - apart])
    inside = []
    for numbers in chance.normal(truths, 0.1, (2000, 3)).tolist():
        reach = extreme_noise(max, numbers, [0.196] * 3)
        inside.append(abs(max(numbers) - 5.0) <= reach)
    assert 0.93 <= np.mean(inside) <= 0.995


A = Quantity(
    6.0, "mm", "toy.json#/rows/0/a_mm", noise=0.3, samples=(5.9, 6.0, 6.1, 6.0)
)
B = Quantity(2.0, "s", "toy.json#/rows/0/b_s", noise=0.1, samples=(2.1, None, 1.9, 2.0))
TERMS = (
    A / B * B,
    A * B * B / 2,
    1 / B,
    B / (A * A),
    2 - A / A,
    PERCENT * abs(-A) / A,
    sum([A, A]),
    combined(max, A, A),
)


def test_arithmetic_is_one_formula_of_what_was_measured():
    term, formula = (
        PERCENT * (1 - A / (A + A / B * B)),
        lambda a, b: 100 * (1 - a / (a + a / b * b)),
    )
    assert (term.value, term.samples) == (
        formula(6.0, 2.0),
        samples_of(formula, [A, B]),
    )
    assert term.noise == noise_of(formula, [A, B])
    assert (term.reads, (A - A).noise, (A - A).samples[0]) == (
        {A.source, B.source},
        0.0,
        0.0,
    )
    assert [term.unit for term in TERMS] == [
        "mm",
        "mm·s²",
        "1/s",
        "s/mm²",
        "1",
        "%",
        "mm",
        "mm",
    ]
    with pytest.raises(
        ReportError,
        match=r"^6 mm and 2.0 s do not have the same unit: correct the formula$",
    ):
        A - B
    for unnamed in (term, pickle.loads(pickle.dumps(term))):
        with pytest.raises(ReportError, match="is printed without a name: derive it"):
            _ = unnamed.bare
