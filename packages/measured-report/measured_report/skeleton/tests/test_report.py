"""Test that all records are fresh and that the pages show the measured numbers."""

from measured_report.editions.project import Project, own_release
from measured_report.editions.status import states_of
from measured_report.site.build import build
from measured_report.site.check import check_site

PROJECT = Project(own_release())


def test_every_section_is_measured_and_fresh():
    assert {
        state.section: state.summary
        for state in states_of(PROJECT)
        if state.kind != "fresh"
    } == {}


def test_the_pages_are_whole_and_every_number_is_what_was_measured():
    states, notes = build(PROJECT)
    assert states[PROJECT.release] == []
    assert notes == []
    assert check_site(PROJECT.site) == []
