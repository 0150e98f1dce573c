"""Test citations of statements and their sources."""

import pytest
from toys import TEMPLATE

from measured_report.files.errors import ReportError
from measured_report.site.check import check_site

pytestmark = pytest.mark.words


def test_a_statement_says_that_it_is_not_measured_here(toy):
    words = "\n{% call stated('law') %} Twice *as* large as {{ row['stiff'].slip_mm }}. {% endcall %}\n"
    toy.write("templates/sources.toml", '[law]\nurl = "https://example.org/law"\n')
    toy.write("templates/sections/toy.md.j2", TEMPLATE + words)
    toy.build()
    assert '<span class="stated">Twice <em>as</em> large as <data' in toy.page
    assert (
        '.<sup class="cited"><a href="#source-1" aria-label="Source 1">1</a></sup></span>'
        in toy.page
    )
    assert (
        '<li id="source-1"><a href="https://example.org/law">example.org/law</a></li>'
        in toy.page
    )
    assert check_site(toy.project.site) == []
    toy.write("templates/sources.toml", '[lore]\npackage = "newton"\n')
    with pytest.raises(
        ReportError, match=r"sources\.toml: lore has neither a url nor a package"
    ):
        toy.build()
