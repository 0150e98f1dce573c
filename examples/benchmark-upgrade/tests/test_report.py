"""Tests that all records are fresh, that the pages are complete, and that the statistical test is correct."""

from types import SimpleNamespace

import pytest

from measured_report.editions.project import Project, own_release
from measured_report.editions.status import states_of
from measured_report.site.build import build
from measured_report.site.check import check_site
from report.paired import Step, sign_test

PROJECT = Project(own_release(), own_release=own_release())


def test_no_record_is_stale():
    states = [
        state
        for release in PROJECT.releases
        for state in states_of(PROJECT.of(release))
    ]
    assert {state.kind for state in states} <= {"fresh", "missing"}
    assert {
        state.section for state in states_of(PROJECT) if state.kind != "fresh"
    } == set()


def test_the_pages_are_whole_and_every_number_is_what_was_measured():
    build(PROJECT)
    assert check_site(PROJECT.site) == []


def test_episodes_are_compared_seed_by_seed_as_far_as_both_go():
    before = SimpleNamespace(steps="70 - 80 90 99", states="aaaabbbbccccddddffff")
    after = SimpleNamespace(steps="- 60 81 90", states="aaaab0bbcccceeee")
    step = Step("task", ("1", "2"), (before, after))
    assert step.counts == {
        "lost": 1,
        "gained": 1,
        "slower": 1,
        "faster": 0,
        "other_motion": 2,
    }
    assert not step.beyond_chance(1)
    assert sign_test(10, 0) == pytest.approx(2 / 2**10) and sign_test(3, 4) == 1.0
