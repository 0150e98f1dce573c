"""Passages: paragraphs stand only while the claims that they rest on do, with numbers of these alone."""

import pytest
from conftest import MODULE, TEMPLATE

from measured_report.files.errors import ReportError
from measured_report.pages.editions import editions_of
from measured_report.pages.prose import Templates
from measured_report.site.check import check_site
from tests.inert import inert_passages
from tests.perturbed import of_editions

pytestmark = pytest.mark.words
FALLEN = (("soft", 0.5), ("stiff", 0.3124))
PLAIN = '{% passage needs="toy.helps" %}\nStiff ones gain {{ toy.helps.gain }}.\n{% endpassage %}'
OTHERWISE = PLAIN.replace("{% endpassage", "{% otherwise %}\nIt is *another* story.\n{% endpassage")
OTHER_DATA = "was written for other data"


def built(toy, passage: str, *, falls: bool = False, before: str = "# A report") -> str:
    """The front page with a passage on it."""
    if falls:
        toy.measure([{"case": case, "slip_mm": slip, "dropped": False} for case, slip in FALLEN])
    toy.write("templates/front.md.j2", f"{before}\n\n{passage}\n\nThe end.\n")
    toy.build()
    assert check_site(toy.project.site) == []
    return toy.front


def test_a_passage_stands_while_its_claims_hold(toy):
    page = built(toy, OTHERWISE)
    assert '<div class="passage" data-needs="toy.helps holds" data-outcome="holds">\n<p>Stiff ones gain <data' in page
    assert "</data>.</p>\n</div>\n<p>The end.</p>" in page
    assert "another" not in page and OTHER_DATA not in page


def test_where_a_claim_falls_the_other_words_are_said(toy):
    page = built(toy, OTHERWISE, falls=True)
    assert "<p>It is <em>another</em> story.</p>" in page
    assert "Stiff ones gain" not in page and OTHER_DATA not in page


def test_without_other_words_the_claims_speak_for_themselves(toy):
    page = built(toy, PLAIN, falls=True)
    assert 'data-needs="toy.helps holds" data-outcome="fails"' in page
    assert 'data-claim="toy.helps" data-outcome="fails">It does not.</span>' in page
    assert OTHER_DATA in page and "Stiff ones gain" not in page


def test_a_passage_falls_with_a_number_that_is_not_there(toy):
    module = MODULE.replace('{"gain": gain}', '{"gain": gain, "lost": absent("mm", "it fell")}')
    toy.write("report/sections/toy.py", "from measured_report.values.quantities import absent\n" + module)
    page = built(toy, OTHERWISE.replace("helps.gain", "helps.lost"))
    assert "another" in page and "it fell" not in page


def test_other_stories_rest_on_claims_too_and_a_part_of_a_line_can_be_a_passage(toy):
    other = '{% passage needs="toy.helps fails" %}\nGain {{ toy.helps.gain }} is none.\n{% endpassage %}'
    line = '# {% passage needs="toy.helps" %}It helps{% otherwise %}It does not help{% endpassage %}'
    page = built(toy, OTHERWISE.replace("It is *another* story.", other), falls=True, before=line)
    assert 'data-needs="toy.helps fails" data-outcome="holds">\n<p>Gain <data' in page
    assert "<h1>It does not help</h1>" in page
    assert '<h1><span class="passage" data-needs="toy.helps holds" data-outcome="holds">It helps' in built_again(
        toy, line
    )


def built_again(toy, line: str) -> str:
    toy.measure()
    return built(toy, "", before=line)


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("needs=", "need=", r"front.md.j2:3"),
        ('"toy.helps"', '"toy helps"', r"front.md.j2:3: 'toy helps' is no need of a passage"),
        ('"toy.helps"', '"toy.hepls"', "toy has no claim 'hepls'; it has: helps"),
        (PLAIN, PLAIN.replace("toy", "top"), "there is no report/sections/top.py"),
        ("toy.helps.gain", "toy.helps.bound", "has no attribute 'bound'"),
        ("toy.helps.gain", 'sections["toy"].row["stiff"].slip_mm', "names sections, which is no section that it needs"),
        ("toy.helps.gain", "gap.helps.gain", "names gap, which is no section that it needs"),
        ("toy.helps.gain", "5 mm", "5 mm is typed"),
    ],
)
def test_what_is_wrong_with_a_passage_stops_the_build(toy, old, new, message):
    typed = "{{ toy.helps.gain }}" if new == "5 mm" else old
    with pytest.raises(ReportError, match=message):
        built(toy, PLAIN.replace(typed, new))


@pytest.mark.parametrize("place", ["front.md.j2", "sections/toy.md.j2"])
def test_the_search_for_inert_numbers_sees_passages(toy, place):
    """The gain moves the claim. The bound of the claim is another thing: where it is not compared it moves nothing."""
    module = MODULE.replace("claims=[", 'claims=[Claim("stands", at_least(bound, bound), {"slip": soft.slip_mm}), ')
    toy.write("report/sections/toy.py", module)
    words = TEMPLATE.replace(
        "{% claim helps", "{% claim stands %}{% holds %} A. {% fails %} B. {% asks %} c {% endclaim %}\n{% claim helps"
    )
    toy.write("templates/sections/toy.md.j2", words)
    inert = PLAIN.replace("toy.helps.gain", "toy.stands.slip").replace('"toy.helps"', '"toy.stands"')
    text = "# A report\n" if place == "front.md.j2" else words
    toy.write(f"templates/{place}", f"{text}\n{PLAIN}\n\n{inert}\n")
    templates = Templates(toy.project.templates)
    found = inert_passages(of_editions(editions_of(toy.project, templates), templates, ["1.4.0"]), "1.4.0")
    assert found == {"toy.stands holds toy.json#/rows/0/slip_mm"}
