"""Names of cases for people: every case has one, and its code name stays with it."""

import re
from collections import Counter
from collections.abc import Iterable

import pytest

from measured_report.deriving.sections import outline_of
from measured_report.editions.project import Project, own_release
from measured_report.records.identity import sections
from measured_report.records.reading import load_record
from report.names import case_html, cases_html, listed, name_of, number_of

pytestmark = pytest.mark.words
CODE = re.compile(r"[a-z]-|_|[/:]|\d(mm|cm|hz|kg|s)\b|\de[+\d]")
"""What gives away a name that was made for programs."""
NO_CASES = re.compile(r"(option|default|sum|audit|as-shipped|fixed)-\w+|.*-batch-\d+|map")
"""Rows that are no runs, or of which only their number is shown."""


def unfit(names: Iterable[str]) -> list[str]:
    """Those that were made for programs, and those that two have."""
    return [name for name, count in Counter(names).items() if count > 1 or CODE.search(name)]


@pytest.mark.parametrize(
    ("case", "name"),
    [
        ("as-shipped", "shipped pads"),
        ("untrimmed", "exactly as shipped"),
        ("stiff-pads", "stiff pads"),
        ("substeps-64", "substeps 64"),
        ("gravity--9.81", "gravity upward"),
        ("pad-mu-0.2", "pads' friction 0.2"),
        ("hold-60s-stiff", "arm held still, 60 s, stiff pads"),
        ("as-shipped-mujoco-c-noslip", "shipped pads, MuJoCo C, noslip"),
        ("ke-kd-100-4.64e+04-4", "pads' ke 46400, kd 100, 4 substeps"),
        ("as-shipped/newton/iterations-1", "shipped pads, Newton's contacts, 1 iteration"),
        ("density-500", "density 500"),
    ],
)
def test_a_case_has_a_name_for_people(case, name):
    assert name_of(case) == name


def test_the_code_name_stays_with_it_and_numbers_are_as_on_the_page():
    for text, shown in {"0.2": "0.2", "8e3": "8000", "2.5e6": "2.5×10⁶", "1e-10": "10⁻¹⁰", "64": "64"}.items():
        assert number_of(text) == shown
    assert case_html("stiff-pads") == '<span class="case" title="stiff-pads">stiff pads</span>'
    assert cases_html([]) == "none"


def test_every_case_of_the_tracked_results_has_one():
    project = Project(own_release())
    for release in project.releases:
        for section in sections():
            path = project.of(release).record_path(section)
            rows = load_record(path).rows if path.is_file() else []
            cases = {row["case"] for row in rows if not NO_CASES.fullmatch(row["case"])}
            assert unfit(map(name_of, cases)) == [], section


def test_every_section_has_one_or_is_called_as_its_file(toy):
    assert unfit(outline_of(section).label for section in sections()) == []
    toy.write("report/sections/how_heavy.py", "order = 1\n\n\ndef derive(results):\n    pass\n")
    assert outline_of("how_heavy").label == "how heavy"
    toy.write("report/sections/how_heavy.py", 'order = 1\nlabel = "weight"\n\n\ndef derive(results):\n    pass\n')
    assert outline_of("how_heavy").label == "weight"


def test_a_sentence_lists_names_with_an_and_before_the_last():
    assert [listed(list("abc")[:count]) for count in range(4)] == ["", "a", "a and b", "a, b and c"]
