"""Test that numbers are printed with the digits that their noise permits, and chosen
numbers as they were chosen.
"""

import math
import re
from decimal import Decimal

import pytest

pytest.importorskip("hypothesis", reason="the extra test has it")

from hypothesis import assume, example, given
from hypothesis import strategies as st

from measured_report.values.format import (
    format_least,
    format_most,
    format_number,
    label_of,
)


def read(text: str) -> Decimal:
    """Return the number that was written as a text."""
    digits = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹\u2212", "-0123456789-", "\u202f")
    mantissa, _, power = re.fullmatch(
        r"(-?[\d.]+?)?(×?10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?",
        text.translate({0x202F: None, 0x2212: "-"}),
    ).groups()
    return Decimal(mantissa or 1).scaleb(int((power or "⁰").translate(digits)))


SIZES = st.floats(1e-12, 1e12)
VALUES = st.builds(math.copysign, SIZES, st.sampled_from((1.0, -1.0)))


def last_place(text: str) -> Decimal:
    """Test the size of the last digit.

    Zeros at the end of a whole number may not be significant.
    """
    number = read(text)
    return Decimal(1).scaleb(
        number.as_tuple().exponent
        if "." in text
        else number.normalize().as_tuple().exponent
    )


@given(VALUES, SIZES)
@example(0.004, 0.0011)
@example(9.996, 0.0011)
def test_rounding_moves_by_no_more_than_half_the_noise_and_writes_no_digits_for_nothing(
    value, noise
):
    text = format_number(value, noise=noise)
    if abs(value) <= noise:
        size = Decimal(repr(noise)) + Decimal(repr(abs(value)))
        assert text.startswith("<") and read(text[2:]) >= size
        return
    error, half = abs(read(text) - Decimal(repr(value))), Decimal(repr(noise)) / 2
    assert error <= half
    assert len(text) == 1 or last_place(text) * 10 > half / 5, (
        "a digit less would have moved it by more"
    )


@given(st.integers(-(10**6), 10**6), st.integers(-4, 4))
def test_what_was_typed_is_written_as_it_was(digits, power):
    typed = Decimal(digits).scaleb(power)
    assume(typed == 0 or typed.adjusted() < 12)
    assert read(format_number(float(typed), noise=0.0)) == typed


@given(VALUES, st.one_of(st.none(), st.just(0.0), SIZES))
@example(1.181, 0.5)
@example(0.0, 0.0059)
@example(0.020000000000000462, None)
def test_a_bound_contains_the_interval_of_the_number(value, noise):
    most, least = (
        read(format_most(value, noise=noise)),
        read(format_least(value, noise=noise)),
    )
    width = Decimal(repr(noise or 0.0))
    dust = Decimal("1e-9") * abs(Decimal(value))
    assert most + dust >= Decimal(value) + width
    assert least - dust <= max(Decimal(value) - width, Decimal(0))
    assert format_most(0.020000000000000462) == format_least(0.02) == "0.020"


LABELS = {
    "as-shipped": "shipped pads",
    "ke-#-1": "ke {}, 1 step",
    "ke-#-#": "ke {}, {} steps",
    "kd-#-#": "kd {1}",
}


@pytest.mark.parametrize(
    ("case", "label"),
    [
        ("as-shipped", "shipped pads"),
        ("as-shipped-10cm", "as shipped 10cm"),
        ("ke-4.64e+04-1", "ke 46400, 1 step"),
        ("ke-2.5e6-16", "ke 2.5×10⁶, 16 steps"),
        ("ke-1e-10-0.2", "ke 10⁻¹⁰, 0.2 steps"),
        ("kd-100-8e3", "kd 8000"),
        ("has_no-label", "has no label"),
    ],
)
def test_a_case_is_called_by_the_first_label_that_fits_or_by_its_own_name(case, label):
    assert label_of(case, LABELS) == label
