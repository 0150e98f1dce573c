"""The cure at the limits of the grasp, where it could break what holds without it."""

from collections import defaultdict
from collections.abc import Iterable, Mapping

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
    cell_count,
    rows_with,
    some_html,
    table_of,
)
from report.shared.maps import HELD_HEIGHT_M, lost_count

VARIANTS = {  # names by variant, and which of them a run has to be tried with to be counted
    "term": ("the term", ("term", "best")),
    "best": ("the root cure", ("term", "best")),
    "firm": ("the root cure on stiff pads", ("firm", "firm-euler")),
    "firm-euler": ("the same, Euler", ("firm", "firm-euler")),
}


def derive(results: Results) -> Section:
    runs: dict[str, dict[str, Row]] = defaultdict(dict)
    for row in rows_with(results, "of", "variant", "family", "kept"):
        runs[row.of][row.variant] = row
    lines = [_line(results, runs, variant) for variant in VARIANTS]
    columns = {above: [line[above] for line in lines] for above in lines[0]}
    table = table_of("way", [name for name, _ in VARIANTS.values()], columns)
    # Whether the root cure keeps the cube over the map of section envelope.
    held = results.chosen("held_height", "lower has left the hand", HELD_HEIGHT_M, "m")
    lost, cells = (
        lost_count(results, results.trace("map"), "best", held),
        results.row["map-best"].cell_count,
    )
    never = all_of(
        at_most(lost, 0, why="no cell is lost"), at_least(cells, 100, why="a map")
    )
    return Section(
        tables={"limits": table},
        claims=[Claim("best_never_drops", never, {"cells": cells, "lost": lost})],
    )


def _line(
    results: Results, runs: Mapping[str, Mapping[str, Row]], variant: str
) -> dict[str, Value | str]:
    tried = {
        run: rows
        for run, rows in runs.items()
        if {"plain", *VARIANTS[variant][1]} <= set(rows)
    }
    plain, mine = (
        [run for run, rows in tried.items() if rows[which].kept]
        for which in ("plain", variant)
    )
    lost, won = (
        [run for run in plain if run not in mine],
        [run for run in mine if run not in plain],
    )
    name = variant.replace("-", "_")

    def count(name: str, formula: str, counted: Iterable[str]) -> Value:
        return results.value(
            name, formula, cell_count([tried[run]["plain"].substeps for run in counted])
        )

    return {
        "kept without": count(
            f"kept_{name}", "runs that keep the cube with nothing done", plain
        ),
        "lost of these": count(
            f"limit_lost_{name}", "of these, runs that lose it this way", lost
        ),
        "kept only so": count(f"won_{name}", "runs that keep it only this way", won),
        "which are lost": some_html([case_html(tried[run]["plain"]) for run in lost])
        or "none",
    }
