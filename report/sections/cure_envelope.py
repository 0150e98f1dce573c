"""How hard can one shake with the cure? The map of section envelope with the term, and with all remedies."""

import numpy as np
import pandas as pd

from measured_report.claims.claim import Claim, all_of, at_least, at_most
from measured_report.parts.section import Figure, Section
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Series
from report.sections.envelope import HELD_HEIGHT_M, draw_maps, held_slip, lost_count
from report.sections.envelope import SIDES as OTHERS
from report.shared.arithmetic import settles, table_of

order = 147
page = "cure"
label = "harder shakes with the cure"

SIDES = {"term": "the term", "best": "all remedies"}
MAP = "map"


def derive(results: Results) -> Section:
    trace, held = results.trace(MAP), results.chosen("held_height", "lower has left the hand", HELD_HEIGHT_M, unit="m")
    other = results.others.get("envelope")
    before = other.trace(MAP) if other else Series(None, "", "section envelope has no results here")
    maps = {**dict.fromkeys(SIDES, trace), **dict.fromkeys(OTHERS, before)}
    lost = {side: lost_count(results, found, side, held) for side, found in maps.items()}
    gains = {(side, than): _gain(results, before, than, trace, side) for side in SIDES for than in OTHERS}
    columns = {"runs that lose the cube": [lost[side] for side in SIDES]}
    columns |= {f"times less than {label}": [gains[side, than] for side in SIDES] for than, label in OTHERS.items()}
    cells, gain = results.row["best"].cell_count, gains["best", "stiff"]
    drops = all_of(at_most(lost["best"], 0, why="no cell is lost"), at_least(cells, 100, why="a map"))
    return Section(
        tables={"sides": table_of("what is done", SIDES.values(), columns)},
        figures={"maps": Figure(lambda: draw_maps(trace.value, SIDES), [trace], lost)},
        claims=[
            Claim("best_never_drops", drops, {"cells": cells, "lost": lost["best"], "term": lost["term"]}),
            Claim("best_slips_less_than_stiff", settles(gain), {"gain": gain, "term": gains["term", "stiff"]}),
        ],
    )


def _gain(results: Results, before: Series, than: str, trace: Series, side: str) -> Value:
    """Compare cell by cell, where the cube is kept in both."""

    def median_gain(first: pd.DataFrame, second: pd.DataFrame) -> float:
        ratios = (held_slip(first, than) / held_slip(second, side)).to_numpy()
        return float(np.median(ratios[np.isfinite(ratios)]))

    formula = f"median over the map of the slip of side {than} over that of side {side}, where both keep the cube"
    return results.value(f"gain_{side}_{than.replace('-', '_')}", formula, median_gain, before, trace)
