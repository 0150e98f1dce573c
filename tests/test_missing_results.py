"""Test that a missing record, row or run changes only the sentences that read it."""

from collections.abc import Callable, Sequence
from functools import cache
from unittest import mock

import pytest
from altered import (
    NEWEST,
    TEMPLATES,
    Place,
    Records,
    Row,
    Scenario,
    as_measured,
    failed,
    outcomes_in,
    project_of,
    text_of,
)
from toys import IS_WEEKLY

from measured_report.editions.project import own_release
from measured_report.pages.wording import worded_editions

pytestmark = [pytest.mark.words, pytest.mark.usefixtures("unchanged")]
OWN = own_release()
REPRODUCTION = "reproduction"
Pages = dict[str, tuple[dict[str, str], str]]


@cache
def told(
    scenario: Scenario, releases: Sequence[str] = (OWN,), without: Place | None = None
) -> Pages:
    """Return the outcomes of claims by release, and the text of all pages."""
    picture = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"></svg>'] * 2
    undraw = mock.patch(
        "measured_report.parts.figures.draw_svgs", lambda *_, **__: picture
    )
    with project_of(scenario, releases, without) as project, undraw:
        editions = worded_editions(project, TEMPLATES)
        texts = {release: text_of(editions, release) for release in releases}
        return {release: (outcomes_in(text), text) for release, text in texts.items()}


def altered(section: str, change: Callable[[list[Row]], list[Row]]) -> Scenario:
    """Return the results in which a function changes the rows of a section."""

    def rows(records: Records, place: Place) -> list[Row]:
        found = as_measured(records, place)
        return change(found) if place[1] == section else found

    return Scenario(f"altered {section}", rows)


def changed(before: Pages, after: Pages, release: str = OWN) -> dict[str, str | None]:
    outcomes = after[release][0]
    return {
        claim: outcomes.get(claim)
        for claim, outcome in before[release][0].items()
        if outcomes.get(claim) != outcome
    }


AS_MEASURED = Scenario("as measured")


@pytest.fixture(scope="module")
def whole() -> Pages:
    return told(AS_MEASURED)


@pytest.mark.parametrize("missing", [OWN, NEWEST] if IS_WEEKLY else [OWN])
def test_a_release_without_its_shake_test_costs_the_sentences_that_read_it(missing):
    releases = (OWN, NEWEST)
    before = told(AS_MEASURED, releases)
    after = told(AS_MEASURED, releases, (missing, REPRODUCTION))
    [other] = {*releases} - {missing}
    assert changed(before, after, other) == {
        "story.fine_since": "unknown",
        "upgrade.mujoco_contacts_as_before": "unknown",
    }
    found = changed(before, after, missing)
    gone = {claim for claim, outcome in found.items() if outcome is None}
    assert {claim.partition(".")[0] for claim in gone} == {REPRODUCTION}
    assert {found[claim] for claim in found.keys() - gone} == {"unknown"}
    assert found["story.advice"] == found["story.ends_creep"] == "unknown"
    assert "make rerun SECTION=reproduction" in after[missing][1]


@pytest.mark.parametrize(
    ("section", "case", "named"),
    [
        (
            REPRODUCTION,
            "stiff-pads",
            "stiff pads, which may be cheaper, was not measured",
        ),
        (
            REPRODUCTION,
            "as-shipped",
            "as shipped, which may be cheaper, was not measured",
        ),
        ("speed", "stiff-pads-only", "stiff pads, which may be cheaper, was not timed"),
    ],
)
def test_advice_gets_no_costlier_without_a_row(whole, section, case, named):
    scenario = altered(
        section, lambda rows: [row for row in rows if row["case"] != case]
    )
    found = told(scenario)
    outcomes, text = found[OWN]
    assert outcomes["story.advice"] == "unknown" and named in text
    assert "holds" not in {
        outcome
        for claim, outcome in changed(whole, found).items()
        if claim.startswith("story.")
    }


def test_one_run_of_the_noise_that_fails_costs_nothing(whole):
    scenario = altered("noise", lambda rows: [failed(rows[0]), *rows[1:]])
    assert changed(whole, told(scenario)) == {}


def test_a_run_that_failed_is_not_one_that_keeps_the_cube(whole):
    """Test that the claim that only MuJoCo loses the cube is undecided without MuJoCo's
    run.
    """

    def fail(rows: list[Row]) -> list[Row]:
        runs = (row["case"].startswith("mujoco-c") for row in rows)
        pairs = zip(rows, runs, strict=True)
        return [failed(row) if is_run else row for row, is_run in pairs]

    assert changed(whole, told(altered("engines", fail)))["engines.only_it_loses"] == (
        "unknown"
    )


def test_a_cube_that_every_run_loses_is_said_to_be_lost(whole):
    lost = {"dropped": True, "slip_mm": None, "slip_mm_reason": "the cube was lost"}
    scenario = altered(
        REPRODUCTION,
        lambda rows: [{**row, **lost} if "dropped" in row else row for row in rows],
    )
    outcomes, text = told(scenario)[OWN]
    assert outcomes["reproduction.cube_is_lost"] == "holds"
    assert "a Franka gripper loses the shaken cube" in text
    assert whole[OWN][0]["reproduction.cube_is_lost"] == "fails"
    assert "loses the shaken cube" not in whole[OWN][1]
