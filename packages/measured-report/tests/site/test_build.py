"""Test that a site is built from handmade results, checked, and published in one step."""

import gzip
import json
import os
import re
import shutil
from dataclasses import replace
from itertools import combinations, pairwise
from types import SimpleNamespace
from xml.etree import ElementTree

import pandas as pd
import pytest
from markupsafe import Markup
from toys import EXPERIMENT, MODULE, ROWS, TEMPLATE, derived

from measured_report.commands import diff
from measured_report.editions.release import release_of
from measured_report.files.config import Page, report
from measured_report.files.errors import ReportError
from measured_report.parts.prose import Prose
from measured_report.parts.section import Table
from measured_report.records.identity import identity_of
from measured_report.records.record import write_record
from measured_report.records.traces import packed
from measured_report.site import compare as compare_module
from measured_report.site.build import build
from measured_report.site.check import check_site
from measured_report.site.pages import rows_csv
from measured_report.values.results import ResultsError


def test_a_section_takes_three_files_and_passes_the_check(toy):
    toy.build()
    assert check_site(toy.project.site) == []
    assert (
        '<data value="0.3124" data-src="newton-1.4.0/toy.json#/rows/1/slip_mm">0.31</data>&nbsp;mm'
        in toy.page
    )
    assert 'data-claim="toy.helps" data-outcome="holds"' in toy.page
    text, _, evidence = toy.page.partition('<template id="evidence">')
    assert "A processor" in text and "make rerun" not in text, (
        "no line that a reader without it can't use"
    )
    told = json.loads(evidence.partition("</template>")[0])
    row = "newton-1.4.0/toy.json#/rows/{}".format
    assert told["rows"] == {
        row(index): [case, "the scene as shipped"]
        for index, case in ((0, "soft"), (1, "stiff"))
    }
    gain = [list(told["rows"]).index(row(index)) for index in (0, 1)]
    assert told["derived"]["values.json#/toy/gain"] == [2, *gain]
    record = told["records"]["newton-1.4.0/toy.json"]
    assert record["Release"] == "Newton 1.4.0"
    assert record["Measured"] == "2026-01-02 03:04 UTC, commit abc"
    assert record["Measure again"].startswith("make rerun SECTION=toy")
    line = 1 + MODULE.splitlines().index("def derive(results):")
    assert record["Code"].endswith(f", report/sections/toy.py:{line}")
    values = json.loads((toy.project.site / "data/values.json").read_text())
    assert values["toy"]["gain"]["formula"] == "soft over stiff"
    assert (
        toy.project.site / "data/newton-1.4.0/toy.json"
    ).read_bytes() == toy.record_path.read_bytes()
    assert (toy.project.site / "data/newton-1.4.0/toy.stiff.csv.gz").is_file()


def test_the_headlines_of_all_editions_are_a_page_with_where_they_changed(
    toy, monkeypatch
):
    rules = replace(
        report().settings.changes,
        headlines={"the slip": "toy.soft.slip_mm", "the gain": "toy.gain"},
    )
    told = replace(report().settings, changes=rules)
    monkeypatch.setitem(vars(report()), "settings", told)
    vars(report()).pop("columns", None)
    toy.build()
    assert not (toy.project.site / "compare.html").exists(), "of one edition"
    assert "newest measured" not in toy.front
    for release, slip_mm in (("1.5.0", 6.3617), ("1.6.0", 0.5), ("1.7.0", 0.5)):
        toy.of(release).measure([{**ROWS[0], "slip_mm": slip_mm}, ROWS[1]])
    toy.build()
    page = (toy.project.site / "compare.html").read_text()
    assert check_site(toy.project.site) == [] and 'href="compare.html"' in toy.front
    assert "1.7.0 is the newest measured release" in toy.front
    headlines = page.partition('id="compare-changes')[0]
    assert headlines.count("<data") == 8
    assert headlines.count('<span class="moved better">better</span>') == 1
    assert 'data-src="newton-1.7.0/toy.json#/rows/0/slip_mm">0.5' in headlines


