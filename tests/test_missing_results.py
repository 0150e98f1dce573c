"""Test that a missing record, row or run changes only the sentences that read it."""

from collections.abc import Callable, Mapping
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
from tests.removals import OF_ALL, Removal, World

pytestmark = [pytest.mark.words, pytest.mark.usefixtures("unchanged")]
OWN = own_release()
REPRODUCTION = "reproduction"
Pages = tuple[dict[str, str], str]


def told(scenario: Scenario) -> Pages:
    """Return the outcomes of claims and the text of all pages."""
    picture = ['<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"></svg>'] * 2
    undraw = mock.patch(
        "measured_report.parts.figures.draw_svgs", lambda *_, **__: picture
    )
    with project_of(scenario, [OWN]) as project, undraw:
        text = text_of(worded_editions(project, TEMPLATES), OWN)
    return outcomes_in(text), text


def altered(changes: Mapping[str, Callable[[list[Row]], list[Row]]]) -> Scenario:
    """Return the results in which functions change the rows of some sections."""

    def rows(records: Records, place: Place) -> list[Row]:
        found = as_measured(records, place)
        return changes[place[1]](found) if place[1] in changes else found

    return Scenario(f"altered {', '.join(changes)}", rows)


def changed(before: Pages, after: Pages) -> dict[str, str | None]:
    outcomes = after[0]
    return {
        claim: outcomes.get(claim)
        for claim, outcome in before[0].items()
        if outcomes.get(claim) != outcome
    }


AS_MEASURED = Scenario("as measured")


@pytest.fixture(scope="module")
def whole() -> Pages:
    return told(AS_MEASURED)


@pytest.mark.parametrize("missing", [OWN, NEWEST] if IS_WEEKLY else [OWN])
def test_a_release_without_its_shake_test_costs_the_sentences_that_read_it(
    editions, missing
):
    world = World(editions, TEMPLATES)
    found = {
        key: text
        for key, text in world.changed(Removal(missing, REPRODUCTION)).items()
        if key[1:] not in OF_ALL
    }
    [other] = {OWN, NEWEST} - {missing}
    assert {(name, claim) for label, name, claim in found if label == other} == {
        ("story", "fine_since"),
        ("upgrade", "mujoco_contacts_as_before"),
    }
    gone = {name for (_, name, _), text in found.items() if text is None}
    assert gone == {REPRODUCTION}
    assert all(text.startswith("cannot tell") for text in found.values() if text)
    for claim in ("advice", "ends_creep"):
        assert (missing, "story", claim) in found
    assert world.faults == []


@pytest.mark.parametrize(
    ("case", "way"),
    [("stiff-pads", "stiff pads"), ("as-shipped", "as shipped")][: 1 + IS_WEEKLY],
)
def test_advice_gets_no_costlier_without_a_row(whole, case, way):
    scenario = altered(
        {REPRODUCTION: lambda rows: [row for row in rows if row["case"] != case]}
    )
    found = told(scenario)
    outcomes, text = found
    assert outcomes["story.advice"] == "unknown"
    assert f"{way}, which may be cheaper, was not measured" in text
    assert "holds" not in {
        outcome
        for claim, outcome in changed(whole, found).items()
        if claim.startswith("story.")
    }


@pytest.mark.skipif(not IS_WEEKLY, reason="the next test fails this run with others")
def test_one_run_of_the_noise_that_fails_costs_nothing(whole):
    scenario = altered({"noise": lambda rows: [failed(rows[0]), *rows[1:]]})
    assert changed(whole, told(scenario)) == {}


def test_runs_that_fail_and_a_row_that_is_missing_cost_the_sentences_that_read_them(
    whole,
):
    """Test that one failed run of the noise costs nothing, that the claim that only
    MuJoCo loses the cube is undecided without MuJoCo's run, and that advice is without
    the time of its alternative.
    """

    def fail(rows: list[Row]) -> list[Row]:
        runs = (row["case"].startswith("mujoco-c") for row in rows)
        pairs = zip(rows, runs, strict=True)
        return [failed(row) if is_run else row for row, is_run in pairs]

    scenario = altered(
        {
            "noise": lambda rows: [failed(rows[0]), *rows[1:]],
            "engines": fail,
            "speed": lambda rows: [
                row for row in rows if row["case"] != "stiff-pads-only"
            ],
        }
    )
    found = told(scenario)
    outcomes, text = found
    assert outcomes["story.advice"] == "unknown"
    assert "stiff pads, which may be cheaper, was not timed" in text
    changes = changed(whole, found)
    assert changes["engines.only_it_loses"] == "unknown"
    assert {claim.partition(".")[0] for claim in changes} <= {
        "engines",
        "speed",
        "story",
    }
    assert {*changes.values()} == {"unknown"}


def test_a_cube_that_every_run_loses_is_said_to_be_lost(whole):
    lost = {"dropped": True, "slip_mm": None, "slip_mm_reason": "the cube was lost"}
    scenario = altered(
        {
            REPRODUCTION: lambda rows: [
                {**row, **lost} if "dropped" in row else row for row in rows
            ]
        }
    )
    outcomes, text = told(scenario)
    assert outcomes["reproduction.cube_is_lost"] == "holds"
    assert "a Franka gripper loses the shaken cube" in text
    assert whole[0]["reproduction.cube_is_lost"] == "fails"
    assert "loses the shaken cube" not in whole[1]
