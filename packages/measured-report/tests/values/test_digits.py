"""Test digits computed by hand: the rounding of numbers, bounds, and numbers that fit
into a figure.
"""

import pytest

from measured_report.values import format as module
from measured_report.values.format import (
    THIN_SPACE,
    format_least,
    format_most,
    format_number,
)
from measured_report.values.quantities import Quantity, Value


def thin(text: str) -> str:
    return text.replace(" ", THIN_SPACE).replace("-", "\u2212")


NOISY = {
    (120.6, 1.5): "121",
    (123.4, 2.0): "123",
}  # half the noise is below ten; the noise itself would give 120
NOISY |= {
    (12.5, 1.0): "13",
    (12.4, 0.75): "12.4",
}  # 12.5 differs by exactly half the noise, and 12 by more
NOISY |= {
    (8.0, 5.0): "8",
    (6.0, 1e-5): "6.00",
    (6.3617, 1e-5): "6.3617",
    (99.96, 0.1): "100",
    (0.5625, 0.5): "0.6",
}
NOISY |= {
    (-0.5, 0.5): "< 1",
    (1e-3, 0.1041): "< 0.11",
    (-0.5, 1.5): "< 2",
    (0.25, 1.5): "< 2",
    (0.036, 0.09): "< 0.13",  # not 0.09
}
NOISY |= {
    (1e-4, 0.1091): "< 0.11",
    (0.0, 0.5): "0",
    (140.2, 32.0): "140",
    (20.1, 0.31): "20",
    (20.3, 0.31): "20.3",
}
NOISY |= {
    (9.996, 0.01): "10.0",
    (9.996, 0.001): "9.996",
    (7156287.3, 1e5): "7 200 000",
    (11.45, 0.1): "11.5",
}
EXACT = {
    123456.0: "123 456",
    1234567.0: "1 230 000",
    0.1234565: "0.123",
    0.00125: "0.00125",
    1e7: "10⁷",
}
BARE = {
    6.25: "6.3",
    9.96: "10",
    -9.96: "-10",
    1e-4: "0.00010",
    1.2e-5: "1.2 × 10⁻⁵",
    1.2e6: "1 200 000",
}
BARE |= {1.2e7: "1.2 × 10⁷", -5: "-5", -1.5e-12: "-1.5 × 10⁻¹²", 1234567: "1 234 567"}


def test_a_number_is_rounded_at_half_its_noise_to_three_digits_or_without_one_to_two():
    assert {key: format_number(key[0], noise=key[1]) for key in NOISY} == {
        key: thin(NOISY[key]) for key in NOISY
    }
    assert {value: format_number(value, noise=0.0) for value in EXACT} == {
        key: thin(EXACT[key]) for key in EXACT
    }
    assert {value: format_number(value) for value in BARE} == {
        key: thin(BARE[key]) for key in BARE
    }


BOUNDS = [
    (6.361, 0.01, "6.371", "6.35"),
    (6.369, 0.01, "6.38", "6.359"),
]  # 6.38 would differ from 6.371 by more than 0.005
BOUNDS += [
    (-6.365, 0.01, "-6.35", "-6.38"),
    (0.31, 0.5, "0.9", "0"),
    (1.5, 1.0, "3", "0.5"),
    (5, 1.2, "6.2", "3.8"),
    (0.0, 0.5, "0.5", "0"),
    (0.0, 0.0, "0", "0"),
]
BOUNDS += [
    (0.0, None, "0", "0"),
    (0.1 + 0.2, 0.02, "0.33", "0.28"),
    (0.1 + 0.2, None, "0.30", "0.30"),
    (3, None, "3", "3"),
    (0.321, None, "0.33", "0.32"),
]


@pytest.mark.parametrize(
    ("value", "noise", "most", "least"), [*BOUNDS, (2 / 3, 0.0, "0.667", "0.666")]
)
def test_a_bound_is_rounded_away_from_what_it_bounds(value, noise, most, least):
    assert (format_most(value, noise=noise), format_least(value, noise=noise)) == (
        thin(most),
        thin(least),
    )
    found = Value(value, "mm", "values.json#/a", noise=noise)
    assert 'data-as="most"' in found.most and f">{thin(most)}<" in found.most
    assert 'data-as="least"' in found.least and f">{thin(least)}<" in found.least
    assert format_most(None) == format_least(None) == "n/a"


def test_dust_lies_behind_the_twelfth_digit_and_a_program_reads_six():
    assert (
        module.without_rounding_error(1.23456789012345) == 1.23456789012
        and module.without_rounding_error(3) == 3
    )
    codes = {123456.7: "123457", 0.1234567: "0.123457", 0.5: "0.5", None: "n/a"}
    assert {value: module.format_code(value) for value in codes} == codes
    assert (
        str(Quantity(2.0, "1", "a", noise=0.1)) == "2.0"
        and str(Quantity(2.0, "mm", "a", noise=0.1)) == "2.0 mm"
    )


def test_powers_shares_and_numbers_of_cases_are_whole():
    assert module.format_power(-120) == "10⁻¹²⁰"
    shares = [module.format_share(share) for share in (4.0, 2.81, 0.0512, -0.5)]
    assert (
        shares == ["400 %", "280 %", "5.1 %", "-50 %"]
        and module.format_share(4.0, "+") == "+400 %"
    )
    names = {
        "1e-3": "0.001",
        "9e-4": "9×10⁻⁴",
        "9.9e4": "99000",
        "1e5": "10⁵",
        "2.50": "2.50",
        "1.0e6": "10⁶",
    }
    assert {name: module.number_of(name) for name in names} == names
