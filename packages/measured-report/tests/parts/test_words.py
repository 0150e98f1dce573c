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
            "It helps {{ gain }}",
            "It helps {{ gain | round(2) }}",
            r"toy.md.j2:4: 20.* is rounded according to its noise: print it without the filter",
        ),
        (
            "Stiff is {{",
            'Stiff is {{ "a" + 1 }} {{',
            r"toy.md.j2:9: TypeError: can only concatenate str",
        ),
        *(
            (
                "It helps {{ gain }}",
                f"It helps {typed}",
                rf"toy.md.j2:4: {said} is hard-coded: use a measured number",
            )
            for typed, said in (
                ("ten times", "ten times"),
                ("Twice as much", "Twice as"),
                ("two-fold", "two-fold"),
                ("half as much", "half as"),
                ("by a third of it", "a third of"),
                ("`6.3 mm` of {{ gain }}", "6.3 mm"),
                ("fifty per cent", "fifty per cent"),
                ("an order of magnitude", "order of magnitude"),
                ("nearly double", "nearly double"),
                ("| by | 3.5 |", "3.5"),
            )
        ),
        (
            'axes.plot(trace.value["time_s"], trace.value["x_mm"]',
            "axes.plot([0, 1, 2], [0.1, 0.2, 0.5]",
            "toy.py:11 draws numbers that are typed in the code: draw numbers of",
        ),
        (
            'axes.plot(trace.value["time_s"], trace.value["x_mm"]',
            "data = {'a': -3.1, 'b': 2}; axes.bar(data.keys(), data.values()",
            "toy.py:11 draws numbers that are typed in the code: draw numbers of",
        ),
        (
            'axes.plot(trace.value["time_s"], trace.value["x_mm"]',
            "frame = pd.DataFrame({'a': [0.1, 0.5]}); frame.plot(ax=axes",
            "toy.py:11 draws numbers that are typed in the code: draw numbers of",
        ),
        (
            "axes.legend()",
            'axes.set(title="it moves 2.5 mm")',
            "toy.py:12 draws numbers that are typed in the code: draw numbers of",
        ),
        (
            'axes.plot(trace.value["time_s"], trace.value["x_mm"]',
            "axes.axhline(1.1); axes.plot(trace.value, trace.value",
            "toy.py:11 draws numbers that are typed in the code: draw numbers of",
        ),
        (
            "{{ gain }}",
            "{{ gain }} %",
            r"toy.md.j2: the unit % is typed after a number, which is printed with",
        ),
        (
            "slip_mm }}.",
            "slip_mm }} mm.",
            r"toy.md.j2: the unit mm is typed after a number, which is printed with",
        ),
        (
            '{"gain": gain})]',
            '{"gain": "20.3 mm"})]',
            r"it prints '20.3 mm', which does not have a source: use a Quantity",
        ),
        (
            "{% holds %} It helps {{ gain }} times.",
            "{% holds %}",
            r"toy.md.j2:\d: claim helps has no text for holds: add it",
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


@pytest.mark.parametrize(
    "words",
    ["it ran several times", "a scaffold", "half of it", "`x = 3`", "the third of May"],
)
def test_words_that_are_no_measured_number_are_kept(toy, words):
    toy.write("templates/sections/toy.md.j2", f"{TEMPLATE}\nAnd {words}.\n")
    toy.build()
    assert words.strip("`") in toy.page


def test_a_helper_of_figures_that_draws_typed_numbers_is_refused(toy):
    toy.write("report/shared.py", "def draw(axes):\n    axes.plot([3.5, 4.5])\n")
    with pytest.raises(ReportError, match=r"report/shared.py:2 draws numbers"):
        toy.build()


def test_positions_and_computed_lists_can_be_drawn(toy):
    drawn = 'axes.bar([0, 1], [2 * x for x in trace.value["x_mm"]]'
    old = 'axes.plot(trace.value["time_s"], trace.value["x_mm"]'
    toy.write("report/sections/toy.py", MODULE.replace(old, drawn))
    toy.build()
    assert "<figure" in toy.page


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