def test_a_page_of_the_report_replaces_the_page_that_compares_releases(
    toy, monkeypatch
):
    settings = report().settings
    own_page = Page("compare", label="Side by side", always=True)
    pages = (*settings.pages, own_page)
    monkeypatch.setitem(vars(report()), "settings", replace(settings, pages=pages))
    vars(report()).pop("columns", None)
    toy.write("templates/pages/compare.md.j2", "# The releases side by side\n")
    toy.of("1.5.0").measure(ROWS)
    toy.build()
    site = toy.project.site
    assert "The releases side by side</h1>" in (site / "compare.html").read_text()
    assert not (site / "data/compare").exists()
    assert check_site(site) == []


def test_a_setting_is_named_in_words_and_further_rows_are_counted(toy, monkeypatch):
    rules = replace(report().settings.changes, keys=["case", "kind"])
    settings = replace(report().settings, changes=rules)
    monkeypatch.setitem(vars(report()), "settings", settings)
    vars(report()).pop("columns", None)
    for release, number in (("1.5.0", 1.0), ("1.6.0", 2.0)):
        cases = ("soft", "stiff", *"abcdef")
        rows = [{**ROWS[0], "case": case, "slip_mm": number} for case in cases]
        option = {"case": "option-cone", "kind": "option", "value": number}
        toy.of(release).measure([*rows, option])
    toy.build()
    page = (toy.project.site / "compare.html").read_text()
    pair = page.partition('id="1.5.0..1.6.0"')[2].partition("</section>")[0]
    assert '<th scope="row">solver option cone <span class="moved">in toy: ' in pair
    assert "; 5 other rows changed too</span>" in pair


def test_a_comparison_is_kept_until_its_numbers_or_sentences_change(toy, monkeypatch):
    for release, slip_mm in (("1.5.0", 6.3617), ("1.6.0", 0.3)):
        toy.of(release).measure([{**ROWS[0], "slip_mm": slip_mm}, ROWS[1]])
    toy.build()
    page = toy.project.site / "compare.html"
    kept = page.read_text()
    assert "It does not." in kept
    compared = []
    compare = compare_module.compare

    def count(before, after):
        compared.append((before.project.release, after.project.release))
        return compare(before, after)

    monkeypatch.setattr(compare_module, "compare", count)
    toy.write("templates/front.md.j2", "# Another title\n")
    toy.build()
    assert not compared and page.read_text().count("</section>") == kept.count(
        "</section>"
    )
    toy.write("templates/sections/toy.md.j2", TEMPLATE.replace("does not.", "cannot."))
    toy.build()
    assert len(compared) == 2 and "It cannot." in page.read_text()
    toy.of("1.6.0").measure([{**ROWS[0], "slip_mm": 0.31}, ROWS[1]])
    compared.clear()
    toy.build()
    assert len(compared) == 3


def test_two_releases_are_compared_as_diff_does(toy, capsys):
    """A slip of 6.36 mm that becomes 0.5 mm changes by 92 %, 9.2 times the threshold of 10 %."""
    for release, slip_mm in (("1.5.0", 6.3617), ("1.6.0", 0.5), ("1.7.0", 0.51)):
        toy.of(release).measure([{**ROWS[0], "slip_mm": slip_mm}, ROWS[1]])
    toy.build()
    site = toy.project.site
    assert check_site(site) == []
    pairs = (site / "compare.html").read_text().partition('<div class="pairs">')[2]
    sections = dict(
        re.findall(r'<section id="([^"]+)"(.*?)</section>', pairs, re.DOTALL)
    )
    releases = ["1.4.0", "1.5.0", "1.6.0", "1.7.0"]
    assert set(sections) == {f"{a}..{b}" for a, b in combinations(releases, 2)}
    shown = {name for name, html in sections.items() if not html.startswith(" hidden")}
    assert shown == {f"{a}..{b}" for a, b in pairwise(releases)}
    assert next(iter(sections)) == "1.6.0..1.7.0", "the newest"
    for name, html in sections.items():
        a, b = name.split("..")
        options = {"a": release_of(a), "b": release_of(b), "format": "json"}
        diff.run(toy.project, SimpleNamespace(**options))
        packed = (site / f"data/compare/{name}.json.gz").read_bytes()
        text = gzip.decompress(packed).decode()
        assert text == capsys.readouterr().out
        told = json.loads(text)
        assert html.count("<tr") - 1 == len(told["flips"]) + len(told["moves"])
        large = [*told["flips"], *told["alarms"], *told["improvements"]]
        assert html.count('<tr class="relevant">') == len(large)
    jump = sections["1.5.0..1.6.0"]
    assert jump.index("flipped") < jump.index('<td class="number">9.2')
    assert 'href="newton-1.5.0/' in jump and 'href="newton-1.6.0/' in jump


