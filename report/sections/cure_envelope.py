"""How hard can one shake with the cure? The map of section envelope with the term, and with all remedies."""

import numpy as np
import pandas as pd

from measured_report.claims.claims import Claim, all_of, at_least, at_most
from measured_report.parts.parts import Figure, Section, Table
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Series
from report.sections.envelope import HELD_HEIGHT_M, draw_maps, grid_of, lost_count
from report.shared.arithmetic import SETTLES

order = 147
page = "cure"
label = "harder shakes with the cure"

SIDES = {"term": "the term", "best": "all remedies"}
OTHERS = {"as-shipped": "shipped pads", "stiff": "stiff pads"}
"""Sides of the map in section envelope."""
MAP = "map"


def derive(results: Results) -> Section:
    trace, held = results.trace(MAP), results.chosen("held_height", "lower has left the hand", HELD_HEIGHT_M, unit="m")
    other = results.others.get("envelope")
    before = other.trace(MAP) if other else Series(None, "", "section envelope has no results here")
    lost = {side: lost_count(results, trace, side, held) for side in SIDES}
    lost |= {side: lost_count(results, before, side, held) for side in OTHERS}
    gains = {(side, than): _gain(results, before, than, trace, side) for side in SIDES for than in OTHERS}
    maps = Figure(
        draw=lambda: draw_maps(trace.value, SIDES), sources=[trace], numbers={side: lost[side] for side in SIDES}
    )
    return Section(
        tables={"sides": _table(lost, gains)},
        figures={"maps": maps},
        claims=[_never_drops(results, lost), _gains(results, gains)],
    )


def _gain(results: Results, before: Series, than: str, trace: Series, side: str) -> Value:
    """Cell by cell, where the cube is kept in both."""

    def median_gain(first: pd.DataFrame, second: pd.DataFrame) -> float:
        ratios = (_held_slip(first, than) / _held_slip(second, side)).to_numpy()
        return float(np.median(ratios[np.isfinite(ratios)]))

    return results.value(
        f"gain_{side}_{than.replace('-', '_')}",
        f"median over the map of the slip of side {than} over that of side {side}, where both keep the cube",
        median_gain,
        before,
        trace,
    )


def _held_slip(frame: pd.DataFrame, side: str) -> pd.DataFrame:
    return grid_of(frame, side, "slip_mm").where(grid_of(frame, side, "dropped").astype(str) == "False")


def _never_drops(results: Results, lost: dict[str, Value]) -> Claim:
    bound = results.chosen("lost_bound", "no cell is lost", 0)
    cells = results.row["best"].cell_count
    some = results.chosen("cells_bound", "a map", 100)
    numbers = {"cells": cells, "lost": lost["best"], "term": lost["term"]}
    return Claim("best_never_drops", all_of(at_most(lost["best"], bound), at_least(cells, some)), numbers=numbers)


def _gains(results: Results, gains: dict[tuple[str, str], Value]) -> Claim:
    over = gains["best", "stiff"]
    bound = results.chosen("gain_bound", *SETTLES)
    return Claim(
        "best_slips_less_than_stiff", at_least(over, bound), numbers={"gain": over, "term": gains["term", "stiff"]}
    )


def _table(lost: dict[str, Value], gains: dict[tuple[str, str], Value]) -> Table:
    columns = {"runs that lose the cube": [lost[side] for side in SIDES]}
    columns |= {f"times less than {label}": [gains[side, than] for side in SIDES] for than, label in OTHERS.items()}
    return Table(pd.DataFrame(columns, index=pd.Index(list(SIDES.values()), name="what is done")))
