"""Test properties of the report with altered editions.

For any measurements, no command ends in a traceback, no claims contradict each other,
and each number is on the stated side of its bound.
"""

import pytest
from altered import SCENARIOS, outcomes_in, said, text_of
from toys import IS_WEEKLY

from measured_report.editions.project import own_release

pytestmark = [pytest.mark.words, pytest.mark.usefixtures("unchanged")]
pytestmark += [pytest.mark.filterwarnings("error::RuntimeWarning")]
SAMPLE = ("reversed", "moving-x-minus-0.05", "noise-x-60", "failing")
"""Names of the scenarios that the suite tries. The others change a part of the same data."""
BY_NAME = {scenario.name: scenario for scenario in SCENARIOS}
RECOMMENDING = (
    "front.title",
    "front.remedy",
    "front.is_mistuned",
    "front.way_",
    "story.remedy",
    "story.files",
)
RECOMMENDING += (
    "fix.recommended",
    "stiffness.together_they_hold",
    "reproduction.stiff_pads_hold",
)
BELOW_THE_NOISE = ("envelope.map_gain", "hold.creep_goes_on", "gap.not_the_cause")

NEEDS = {  # claims that hold, and claims that must then hold or fail as well
    "stiffness.cause": (
        *("contacts.missing_term", "contacts.term_restored", "contacts.slide_accounts"),
        "hold.drift_needs_cycle",
    ),
    "upgrade.cause": (
        "upgrade.friction_timeconst_is_new",
        "upgrade.taking_it_away_brings_it_back",
    ),
}
TOLD_OF_A_CHANGE = (
    "in_one_step",
    "taking_it_away_brings_it_back",
    "giving_it_does_the_same",
    "release_has_a_switch",
)


def assert_that_claims_go_together(outcomes: dict[str, str]) -> None:
    for claim, needs in NEEDS.items():
        assert outcomes.get(claim) != "holds" or {outcomes[need] for need in needs} == {
            "holds"
        }
    changes = {outcomes.get(f"upgrade.{claim}") for claim in TOLD_OF_A_CHANGE}
    assert "holds" not in changes or outcomes["upgrade.slip_is_the_same"] in (
        "fails",
        "opposite",
    )


@pytest.fixture(scope="module")
def measured(editions) -> dict[str, str]:
    return outcomes_in(text_of(editions, own_release()))


@pytest.mark.slow
@pytest.mark.parametrize(
    "scenario",
    [each for each in SCENARIOS if IS_WEEKLY or each.name in SAMPLE],
    ids=lambda scenario: scenario.name,
)
def test_whatever_is_measured_no_section_is_lost_other_claims_hold_and_the_site_is_sound(
    scenario, measured
):
    """Test that every number is on the stated side of its bound and agrees with the
    record.
    """
    found, problems = said(scenario)
    assert any(
        measured.get(claim, outcome) != outcome for claim, outcome in found.items()
    )
    assert problems == []
    for outcomes in (measured, found):
        assert_that_claims_go_together(outcomes)


@pytest.mark.parametrize(
    ("name", "claims"), [("reversed", RECOMMENDING), ("noise-x-60", BELOW_THE_NOISE)]
)
def test_what_a_scenario_does_not_show_does_not_hold(name, claims, measured):
    before = {claim for claim, outcome in measured.items() if claim.startswith(claims)}
    outcomes = said(BY_NAME[name])[0]
    assert (
        before
        and {claim for claim in before if outcomes.get(claim) == "holds"} == set()
    )
