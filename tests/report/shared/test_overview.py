"""The overview at the head of the page: which runs it shows, and what it does without some of them."""

import pytest

from measured_report.site.check import check_site
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results
from report.shared.overview import _label, _mark, lines_of, overview

pytestmark = pytest.mark.words
WHOLE = {"drift_mm_s": 0.5, "failure": None}
"""What a run of the whole task says beside its slip."""
SHAKE = {"shake_amplitude_m": 0.03, "shake_frequency_hz": 1.0, "shake_duration_s": 11.4, "dropped": False, **WHOLE}
LOST = {"slip_mm": None, "slip_mm_reason": "a body's pose is not finite", "dropped": None}
SHIPPED = {"case": "as-shipped", "slip_mm": 6.36, **SHAKE}
TEMPLATE = """# The story

{% if overview %}
{% figure overview %} All. {% alt %} {{ runs }} runs. {% endfigure %}
{% endif %}
"""


@pytest.fixture
def results(toy):
    """Results of the toy section with the rows that are given."""
    return lambda rows: Results(toy.record(rows), toy.record_path, label="a toy")


def lines(results: Results):
    return lines_of({"toy": results}, results.rows[0])


NOISE = Quantity(0.007, "mm", "")


@pytest.mark.parametrize(
    ("slip_mm", "effect"),
    [(6.354, ": no effect"), (6.3, ": hardly any effect"), (5.9, ": little effect"), (5.5, ""), (7.1, "")],
)
def test_a_section_that_does_little_says_how_little(results, slip_mm, effect):
    (line,) = lines(results([SHIPPED, SHIPPED | {"case": "pad-mu-0.2", "slip_mm": slip_mm}]))
    assert line.does_little == bool(effect)
    assert _label(line, NOISE) == f"a toy\n2 runs{effect}"
    assert effect != ": no effect" or _label(line, None).endswith(": hardly any effect"), "without a known noise"


def test_the_farthest_run_is_named_as_shortly_as_can_be_and_only_what_compares_counts(results):
    slips = {"pad-ke-2.5e6": 0.311, "pad-ke-2.5e5": 0.312, "pad-ke-2.5e4": 1.87, "pad-ke-100": 12.0}
    (line,) = lines(results([SHIPPED, *(SHIPPED | {"case": case, "slip_mm": slip} for case, slip in slips.items())]))
    assert line.farthest.case == "pad-ke-2.5e5"
    stiff = [SHIPPED | {"case": case, "slip_mm": 0.31} for case in ("stiff-pads", "stiff-pads-noslip")]
    (line,) = lines(results([SHIPPED, SHIPPED | {"case": "as-shipped-noslip"}, *stiff]))
    assert line.farthest is None and line.does_little
    (line,) = lines(results([SHIPPED, *stiff]))
    assert line.farthest is None and not line.does_little  # nothing was tried
    assert lines(results([SHIPPED | {"slip_mm": None, "slip_mm_reason": "it fell"}])) == []
    (line,) = lines(results([SHIPPED, SHIPPED | {"case": "long", "slip_mm": 60.0, "shake_duration_s": 600.0}]))
    assert line.farthest is None and not line.does_little
    parts = [{"case": "missing-term", "slip_mm": 2.2}, {"case": "from-the-shake-on", "slip_mm": 6.3, "failure": None}]
    (line,) = lines(results([SHIPPED, *parts, {"case": "map", "wall_s": 1.0}]))
    assert [row.case for row in line.rows] == ["as-shipped"]
    assert overview({}) is None
    assert overview({"toy": results([{"case": "stiff", "slip_mm": 0.3, **WHOLE}])}) is None


@pytest.mark.parametrize(
    ("change", "mark"),
    [
        ({"shake_duration_s": 11.5}, "the baseline's shake"),
        ({"shake_duration_s": 600.0}, "another shake or duration"),
        ({"shake_amplitude_m": 0.06}, "another shake or duration"),
        ({"dropped": True}, "dropped"),
    ],
)
def test_a_mark_says_whether_the_shake_is_the_baseline_s(results, change, mark):
    baseline, run = results([SHIPPED, SHIPPED | {"case": "run"} | change]).rows
    assert _mark(run, baseline) == mark


def test_the_page_has_it_when_there_are_runs_to_show(toy):
    toy.write("templates/front.md.j2", TEMPLATE)
    others = [{"case": "soft", "slip_mm": 6.0, **WHOLE}, {"case": "stiff", "slip_mm": 300.0, **SHAKE, "dropped": True}]
    toy.measure([*others, SHIPPED, {"case": "broken", **SHAKE, **LOST}])
    toy.build()
    assert check_site(toy.project.site) == []
    assert '<figure id="front-overview">' in toy.front
    assert "1 without result" in toy.front
    toy.measure()
    toy.build()
    assert "front-overview" not in toy.front