def test_text_from_results_is_no_markup(toy):
    evil = '<script>alert(1)</script> *a* `b` "c"'
    toy.measure([{**ROWS[0], "case": evil}, ROWS[1]])
    toy.write(
        "templates/sections/toy.md.j2", TEMPLATE + "\nFirst: {{ rows[0].case }}\n"
    )
    toy.build()
    assert "<script>" not in toy.page
    assert toy.page.count("&lt;script&gt;alert(1)&lt;/script&gt; *a* `b`") == 2
    assert check_site(toy.project.site) == []


def test_where_the_sources_are_known_code_is_linked_and_cloned(toy, monkeypatch):
    monkeypatch.setitem(vars(report()), "sources", "https://git.example/shake")
    toy.build()
    line = 1 + [line.startswith("def derive(") for line in MODULE.splitlines()].index(
        True
    )
    assert (
        f'<a href="https://git.example/shake/blob/HEAD/report/sections/toy.py#L{line}">'
        in toy.page
    )
    assert (
        "git clone https://git.example/shake report &amp;&amp; cd report &amp;&amp; make rerun SECTION=toy"
        in toy.page
    )


def test_a_site_whose_address_is_known_has_a_feed_and_each_page_says_what_it_tells(toy):
    toy.of("1.8.0").measure([{**ROWS[0], "slip_mm": 1.0}, ROWS[1]])
    build(toy.project, "https://site.example/")
    feed = ElementTree.parse(toy.project.site / "feed.xml").getroot()
    links = [link.get("href") for link in feed.iterfind("{*}entry/{*}link")]
    assert links == [
        "https://site.example/newton-1.8.0/index.html",
        "https://site.example/index.html",
    ]
    assert (
        'type="application/atom+xml" href="https://site.example/feed.xml"' in toy.front
    )
    body = Markup('<p class="left-out">no</p>\n<p>It <b>leans</b>.</p><p>b</p>')
    prose = Prose(Markup(""), body, [], "a", [])
    assert prose.summary.striptags() == "It leans."


def test_links_to_no_page_are_named(toy):
    links = "[a](nowhere.html) [b](#toy) [c](#nothing) [d](cause.html#toy)"
    toy.write("templates/front.md.j2", f"# A report\n\n{links}\n")
    assert [note for note in build(toy.project)[1] if "exist" in note] == [
        "index.html: nowhere.html does not exist",
        "index.html: #nothing does not exist",
    ]


def test_faults_of_html_are_named(toy):
    lines = ["![](robot.png) ![a robot](robot.png)", "<div>", "<i>a", "\u202eb</div>"]
    (toy.project.root / "static").mkdir()
    (toy.project.root / "static/robot.png").write_bytes(b"\x89PNG")
    text = "\n\n".join(lines).replace("robot.png", "static/robot.png")
    toy.write("templates/front.md.j2", f"# A report\n\n{text}\n")
    assert [note for note in build(toy.project)[1] if "index.html: " in note] == [
        "index.html: contains the character U+202E, which cannot be printed",
        "index.html: the picture static/robot.png has no text for readers who cannot "
        "see it: add one",
        "index.html: <i> is not closed",
    ]


@pytest.mark.parametrize(
    ("text", "part"),
    [
        ("It slips { slip }.", "{ slip }"),
        ("Rods <!-- are long.", "<!--"),
        ("```python\nx = y", "`"),
        ("It slips `far.", "`"),
        ("| a | b |\n|---|\n| x | y |", "|---"),
    ],
)
def test_broken_markup_is_named(toy, text, part):
    code = "`{ slip } <!-- |---`"
    toy.write("templates/front.md.j2", f"# A report\n\n{code}\n\n{text}\n")
    note = f"index.html: prints {part}, which looks like broken markup"
    assert note in build(toy.project)[1]
    toy.write("templates/front.md.j2", f"# A report\n\n{code}\n")
    assert note not in build(toy.project)[1]


