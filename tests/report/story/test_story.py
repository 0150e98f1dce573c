"""The front page and the story: short, made of claims, every number once, and following the data."""

import re
from collections import Counter
from dataclasses import replace
from itertools import product

import pytest

from experiments.facts.case import AS_SHIPPED
from experiments.simulation.task import FRAME_RATE
from measured_report import ROOT
from measured_report.claims.claim import FAILS, HOLDS, Outcome
from measured_report.pages.outline import FRONT
from measured_report.pages.prose import Templates
from measured_report.site.check import check_site
from report.sections.reproduction import SCENE
from report.story.found import Found
from report.story.front import derive as front_of
from report.story.story import TOLD
from report.story.story import derive as story_of

pytestmark = pytest.mark.words
WHOLE = ["1.4.0", "1.8.0"]
"""Releases that were measured whole."""
MOST_WORDS = 2500
TAGS = re.compile(r"<[^>]*>")
SAYING = re.compile(r"\{#.*?#\}|\{%.*?%\}|\{\{.*?\}\}|<[^>]*>|\(#\w+\)", re.DOTALL)
FORMULAS = ("2 / (dmax · timeconst)", "2 / kd", "2√ke")
NUMBER = re.compile(r"(?<![\w.])\d")


@pytest.fixture(scope="module")
def templates():
    return Templates(ROOT / "templates")


def front_text(edition, templates):
    return edition.texts(FRONT, templates, {})[0]


def story_text(edition, templates):
    return edition.texts(FRONT, templates, {})[1]


def html_of(prose) -> str:
    return prose.html({figure.anchor: f"[{figure.anchor}]" for figure in prose.figures})


def words_of(prose) -> int:
    captions = [figure.wording("caption", figure.numbers) for figure in prose.figures]
    return len(TAGS.sub(" ", " ".join([html_of(prose), *captions])).split())


def test_what_was_measured_whole_is_told_shortly(editions, templates):
    for edition in editions.values():
        assert words_of(story_text(edition, templates)) <= MOST_WORDS
        assert words_of(front_text(edition, templates)) <= MOST_WORDS / 3
    told = [release for release, edition in editions.items() if story_text(edition, templates).printed]
    assert told == WHOLE


@pytest.mark.parametrize("name", ["front", "story"])
def test_no_number_is_typed(name):
    text = SAYING.sub(" ", (ROOT / "templates" / f"{name}.md.j2").read_text(encoding="utf-8"))
    for formula in FORMULAS:
        text = text.replace(formula, "")
    assert [text[max(0, found.start() - 30) : found.end() + 10] for found in NUMBER.finditer(text)] == []


def test_the_story_says_every_number_once(editions, templates):
    for edition in editions.values():
        prose = story_text(edition, templates)
        said = "".join(thing for thing in prose.printed if isinstance(thing, str))
        sources = Counter(re.findall(r'data-src="([^"]+)"', said))
        assert [source for source, count in sources.items() if count > 1] == []
        assert len(sources) > 40 or not prose.printed


@pytest.mark.parametrize(("make", "page"), [(front_of, "front"), (story_of, "story")])
def test_every_claim_is_on_its_page_and_every_outcome_can_be_said(editions, templates, make, page):
    for edition in editions.values():
        prose = {"front": front_text, "story": story_text}[page](edition, templates)
        said = html_of(prose) + prose.title
        names = {claim.name for claim in make(edition.chapters).claims}
        assert set(re.findall(r'data-claim="\w+\.(\w+)"', said)) == names
        words = templates.text(f"{page}.md.j2").words
        for claim in make(edition.chapters).claims:
            claim = replace(claim, wording=words["claim", claim.name])
            texts = [replace(claim, outcome=outcome).text for outcome in (HOLDS, FAILS, Outcome("unknown", "a test"))]
            assert len(set(texts)) == 3 and all(texts)
            assert claim.name == "title" or all(text.endswith((".", ":")) for text in texts), texts


def test_title_and_story_follow_the_data(editions, templates):
    titles = {release: front_text(edition, templates).title.striptags() for release, edition in editions.items()}
    assert titles["1.4.0"].startswith("The cube creeps through a firm grasp")
    assert titles["1.8.0"].startswith("The cube hardly creeps in the grasp")
    for release, said in {"1.4.0": "It takes the shake", "1.8.0": "not the shake alone that moves"}.items():
        text = TAGS.sub("", html_of(story_text(editions[release], templates)))
        assert said in text and "the other way" in text


def in_both(edition, templates):
    """The story's claims that retell a section's, each beside that one."""
    words = templates.text("story.md.j2").words
    for claim in story_of(edition.chapters).claims:
        if claim.name in TOLD:
            section, name = TOLD[claim.name]
            yield Found(edition.chapters).claim(section, name), replace(claim, wording=words["claim", claim.name])


def test_what_a_section_calls_not_shown_its_retelling_does(editions, templates):
    pairs = [pair for release in WHOLE for pair in in_both(editions[release], templates)]
    careful = [(told, again) for told, again in pairs if "not shown" in told.said("fails")]
    assert len(careful) > 10
    assert [again.name for _, again in careful if "not shown" not in again.said("fails")] == []
    opposite = [again for told, again in pairs if told.said("opposite")]
    assert opposite and all(again.said("opposite") for again in opposite)


