"""Error against run time: which settings none beats, and from how many worlds on Warp is ahead."""

from dataclasses import replace

from measured_report.files.root import ROOT
from measured_report.records.columns import units_of
from measured_report.records.record import load_record
from measured_report.values.results import Results
from report.sections.error_runtime.runs import ERROR, TIME, front

PATH = ROOT / "results/newton-1.4.0/error_runtime.json"


def test_a_front_has_the_settings_that_no_other_of_their_kind_beats():
    cells = [(1.0, 9.0, "c"), (2.0, 5.0, "c"), (3.0, 5.0, "c"), (2.0, 5.0, "c"), (4.0, 1.0, "c"), (1.0, 10.0, "c")]
    cells += [(4.0, 4.0, "warp")]
    rows = [{"case": str(n), ERROR: e, TIME: t, "backend": backend} for n, (e, t, backend) in enumerate(cells)]
    results = Results(replace(load_record(PATH), rows=rows, units=units_of(rows)), PATH)
    assert front(results.rows) == {"0", "1", "3", "4"}
    assert front(results.rows, "backend") == {"0", "1", "3", "4", "6"}
    assert front([]) == frozenset()