def test_results_that_a_table_or_a_figure_lacks_are_named_one_by_one(toy):
    module = MODULE.replace("[trace],", "[trace, results.trace('soft')],")
    toy.write(
        "report/sections/toy.py",
        module.replace(
            "row in rows]}", "row in [*rows, results.row['x']]]}", 1
        ).replace("index=[row.case for row in rows]", "index=['soft', 'stiff', 'x']"),
    )
    assert [note for note in build(toy.project)[1] if "lacks" in note] == [
        "toy: figure way lacks a source: there is no toy.soft.csv.gz",
        "toy: table cases lacks a number: there is no single row of case x",
    ]


def test_columns_and_repeats_that_may_be_mistakes_are_named(toy):
    units = {"mass_g": 1.0, "speed_km_s": 2.0, "rate_per_ms": 3.0, "top_k": 1.0}
    rows = [{**row, **units, "substeps": 4} for row in ROWS]
    for count, case in ((4, "soft"), (8, "soft"), (4, "sof")):
        rows.append({**rows[0], "case": f"{case}-{count}", "of": case})
        rows[-1]["substeps"] = count
    toy.measure(rows)
    notes = build(toy.project)[1]
    for note in (
        "toy: column mass_g has no unit: add g to units in report.toml, or rename the "
        "column",
        "toy: column speed_km_s has the unit s: add km_s to units in report.toml, or "
        "rename the column",
        "toy: substeps of soft is 4, and that of a repeat is 8: repeat a case with its "
        "own settings",
        "results/newton-1.4.0 has no edition.toml, so a lost record would not be "
        "noticed: restore it or measure a section again",
    ):
        assert note in notes
    assert not [note for note in notes if "rate_per_ms" in note or "top_k" in note]


def test_a_repeat_of_no_case_is_named_in_the_section_on_noise(toy, monkeypatch):
    settings = replace(report().settings, noise_section="toy")
    monkeypatch.setitem(vars(report()), "settings", settings)
    vars(report()).pop("columns", None)
    for case in ("soft", "sof"):
        repeats = [{**ROWS[0], "case": f"again-{n}", "of": case} for n in range(2)]
        toy.measure([*ROWS, *repeats])
        is_named = [f"repeats {case}," in note for note in build(toy.project)[1]]
        assert any(is_named) == (case == "sof")


@pytest.mark.parametrize(
    "code",
    [
        "import random\nrandom.random()",
        "from random import uniform as draw_one\ndraw_one(0, 1)",
        "import numpy as np\nnp.random.default_rng()",
        "from datetime import datetime\ndatetime.now()",
        "import numpy as np\nnp.loadtxt('assets/curve.csv')",
        "import csv\ncsv.DictReader([])",
        "from pandas import read_csv\nread_csv('assets/curve.csv')",
    ],
)
def test_a_section_whose_numbers_have_no_record_is_refused(toy, code):
    seeded = "import numpy as np\nnp.random.default_rng(1).normal()"
    toy.write("report/sections/toy.py", f"{seeded}\n{MODULE}")
    toy.build()
    toy.write("report/sections/toy.py", f"{code}\n{MODULE}")
    with pytest.raises(ReportError, match=r"toy\.py:2 uses numbers without"):
        toy.build()


def test_a_package_that_is_not_installed_is_named(toy, monkeypatch):
    settings = report().settings
    packages = [*settings.packages, "nmpy"]
    changed = replace(settings, packages=packages)
    monkeypatch.setitem(vars(report()), "settings", changed)
    vars(report()).pop("columns", None)
    notes = build(toy.project)[1]
    assert [note for note in notes if "installed" in note] == [
        "report.toml: packages names nmpy, which is not installed: correct the name"
    ]


def test_a_section_whose_name_is_not_ascii_is_refused(toy):
    toy.write("report/sections/größe.py", MODULE)
    with pytest.raises(ReportError, match=r"größe.py has an invalid name: use a Pyth"):
        toy.build()


