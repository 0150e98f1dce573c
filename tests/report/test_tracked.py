"""Test that all tracked results are shown, and that every other outcome has a sentence."""

import random
import shutil
from dataclasses import replace

import pytest
from markupsafe import escape
from toys import IS_WEEKLY, link

from measured_report.changes.compare import flips_between
from measured_report.editions.project import Project, own_release
from measured_report.files.root import ROOT
from measured_report.findings.editions import derive_edition
from measured_report.pages.prose import Templates
from measured_report.parts.claim import FAILS, HOLDS, Outcome
from measured_report.parts.section import UNDRAWN
from measured_report.records.record import write_record
from measured_report.site.check import check_site
from report.story import advice, investigation, story

pytestmark = [pytest.mark.words, pytest.mark.usefixtures("unchanged")]
OUTCOMES = (HOLDS, FAILS, Outcome("unknown", "as a test"))


def test_every_claim_table_and_figure_is_on_the_page_and_only_what_was_not_measured_is_left_out(
    editions,
):
    for edition in editions.values():
        for chapter in edition.chapters.values():
            printed, section = chapter.prose.printed, chapter.section
            said = "".join(map(str, printed))
            names = [claim.name for claim in section.claims]
            assert [
                name
                for name in names
                if f'data-claim="{chapter.name}.{name}"' not in said
            ] == []
            assert [
                name
                for name, table in section.tables.items()
                if escape(table) not in said
            ] == []
            assert [
                name
                for name, figure in section.figures.items()
                if f'<figure id="{figure.anchor}"' not in said
                and "A figure is left out here" not in said
            ] == []
    assert [
        state
        for edition in editions.values()
        for state in edition.left_out
        if state.kind != "missing"
    ] == []


def test_every_outcome_of_every_claim_can_be_said(editions):
    """Test wordings that name a missing number.

    Otherwise they would fail only when the claim flips.
    """
    chapters = {release: edition.chapters for release, edition in editions.items()}
    words = {
        name: Templates(ROOT / "templates").words(f"{name}.md.j2")
        for name in ("story", "investigation", "pages/advice")
    }
    for release in editions:
        claims = [
            claim
            for chapter in chapters[release].values()
            for claim in chapter.section.claims
        ]
        told = {
            "story": story.derive(chapters, release),
            "investigation": investigation.derive(chapters[release]),
            "pages/advice": advice.derive(chapters[release]),
        }
        for name, section in told.items():
            claims += [
                replace(claim, wording=words[name]["claim", claim.wording_name])
                for claim in section.claims
            ]
        for claim in claims:
            said = [replace(claim, outcome=outcome).text for outcome in OUTCOMES]
            assert (
                all(text.endswith((".", ":")) for text in said) and len(set(said)) == 3
            ), said


def shaken(row: dict, floors: dict[str, float], chance: random.Random) -> dict:
    """Return the row of another possible measurement, which differs by up to the noise."""
    if (
        row.get("backend") in ("c", "mujoco", "mujoco-c")
        or row.get("device") == "cpu"
        or row["case"].startswith("double-")
    ):
        return row  # these runs are bit-identical every time
    found = {name: row[name] for name in floors if row.get(name) is not None}
    moved = {
        name: value + (chance.random() - 0.5) * floors[name]
        for name, value in found.items()
    }
    return (
        row | moved | {name: abs(moved[name]) for name in {"slip_mm"} & set(moved)}
    )  # a length


@pytest.mark.parametrize("release", ["1.4.0", "1.8.0"] if IS_WEEKLY else ["1.8.0"])
def test_no_claim_flips_by_noise_alone(release, editions, tmp_path):
    link(tmp_path, "report", "experiments", "templates", "assets", "pyproject.toml")
    shutil.copytree(
        ROOT / "results" / f"newton-{release}",
        tmp_path / "results" / f"newton-{release}",
    )
    project = Project(release, root=tmp_path, own_release=own_release())
    before = {
        name: chapter
        for name, chapter in editions[release].chapters.items()
        if not chapter.compares
    }
    columns = ("slip_mm", "drift_mm_s")
    chance = random.Random(0)
    for section, chapter in before.items():
        if section != "noise":
            record = chapter.results.record
            noises = [
                {
                    name: row[name].noise or 0.0
                    for name in columns
                    if row.plain.get(name) is not None
                }
                for row in chapter.results.rows
            ]
            rows = [
                shaken(*each, chance) for each in zip(record.rows, noises, strict=True)
            ]
            write_record(project.record_path(section), replace(record, rows=rows))
    after = derive_edition(project).chapters
    first, again = (side["gap"].results.rows[0].slip_mm for side in (before, after))
    assert 0.0 < abs(first.value - again.value) <= first.noise / 2
    assert [
        flip.claim
        for flip in flips_between(before, {name: after[name] for name in before})
    ] == []


def test_the_tracked_results_make_a_report_without_the_simulator(site):
    assert check_site(site) == []
    assert [
        path
        for path in site.rglob("*.html")
        if UNDRAWN in path.read_text(encoding="utf-8")
    ] == []
