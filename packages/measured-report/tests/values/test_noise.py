"""Noise: intervals and tests whose numbers are from tables, from SciPy, or worked by hand."""

import math
from functools import partial
from statistics import fmean

import numpy as np
import pytest

pytest.importorskip("scipy", reason="the extra test has it")
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
    fenced,
    t_quantile,
    variance_of,
    welch,
)
from measured_report.values.quantities import (
    PERCENT,
    Quantity,
    Value,
    combined,
    noise_of,
    samples_of,
)

SIZES = st.floats(1e-12, 1e12)


@pytest.mark.parametrize(
    "freedom", [1.0, 1.2, 1.5, 1.8, 2.0, 2.5, 3.0, 4.5, 7.0, 20.0, 100.0, math.inf]
)
@pytest.mark.parametrize("share", [0.9, 0.95, 0.999])
def test_quantiles_and_chances_are_those_of_student_s_t(freedom, share):
    exact = stats.t.ppf((1 + share) / 2, freedom)
    found = t_quantile(share, freedom)
    assert found == pytest.approx(
        exact, rel=0.03 if freedom < 3 else 2e-3 if freedom < 4 else 1e-4
    )
    assert chance_of(np.array([2 * found]), 2.0, freedom) == pytest.approx(
        [1 - share], rel=1e-5
    )


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
    """Of ten the third may be 0.003 at 1 %, and the fourth 0.004: a smaller one behind a larger counts as well."""
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
    """Of 1 to 7 and 100 the median is 4.5, and half are within 2 of it: five times 1.4826 times 2 is 14.826."""
    assert fenced([1, 2, 3, 4, 5, 6, 7, 100]) == pytest.approx(
        [1, 2, 3, 4, 5, 6, 7, 4.5 + 14.826]
    )
    assert fenced([-100, 2, 3, 4, 5, 6, 7, 8])[0] == pytest.approx(4.5 - 14.826)
    assert fenced([1, 2, 3, 4, 100]) == [1, 2, 3, 4, 100], (
        "too few to tell which is one"
    )
    assert fenced([5.0] * 7 + [9.0]) == [5.0] * 7 + [9.0], "no deviation to count in"
    assert variance_of([2, 4, 4, 4, 5, 5, 7, 9]) == pytest.approx(32 / 7)


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
    """Ends from Newcombe (1998), Statistics in Medicine 17, 857-872, table I, method 3; the last by symmetry."""
    share = successes / trials
    assert binomial_noise(share, trials) == pytest.approx(abs(end - share), abs=5e-5)


def test_the_noise_of_a_mean_is_its_confidence_interval():
    """Three costs of 23.3, 22.6 and 23.3 % have a deviation of 0.404 %: t of 4.303 makes ±1.00 % of their mean."""
    costs = [23.3, 22.6, 23.3]
    noise = Estimate(fmean(costs), variance_of(costs), freedom=2.0, count=3.0).noise
    assert noise == pytest.approx(stats.t.ppf(0.975, 2) * stats.sem(costs), rel=0.01)
    assert noise == pytest.approx(1.0, rel=0.05)
    known = Estimate(5.0, variance=0.04, freedom=20.0, count=4.0)
    assert known.noise == pytest.approx(stats.t.ppf(0.975, 20) * 0.1, rel=1e-3)
    assert Estimate(5.0, variance=0.04, count=4.0).noise == pytest.approx(
        0.196, rel=1e-3
    )
    assert Estimate(5.0, variance=1e-8, freedom=20.0, least=0.01).noise == 0.01
    assert Estimate(5.0).noise == Estimate(5.0).written_noise == 0.0
    assert (
        known.written_noise == known.noise
        and Estimate(5.0, least=1e-9).written_noise == 0.0025
    )


