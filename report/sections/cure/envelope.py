"""The map of section envelope with the term, and with the whole cure: how hard can one shake?"""

import numpy as np
import pandas as pd

from measured_report.parts.claim import HOLDS, Claim, all_of, at_least, at_most
from measured_report.parts.section import Figure, Section
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Series
from report.shared.maps import HELD_HEIGHT_M, draw_maps, held_slip, lost_count

SIDES = {"term": "the term", "best": "the whole cure"}
MAP = "map"


def derive(results: Results) -> Section:
    trace, held = results.trace(MAP), results.chosen("held_height", "lower has left the hand", HELD_HEIGHT_M, unit="m")
    other = results.others.get("envelope")
    before = other.trace(MAP) if other else Series(None, "", "section envelope has no results here")
    lost = {side: lost_count(results, trace, side, held) for side in SIDES}
    cells, gain = results.row["map-best"].cell_count, _gain(results, before, "stiff", trace, "best")
    drops = all_of(at_most(lost["best"], 0, why="no cell is lost"), at_least(cells, 100, why="a map"))
    flags = {"keeps": drops == HOLDS, "is_crossed": any(count.value for count in lost.values())}
    return Section(
        figures={"maps": Figure(lambda: draw_maps(trace.value, SIDES), [trace], lost | flags)},
        claims=[
            Claim("best_never_drops", drops, {"cells": cells, "lost": lost["best"]}),
            Claim("best_slips_less_than_stiff", at_least(gain, 2.0, why="half the slip"), {"gain": gain}),
        ],
    )


def _gain(results: Results, before: Series, than: str, trace: Series, side: str) -> Value:
    """Compare cell by cell, where the cube is kept in both."""

    def median_gain(first: pd.DataFrame, second: pd.DataFrame) -> float:
        ratios = (held_slip(first, than) / held_slip(second, side)).to_numpy()
        return float(np.median(ratios[np.isfinite(ratios)]))

    formula = f"median over the map of the slip of side {than} over that of side {side}, where both keep the cube"
    return results.value(f"gain_{side}_{than.replace('-', '_')}", formula, median_gain, before, trace)
