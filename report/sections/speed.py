"""Compare the speed of one world with shipped pads, with the fix, and with each change
that the fix makes.
"""

from report.shared import (
    PERCENT,
    SLOWER,
    TIMED_WORLDS,
    Claim,
    Results,
    Section,
    by_case,
    greater,
    negligible,
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
    "fixed": "stiff pads, without all unneeded parts",
}


def derive(results: Results) -> Section:
    rows = [row for row in results.rows if "worlds" not in row]
    worst = resolution(results, "resolution", rows)
    stiff = results.row["stiff-pads-only"]
    change = results.value(
        "stiff_pads_only_change",
        "time of a frame with stiff pads divided by the time as shipped, minus one",
        PERCENT * (stiff.frame_ratio - 1),
    )
    bound = results.chosen("slower", *SLOWER, "%")
    same = negligible(abs(change), bound)
    claims = [
        Claim("stiff_pads_only_same_time", same, {"change": change, "bound": bound})
    ]
    columns = {
        "time of a frame": "frame_ms",
        "relative to shipped pads": "frame_ratio",
        "relative to real time": "realtime_factor",
    }
    tables = {"frames": by_case(rows, columns, resolution=worst)}
    if len(rows) == len(results.rows):  # records of a CPU have one world only
        return Section(tables=tables, claims=claims, unmeasured=("many_worlds",))
    many = results.row[f"stiff-pads-{TIMED_WORLDS[-1]}"]
    longer = greater(many.frame_ratio, 1.0, "the time with shipped pads")
    claims.append(
        Claim("many_worlds", longer, {"worlds": many.worlds, "ratio": many.frame_ratio})
    )
    return Section(tables=tables, claims=claims)
