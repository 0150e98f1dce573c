"""Altered records: whatever is in one, the pages have no number that it has not, and what can't be shown is named."""

import json
from argparse import Namespace

from alterations import altered
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from measured_report.commands import page
from measured_report.editions.stack import stack_of
from measured_report.site.check import check_site

ROWS = [
    {"case": "soft", "slip_mm": 6.3617, "dropped": False, "run_count": 3, "note": "as 1 of 2"},
    {"case": "stiff", "slip_mm": 0.3124, "dropped": False, "run_count": 3, "note": "as 2 of 2"},
    {"case": "off", "slip_mm": None, "slip_mm_reason": "it fell", "dropped": True, "run_count": 2, "note": None},
]


@settings(max_examples=12, suppress_health_check=[HealthCheck.function_scoped_fixture])
@given(chance=st.randoms(use_true_random=False))
def test_an_altered_record_is_shown_as_it_is_or_named_in_one_line(toy, capsys, chance):
    toy.measure(ROWS)
    words, record = altered(json.loads(toy.record_path.read_text()), chance)
    toy.record_path.write_text(json.dumps(record))
    capsys.readouterr()
    status = page.run(toy.project, Namespace(stack=stack_of("1.4.0"), address=""))
    lines = capsys.readouterr().err.splitlines()
    shown = toy.project.site / "data/newton-1.4.0/toy.json"
    assert shown.is_file() != bool(lines), words
    assert not shown.is_file() or shown.read_bytes() == toy.record_path.read_bytes(), words
    assert status == len(lines) and all("newton-1.4.0/toy.json" in line for line in lines), words
    assert [each for each in check_site(toy.project.site) if "no claim" not in each] == [], words