def test_a_trace_of_no_case_is_named(toy):
    table = {"time_s": [0.0, 1.0], "x_mm": [0.0, 0.3]}
    cases = ("stiff", "stif", "so")
    traces = {case: packed(toy.record_path, case, table) for case in cases}
    write_record(
        toy.record_path, toy.record([*ROWS, {**ROWS[0], "case": "so-1"}]), traces
    )
    assert [note for note in build(toy.project)[1] if "is a trace" in note] == [
        "newton-1.4.0/toy.stif.csv.gz is a trace of stif, which is not a case of toy: "
        "correct its name in measure"
    ]


def test_sections_without_an_order_follow_by_name_and_equal_orders_are_refused(toy):
    for name in ("b", "a"):
        module = MODULE.replace(
            "order = 1\n", "reads = ('a',)\n" if name == "b" else ""
        )
        toy.write(f"report/sections/{name}.py", module)
        toy.write(f"experiments/{name}.py", EXPERIMENT)
        toy.write(f"templates/sections/{name}.md.j2", TEMPLATE)
        record = replace(
            toy.record(),
            section=name,
            identity=identity_of(name, "full", toy.project.root, toy.packages),
        )
        write_record(toy.project.record_path(name), record)
    assert [*derived(toy.project).chapters] == ["toy", "a", "b"]
    toy.write("report/sections/b.py", MODULE)
    with pytest.raises(ReportError, match=r"b.py and .*toy.py both have the order 1"):
        toy.build()


def test_results_that_nothing_reads_are_named(toy):
    """Test a renamed section and a misspelt folder."""
    toy.build()
    results = toy.project.results
    shutil.copy(toy.record_path, results / "toyy.json")
    shutil.copytree(results, results.with_name("newtn-1.4.0"))
    shutil.copy(results / "toy.stiff.csv.gz", results / "toy.soft.csv.gz")
    _, notes = build(toy.project)
    strays = [note for note in notes if note.endswith("remove it")]
    assert strays == [
        "results/newtn-1.4.0 is not an edition: rename or remove it",
        "newton-1.4.0/toyy.json does not belong to a section: rename or remove it",
        "newton-1.4.0/toy.soft.csv.gz is not a trace of toy: remove it",
    ]


@pytest.mark.parametrize("text", ["5.3 mm", "about 7 m/s", "to 12\xa0%"])
def test_a_table_prints_no_typed_number_with_a_unit(text):
    frame = pd.DataFrame({"note": [text, "3 substeps, ke 250"]})
    with pytest.raises(ResultsError, match="in a table does not have a source"):
        Table(frame).rendered()
    assert Table(frame[1:]).rendered()


