"""Test that words of a template about claims, figures and tables are found before the
page is rendered.
"""

import re

import pytest
from toys import MODULE, TEMPLATE

from measured_report.files.errors import ReportError

pytestmark = pytest.mark.words
ASKS = "{% asks %} whether it helps\n"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "claim helps",
            "claim hepls",
            r"sections/toy.md.j2: the section does not have a claim hepls: .* one of helps",
        ),
        (
            ASKS,
            "",
            r"sections/toy.md.j2:3: claim helps does not have {% asks %}: add it",
        ),
        (
            "{% alt %} It moves {{ slip }}.",
            "",
            r"sections/toy.md.j2:11: figure way does not have {% alt %}: add it",
        ),
        (
            "{% holds %}",
            "Well: {% holds %}",
            r"sections/toy.md.j2:3: claim helps has text before its first tag: move it",
        ),
        (
            "{{ gain }}",
            "{{ gian }}",
            r"sections/toy.md.j2:4: 'gian' is undefined",
        ),
        (
            "It helps {{ gain }}",
            "It helps {{ 3 }}",
            r"prints 3, which does not have a source: use a Quantity",
        ),
        (
            "{% table cases %} All cases {% endtable %}",
            "",
            r"sections/toy.md.j2 does not contain the table cases: add {% table cases %}",
        ),
        (
            "helps {{ gain }}",
            "helps at most {{ gain }}",
            r"sections/toy.md.j2:4: at most {{ gain }} may be rounded past its bound: add .most$",
        ),
        (
            "helps {{ gain }}",
            "helps at\nleast {{ gain.most }}",
            r"j2:4: at least {{ gain.most }} may be rounded past its bound: add .least$",
        ),
        (
            "helps {{ gain }}",
            "helps more than {{ gain }}",
            r"more than {{ gain }} may be rounded past its bound: add .most or .least$",
        ),
        (
            ASKS,
            ASKS * 2,
            r"sections/toy.md.j2:7: claim helps has two texts for asks: remove one",
        ),
        (
            "\n{% table",
            TEMPLATE[TEMPLATE.index("{% claim") : TEMPLATE.index("Stiff")]
            + "\n{% table",
            "'claim__helps__holds' defined twice",
        ),
        (
            "claims=[",
            'claims=[Claim("lasts", at_least(gain, bound)), ',
            "toy.md.j2 does not contain the claim lasts: add {% claim lasts %}",
        ),
    ],
)
def test_what_is_wrong_with_the_words_stops_the_build(toy, old, new, message):
    assert old in TEMPLATE + MODULE
    toy.write("templates/sections/toy.md.j2", TEMPLATE.replace(old, new))
    toy.write("report/sections/toy.py", MODULE.replace(old, new))
    with pytest.raises(ReportError, match=message):
        toy.build()


def test_tables_sources_and_what_lies_in_static_are_on_the_page_and_drafts_are_not(
    toy,
):
    words = "| a | b |\n|---|---|\n| c | d |\n"
    cited = "{% call stated('law') %} It is so. {% endcall %}\n"
    toy.write(
        "templates/sources.toml",
        '[law]\nurl = "https://example.org/x"\ntitle = "The law"\n',
    )
    toy.write("templates/sections/toy.md.j2", f"{TEMPLATE}\n{words}\n{cited}")
    for name in ("static/logo.svg", "static/more/a.txt", "static/style.css"):
        toy.write(name, "main { color: red }")
    toy.write("report/sections/_later.py", "a draft(")
    toy.build()
    assert "<td>c</td>" in toy.page
    assert ">The law</a>" in toy.page
    assert (
        'src="static/logo.svg"' in toy.page
        and (toy.project.site / "static/more/a.txt").is_file()
    )
    assert (toy.project.site / "style.css").read_text().endswith("main { color: red }")


def test_claims_that_share_a_wording_are_printed_one_after_another(toy):
    shared = (
        'Claim("helps", at_least(gain, bound), {"gain": gain}, shared_wording="all"),'
    )
    module = MODULE.replace(
        'Claim("helps", at_least(gain, bound), {"gain": gain})',
        shared + shared.replace("helps", "helps_twice").replace("bound)", "2 * bound)"),
    )
    toy.write("report/sections/toy.py", module)
    toy.write(
        "templates/sections/toy.md.j2", TEMPLATE.replace("claim helps", "claim all")
    )
    toy.build()
    claims = re.findall(r'data-claim="toy.(\w+)" data-outcome="(\w+)"', toy.page)
    assert claims == [("helps", "holds"), ("helps_twice", "holds")]
    toy.write("templates/sections/toy.md.j2", TEMPLATE)
    with pytest.raises(ReportError, match=r"does not have a claim helps|claim all"):
        toy.build()
