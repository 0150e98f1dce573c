"""The cure at the limits of the grasp, where it could break what holds without it."""

from collections import defaultdict

from report.shared import (
    Claim,
    Results,
    Row,
    Section,
    all_of,
    at_least,
    at_most,
    case_html,
    cell_count,
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


def derive(results: Results) -> Section:
    runs: dict[str, dict[str, Row]] = defaultdict(dict)
    for row in rows_with(results, "of", "variant", "family", "kept"):
        runs[row.of][row.variant] = row
    columns: dict[str, list] = defaultdict(list)
    for variants in (
        VARIANTS,
        STIFF_VARIANTS,
    ):  # a run counts if tried with all of them
        tried = [rows for rows in runs.values() if {"plain", *variants} <= set(rows)]
        for variant in variants:
            kept = [rows["plain"] for rows in tried if rows["plain"].kept]
            lost = [
                rows["plain"]
                for rows in tried
                if rows["plain"].kept and not rows[variant].kept
            ]
            won = [
                rows["plain"]
                for rows in tried
                if rows[variant].kept and not rows["plain"].kept
            ]
            counts = (
                (
                    "kept without",
                    "kept",
                    "runs that keep the cube with nothing done",
                    kept,
                ),
                (
                    "lost of these",
                    "limit_lost",
                    "of these, runs that lose it this way",
                    lost,
                ),
                ("kept only so", "won", "runs that keep it only this way", won),
            )
            for above, name, formula, rows in counts:
                name = f"{name}_{variant.replace('-', '_')}"
                count = cell_count([row.substeps for row in rows])
                columns[above].append(results.value(name, formula, count))
            columns["which are lost"].append(
                some_html([case_html(row) for row in lost]) or "none"
            )
    names = (VARIANTS | STIFF_VARIANTS).values()
    # Whether the root cure keeps the cube over the map of section envelope.
    held = results.chosen("held_height", "lower has left the hand", HELD_HEIGHT_M, "m")
    lost_cells = lost_count(results, results.trace("map"), "best", held)
    cells = results.row["map-best"].cell_count
    never = all_of(
        at_most(lost_cells, 0, "no cell is lost"), at_least(cells, 100, "a map")
    )
    numbers = {"cells": cells, "lost": lost_cells}
    return Section(
        tables={"limits": table_of("way", names, columns)},
        claims=[Claim("best_never_drops", never, numbers)],
    )