def test_two_means_are_compared_as_welch_does():
    """SciPy's own test on samples of 3 and 5."""
    a, b = [27.5, 21.0, 19.0], [27.1, 22.0, 20.8, 23.4, 23.4]
    variances = np.array(
        [[variance_of(a) / 3, variance_of(b) / 5], [0.0, 0.0], [9.0, 16.0]]
    )
    errors, freedoms = welch(
        variances, np.array([[2, 4], [math.inf, math.inf], [math.inf, math.inf]])
    )
    exact = stats.ttest_ind(a, b, equal_var=False)
    assert abs(fmean(a) - fmean(b)) / errors[0] == pytest.approx(abs(exact.statistic))
    assert freedoms == pytest.approx([exact.df, math.inf, math.inf])
    assert errors[1:] == pytest.approx([0.0, 5.0])


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


TENTHS = stats.t.ppf(0.975, 2) * 0.1 / 3**0.5  # of three that are a tenth apart
KNOWN = [
    (0.5, (2.0, 2.0), 0.5),
    (0.5, (1.9, 2.0, 2.1, None), TENTHS),
]  # those that agree say nothing
KNOWN += [
    (0.5, (1.99, 2.01), stats.t.ppf(0.975, 1) * 0.01),
    (0.1, (1.99, 2.01), 0.1),
]  # their mean is off by 0.01
KNOWN += [
    (0.2, (1.9, 2.0, 2.1), 0.2),
    (None, (1.9, 2.0, 2.1), None),
    (0.0, (), 0.0),
    (1e-9, (), 0.001),
]


@pytest.mark.parametrize(("noise", "samples", "expected"), KNOWN)
def test_a_value_has_the_noise_of_its_sources_or_of_its_measurements_if_that_is_less(
    noise, samples, expected
):
    source = Quantity(2.0, "mm", "a", noise=noise, samples=samples)
    assert noise_of(lambda number: number, [source]) == (
        expected and pytest.approx(expected, rel=5e-3)
    )
    assert ("measurements" in Value(**vars(source)).bare) == bool(
        len(samples) > 1 and noise
    )
    assert "measurements" not in source.bare
    assert samples_of(min, [source, Quantity(2.0, "mm", "b", noise=0.0)]) == [
        each and min(each, 2.0) for each in samples
    ]


@given(SIZES, SIZES, st.floats(1e-6, 0.5), st.floats(1e-6, 0.5))
def test_a_ratio_carries_the_noise_of_both_parts(above, below, share, other):
    noise = noise_by(lambda a, b: a / b, (above, share * above), (below, other * below))
    assert noise >= 0.999 * max(share, other) * above / below


def test_what_measurements_have_in_common_cancels_and_what_is_no_sum_is_moved_as_they_are_apart():
    """Cards of 10 and 11 ms are known within 6.35 ms, by t of one degree: 12.71 · 0.5 ms, as is half of each."""
    noise = stats.t.ppf(0.975, 1) * 0.5
    one, half = (
        Quantity(10.5, "ms", "a", noise=noise, samples=(10.0, 11.0)),
        partial(Quantity, unit="ms", source="b"),
    )
    alike, unlike = (
        half(5.25, noise=noise / 2, samples=(5.0, 5.5)),
        half(5.3, noise=0.6 * noise, samples=(5.0, 5.6)),
    )
    assert (one / alike).noise == pytest.approx(5e-4 * 2), "no more than is written"
    off, other = noise / 2**0.5, 0.6 * noise / 2**0.5
    by_hand = 2**0.5 * ((10.5 - off) / (5.3 - other) - 10.5 / 5.3)
    assert (one / unlike).noise == pytest.approx(by_hand, rel=1e-3)
    assert combined(
        lambda a, b: float(a > 1.99 * b), one, alike
    ).noise == pytest.approx(5e-4), "whatever the card"
    assert combined(lambda a, b: float(a > 10.6), one, alike).noise == 1.0, (
        "on some cards"
    )


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
        match=r"^6 mm and 2.0 s have no unit in common: derive them in one$",
    ):
        A - B
    with pytest.raises(ReportError, match="has no name to be shown by"):
        _ = term.bare
