"""Test which times of two releases are compared."""

from dataclasses import replace
from types import SimpleNamespace

from measured_report.files.root import ROOT
from measured_report.records.record import load_record
from report.sections.upgrade.ends import machines_differ

SPEED = load_record(ROOT / "results/newton-1.4.0/speed.json")


def test_times_compare_where_both_were_measured_on_machines_of_one_kind():
    def timed(**machine: str) -> dict[str, SimpleNamespace]:
        record = replace(SPEED, machine={**SPEED.machine, **machine})
        return {"speed": SimpleNamespace(results=SimpleNamespace(record=record))}

    assert (
        machines_differ(
            {
                "1.4.0": timed(),
                "1.5.0": timed(driver="1"),
                "1.8.0": timed(host="there"),
            },
            "speed",
        )
        is None
    )
    assert (
        "measured on"
        in machines_differ(
            {"1.4.0": timed(), "1.8.0": timed(gpu="another")}, "speed"
        ).reason
    )
