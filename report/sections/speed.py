"""Speed of one world: as shipped, as fixed, and with either change alone."""

from measured_report.parts.claim import Claim, at_most
from measured_report.parts.section import Section
from measured_report.values.quantities import PERCENT, Value
from measured_report.values.results import Results
from report.shared.tables import by_case
from report.shared.timing import resolution

order = 160
page = "error"
label = "speed of one world"
labels = {
    "as-shipped": "shipped pads",
    "as-shipped-untrimmed": "exactly as shipped",
    "stiff-pads-only": "stiff pads",
    "all-gaps-zero": "no contact gap",
    "fixed": "fixed scene",
}


def derive(results: Results) -> Section:
    columns = {"a frame": "frame_ms", "of shipped pads": "frame_ratio", "of real time": "realtime_factor"}
    worst = resolution(results, "resolution", results.rows)
    table = by_case(results.rows, columns, resolution=worst)
    return Section(tables={"frames": table}, claims=[_same_time(results, worst)])


def _same_time(results: Results, worst: Value) -> Claim:
    row = results.row["stiff-pads-only"]
    formula = "time of a frame of stiff-pads-only over that of as-shipped, less one, either way, with its resolution"
    departure = PERCENT * (abs(row.frame_ratio - 1) + row.ratio_resolution)
    change = results.value("stiff_pads_only_change", formula, departure, is_noise=True)
    outcome = at_most(change, 3.0, why="a slowdown that would matter")
    return Claim("stiff_pads_only_same_time", outcome.having_read(worst), {"change": change, "ratio": row.frame_ratio})
