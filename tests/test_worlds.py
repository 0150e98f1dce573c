"""Test the tracked results with some of the removals that tests.removals lists."""

import pytest

pytest.importorskip("hypothesis", reason="the extra test has it")

from hypothesis import Phase, given, settings
from hypothesis import strategies as st

from measured_report.changes.moves import moves_between
from measured_report.editions.project import own_release
from measured_report.files.config import report
from measured_report.files.root import ROOT
from measured_report.pages.prose import Templates
from tests.altered import NEWEST
from tests.removals import Removal, World, removals_of

pytestmark = [pytest.mark.words, pytest.mark.usefixtures("unchanged")]
RELEASES = (own_release(), NEWEST)
FEW = 4


@pytest.fixture(scope="module")
def world(editions) -> World:
    return World(editions, Templates(ROOT / "templates"))


@pytest.fixture(scope="module")
def removals(world) -> list[Removal]:
    """Removals from all sections except noise, which every interval reads."""
    noise = report().settings.noise_section
    return [each for each in removals_of(world, RELEASES) if each.section != noise]


@settings(
    max_examples=FEW, phases=[Phase.generate]
)  # shrinking an example takes minutes
@given(data=st.data())
def test_what_is_missing_changes_no_sentence_that_does_not_read_it(
    world, removals, data
):
    removal = data.draw(st.sampled_from(removals))
    world.faults.clear()
    assert world.unread(removal) == {}, removal
    assert world.faults == [], removal


ROWS = {
    "newton_solvers": ("warp-3cm", "steel-3cm", "steel-32-rows-3cm"),
    "stability": ("ke-critical-464-1",),
}
"""Runs that decide a sentence although it does not print their numbers."""


@pytest.mark.parametrize("section", ROWS)
def test_a_run_that_a_sentence_does_not_print_is_read_as_well(world, section):
    record = world.releases[NEWEST][section].results.record
    for index, row in enumerate(record.rows):
        if row["case"] in ROWS[section]:
            removal = Removal(NEWEST, section, index)
            assert world.unread(removal) == {}, removal


def test_a_release_with_the_rows_of_another_has_no_number_that_moved(world):
    older, newer = (world.releases[release] for release in RELEASES)
    cells = [
        cell
        for name, chapter in older.items()
        if name in newer
        for cell in moves_between(chapter, world.with_rows_of(newer[name], chapter))
    ]
    assert [cell for cell in cells if cell.is_real] == [] and len(cells) > 1000
