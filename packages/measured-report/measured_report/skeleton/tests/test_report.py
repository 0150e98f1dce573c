"""Test that all records are fresh and that the pages show the measured numbers."""

from measured_report.editions.project import Project, own_release
from measured_report.editions.status import states_of
from measured_report.site.build import build
from measured_report.site.check import check_site

PROJECT = Project(own_release())


def test_all_sections_are_measured_and_fresh():
    assert {
        state.section: state.summary
        for state in states_of(PROJECT)
        if state.kind != "fresh"
    } == {}


def test_pages_are_complete_and_show_the_measured_numbers():
    states, notes = build(PROJECT)
    assert states[PROJECT.release] == []
    assert notes == []
    assert check_site(PROJECT.site) == []
