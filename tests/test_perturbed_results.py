"""Test properties of the report with perturbed results.

This is a separate file so that another process can run it. Each printed number depends
on its test, and a damaged record only affects the sections that read the lost cells.
"""

import random
import re
from dataclasses import replace

import pytest
from altered import NEWEST
from current_columns import REASON
from toys import IS_WEEKLY

from measured_report.editions.project import own_release
from measured_report.files.root import ROOT
from measured_report.pages.prose import Templates
from measured_report.parts.claim import HOLDS
from measured_report.records.record import Record
from measured_report.values.format import ABSENT
from measured_report.values.results import Results
from tests.inert import inert_passages, surveys
from tests.perturbed import FACTORS, Perturbation, of_editions, perturbed

pytestmark = [pytest.mark.words, pytest.mark.usefixtures("unchanged")]
pytestmark += [pytest.mark.filterwarnings("error::RuntimeWarning")]
NO_NUMBER = re.compile(r"\b(nan|inf)\b")
UNNAMED = re.compile(rf'<(?:data|span)(?![^>]* title="[^"])[^>]*>{ABSENT}<')
"""Missing number without a reason."""
OWN_AND_NEWEST = (own_release(), NEWEST)


@pytest.fixture(scope="module")
def perturbation(editions) -> Perturbation:
    return of_editions(editions, Templates(ROOT / "templates"), OWN_AND_NEWEST)


def test_no_words_name_what_their_test_has_not_read(perturbation):
    assert set().union(*(survey.unread() for survey in surveys(perturbation))) == set()


@pytest.mark.slow
def test_no_number_in_a_claim_or_a_passage_could_be_anything(perturbation):
    """Test that a number which is zero, negated, or a thousand times as large or as
    small changes the outcome or the words.
    """
    found = [
        survey.inert()
        for survey in surveys(perturbation)
        if survey.release in OWN_AND_NEWEST
    ]
    found += [inert_passages(perturbation, release) for release in OWN_AND_NEWEST]
    assert set().union(*found) == set()


def damaged(record: Record, chance: random.Random) -> Record:
    """Test a record that lost a row or a cell, or has another object in its place."""
    rows = list(record.rows)
    index = chance.randrange(len(rows))
    if chance.random() < 0.2 and len(rows) > 1:
        return replace(record, rows=[*rows[:index], *rows[index + 1 :]])
    row = rows[index]
    # Reasons are left out, because without one the cause of a missing number is
    # unknown.
    column = chance.choice(
        [column for column in row if column != "case" and not column.endswith(REASON)]
    )
    change, value = chance.choice((*FACTORS, "missing")), row[column]
    if change == "missing" and chance.random() < 0.3:
        rows[index] = {name: cell for name, cell in row.items() if name != column}
    elif change == "missing":
        rows[index] = row | {column: None, column + REASON: "as a test"}
    else:
        other = (
            not value
            if isinstance(value, bool)
            else ""
            if isinstance(value, str)
            else perturbed(value, change)
        )
        rows[index] = row | {column: other}
    return replace(record, rows=rows)


def lost_pointers(results: Results, record: Record) -> set[str]:
    """Return pointers to the numbers that a damaged record has lost while all rows
    remain.
    """
    before, after = results.record.rows, record.rows
    return {
        f"{results.source}#/rows/{index}/{column}"
        for index in (range(len(before)) if len(before) == len(after) else ())
        for column, value in before[index].items()
        if value is not None and after[index].get(column) is None
    }


@pytest.mark.slow
def test_a_damaged_record_takes_nothing_down(perturbation):
    chance = random.Random(0)
    pairs = [
        (release, name)
        for release, chapters in perturbation.releases.items()
        for name in chapters
    ]
    for _ in range(300 if IS_WEEKLY else 30):
        release, name = chance.choice(pairs)
        chapter = perturbation.releases[release][name]
        results, held = (
            chapter.results,
            {claim.name for claim in chapter.section.claims if claim.outcome == HOLDS},
        )
        record = damaged(results.record, chance)
        section = perturbation.worded(
            perturbation.section(release, name, {results.source: record}), name
        )
        lost = lost_pointers(results, record)
        said = [claim.sentence for claim in section.claims] + [
            table.__html__() for table in section.tables.values()
        ]
        said += [
            figure.wording["alt"](figure.numbers) for figure in section.figures.values()
        ]
        for text in said:
            assert not NO_NUMBER.search(text.striptags()), (release, name, text)
            assert not UNNAMED.search(text), (release, name, text)
        for claim in section.claims:
            place = release, name, claim.name
            assert claim.outcome.name == "unknown" or ABSENT not in claim.text, place
            # A claim that did not hold before may fail because of another number.
            answers = {"unknown"} if claim.name in held else {"unknown", "fails"}
            assert claim.outcome.name in answers or not lost & claim.outcome.reads, (
                place
            )
