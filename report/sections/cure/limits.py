"""Test the cure at the limits of the grasp, where it could lose the cube."""

from collections import defaultdict
from typing import Any

from report.shared import (
    Claim,
    Results,
    Row,
    Section,
    Value,
    all_of,
    at_least,
    at_most,
    case_html,
    rows_with,
    some_html,
    table_of,
)
from report.shared.maps import HELD_HEIGHT_M, lost_count

VARIANTS = {"term": "the term", "best": "the root cure"}
STIFF_VARIANTS = {
    "firm": "the root cure with stiff pads",
    "firm-euler": "the same, Euler",
}
Runs = dict[str, Row]  # the runs of one setting, by variant


def derive(results: Results) -> Section:
    runs: dict[str, Runs] = defaultdict(dict)
    for row in rows_with(results, "of", "variant", "family", "kept"):
        runs[row.of][row.variant] = row
    lines = []
    # A setting counts if it was run with all variants and its own pads.
    for variants in (VARIANTS, STIFF_VARIANTS):
        tried = [rows for rows in runs.values() if {"plain", *variants} <= set(rows)]
        lines += [_line(results, variant, tried) for variant in variants]
    columns = {heading: [line[heading] for line in lines] for heading in lines[0]}
    names = (VARIANTS | STIFF_VARIANTS).values()
    # Test whether the root cure keeps the cube in all cells of the map in section
    # envelope.
    held = results.chosen(
        "held_height", "a cube that ends lower has left the hand", HELD_HEIGHT_M, "m"
    )
    lost_cells = lost_count(results, results.trace("map"), "best", held)
    cells = results.row["map-best"].cell_count
    never = all_of(
        at_most(lost_cells, 0, "all cells keep the cube"),
        at_least(cells, 100, "enough cells for a map"),
    )
    numbers = {"cells": cells, "lost": lost_cells}
    return Section(
        tables={"limits": table_of("remedy", names, columns)},
        claims=[Claim("best_never_drops", never, numbers)],
    )


def _line(results: Results, variant: str, tried: list[Runs]) -> dict[str, Any]:
    """Return the cells of a variant: counts of runs, and the cases in which it loses
    the cube.
    """
    kept = [runs for runs in tried if runs["plain"].kept]
    lost = [runs for runs in kept if not runs[variant].kept]
    gained = [runs for runs in tried if runs[variant].kept and not runs["plain"].kept]
    # The counts depend on all runs that were made.
    sources = [row.substeps for runs in tried for row in runs.values()]

    def count(name: str, formula: str, counted: list[Runs]) -> Value:
        name = f"{name}_{variant}".replace("-", "_")
        return results.value(name, formula, lambda *_: len(counted), *sources)

    return {
        "kept without the cure": count(
            "kept", "runs that keep the cube without the cure", kept
        ),
        "of these, lost with the cure": count(
            "limit_lost", "runs among these that lose the cube with the cure", lost
        ),
        "kept only with the cure": count(
            "won", "runs that keep the cube only with the cure", gained
        ),
        "lost cases": some_html([case_html(runs["plain"]) for runs in lost]) or "none",
    }
