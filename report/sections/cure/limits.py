"""The cure at the limits of the grasp, where it could lose the cube."""

from collections import defaultdict
from functools import partial

from report.shared import (
    Claim,
    Results,
    Row,
    Section,
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
    "firm": "the root cure on stiff pads",
    "firm-euler": "the same, Euler",
}


def _count_of(count: int, *_: float) -> int:
    return count


def derive(results: Results) -> Section:
    runs: dict[str, dict[str, Row]] = defaultdict(dict)
    for row in rows_with(results, "of", "variant", "family", "kept"):
        runs[row.of][row.variant] = row
    columns: dict[str, list] = defaultdict(list)
    # A run counts if it was made with all variants on its pads.
    for variants in (VARIANTS, STIFF_VARIANTS):
        tried = [rows for rows in runs.values() if {"plain", *variants} <= set(rows)]
        for variant in variants:
            kept = []
            lost = []
            gained = []
            for rows in tried:
                plain = rows["plain"]
                if plain.kept:
                    kept.append(plain)
                if plain.kept and not rows[variant].kept:
                    lost.append(plain)
                if rows[variant].kept and not plain.kept:
                    gained.append(plain)
            name = variant.replace("-", "_")
            for heading, value, formula, counted in (
                (
                    "kept without it",
                    "kept",
                    "runs that keep the cube without the cure",
                    kept,
                ),
                (
                    "lost of these",
                    "limit_lost",
                    "runs among these that lose it with the cure",
                    lost,
                ),
                (
                    "kept only with it",
                    "won",
                    "runs that keep it only with the cure",
                    gained,
                ),
            ):
                # The count depends on all runs that were made.
                sources = [row.substeps for rows in tried for row in rows.values()]
                count = partial(_count_of, len(counted))
                columns[heading].append(
                    results.value(f"{value}_{name}", formula, count, *sources)
                )
            columns["lost cases"].append(
                some_html([case_html(row) for row in lost]) or "none"
            )
    names = (VARIANTS | STIFF_VARIANTS).values()
    # Test whether the root cure keeps the cube in all cells of the map of section
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
