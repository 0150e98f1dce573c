"""Test the numbers of a row as templates and sections read them."""

from dataclasses import replace

from toys import ROWS, derived

from measured_report.files.config import report
from measured_report.files.settings import Columns

SOFT, STIFF = ROWS


def test_a_number_without_meaning_has_its_reason(toy, monkeypatch):
    trials = Columns(trials="try_count", names=["hit_count"])
    settings = replace(report().settings, columns=[*report().settings.columns, trials])
    monkeypatch.setitem(vars(report()), "settings", settings)
    vars(report()).pop("columns", None)
    absent = {"slip_mm": None, "slip_mm_reason": "not measured"}
    toy.measure(
        [
            {**SOFT, "dropped": True},
            {**STIFF, "try_count": 4, "hit_count": 5},
            {**SOFT, "case": "absent", **absent},
        ]
    )
    rows = derived(toy.project).chapters["toy"].results.row
    assert rows["soft"].slip_mm.reason == "soft: lost"
    assert rows["stiff"].hit_count.reason == (
        "stiff: stiff has hit_count 5, with try_count 4"
    )
    assert rows["absent"].slip_mm.reason == "absent: not measured"
    assert rows["stiff"].slip_mm.value == STIFF["slip_mm"]
    vars(report()).pop("columns", None)
