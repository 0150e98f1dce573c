"""Speed of one world: as shipped, as fixed, and with either change alone."""

from report.shared import (
    PERCENT,
    TIMED_WORLDS,
    Claim,
    Results,
    Section,
    at_most,
    by_case,
    greater,
    resolution,
)

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
    columns = {
        "a frame": "frame_ms",
        "of shipped pads": "frame_ratio",
        "of real time": "realtime_factor",
    }
    rows = [row for row in results.rows if "worlds" not in row]
    worst = resolution(results, "resolution", rows)
    one, many = (
        results.row["stiff-pads-only"],
        results.row[f"stiff-pads-{TIMED_WORLDS[-1]}"],
    )
    departure = PERCENT * (abs(one.frame_ratio - 1) + one.ratio_resolution)
    change = results.value(
        "stiff_pads_only_change",
        "time of a frame of stiff-pads-only over that of as-shipped, less one, either way, with its resolution",
        departure,
        is_noise=True,
    )
    same = at_most(change, 3.0, why="a slowdown that would matter").having_read(worst)
    tables = {"frames": by_case(rows, columns, resolution=worst)}
    claims = [
        Claim(
            "stiff_pads_only_same_time",
            same,
            {"change": change, "ratio": one.frame_ratio},
        )
    ]
    if len(rows) == len(results.rows):  # on a CPU
        return Section(tables=tables, claims=claims, unmeasured=("many_worlds",))
    longer = greater(
        many.frame_ratio,
        1.0,
        noise=many.ratio_resolution,
        why="the time with shipped pads",
    )
    claims += [
        Claim("many_worlds", longer, {"worlds": many.worlds, "ratio": many.frame_ratio})
    ]
    return Section(tables=tables, claims=claims)
