"""Properties of the report over altered editions.

Whatever is measured, nothing ends in a traceback, no claims contradict each other (``templates/pairs.toml`` stops the
build), and no bound stands on the wrong side.
"""

import pytest
from altered import SCENARIOS, said, said_of

from measured_report.editions.project import own_release

pytestmark = [pytest.mark.words, pytest.mark.usefixtures("unchanged")]
pytestmark += [pytest.mark.filterwarnings("error::RuntimeWarning")]
BY_NAME = {scenario.name: scenario for scenario in SCENARIOS}
RECOMMENDING = ("front.title", "front.remedy", "front.is_mistuned", "front.way_", "story.remedy", "story.files")
RECOMMENDING += ("fix.recommended", "stiffness.together_they_hold", "reproduction.stiff_pads_hold")
BELOW_THE_NOISE = ("envelope.map_gain", "hold.creep_goes_on", "gap.not_the_cause")


@pytest.fixture(scope="module")
def measured(editions) -> dict[str, str]:
    return said_of(editions, own_release())


@pytest.mark.slow
@pytest.mark.parametrize("scenario", SCENARIOS, ids=lambda scenario: scenario.name)
def test_whatever_is_measured_no_section_is_lost_other_claims_hold_and_the_site_is_sound(scenario, measured):
    """A contradiction between claims stops the build; every bound stands on its side, every number is the record's."""
    found, problems = said(scenario)
    assert any(measured.get(claim, outcome) != outcome for claim, outcome in found.items())
    assert problems == []


@pytest.mark.parametrize(("name", "claims"), [("reversed", RECOMMENDING), ("noise-x-60", BELOW_THE_NOISE)])
def test_what_a_scenario_does_not_show_does_not_hold(name, claims, measured):
    before = {claim for claim, outcome in measured.items() if claim.startswith(claims)}
    outcomes = said(BY_NAME[name])[0]
    assert before and {claim for claim in before if outcomes.get(claim) == "holds"} == set()