def depends(claim, part, flag):
    """Whether what it says there is another thing where a flag is the other way."""
    return claim.said(part) != claim.wording(part, {**claim.numbers, flag: not claim.numbers[flag]})


def test_words_that_depend_on_a_flag_do_so_when_retold(editions, templates):
    tried = set()
    for told, again in (pair for release in WHOLE for pair in in_both(editions[release], templates)):
        flags = [name for name, number in told.numbers.items() if isinstance(number, bool)]
        for flag, part in product(flags, ("holds", "fails")):
            if depends(told, part, flag):
                tried.add(flag)
                assert depends(again, part, flag), f"{again.name} {part} {flag}"
    assert tried == {"is_opposed", "small_ones_fail"}


def failing(chapter, *names):
    """The chapter as if its claims of these names, or all, failed."""
    claims = [replace(c, outcome=FAILS) if c.name in names or not names else c for c in chapter.section.claims]
    return replace(chapter, section=replace(chapter.section, claims=claims))


@pytest.mark.parametrize("name", ["mujoco_contacts_as_before", "pyramid_as_before"])
def test_that_the_fix_is_needed_elsewhere_takes_other_contacts_and_the_other_cone(editions, name):
    chapters = editions["1.8.0"].chapters
    upgrade = chapters["upgrade"]
    for each, outcome in ((upgrade, HOLDS), (failing(upgrade, name), FAILS)):
        (elsewhere,) = [c for c in story_of({**chapters, "upgrade": each}).claims if c.name == "elsewhere"]
        assert elsewhere.outcome == outcome


def mistuned(edition, templates, **chapters):
    """What the front page says of the scene's tuning, with other chapters of these names."""
    (claim,) = [c for c in front_of({**edition.chapters, **chapters}).claims if c.name == "is_mistuned"]
    return replace(claim, wording=templates.text("front.md.j2").words["claim", claim.name])


def test_pads_that_gain_less_than_a_remedy_are_not_called_no_better(editions, templates):
    edition = editions["1.8.0"]
    assert "stiffer pads do not make the slip 10 times less" in mistuned(edition, templates).text
    noise = edition.chapters["noise"]
    large = replace(noise.results.derived["slip_floor"], value=1.0)
    loud = replace(noise, results=replace(noise.results, derived={**noise.results.derived, "slip_floor": large}))
    assert "stiffer pads are not shown to be better" in mistuned(edition, templates, noise=loud).text


def test_what_the_lint_does_not_name_says_nothing_of_the_pads(editions, templates):
    edition = editions["1.4.0"]
    claim = mistuned(edition, templates, lint=failing(edition.chapters["lint"]))
    assert claim.outcome == FAILS and claim.text.startswith("The lint does not say")


def test_front_and_story_agree_on_where_stiff_pads_help(editions, templates):
    for release, edition in editions.items():
        both = [*front_of(edition.chapters).claims, *story_of(edition.chapters).claims]
        claims = {claim.name: claim for claim in both}
        if "remedy_elsewhere" in claims:
            ways = [claims[f"way_{name}"].outcome == HOLDS for name in ("mujoco", "c", "pyramid")]
            assert (claims["remedy_elsewhere"].outcome == HOLDS) == all(ways), release


def test_a_claim_that_flips_changes_the_front_page(editions, templates):
    edition = editions["1.5.0"]  # it has no clips
    flipped = failing(edition.chapters["reproduction"], "slips")
    front = front_text(replace(edition, chapters={**edition.chapters, "reproduction": flipped}), templates)
    assert front.title.striptags().startswith("The cube hardly creeps in the grasp")
    assert "Where the cube ends" in front.figures[0].wording("caption", front.figures[0].numbers)


def test_the_scene_that_is_told_is_the_one_that_is_simulated():
    edge_m, density = AS_SHIPPED.cube_edge_m, AS_SHIPPED.cube_density_kg_m3
    told = {name: value for name, value, _ in SCENE}
    assert told["cube_edge"] == pytest.approx(1e3 * edge_m)
    assert told["cube_mass"] == pytest.approx(1e3 * density * edge_m**3)
    assert (told["frame_rate"], told["substeps"]) == (FRAME_RATE, AS_SHIPPED.substeps)
    assert told["impratio"] == AS_SHIPPED.impratio


def test_alternative_texts_are_short(editions, templates):
    for edition in editions.values():
        proses = [front_text(edition, templates), story_text(edition, templates)]
        proses += [chapter.prose for chapter in edition.chapters.values()]
        figures = [figure for prose in proses for figure in prose.figures]
        alts = {figure.anchor: figure.wording("alt", figure.numbers).striptags() for figure in figures}
        assert {anchor: len(alt) for anchor, alt in alts.items() if len(alt) > 300} == {}


def test_what_is_not_there_is_said(editions):
    found = Found(editions["1.5.0"].chapters)
    assert found.claim("friction", "not_the_cause") is None
    assert found.cell("speed", "as-shipped", "frame_ms", "ms").reason == "section speed has no results here"
    assert found.value("reproduction", "no_such", "mm").reason == "section reproduction does not say"


def test_without_the_shake_test_there_is_a_title_alone(toy):
    toy.write("templates/front.md.j2", (ROOT / "templates" / "front.md.j2").read_text(encoding="utf-8"))
    toy.build()
    assert "<h1>A shake test on a grasped cube</h1>" in toy.front
    assert check_site(toy.project.site) == []
