"""How hard can one shake? Amplitude and frequency, as shipped and with stiff pads, as points and as a map."""

from statistics import median

import numpy as np
import pandas as pd

from report.shared import (
    HOLDS,
    Claim,
    Column,
    Figure,
    Results,
    Row,
    Section,
    Series,
    Table,
    all_of,
    at_least,
    at_most,
    decided,
    noise_floor,
    resolved,
    table_of,
)
from report.shared.maps import HELD_HEIGHT_M, draw_maps, held_slip, lost_count

order = 120
page = "fix"
reads = ("noise",)
label = "harder shakes"

SIDES = {"as-shipped": "shipped pads", "stiff": "stiff pads"}


def derive(results: Results) -> Section:
    trace = results.trace("map")
    held = results.chosen(
        "held_height", "a cube that ends lower has left the hand", HELD_HEIGHT_M, "m"
    )
    shipped, stiff = (lost_count(results, trace, side, held) for side in SIDES)
    cells = results.value(
        "cells",
        "cells of the map on each side",
        lambda frame: len(frame) // len(SIDES),
        trace,
    )
    drops, never = (
        decided(bool(shipped.value), shipped),
        at_most(stiff, 0, why="no cell is dropped"),
    )
    claims = [Claim("as_shipped_drops", drops, {"lost": shipped, "cells": cells})]
    claims += [
        Claim(
            "stiff_pads_never_drop",
            never,
            {"lost": stiff, "cells": cells, "held": held},
        )
    ]
    about = {
        "shipped": shipped,
        "stiff": stiff,
        "seconds": results.row["as-shipped-3cm-1hz"].shake_duration_s,
    }
    about |= {"keeps": never == HOLDS, "drops": drops == HOLDS}
    figures = {"maps": Figure(lambda: draw_maps(trace.value, SIDES), [trace], about)}
    return Section(
        tables={"shakes": _shakes(results)},
        figures=figures,
        claims=[*claims, _map_gain(results, trace)],
    )


def _shakes(results: Results) -> Table:
    """Tell how shakes at round numbers end, and how many times less stiff pads slip."""
    shakes = [
        row["case"].removeprefix("stiff-")
        for row in results.rows
        if row["case"].startswith("stiff-")
    ]
    pairs = [[results.row[f"{side}-{shake}"] for side in SIDES] for shake in shakes]
    columns: dict[str, Column] = {}
    for label, rows in zip(SIDES.values(), zip(*pairs, strict=True), strict=True):
        columns[f"slip, {label}"] = [
            row.slip_mm if _is_held(row) else "lost" for row in rows
        ]
        columns[f"cube ends at, {label}"] = [row.cube_height_m for row in rows]
    columns["times less"] = [
        results.value(
            f"round_gain_{shake}",
            "slip as shipped over that in stiff pads",
            shipped.slip_mm / stiff.slip_mm,
        )
        if _is_held(shipped) and _is_held(stiff)
        else ""
        for shake, (shipped, stiff) in zip(shakes, pairs, strict=True)
    ]
    names = [
        shake.replace("cm-", "\u00a0cm, ").replace("hz", "\u00a0Hz") for shake in shakes
    ]
    return table_of(
        "shake",
        names,
        columns,
        seconds=results.row["as-shipped-3cm-1hz"].shake_duration_s,
    )


def _is_held(row: Row) -> bool:
    return row.slip_mm.value is not None and row.plain["cube_height_m"] >= HELD_HEIGHT_M


def _map_gain(results: Results, trace: Series) -> Claim:
    middle = results.value(
        "map_gain_median",
        "median over the map of the ratio of the slips, where the cube is held before and after",
        lambda map: median(np.divide(*_slips(map))),
        trace,
    )
    least = results.value(
        "map_gain_least",
        "least ratio on the map",
        lambda map: np.divide(*_slips(map)).min(),
        trace,
    )
    gap = results.value(
        "map_gap_least",
        "least of the differences of the slips, as shipped less stiff, in size",
        lambda map: abs(np.subtract(*_slips(map))).min(),
        trace,
        unit="mm",
    )
    outcome = all_of(
        at_least(least, 1.0, why="less slip"),
        resolved(noise_floor(results, "slip_floor"), gap),
    )
    return Claim("map_gain", outcome, {"median": middle, "least": least})


def _slips(frame: pd.DataFrame) -> tuple[np.ndarray, np.ndarray]:
    shipped, stiff = (held_slip(frame, side).to_numpy(dtype=float) for side in SIDES)
    is_there = np.isfinite(shipped) & np.isfinite(stiff) & (stiff != 0.0)
    return shipped[is_there], stiff[is_there]
