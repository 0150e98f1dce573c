"""What the patch costs: no price counts that is not known, or of a patch that does nothing."""

from collections.abc import Callable
from dataclasses import replace

import pytest

from measured_report.files.root import ROOT
from measured_report.records.reading import load_record
from measured_report.records.record import units_of
from measured_report.values.results import Results
from report.sections import upstream_cost
from report.shared.timing import CURE_WORLDS

PATH = ROOT / "results/newton-1.4.0/speed.json"
TIMES = {"frame_ms": 5.0, "ratio_resolution": 0.001, "contact_count": 10.0, "row_count": 32.0, "substeps": 16}
OFF = TIMES | {"way": "off", "kernel_count": 1680, "frame_ratio": 1.0}
ON = TIMES | {"way": "on", "kernel_count": 1696, "frame_ratio": 1.01, "asked_change_m_s2": 0.02}


def claims(change: Callable[[dict], dict]) -> dict[str, str]:
    rows = [{"case": "released", "way": "released", "kernel_count": 1680}]
    rows += [{"case": f"{row['way']}-{count}", "worlds": count, **row} for count in CURE_WORLDS for row in (OFF, ON)]
    rows = [row | change(row) for row in rows]
    results = Results(replace(load_record(PATH), rows=rows, units=units_of(rows)), PATH)
    return {claim.name: claim.outcome.name for claim in upstream_cost.derive(results).claims}


@pytest.mark.parametrize(
    ("way", "change", "outcomes"),
    [
        ("on", {}, "holds holds holds"),
        ("on", {"frame_ratio": 1.04}, "fails holds holds"),
        ("on", {"ratio_resolution": 0.02}, "unknown holds holds"),
        ("on", {"asked_change_m_s2": 0.0}, "fails holds fails"),
        ("on", {"kernel_count": 1680}, "holds fails holds"),
        ("released", {"kernel_count": 1679}, "holds fails holds"),
        ("on", {"case": "lost"}, "unknown unknown unknown"),
    ],
)
def test_little_is_a_price_that_is_known_of_a_patch_that_acts(way, change, outcomes):
    found = claims(lambda row: change if row["way"] == way else {})
    assert found == dict(zip(("costs_little", "off_launches_nothing", "acts"), outcomes.split(), strict=True))
