"""The report: its records are fresh, its pages say what was measured, and the pendulum is one."""

import math

import pytest

from experiments.pendulum import START_RAD, swing
from measured_report.editions.project import Project, own_release
from measured_report.editions.status import states_of
from measured_report.site.build import build
from measured_report.site.check import check_site

PROJECT = Project(own_release())


def test_every_section_is_measured_and_fresh():
    assert {state.section: state.summary for state in states_of(PROJECT) if state.kind != "fresh"} == {}


def test_the_pages_are_whole_and_every_number_is_what_was_measured():
    assert build(PROJECT)[PROJECT.release].left_out == []
    assert check_site(PROJECT.site) == []


def test_a_rod_that_is_lifted_has_the_energy_of_its_middle():
    """Energy at the start is m g l/2 (1 - cos θ) above the lowest point, for 1 kg and 0.5 m."""
    _, energies = swing("RK4", START_RAD, 0.1)
    _, lowest = swing("RK4", 0.0, 0.1)
    assert energies[0] - lowest[0] == pytest.approx(9.81 * 0.25 * (1 - math.cos(START_RAD)), rel=1e-6)
