"""Compares units, noise and arithmetic with numbers computed by hand."""

import math

import pytest

from number_audit.files import AuditError
from number_audit.quantities import (
    Quantity,
    in_unit,
    product_unit,
    ratio_unit,
    sample_mean,
    student_t,
)


@pytest.mark.parametrize(
    ("freedom", "t"),
    [  # NIST/SEMATECH e-Handbook of Statistical Methods, 1.3.6.7.2, 0.975
        (1, 12.706),
        (2, 4.303),
        (5, 2.571),
        (9, 2.262),
        (10, 2.228),
        (30, 2.042),
        (40, 2.021),
        (100, 1.984),
        (1e9, 1.960),
    ],
)
def test_student_t_is_that_of_the_tables(freedom, t):
    assert student_t(freedom) == pytest.approx(t, abs=2e-3)


def test_the_noise_of_a_mean_is_its_confidence_interval():
    """For a deviation of 1 and 4 samples it is 3.182 / 2."""
    mean, noise = sample_mean(
        [1.0, 1.0, 1.0 + math.sqrt(3) / 2, 1.0 - math.sqrt(3) / 2]
    )
    assert mean == pytest.approx(1.0)
    assert noise == pytest.approx(3.182 / 2 * math.sqrt(0.5), abs=1e-3)


A = Quantity(6.0, "m", {"a": 0.3})
B = Quantity(2.0, "s", {"b": 0.4})


@pytest.mark.parametrize(
    ("result", "value", "unit", "noise"),
    [
        (A + A, 12.0, "m", 0.6),  # Both terms are the same source.
        (A - A, 0.0, "m", 0.0),
        (A + Quantity(1.0, "m", {"c": 0.4}), 7.0, "m", 0.5),
        (A * B, 12.0, "m·s", math.hypot(2 * 0.3, 6 * 0.4)),
        (A / B, 3.0, "m/s", math.hypot(0.3 / 2, 6 / 4 * 0.4)),
        (A / B / B, 1.5, "m/s/s", math.hypot(0.3 / 4, 2 * 6 / 8 * 0.4)),
        (A / A, 1.0, "1", 0.0),
        (-A, -6.0, "m", 0.3),
        (Quantity(2.0) * A, 12.0, "m", 0.6),
        (Quantity(1.0) * A, 6.0, "m", 0.3),  # Unknown noise does not count.
    ],
)
def test_arithmetic_carries_unit_and_noise(result, value, unit, noise):
    assert result.value == pytest.approx(value)
    assert result.unit == unit
    assert result.noise == pytest.approx(noise)


@pytest.mark.parametrize("mistake", [lambda: A + B, lambda: A / Quantity(0.0)])
def test_what_can_not_be_computed_is_an_error(mistake):
    with pytest.raises(AuditError):
        mistake()


def test_a_number_is_computed_from_at_most_a_thousand_places():
    total = Quantity(0.0)
    with pytest.raises(AuditError, match="more than 1000 places"):
        for index in range(1001):
            total = total + Quantity(1.0, "1", {str(index): 1.0})


def test_units_are_converted_with_their_noise():
    assert str(in_unit(Quantity(0.0123, "s", {"a": 0.0002}), "ms")) == "12.3 ± 0.2 ms"
    assert str(in_unit(Quantity(2.0, "mm/s"), "m/s")) == "0.002 m/s"
    assert str(in_unit(Quantity(3.0, "KiB"), "B")) == "3072 B"
    assert in_unit(Quantity(1.0, "m"), "s") is None
    assert in_unit(Quantity(5.0, "apples"), "m") == Quantity(5.0, "apples")


@pytest.mark.parametrize(
    ("first", "second", "product", "ratio"),
    [
        ("m", "m", "m·m", "1"),
        ("m/s", "s", "m", "m/s/s"),
        ("1", "s", "s", "1/s"),
        ("N·m", "s", "N·m·s", "N·m/s"),
        ("m", "1", "m", "m"),
    ],
)
def test_units_multiply(first, second, product, ratio):
    assert product_unit(first, second) == product
    assert ratio_unit(first, second) == ratio
