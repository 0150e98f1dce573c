"""Scatter: how far measurements come out apart, with few of them, an outlier, and a chaotic case."""

import random
from dataclasses import replace

import pytest

from measured_report.editions.project import Project
from measured_report.records.record import load_record
from measured_report.values.scatter import apart, key_of, quantile


def records(count, sigma, seed=0, size=40, column="slip_mm", outlier=0.0):
    """Return so many measurements of cases that scatter by ``sigma``."""
    made, base = random.Random(seed), load_record(Project("1.4.0").record_path("gap"))
    found = []
    for number in range(count):
        rows = [{"case": f"c{place}", column: 5.0 + place / 10 + made.gauss(0, sigma)} for place in range(size)]
        rows[0][column] += outlier * number
        found.append(replace(base, rows=rows, units={column: "mm"}, traces={}))
    return found


def ringing(count, sigma, **more):
    """Return the share of numbers of another measurement that are beyond the noise."""
    beyond = total = 0
    for seed in range(40):
        *known, new = records(count + 1, sigma, seed, **more)
        found = apart(known)
        for one, other in zip(known[0].rows, new.rows, strict=True):
            beyond += abs(one["slip_mm"] - other["slip_mm"]) > found.noise("slip_mm", one)
            total += 1
    return beyond / total


@pytest.mark.parametrize("count", [2, 3, 5])
def test_another_measurement_is_within_the_noise(count):
    assert ringing(count, 0.05) <= 0.001


def test_few_measurements_are_a_wider_interval():
    noises = [apart(records(count, 0.05)).noise("slip_mm", {"case": "c9", "slip_mm": 6.0}) for count in (2, 3, 6)]
    assert noises == sorted(noises, reverse=True)
    assert quantile(5) == pytest.approx(6.869, rel=0.03)  # Student's t, from a table
    assert quantile(10) == pytest.approx(4.587, rel=0.01)


def test_measurements_that_repeat_each_other_know_no_number_to_more_than_a_thousandth():
    assert apart(records(2, 1e-9)).noise("slip_mm", {"case": "c9", "slip_mm": 6.0}) == pytest.approx(0.006)


def test_an_outlier_widens_its_own_noise_and_not_that_of_others():
    plain, odd = apart(records(3, 0.05)), apart(records(3, 0.05, outlier=5.0))
    other, own = {"case": "c9", "slip_mm": 6.0}, {"case": "c0", "slip_mm": 5.0}
    assert odd.noise("slip_mm", other) == pytest.approx(plain.noise("slip_mm", other), rel=0.25)
    assert odd.noise("slip_mm", own) > 10 * plain.noise("slip_mm", own)


def test_an_engine_that_repeats_has_nothing_of_the_noise_of_one_that_does_not():
    both = [
        replace(
            quiet,
            rows=[
                *({**row, "backend": "warp"} for row in quiet.rows),
                *({**row, "case": f"{row['case']}-wild", "backend": "vbd"} for row in loud.rows),
            ],
        )
        for quiet, loud in zip(records(2, 0.001, seed=1), records(2, 1.0, seed=2), strict=True)
    ]
    noises = [apart(both).noise("slip_mm", both[0].rows[place]) for place in (9, 49)]
    assert noises[0] < 0.05 < 1.0 < noises[1]


def test_times_of_another_kind_of_processor_are_no_noise():
    one, other = records(2, 0.05, column="frame_ms")
    other = replace(other, machine={**other.machine, "gpu": "another"})
    assert not apart([one, other]).of("frame_ms", {})
    assert apart([one, replace(other, machine=one.machine)]).of("frame_ms", {})
    one, other = records(2, 0.05)
    assert apart([one, replace(other, machine={**other.machine, "gpu": "another"})]).of("slip_mm", {})


def test_a_run_that_one_measurement_loses_is_at_the_edge():
    one, other = records(2, 0.05)
    rows = [{**row, "dropped": place == 3} for place, row in enumerate(other.rows)]
    found = apart([replace(one, rows=[{**row, "dropped": False} for row in one.rows]), replace(other, rows=rows)])
    assert found.edge == {key_of({"case": "c3"})}
