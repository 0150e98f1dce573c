"""Test that a paragraph is shown only while its claims hold, and that it prints numbers
of these claims only.
"""

import pytest
from toys import MODULE

from measured_report.files.errors import ReportError
from measured_report.site.check import check_site

pytestmark = pytest.mark.words
FALLEN = (("soft", 0.5), ("stiff", 0.3124))
PLAIN = '{% passage needs="toy.helps" %}\nStiff ones gain {{ toy.helps.gain }}.\n{% endpassage %}'
OTHERWISE = PLAIN.replace(
    "{% endpassage", "{% otherwise %}\nIt is *another* story.\n{% endpassage"
)
OTHER_DATA = "was written for other data"


def built(toy, passage: str, *, falls: bool = False, before: str = "# A report") -> str:
    """Return the front page with a passage on it."""
    if falls:
        toy.measure(
            [{"case": case, "slip_mm": slip, "dropped": False} for case, slip in FALLEN]
        )
    toy.write("templates/front.md.j2", f"{before}\n\n{passage}\n\nThe end.\n")
    toy.build()
    assert check_site(toy.project.site) == []
    return toy.front


def test_a_passage_stands_while_its_claims_hold(toy):
    page = built(toy, OTHERWISE)
    assert (
        '<div class="passage" data-needs="toy.helps holds" data-outcome="holds">\n<p>Stiff ones gain <data'
        in page
    )
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
    module = MODULE.replace(
        '{"gain": gain}', '{"gain": gain, "lost": absent("mm", "it fell")}'
    )
    toy.write(
        "report/sections/toy.py",
        "from measured_report.values.quantities import absent\n" + module,
    )
    page = built(toy, OTHERWISE.replace("helps.gain", "helps.lost"))
    assert "another" in page and "it fell" not in page


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("needs=", "need=", r"front.md.j2:3"),
        (
            '"toy.helps"',
            '"toy helps"',
            r"front.md.j2:3: needs: expects \"section.claim\", got 'toy helps'",
        ),
        (
            '"toy.helps"',
            '"toy.hepls"',
            "section toy does not have a claim 'hepls': .*helps",
        ),
        (PLAIN, PLAIN.replace("toy", "top"), "report/sections/top.py does not exist"),
        ("toy.helps.gain", "toy.helps.bound", "has no attribute 'bound'"),
        (
            "toy.helps.gain",
            "gap.helps.gain",
            "'gap' is undefined",
        ),
        ("toy.helps.gain", "5 mm", "5 mm is hard-coded"),
    ],
)
def test_what_is_wrong_with_a_passage_stops_the_build(toy, old, new, message):
    typed = "{{ toy.helps.gain }}" if new == "5 mm" else old
    with pytest.raises(ReportError, match=message):
        built(toy, PLAIN.replace(typed, new))
