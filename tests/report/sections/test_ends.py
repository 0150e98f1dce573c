"""When times of two releases are compared."""

from dataclasses import replace
from types import SimpleNamespace

from measured_report.files.root import ROOT
from measured_report.records.record import load_record
from report.sections.upgrade.ends import machines_differ

SPEED = load_record(ROOT / "results/newton-1.4.0/speed.json")


def timed(minute: int, **machine: str) -> SimpleNamespace:
    """A section that took the minute before this one."""
    end = f"2026-11-23T00:{minute:02}:00+00:00"
    measured = {"date": end, "ended": end, "started": f"2026-11-23T00:{minute - 1:02}:00+00:00", "seconds": 60.0}
    record = replace(SPEED, measured=measured, machine={**SPEED.machine, "host": "here", **machine})
    return SimpleNamespace(results=SimpleNamespace(record=record))


def test_times_compare_where_both_were_measured_alone_on_machines_of_one_kind():
    releases = {"1.4.0": {"speed": timed(10)}, "1.8.0": {"speed": timed(20)}}
    assert machines_differ(releases, "speed") is None
    shared = {**releases, "1.8.0": {"speed": timed(20), "cure": timed(20)}}
    assert (
        machines_differ(shared, "speed").reason
        == "other sections ran on the same host while it was timed in Newton 1.8.0"
    )
    others = {**releases, "1.8.0": {"speed": timed(20), "cure": timed(20, host="there")}}
    assert machines_differ(others, "speed") is None
    older = {**releases, "1.8.0": {"speed": timed(20, driver="1")}}
    assert "measured on" in machines_differ(older, "speed").reason
    between = {"1.4.0": releases["1.4.0"], "1.5.0": {"speed": timed(15), "cure": timed(15)}, "1.8.0": releases["1.8.0"]}
    assert machines_differ(between, "speed") is None
