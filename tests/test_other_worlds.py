"""Scenarios: whatever is measured, the pages build, no section is lost, and their claims were read by a person.

``python -m tests.worlds`` writes what is kept anew; read what changed before you commit it.
"""

import re

import pytest
from worlds import AS_MEASURED, SCENARIOS, Scenario, as_measured, kept, otherwise, project_of, said

from measured_report.deriving.editions import editions_of
from measured_report.editions.project import own_release
from measured_report.pages.prose import Templates
from measured_report.records.columns import REASON
from measured_report.site.pages import undrawn
from report.media.card import TITLE
from report.story.found import CASES

pytestmark = pytest.mark.words

RECOMMENDING = ("front.title", "front.remedy", "front.is_mistuned", "front.way_", "story.remedy", "story.files")
RECOMMENDING += ("fix.recommended", "stiffness.together_they_hold", "reproduction.stiff_pads_hold")
CAUSES = ("stiffness.cause", "contacts.missing_term", "contacts.term_restored", "story.restored", "story.missing")
CAUSES += ("hold.creep_is_rounding", "turntable.follows_law", "front.remedy", "story.remedy", "fix.recommended")
BELOW_THE_NOISE = ("hold.longer_steps", "contacts.rest_goes_with_step", "cure_hold.compensation")
BELOW_THE_NOISE += ("cure_hold.rest_goes", "speed.fixed_is_faster", "envelope.map_gain", "hold.creep_goes_on")
# Its bound is 5 % of the slip, to which 50 times the noise does not come since it was measured again.
BELOW_MORE_NOISE = ("gap.not_the_cause",)

TURNED = ("reversed", "all-equal", "moving-x-0.05", "moving-x-20", "noise-x-60", "releases-swapped")
"""Scenarios in which everything is there, and is otherwise."""
PART = re.compile(r"[.;:]\s")
QUESTION = re.compile("(?:what|how|which|where|whose) ", re.IGNORECASE)
OF_ALL = re.compile(r"\b(?:not (?!seen|known|measured)|never|all (?!of )|every|always|why)\b", re.IGNORECASE)
VERB = re.compile(
    r"(?<!that )(?<!what )\b(?:is|are|was|were|has|have|acts|breaks|changes|costs|creeps|decides|drifts|ends|falls|"
    r"fits|follows|forgets|gains|helps|holds|keeps|leaves|lets|loses|matters|moves|needs|pays|slips|stays|takes|turns|works)\b"
)


def asserts(words: str) -> bool:
    """Whether words that are no sentence say something: of all or of none, why, or by a verb without a number."""
    parts = [part for part in PART.split(words) if not part.endswith("?")]
    told = [part for part in parts if "#" not in part and not QUESTION.match(part)]
    return any(map(OF_ALL.search, parts)) or any(map(VERB.search, told))


@pytest.fixture(scope="module")
def before() -> dict[str, str]:
    return dict(said(AS_MEASURED).outcomes)


def among(outcomes: dict[str, str], names: tuple[str, ...]) -> dict[str, str]:
    return {claim: outcome for claim, outcome in outcomes.items() if claim.startswith(names)}


@pytest.mark.parametrize("scenario", SCENARIOS, ids=[scenario.name for scenario in SCENARIOS])
def test_what_a_scenario_says_otherwise_was_read(scenario):
    assert otherwise(scenario) == kept(scenario.name), "python -m tests.worlds renews it; read what changed"


def test_words_outside_sentences_that_stand_whatever_is_measured_assert_nothing():
    """Titles, headings, alternative texts, cells of tables and the picture of links."""
    scenarios = (AS_MEASURED, *(scenario for scenario in SCENARIOS if scenario.name in TURNED))
    standing = frozenset.intersection(*(said(scenario).words for scenario in scenarios))
    assert [words for words in sorted({*standing, TITLE, *CASES.values()}) if asserts(words)] == []


@pytest.mark.parametrize(
    ("words", "found"),
    [
        ("One law for all scenes", True),
        ("Stiff pads hold the cube: it stays", True),
        ("What the scene does not need", True),
        ("Why", True),
        ("not seen", False),
        ("Is the slide all of the motion?", False),
        ("How far it slips", False),
        ("The least friction that holds a cube", False),
        ("With shipped pads it slips #, with stiff ones #", False),
        ("The ball is dropped at # in every shake", True),
    ],
)
def test_what_words_assert_is_seen(words, found):
    assert asserts(words) == found


@pytest.mark.parametrize(
    ("scenario", "names"),
    [("reversed", RECOMMENDING), ("all-equal", CAUSES), ("noise-x-50", BELOW_THE_NOISE)]
    + [("noise-x-60", BELOW_MORE_NOISE)],
)
def test_what_a_scenario_does_not_show_does_not_hold(scenario, names, before):
    """Each of these holds as measured, and has another outcome in the scenario."""
    assert set(among(before, names).values()) == {"holds"}
    found = among(kept(scenario), names)
    assert "holds" not in found.values()
    # A scenario may have claims of its own, as where stiff pads still help when the cube does not slip.
    assert found.keys() >= among(before, names).keys()


@pytest.mark.slow
@pytest.mark.parametrize("column", ["integrator", "shake_amplitude_m", "shake_duration_s"])
def test_a_parameter_that_every_record_lacks_stops_no_build(column):
    """It has a reason in its place; sections that are about it may be left out."""

    def rows(records, place):
        lost = {column: None, column + REASON: "as a test"}
        return [{**row, **(lost if column in row else {})} for row in as_measured(records, place)]

    with project_of(Scenario("lacking", rows), [own_release()]) as project:
        editions = editions_of(project, templates := Templates(project.templates))
        assert len(undrawn(editions, templates, project.release)) > 10
