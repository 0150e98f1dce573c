"""Sentences say what their tests have read, whatever was measured, and a damaged record takes no page down."""

import random
import re
from dataclasses import replace
from importlib.metadata import version
from importlib.util import find_spec
from pathlib import Path

import pytest
from conftest import TEMPLATE

from measured_report.files.errors import ReportError
from measured_report.files.root import ROOT
from measured_report.pages.prose import Templates
from measured_report.parts.citations import references
from measured_report.parts.claim import HOLDS
from measured_report.records.columns import REASON
from measured_report.records.record import Record
from measured_report.site.check import check_site
from measured_report.values.format import ABSENT
from measured_report.values.results import Results
from tests.sensitivity_inert import inert_passages, surveys
from tests.sensitivity_perturbed import CHANGES, Perturbation, of_editions, perturbed

pytestmark = pytest.mark.words
WORK = ROOT / "tests" / "sentences"
"""What is still to be mended; these lists may only get shorter."""
NO_NUMBER = re.compile(r"\b(nan|inf)\b")
UNNAMED = re.compile(rf'<(?:data|span)(?![^>]* title="[^"])[^>]*>{ABSENT}<')
"""A number that is not there, without a reason."""


@pytest.fixture(scope="module")
def perturbation(editions) -> Perturbation:
    return of_editions(editions, Templates(ROOT / "templates"))


def listed(name: str) -> set[str]:
    """The lines of a list, reasons left out."""
    lines = (WORK / name).read_text(encoding="utf-8").splitlines()
    return {line.partition("#")[0].strip() for line in lines} - {""}


def test_no_words_name_what_their_test_has_not_read(perturbation):
    """Each line of the list is a number that is named unread; mended, it is to be taken out."""
    assert set().union(*(survey.unread() for survey in surveys(perturbation))) == listed("unread.txt")


def test_captions_name_what_a_test_of_their_section_has_read(perturbation):
    """Each line of the list is a plain value of what is drawn, of which nothing else is said."""
    found = set().union(*(survey.unread_captions() for survey in surveys(perturbation)))
    assert found == listed("captions.txt")


@pytest.mark.slow
def test_titles_of_figures_change_with_what_they_draw(perturbation):
    own = [survey for survey in surveys(perturbation) if survey.release == "1.4.0"]
    assert set().union(*(survey.fixed_titles() for survey in own)) == listed("fixed.txt")


@pytest.mark.slow
def test_no_number_in_a_claim_or_a_passage_could_be_anything(perturbation):
    """Zero, negated, a thousand times as large or as small, it changes the outcome or the words."""
    found = [survey.inert() for survey in surveys(perturbation)]
    found += [inert_passages(perturbation, release) for release in perturbation.releases]
    assert set().union(*found) == listed("inert.txt")


def damaged(record: Record, chance: random.Random) -> Record:
    """A record that lost a row or a cell, or holds something else in its place."""
    rows = list(record.rows)
    index = chance.randrange(len(rows))
    if chance.random() < 0.2 and len(rows) > 1:
        return replace(record, rows=[*rows[:index], *rows[index + 1 :]])
    row = rows[index]
    # Not a reason: without it nobody can say why its number is not there.
    column = chance.choice([column for column in row if column != "case" and not column.endswith(REASON)])
    change, value = chance.choice(CHANGES), row[column]
    if change == "missing" and chance.random() < 0.3:
        rows[index] = {name: cell for name, cell in row.items() if name != column}
    elif change == "missing":
        rows[index] = row | {column: None, column + REASON: "as a test"}
    else:
        other = not value if isinstance(value, bool) else "" if isinstance(value, str) else perturbed(value, change)
        rows[index] = row | {column: other}
    return replace(record, rows=rows)


def lost_pointers(results: Results, record: Record) -> set[str]:
    """To the numbers that a damaged record has lost, where it has all rows."""
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
    pairs = [(release, name) for release, chapters in perturbation.releases.items() for name in chapters]
    for _ in range(500):
        release, name = chance.choice(pairs)
        chapter = perturbation.releases[release][name]
        results, held = chapter.results, {claim.name for claim in chapter.section.claims if claim.outcome == HOLDS}
        record = damaged(results.record, chance)
        section = perturbation.section(release, name, {results.source: record})
        lost = lost_pointers(results, record)
        said = [claim.sentence for claim in section.claims] + [table.__html__() for table in section.tables.values()]
        said += [figure.wording("alt", figure.numbers) for figure in section.figures.values()]
        for text in said:
            assert not NO_NUMBER.search(text.striptags()), (release, name, text)
            assert not UNNAMED.search(text), (release, name, text)
        for claim in section.claims:
            place = release, name, claim.name
            assert claim.outcome.name == "unknown" or claim.says_missing or ABSENT not in claim.text, place
            # What did not hold before may fail by another number still.
            answers = {"unknown"} if claim.name in held else {"unknown", "fails"}
            assert claim.outcome.name in answers or not lost & claim.outcome.reads, place


def test_what_is_stated_is_still_in_the_package():
    for name, reference in references(ROOT / "templates").items():
        if reference.package and version(reference.package) == reference.version:
            file = Path(find_spec(reference.package).origin).parent / reference.file
            assert reference.excerpt in file.read_text(encoding="utf-8").splitlines()[reference.line - 1], name


def test_a_statement_says_that_it_is_not_measured_here(toy):
    words = "\n{% stated law %} Twice *as* large as {{ row['stiff'].slip_mm }}. {% endstated %}\n"
    toy.write("templates/sources.toml", '[law]\nurl = "https://example.org/law"\n')
    toy.write("templates/sections/toy.md.j2", TEMPLATE + words)
    toy.build()
    assert '<span class="stated">Twice <em>as</em> large as <data' in toy.page
    assert '.<sup class="cited"><a href="#source-1" aria-label="Source 1">1</a></sup></span>' in toy.page
    assert '<li id="source-1"><a href="https://example.org/law">example.org/law</a></li>' in toy.page
    assert check_site(toy.project.site) == []
    toy.write("templates/sources.toml", '[lore]\npackage = "newton"\n')
    with pytest.raises(ReportError, match=r"sources\.toml: lore needs url"):
        toy.build()


def test_a_sentence_requires_the_claims_of_sections_before_it(toy):
    for name, said in (("helps", True), ("toy.helps", True), ("gap.not_the_cause", False)):
        toy.write("templates/sections/toy.md.j2", TEMPLATE + f'\n{{% if holds("{name}") %}}So it is.{{% endif %}}\n')
        toy.build()
        assert ("So it is." in toy.page) == said
    toy.write("templates/sections/toy.md.j2", TEMPLATE + '\n{% if holds("toy.helpz") %}So it is.{% endif %}\n')
    with pytest.raises(ReportError, match="toy has no claim 'helpz'"):
        toy.build()


@pytest.mark.parametrize(
    ("pairs", "message"),
    [
        ('contradict = [["toy.helps holds", "toy.helps holds"]]', "contradicts"),
        ('needs = [["toy.helps holds", "toy.helps fails"]]', "which is not said"),
        ('needs = [["toy.help holds", "toy.helps fails"]]', "no claim toy.help"),
        ("contradicts = []", "has contradicts"),
        ('contradict = [["toy.helps holds", "toy.helps fails"]]', ""),
        ('needs = [["toy.helps fails", "gap.not_the_cause holds"]]', ""),
    ],
)
def test_what_does_not_go_together_stops_the_build(toy, pairs, message):
    toy.write("templates/pairs.toml", pairs)
    if not message:
        toy.build()
        return
    with pytest.raises(ReportError, match=message):
        toy.build()
