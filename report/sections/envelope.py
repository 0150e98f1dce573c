"""Show the slip over amplitude and frequency, as a table and as a map."""

import math
from dataclasses import replace
from statistics import median

import numpy as np
import pandas as pd

from report.shared import (
    HOLDS,
    Claim,
    Figure,
    Results,
    Row,
    Section,
    at_least,
    at_most,
    decided,
    table_of,
)
from report.shared.maps import HELD_HEIGHT_M, draw_maps, held_slip, lost_count

order = 120
page = "fix"
label = "harder shakes"

SIDES = {"as-shipped": "shipped pads", "stiff": "stiff pads"}


def derive(results: Results) -> Section:
    trace = results.trace("map")
    held = results.chosen(
        "held_height", "a cube that ends lower has left the hand", HELD_HEIGHT_M, "m"
    )
    shipped, stiff = (lost_count(results, trace, side, held) for side in SIDES)
    drops = decided(bool(shipped.value), shipped)
    never = at_most(stiff, 0, "no cell is dropped")
    cells = results.value(
        "cells",
        "cells of the map on each side",
        lambda frame: len(frame) // len(SIDES),
        trace,
    )
    middle = results.value(
        "map_gain_median",
        "median ratio of the slips of shipped and stiff pads, over the cells of the"
        " map that keep the cube with both",
        lambda map: median(np.divide(*_slips(map))),
        trace,
    )
    least = results.value(
        "map_gain_least",
        "smallest of these ratios",
        lambda map: np.divide(*_slips(map)).min(),
        trace,
    )
    # The table lists the shakes with round amplitudes and frequencies.
    stiff_cases = (
        row["case"] for row in results.rows if row["case"].startswith("stiff-")
    )
    shakes = [case.removeprefix("stiff-") for case in stiff_cases]
    columns: dict[str, list] = {}
    for side, name in SIDES.items():
        rows = [results.row[f"{side}-{shake}"] for shake in shakes]
        slips = [row.slip_mm if _is_held(row) else "lost" for row in rows]
        columns[f"slip, {name}"] = slips
        columns[f"final cube height, {name}"] = [row.cube_height_m for row in rows]
    columns["slip ratio"] = [_slip_ratio(results, shake) for shake in shakes]
    # We assume that the cells of the map scatter like the same runs in this table.
    held_slips = [row.slip_mm for row in results.rows if _is_held(row)]
    shares = [
        slip.noise / slip.number for slip in held_slips if slip.noise and slip.value
    ]
    noise = math.sqrt(2) * max(shares, default=0.0) * (least.value or 0.0)
    gains = at_least(replace(least, noise=noise), 1.0, "a smaller slip")
    gains = gains.having_read(*held_slips)

    names = [
        shake.replace("cm-", "\u00a0cm, ").replace("hz", "\u00a0Hz") for shake in shakes
    ]
    seconds = results.row["as-shipped-3cm-1hz"].shake_duration_s
    numbers = {
        "shipped": shipped,
        "stiff": stiff,
        "seconds": seconds,
        "keeps": never == HOLDS,
        "drops": drops == HOLDS,
    }
    maps = Figure(lambda: draw_maps(trace.value, SIDES), [trace], numbers)
    return Section(
        tables={"shakes": table_of("shake", names, columns, seconds=seconds)},
        figures={"maps": maps},
        claims=[
            Claim("as_shipped_drops", drops, {"lost": shipped, "cells": cells}),
            Claim(
                "stiff_pads_never_drop",
                never,
                {"lost": stiff, "cells": cells, "held": held},
            ),
            Claim("map_gain", gains, {"median": middle, "least": least}),
        ],
    )


def _slip_ratio(results: Results, shake: str):
    shipped, stiff = (results.row[f"{side}-{shake}"] for side in SIDES)
    if not (_is_held(shipped) and _is_held(stiff)):
        return ""
    return results.value(
        f"round_gain_{shake}",
        "slip with shipped pads divided by the slip with stiff pads",
        shipped.slip_mm / stiff.slip_mm,
    )


def _is_held(row: Row) -> bool:
    is_high = row.slip_mm.value is not None
    return is_high and row.plain["cube_height_m"] >= HELD_HEIGHT_M


def _slips(frame: pd.DataFrame) -> tuple[np.ndarray, np.ndarray]:
    """Return the slips in the shakes in which both kinds of pads keep the cube."""
    shipped, stiff = (held_slip(frame, side).to_numpy(dtype=float) for side in SIDES)
    is_usable = np.isfinite(shipped) & np.isfinite(stiff) & (stiff != 0.0)
    return shipped[is_usable], stiff[is_usable]
