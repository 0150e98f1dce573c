"""The tracked results: what is measured is shown, and whatever comes out next time can be said."""

import random
import shutil
from dataclasses import replace

import pytest
from markupsafe import escape

from report import ROOT
from report.assemble import assemble, derive_release, derive_releases
from report.claims import FAILS, HOLDS, Outcome
from report.compare import flips
from report.parts import PlacedFigure
from report.project import Project, own_release
from report.records import write_record


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


def shaken(row: dict, floors: dict[str, float], chance: random.Random) -> dict:
    """The row as another measurement of the same might have it: runs differ by up to the noise."""
    if row.get("backend") == "mujoco" or row.get("device") == "cpu" or row["case"].startswith("double-"):
        return row  # these repeat to the last bit
    found = {name: row[name] for name in floors if row.get(name) is not None}
    return row | {name: value + (chance.random() - 0.5) * floors[name] for name, value in found.items()}


@pytest.mark.parametrize("release", ["1.4.0", "1.8.0"])
def test_no_claim_flips_by_noise_alone(release, tmp_path):
    for name in ("report", "experiments", "assets", "pyproject.toml"):
        (tmp_path / name).symlink_to(ROOT / name)
    shutil.copytree(ROOT / "results" / f"newton-{release}", tmp_path / "results" / f"newton-{release}")
    project = Project(release, root=tmp_path, own_release=own_release())
    before = derive_release(project, "before.json").sections
    values = before["noise"].results.derived
    floors = {"slip_mm": values["slip_floor"].value, "drift_mm_s": values["drift_floor"].value}
    chance = random.Random(0)
    for section, derived in before.items():
        if section != "noise":
            record = derived.results.record
            write_record(
                project.record_path(section), replace(record, rows=[shaken(row, floors, chance) for row in record.rows])
            )
    after = derive_release(project, "after.json").sections
    first, again = (side["gap"].results.rows[0].slip_mm.value for side in (before, after))
    assert 0.0 < abs(first - again) <= floors["slip_mm"] / 2
    assert [flip.text for flip in flips(before, after)] == []
