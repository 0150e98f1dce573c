"""Test that the records are fresh, that the pages are complete, and that the orbit is right."""

from experiments.solvers import orbit
from measured_report.editions.project import Project, own_release
from measured_report.editions.status import states_of
from measured_report.site.build import build
from measured_report.site.check import check_site

PROJECT = Project(own_release(), own_release=own_release())


def test_no_record_is_stale():
    assert {state.kind for state in states_of(PROJECT)} == {"fresh"}


def test_the_pages_are_complete_and_show_the_measured_numbers():
    states, notes = build(PROJECT)
    assert states[PROJECT.release] == []
    assert notes == []
    assert check_site(PROJECT.site) == []


def test_the_error_of_an_orbit_falls_with_the_tolerance():
    coarse, fine = (orbit("DOP853", tolerance)[0] for tolerance in ("1e-5", "1e-9"))
    assert fine < 1e-6 < coarse < 1.0
