"""How hard can one shake? Amplitude and frequency, as shipped and with stiff pads, as points and as a map."""

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np
import pandas as pd

from measured_report.parts.claim import HOLDS, Claim, all_of, at_least, at_most, decided
from measured_report.parts.section import Figure, Section
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row, Series
from report.shared.arithmetic import noise_floor, resolved
from report.shared.maps import HELD_HEIGHT_M, draw_maps, held_slip, lost_count

order = 120
page = "fix"
reads = ("noise",)
label = "harder shakes"

SIDES = {"as-shipped": "shipped pads", "stiff": "stiff pads"}


def derive(results: Results) -> Section:
    trace = results.trace("map")
    held = results.chosen("held_height", "a cube that ends lower has left the hand", HELD_HEIGHT_M, unit="m")
    lost = {side: lost_count(results, trace, side, held) for side in SIDES}
    shipped, stiff = _drops(results, trace, lost, held)
    seconds = results.row["as-shipped-3cm-1hz"].shake_duration_s
    about = {"shipped": lost["as-shipped"], "stiff": lost["stiff"], "seconds": seconds}
    about |= {"keeps": stiff.outcome == HOLDS, "is_crossed": any(count.value for count in lost.values())}
    return Section(
        figures={"maps": Figure(lambda: draw_maps(trace.value, SIDES), [trace], about)},
        claims=[shipped, stiff, _map_gain(results, trace), _slip_grows(results)],
    )


def _held_slip(row: Row) -> Quantity:
    """Take the slip; none where the cube was dropped, because it then says how far the cube fell."""
    return replace(row.slip_mm, value=None, reason="the cube was dropped") if row.dropped else row.slip_mm


def _drops(results: Results, trace: Series, lost: Mapping[str, Value], held: Value) -> tuple[Claim, Claim]:
    shipped, stiff = (lost[side] for side in SIDES)
    cells = results.value("cells", "cells of the map on each side", lambda frame: len(frame) // len(SIDES), trace)
    drops = decided(bool(shipped.value), shipped)
    never = at_most(stiff, 0, why="no cell is dropped")
    return (
        Claim("as_shipped_drops", drops, {"lost": shipped, "cells": cells}),
        Claim("stiff_pads_never_drop", never, {"lost": stiff, "cells": cells, "held": held}),
    )


def _map_gain(results: Results, trace: Series) -> Claim:
    formula = "median over the map of the ratio of the slips, where the cube is held before and after"
    median = results.value("map_gain_median", formula, lambda frame: np.median(_gains(frame)), trace)
    least = results.value("map_gain_least", "least ratio on the map", lambda frame: _gains(frame).min(), trace)
    formula = "cells with less slip than as shipped"
    share = results.value("map_gain_share", formula, _share_above_one, trace, unit="%")
    formula = "least of the differences of the slips, as shipped less stiff, in size"
    gap = results.value(
        "map_gap_least", formula, lambda frame: abs(np.subtract(*_slips(frame))).min(), trace, unit="mm"
    )
    outcome = all_of(at_least(share, 100.0, why="every cell"), resolved(noise_floor(results, "slip_floor"), gap))
    return Claim("map_gain", outcome, {"median": median, "least": least, "share": share})


def _share_above_one(frame: pd.DataFrame) -> float:
    gains = _gains(frame)
    return 100 * float(np.mean(gains > 1.0)) if len(gains) else float("nan")


def _slip_grows(results: Results) -> Claim:
    small, large = results.row["as-shipped-1cm-1hz"], results.row["as-shipped-6cm-1hz"]

    def power(low: float, high: float, less: float, more: float) -> float:
        return math.log(more / less) / math.log(high / low)

    cells = small.shake_amplitude_m, large.shake_amplitude_m, _held_slip(small), _held_slip(large)
    formula = "logarithm of the ratio of the slips over that of the amplitudes"
    exponent = results.value("amplitude_exponent", formula, power, *cells)
    numbers = dict(zip(("small", "large", "small_slip", "large_slip"), cells, strict=True))
    numbers["frequency"] = small.shake_frequency_hz
    ends = (at_least, 1.7), (at_most, 2.3)
    outcome = all_of(*(bound(exponent, end, why="an exponent of about 2") for bound, end in ends))
    return Claim("slip_grows_faster_than_amplitude", outcome.having_read(numbers["frequency"]), numbers)


def _gains(frame: pd.DataFrame) -> np.ndarray:
    return np.divide(*_slips(frame))


def _slips(frame: pd.DataFrame) -> tuple[np.ndarray, np.ndarray]:
    shipped, stiff = (held_slip(frame, side).to_numpy(dtype=float) for side in SIDES)
    is_there = np.isfinite(shipped / stiff)
    return shipped[is_there], stiff[is_there]
