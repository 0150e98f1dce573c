"""The tracked results: what is measured is shown, and whatever comes out next time can be said."""

from dataclasses import replace

import pytest
from markupsafe import escape

from report.assemble import assemble, derive_releases
from report.claims import FAILS, HOLDS, Outcome
from report.parts import PlacedFigure
from report.project import Project, own_release


@pytest.fixture(scope="module")
def reports():
    """The report of every release that has results."""
    project = Project(own_release())
    derivations = derive_releases(project)
    return [assemble(project.of(release), derivations) for release in derivations]


def test_only_what_was_not_measured_is_left_out(reports):
    assert [state for report in reports for state in report.left_out if state.kind != "missing"] == []


def test_every_claim_table_and_figure_is_on_the_page(reports):
    for report in reports:
        for chapter in report.chapters:
            printed, section = chapter.prose.printed, chapter.section
            said = "".join(str(thing) for thing in printed if not isinstance(thing, PlacedFigure))
            drawn = [thing.figure for thing in printed if isinstance(thing, PlacedFigure)]
            names = [claim.name for claim in section.claims]
            assert [name for name in names if f'data-claim="{chapter.name}.{name}"' not in said] == []
            assert [name for name, table in section.tables.items() if escape(table) not in said] == []
            assert [name for name, figure in section.figures.items() if figure not in drawn] == []


def test_every_outcome_of_every_claim_can_be_said(reports):
    """A wording that names a number it does not have would fail only when the claim flips."""
    for report in reports:
        for chapter in report.chapters:
            for claim in chapter.section.claims:
                for outcome in (HOLDS, FAILS, Outcome("unknown", "as a test")):
                    assert "{" not in replace(claim, outcome=outcome).html(chapter.name)
