"""Speed of one world: as shipped, as fixed, and with either change alone."""

from measured_report.parts.claim import Claim, at_most, greater
from measured_report.parts.section import Section
from measured_report.values.quantities import PERCENT, Value
from measured_report.values.results import Results
from report.shared.tables import by_case
from report.shared.timing import TIMED_WORLDS, resolution

order = 160
page = "error"
label = "speed of one world"
labels = {
    "as-shipped": "shipped pads",
    "as-shipped-untrimmed": "exactly as shipped",
    "stiff-pads-only": "stiff pads",
    "all-gaps-zero": "no contact gap",
    "fixed": "stiff pads, all trimmed",
}


def derive(results: Results) -> Section:
    columns = {"a frame": "frame_ms", "of shipped pads": "frame_ratio", "of real time": "realtime_factor"}
    rows = [row for row in results.rows if "worlds" not in row]
    worst = resolution(results, "resolution", rows)
    tables, claims = {"frames": by_case(rows, columns, resolution=worst)}, [_same_time(results, worst)]
    if len(rows) == len(results.rows):  # on a CPU
        return Section(tables=tables, claims=claims, unmeasured=("many_worlds",))
    return Section(tables=tables, claims=[*claims, _many_worlds(results)])


def _same_time(results: Results, worst: Value) -> Claim:
    row = results.row["stiff-pads-only"]
    formula = "time of a frame of stiff-pads-only over that of as-shipped, less one, either way, with its resolution"
    departure = PERCENT * (abs(row.frame_ratio - 1) + row.ratio_resolution)
    change = results.value("stiff_pads_only_change", formula, departure, is_noise=True)
    outcome = at_most(change, 3.0, why="a slowdown that would matter")
    return Claim("stiff_pads_only_same_time", outcome.having_read(worst), {"change": change, "ratio": row.frame_ratio})


def _many_worlds(results: Results) -> Claim:
    row = results.row[f"stiff-pads-{TIMED_WORLDS[-1]}"]
    outcome = greater(row.frame_ratio, 1.0, noise=row.ratio_resolution, why="the time with shipped pads")
    return Claim("many_worlds", outcome, {"worlds": row.worlds, "ratio": row.frame_ratio})