END = "{% endtable %}\n"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (END, END + "{{ nothing }}", "nothing"),
        (
            END,
            END + '{{ claim("nothing") }}',
            r"templates/sections/toy.md.j2:\d+: toy does not have a claim 'nothing': use one of",
        ),
        (
            END,
            END + '{{ row["stiff"].slip_mm + 1 }}',
            r"templates/sections/toy.md.j2:\d+: 0.31 mm and 1 do not have the same unit",
        ),
        (
            "{{ gain }}",
            "{{ gain|nothing }}",
            r"templates/sections/toy.md.j2:\d+: No filter named 'nothing'",
        ),
        (END, END + "{{ 3.5 }}", "does not have a source: use a Quantity"),
        (END, END + "{% if %}", "templates/sections/toy.md.j2"),
        (
            END,
            END + "It slips\n6.36 mm.",
            r"templates/sections/toy.md.j2:\d+: 6.36 mm is hard-coded",
        ),
        *(
            (END, f"{END}It is {number} so.", f"{number} is hard-coded")
            for number in ("37 %", "3.7 times", "2 m/s", "5 kg/m³")
        ),
        (
            "It does not.",
            "It does not, by {{ 3.5 }}.",
            r"toy.md.j2:\d+: it prints 3.5, which does not have a source",
        ),
        (
            END,
            END
            + '{% passage needs="toy.helps fails" %} By {{ 3.5 }}. {% endpassage %}',
            "prints 3.5, which",
        ),
        ("order = 1", "order = 'x'", "toy.py: order must be a number such as 125"),
        (
            "order = 1",
            "order = 1\npage = 'x'",
            "toy.py names the page 'x': use one of cause",
        ),
        (
            "order = 1",
            "order = 1\nreads = ('no',)",
            "toy.py reads 'no', which is not a section: correct the name",
        ),
        (
            "order = 1",
            "order = 1\nreads = 'toy'",
            "toy.py: reads must be a tuple",
        ),
        (
            "order = 1",
            "order = 1\nreads = ('toy',)",
            "toy.py reads toy, which comes after it",
        ),
        ("order = 1", "order = 1\nlabel = 3", "toy.py: label must be a text"),
        (
            END,
            END + "{# x",
            r"^templates/sections/toy.md.j2:\d+: Missing end of comment tag",
        ),
        ("order = 1", "order = 1\nlabels = ['soft']", "toy.py: labels must be a dict"),
        (
            "order = 1",
            "order = 1\nlabels = dict(soft='x')",
            "toy.py: labels must be a dict, .* as a literal",
        ),
        ("order = 1", "order = (", "report/sections/toy.py cannot be read or parsed: "),
        (
            "order = 1",
            "order = 1\nimport nothing",
            r"report/sections/toy.py:8: .*No module named 'nothing'",
        ),
        ("def derive", "def other", r"toy.py has no function derive\(results\)"),
        (
            "return Section",
            "Section",
            "toy.py: derive returns a NoneType: return a Section",
        ),
    ],
)
def test_a_wrong_template_or_section_stops_the_build_in_one_line_and_keeps_the_site(
    built, old, new, message
):
    before = built.page
    built.write("templates/sections/toy.md.j2", TEMPLATE.replace(old, new))
    built.write("report/sections/toy.py", MODULE.replace(old, new))
    with pytest.raises(ReportError, match=message) as error:
        built.build()
    assert "\n" not in str(error.value)
    assert built.page == before


CLAIM = 'claims=[Claim("helps", at_least(gain, bound), {"gain": gain})]'


@pytest.mark.parametrize(
    ("change", "said"),
    [
        (
            (CLAIM, f"{CLAIM}[: len(rows) - 1]"),
            "The claim helps is left out here: it cannot be derived from the record "
            "of this edition. Run make rerun SECTION=toy NEWTON=1.8.0 to measure it again.",
        ),
        (
            ("trace = ", "rows = results.rows[1].case\n    trace = "),
            "IndexError: list index out of range). "
            "<code>make rerun SECTION=toy NEWTON=1.8.0</code> measures it.",
        ),
    ],
)
def test_what_one_edition_cannot_derive_costs_itself_and_names_its_command(
    toy, change, said
):
    toy.write("report/sections/toy.py", MODULE.replace(*change))
    toy.of("1.8.0").measure(ROWS[1:])
    toy.build()
    pages = (toy.project.site / "newton-1.8.0").glob("*.html")
    assert said in "".join(page.read_text() for page in pages)
    assert 'data-claim="toy.helps" data-outcome="holds"' in toy.page


FIGURE = (
    'figures={"way": Figure(lambda: draw(trace), [trace], {"slip": stiff.slip_mm})}'
)


@pytest.mark.parametrize(
    ("old", "new", "said"),
    [
        ("at_least(gain, bound)", "True", "the outcome of helps is True: use a test"),
        ("at_least(gain, bound)", "gain > bound", "compared by a test that considers"),
        ("[trace], {", "[stiff.slip_mm.number], {", "a source of a figure is not a"),
        (FIGURE, "figures={'way': draw}", "something other than a Figure: use Figure"),
        ("lambda: 10.0", "10.0", "bound = 10.0 was not measured: use results.chosen"),
    ],
)
def test_a_part_of_the_wrong_type_is_named_with_its_line(toy, old, new, said):
    assert old in MODULE
    toy.write("report/sections/toy.py", MODULE.replace(old, new))
    states, _ = build(toy.project)
    [state] = states[toy.project.release]
    assert re.search(rf"report/sections/toy.py:\d+: .*{said}", state.words)


@pytest.mark.parametrize("body", ["return None", "return new_figure()[0]"])
def test_a_figure_without_data_stops_the_build(toy, body):
    module = MODULE.replace("def draw(trace):", f"def draw(trace):\n    {body}")
    toy.write("report/sections/toy.py", module)
    with pytest.raises(ReportError, match=r"toy-way cannot be drawn: .* with data"):
        toy.build()


