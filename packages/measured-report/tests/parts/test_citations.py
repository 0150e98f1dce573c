"""Statements that are cited, and claims of other sections that words rest on."""

import pytest
from toys import TEMPLATE

from measured_report.files.errors import ReportError
from measured_report.site.check import check_site

pytestmark = pytest.mark.words


def test_a_statement_says_that_it_is_not_measured_here(toy):
    words = "\n{% stated law %} Twice *as* large as {{ row['stiff'].slip_mm }}. {% endstated %}\n"
    toy.write("templates/sources.toml", '[law]\nurl = "https://example.org/law"\n')
    toy.write("templates/sections/toy.md.j2", TEMPLATE + words)
    toy.build()
    assert '<span class="stated">Twice <em>as</em> large as <data' in toy.page
    assert '.<sup class="cited"><a href="#source-1" aria-label="Source 1">1</a></sup></span>' in toy.page
    assert '<li id="source-1"><a href="https://example.org/law">example.org/law</a></li>' in toy.page
    assert check_site(toy.project.site) == []
    toy.write("templates/sources.toml", '[lore]\npackage = "newton"\n')
    with pytest.raises(ReportError, match=r"sources\.toml: lore needs url"):
        toy.build()


@pytest.mark.parametrize(
    ("pairs", "message"),
    [
        ('contradict = [["toy.helps holds", "toy.helps holds"]]', "contradicts"),
        ('needs = [["toy.helps holds", "toy.helps fails"]]', "which is not said"),
        ('needs = [["toy.help holds", "toy.helps fails"]]', "no claim toy.help"),
        ("contradicts = []", "has contradicts"),
        ('contradict = [["toy.helps holds", "toy.helps fails"]]', ""),
        ('needs = [["toy.helps fails", "gap.not_the_cause holds"]]', ""),
    ],
)
def test_what_does_not_go_together_stops_the_build(toy, pairs, message):
    toy.write("templates/pairs.toml", pairs)
    if not message:
        toy.build()
        return
    with pytest.raises(ReportError, match=message):
        toy.build()
