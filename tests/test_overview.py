"""The overview at the head of the page: which runs it shows, and what it does without some of them."""

import pytest

from report.check import check_site
from report.overview import _lines, _mark, overview
from report.results import Results

WHOLE = {"drift_mm_s": 0.5, "failure": None}
"""What a run of the whole task says beside its slip."""
SHAKE = {
    "shake_amplitude_m": 0.03,
    "shake_frequency_hz": 1.0,
    "shake_duration_s": 11.4,
    "dropped": False,
    **WHOLE,
}
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
    return lambda rows: Results(toy.record(rows), toy.record_path)


def labels(results: Results) -> list[str]:
    return [line.label for line in _lines("toy", results)]


def test_a_long_series_shares_a_line(results):
    sweep = [{"case": f"sweep-ke-{10.0**power:.3g}", "slip_mm": 1.0, **WHOLE} for power in range(9)]
    few = [{"case": f"pad-mu-{mu:g}", "slip_mm": 1.0, **WHOLE} for mu in (0.2, 10)]
    assert labels(results([SHIPPED, *sweep, *few])) == ["as-shipped", "sweep-ke-… (9)", "pad-mu-0.2", "pad-mu-10"]


def test_rows_of_one_case_share_a_line_and_those_without_a_slip_have_none(results):
    assert labels(results([SHIPPED, SHIPPED, {"case": "map", "wall_s": 1.0}])) == ["as-shipped (2)"]


def test_a_look_at_a_part_of_a_run_has_none(results):
    parts = [{"case": "missing-term", "slip_mm": 2.2}, {"case": "from-the-shake-on", "slip_mm": 6.3, "failure": None}]
    assert labels(results([SHIPPED, *parts])) == ["as-shipped"]


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


def test_there_is_none_without_a_baseline(results):
    assert overview({}) is None
    assert overview({"toy": results([{"case": "stiff", "slip_mm": 0.3, **WHOLE}])}) is None


def test_the_page_has_it_when_there_are_runs_to_show(toy):
    toy.write("templates/story.md.j2", TEMPLATE)
    others = [
        {"case": "soft", "slip_mm": 6.0, **WHOLE},
        {"case": "stiff", "slip_mm": 300.0, **SHAKE, "dropped": True},
    ]
    toy.measure([*others, SHIPPED, {"case": "broken", **SHAKE, **LOST}])
    toy.build()
    assert check_site(toy.project.site) == []
    assert '<figure id="story-overview">' in toy.front
    assert "1 without result" in toy.front
    toy.measure()
    toy.build()
    assert "story-overview" not in toy.front