@pytest.mark.parametrize(
    ("line", "said"),
    [
        ("raise OSError('no ink')", "report/sections/toy.py:12: OSError: no ink"),
        ("1 / 0", "report/sections/toy.py:12: ZeroDivisionError: division by zero"),
    ],
)
def test_a_figure_that_throws_where_all_of_it_is_there_stops_the_build_and_nothing_is_left_behind(
    built, line, said
):
    before = built.page
    built.write("report/sections/toy.py", MODULE.replace("axes.legend()", line))
    with pytest.raises(
        ReportError, match=f"the figure toy-way cannot be drawn: .*{said}"
    ):
        built.build()
    assert built.page == before
    assert not list(built.project.root.glob(".site-*"))


def test_a_name_that_is_no_utf_8_stops_no_build(toy):
    for folder in ("templates", "results", "results/newton-1.4.0", "assets"):
        (toy.project.root / folder / os.fsdecode(b"\xff.json")).write_text("x")
    toy.build()
    assert check_site(toy.project.site) == []


def test_a_stale_section_is_shown_with_what_changed_and_left_out_where_it_no_longer_fits(
    toy,
):
    toy.write("assets/robot.urdf", "<robot name='other'/>")
    toy.build()
    assert (
        "config: assets/robot.urdf" in toy.page
        and "measures the section again" in toy.page
    )
    assert check_site(toy.project.site) == []
    toy.write("templates/sections/toy.md.j2", TEMPLATE + '{{ row["stiff"].new_mm }}')
    for change in (
        lambda: toy.write("experiments/scene.py", "def slip():\n    return 2\n"),
        toy.measure,
    ):
        change()
        toy.build()
        assert 'id="toy"' not in toy.page
        assert re.search(
            r"toy.json: templates/sections/toy.md.j2:\d+: toy: stiff has no column new_mm",
            toy.page,
        )


@pytest.mark.parametrize(
    "spoil",
    [lambda path: path.unlink(), lambda path: path.write_text('{"schema": 1, "rows"')],
)
def test_a_section_without_a_whole_record_is_one_line(toy, spoil):
    spoil(toy.record_path)
    toy.build()
    assert 'id="toy"' not in toy.page
    assert "<b>toy</b>" in toy.page
    assert "<code>make rerun SECTION=toy</code>" in toy.page


def test_a_figure_links_only_the_data_that_is_there_and_is_one_line_without(toy):
    toy.write(
        "report/sections/toy.py",
        MODULE.replace("[trace])}", '[trace, results.trace("soft")])}'),
    )
    toy.build()
    assert "<picture" in toy.page and check_site(toy.project.site) == []
    toy.write("report/sections/toy.py", MODULE)
    write_record(toy.record_path, toy.record(), {})
    toy.build()
    assert "A figure is left out here: there is no toy.stiff.csv.gz" in toy.page
    assert "<picture" not in toy.page
    assert str(toy.project.root) not in toy.page
    assert check_site(toy.project.site) == []


def test_the_site_carries_what_a_section_offers(toy):
    module = MODULE.replace("claims=[", 'downloads={"a.py": "1 < 2\\n"}, claims=[')
    toy.write("report/sections/toy.py", module)
    words = '\nThe file is {{ download("a.py") }}.\n'
    toy.write("templates/sections/toy.md.j2", TEMPLATE + words)
    toy.build()
    assert (toy.project.site / "download" / "a.py").read_text() == "1 < 2\n"
    assert '<a href="download/a.py" download>a.py</a>' in toy.page
    assert check_site(toy.project.site) == []


def test_finding_8_no_text_of_a_table_is_a_formula():
    rows = [
        {"case": "=1+1", "said": "-x", "slip_mm": -1.5},
        {"case": "@a", "said": "-1.5", "slip_mm": None},
    ]
    rows += [{"case": "＝1+1", "said": "\n=1+1", "slip_mm": 1.0}]
    assert rows_csv(rows).split("\n", 3)[1:] == [
        "'=1+1,'-x,-1.5",
        "'@a,'-1.5,",
        "'＝1+1,\"'\n=1+1\",1.0\n",
    ]
