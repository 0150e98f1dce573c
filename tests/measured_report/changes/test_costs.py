"""Whether what was timed was alone on its host."""

from dataclasses import replace
from datetime import datetime

from measured_report.changes.costs import beside, is_timed
from measured_report.files.root import ROOT
from measured_report.records.reading import load_record
from measured_report.records.record import Record

SPEED = load_record(ROOT / "results/newton-1.4.0/speed.json")


def measured(started: str, ended: str, host: str = "here", pause: float = 0.0) -> Record:
    first, last = (f"2026-11-23T{time}:00+00:00" for time in (started, ended))
    seconds = (datetime.fromisoformat(last) - datetime.fromisoformat(first)).total_seconds() - pause
    times = {"date": last, "started": first, "ended": last, "seconds": seconds}
    return replace(SPEED, machine={"host": host}, measured=times)


def test_what_ran_at_the_same_time_on_the_same_host_is_found():
    timed = measured("00:10", "00:20")
    others = {
        "before": measured("00:00", "00:10"),
        "into": measured("00:05", "00:11"),
        "within": measured("00:12", "00:13"),
        "after": measured("00:20", "00:30"),
        "elsewhere": measured("00:12", "00:13", host="there"),
        "unknown": measured("00:12", "00:13", host=""),
    }
    assert beside(timed, [timed, *others.values()]) == [others["into"], others["within"]]
    assert beside(others["unknown"], others.values()) == []


def test_two_that_may_have_taken_turns_were_not_beside_each_other():
    timed, other = measured("00:10", "00:20"), measured("00:00", "00:30", pause=601.0)
    assert beside(timed, [other]) == []
    assert beside(timed, [measured("00:00", "00:30", pause=500.0)]) != []


def test_what_was_timed_alone_was_beside_nothing():
    """Its batches that are not timed ran at once, and beside those of others, for longer than it took."""
    timed, other = measured("00:10", "00:20", pause=-300.0), measured("00:00", "00:30")
    assert beside(timed, [other]) == [other]
    parts = {"batch_points_s": 840.0, "alone_times_s": 60.0}
    timed = replace(timed, measured=timed.measured | parts)
    assert beside(timed, [other]) == [other]  # which never paused
    turns = replace(other, measured=other.measured | {"seconds": 1700.0})
    assert beside(timed, [turns]) == []


def test_a_record_without_its_start_took_so_many_seconds():
    other = replace(measured("00:00", "00:11"), measured={"date": "2026-11-23T00:11:00+00:00", "seconds": 70.0})
    assert other.span[0].minute == 9 and other.span[0].second == 50
    assert beside(measured("00:08", "00:10"), [other]) == [other]


def test_times_make_a_record_timed():
    assert is_timed(SPEED)
    assert not is_timed(load_record(ROOT / "results/newton-1.4.0/noise.json"))
