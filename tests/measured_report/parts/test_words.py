"""Words: what a template says of claims, figures and tables is found before anything is rendered."""

import pytest
from conftest import MODULE, TEMPLATE

from measured_report.files.errors import ReportError
from measured_report.files.root import ROOT
from measured_report.pages.prose import Templates
from measured_report.parts.claim import FAILS, HOLDS, OPPOSITE, Claim, Outcome
from measured_report.parts.words import overstated

pytestmark = pytest.mark.words
ASKS = "{% asks %} whether it helps\n"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("claim helps", "claim hepls", r"sections/toy.md.j2:4: there is no claim hepls; there are: helps"),
        (ASKS, "", r"sections/toy.md.j2:3: claim helps has no {% asks %}"),
        ("{% alt %} It moves {{ slip }}.", "", r"sections/toy.md.j2:11: figure way has no {% alt %}"),
        ("{% holds %}", "Well: {% holds %}", r"sections/toy.md.j2:3: .*belongs behind one of its tags"),
        ("{{ gain }}", "{{ gian }}", r"sections/toy.md.j2:4: claim helps names gian, .* it is given: gain"),
        ("It helps {{ gain }}", "It helps {{ 3 }}", r"prints 3, which says nothing of where it comes from"),
        ("{% table cases %} All cases {% endtable %}", "", r"sections/toy.md.j2 says nothing of the table cases"),
        (ASKS, ASKS * 2, r"sections/toy.md.j2:7: claim helps is worded twice"),
        ("claims=[", 'claims=[Claim("lasts", at_least(gain, bound)), ', "toy.md.j2 says nothing of the claim lasts"),
        ('{"gain": gain}', '{"gain": gain, "none": gain}', r"toy.md.j2:4: claim helps is given none, which is a const"),
    ],
)
def test_what_is_wrong_with_the_words_stops_the_build(toy, old, new, message):
    assert old in TEMPLATE + MODULE
    toy.write("templates/sections/toy.md.j2", TEMPLATE.replace(old, new))
    toy.write("report/sections/toy.py", MODULE.replace(old, new))
    with pytest.raises(ReportError, match=message):
        toy.build()


def test_words_are_known_without_rendering(toy):
    text = Templates(toy.project.templates).text("sections/toy.md.j2")
    wording = text.words["claim", "helps"]
    claim = Claim("helps", HOLDS, {"gain": "3"}, wording)
    assert claim.text == "It helps 3 times."
    assert str(claim.html("toy")).endswith("</span> Because it is stiff.")
    for outcome, said in (
        (FAILS, "It does not."),
        (Outcome("unknown", "it fell"), "Whether it helps cannot be told (it fell)."),
    ):
        assert Claim("helps", outcome, {"gain": "3"}, wording).text == said
    assert wording.names == {"gain"}


def test_a_sentence_stands_where_it_is_written(toy):
    toy.build()
    assert "Because it is stiff.\nStiff is <data" in toy.page
    assert toy.page.index("It helps") < toy.page.index('<figure id="toy-way"') < toy.page.index("All cases")


@pytest.mark.parametrize(
    ("fails", "found"),
    [
        ("It does not.", "It does not"),
        ("The solver matters: the slip changes by {{ slip }}.", "The solver matters"),
        ("{% if few %} It slips {{ slip }}. {% else %} It stays. {% endif %}", "It stays"),
        ("It is not shown that it slips: {{ slip }}. It sticks.", "It sticks"),
        ("It is not shown that no cube slips: {{ slip }} with soft pads, none with stiff ones.", ""),
        ("No loss is seen in any run.", ""),
    ],
)
def test_what_only_is_not_shown_is_not_said_to_be_otherwise(tmp_path, fails, found):
    words = f"{{% claim slips %}}\n{{% holds %}} Never.\n{{% fails %}} {fails}\n{{% asks %}} x\n{{% endclaim %}}"
    (tmp_path / "toy.md.j2").write_text(words, encoding="utf-8")
    assert [line.partition("“")[2].partition("”")[0] for line in overstated(tmp_path)] == ([found] if found else [])


def test_no_template_says_more_than_that_something_is_not_shown():
    """Those of the example and of a new report are looked at by their own tests."""
    assert overstated(ROOT / "templates") == []


def test_a_claim_may_have_words_for_the_opposite_alone(toy):
    toy.write("templates/sections/toy.md.j2", TEMPLATE.replace("{% fails %}", "{% opposite %}"))
    wording = Templates(toy.project.templates).text("sections/toy.md.j2").words["claim", "helps"]
    assert Claim("helps", OPPOSITE, {"gain": "3"}, wording).text == "It does not."
    assert Claim("helps", FAILS, {"gain": "3"}, wording).text == "Whether it helps is not shown."
