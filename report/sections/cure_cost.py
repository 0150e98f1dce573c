"""What the remedies cost: time of a frame with and without them, in one world and in many."""

from collections.abc import Mapping, Sequence
from typing import Any

import pandas as pd
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claims import Claim, at_least, at_most
from measured_report.parts.figures import INK, SERIES, new_figure
from measured_report.parts.parts import Figure, Section, Table
from measured_report.values.format import format_number
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results, Row
from report.names import case_html, name_of, worlds_name
from report.shared.timing import CURE_WORLDS, cell

order = 144
page = "cure"
label = "what the cure costs"

CASES = ("as-shipped", "term", "kept", "best", "term-rk4")
CHEAP = ("term", "kept", "best")
"""Those that fit into one figure."""
Times = Mapping[tuple[str, int], Quantity]
"""Times of a frame, or what they are more than as shipped, by case and number of worlds."""
Rows = Mapping[tuple[str, int], Row]
"""By the same."""


def derive(results: Results) -> Section:
    rows = {(row.case, row.worlds.value): row for row in results.rows}
    counts = [count for count in CURE_WORLDS if any(worlds == count for _, worlds in rows)]
    times = {(case, count): _time(results, rows.get((case, count)), count) for case in CASES for count in CURE_WORLDS}
    extra = {(case, count): _extra(results, times, case, count) for case in CASES[1:] for count in CURE_WORLDS}
    costs = Figure(
        draw=lambda: _draw(counts, extra),
        sources=[times[case, count] for case in CHEAP for count in counts],
        numbers={"term": _worst(results, "term", extra), "best": _worst(results, "best", extra)},
    )
    return Section(
        tables={"times": _table(counts, times, extra)},
        figures={"costs": costs},
        claims=[_term_is_cheap(results, rows, extra), _best_costs_nothing(results, rows, extra), _rk4(results, extra)],
    )


def _time(results: Results, row: Row | None, count: int) -> Quantity:
    return cell(results, row, "frame_ms", f"a batch of {count} worlds")


def _extra(results: Results, times: Times, case: str, count: int) -> Value:
    return results.value(
        f"{case}_extra_{count}",
        f"time of a frame with {case} over that as shipped, less one",
        lambda with_it, without: 100 * (with_it / without - 1),
        times[case, count],
        times["as-shipped", count],
        unit="%",
    )


def _worst(results: Results, case: str, extra: Times) -> Value:
    name = f"{case}_worst"
    if name not in results.derived:
        cells = [extra[case, count] for count in CURE_WORLDS]
        results.value(name, "largest of these, over the numbers of worlds", max, *cells, unit="%")
    return results.derived[name]


def _term_is_cheap(results: Results, rows: Rows, extra: Times) -> Claim:
    largest = _worst(results, "term", extra)
    bound = results.chosen("term_bound", "next to nothing", 3.0, unit="%")
    numbers = _by_count("term", rows, extra) | {"bound": bound}
    return Claim("term_is_cheap", at_most(largest, bound), numbers=numbers)


def _by_count(case: str, rows: Rows, extra: Times) -> dict[str, Any]:
    """What a case costs with each number of worlds, these numbers, and whether the cost is beyond the noise."""
    one, some, many = (extra[case, count] for count in CURE_WORLDS)
    some_worlds, many_worlds = (_worlds(rows, case, count) for count in CURE_WORLDS[1:])
    numbers = {"one": one, "some": some, "many": many, "some_worlds": some_worlds, "many_worlds": many_worlds}
    seen = {f"{name}_seen": _is_seen(numbers[name]) for name in ("one", "some", "many")}
    return numbers | seen


def _is_seen(change: Quantity) -> bool:
    """Whether it is beyond its noise, so that it is written as a number and not as a bound."""
    return None in (change.value, change.noise) or abs(change.value) > change.noise


def _worlds(rows: Rows, case: str, count: int) -> Quantity:
    return rows[case, count].worlds if (case, count) in rows else absent("1", f"there is no run of {count} worlds")


def _best_costs_nothing(results: Results, rows: Rows, extra: Times) -> Claim:
    largest = _worst(results, "best", extra)
    bound = results.chosen("best_bound", "the same time: frames of one run are spread over more", 1.0, unit="%")
    numbers = _by_count("best", rows, extra) | {"bound": bound}
    return Claim("best_costs_nothing", at_most(largest, bound), numbers=numbers)


def _rk4(results: Results, extra: Times) -> Claim:
    least = results.value(
        "rk4_least",
        "time of a frame with the term and RK4 over that as shipped, least of all numbers of worlds",
        lambda *found: min(1 + share / 100 for share in found),
        *(extra["term-rk4", count] for count in CURE_WORLDS),
    )
    most = results.value(
        "rk4_most",
        "the same, most of all numbers of worlds",
        lambda *found: max(1 + share / 100 for share in found),
        *(extra["term-rk4", count] for count in CURE_WORLDS),
    )
    bound = results.chosen("rk4_bound", "a price to think about", 2.0)
    return Claim("rk4_is_dear", at_least(least, bound), numbers={"least": least, "most": most})


def _table(counts: Sequence[int], times: Times, extra: Times) -> Table:
    cells: dict[tuple[str, int], Any] = dict(extra)
    columns: dict[str, list[Any]] = {}
    for count in counts:
        worlds = worlds_name(count)
        columns[worlds] = [times[case, count] for case in CASES]
        columns[f"more, {worlds}"] = [cells.get((case, count), "") for case in CASES]
    return Table(pd.DataFrame(columns, index=pd.Index(map(case_html, CASES), name="case")))


def _draw(counts: Sequence[int], extra: Times) -> Drawing:
    drawing, axes = new_figure(7.2, 2.9)
    for number, case in enumerate(CHEAP):
        cells = [extra[case, count] for count in counts]
        there = [(place + 0.26 * (number - 1), cell) for place, cell in enumerate(cells) if cell.value is not None]
        places, shares = [place for place, _ in there], [cell.value for _, cell in there]
        noises = [cell.noise or 0.0 for _, cell in there]
        look = {"color": SERIES[number], "hatch": ("", "///", "...")[number], "label": name_of(case)}
        axes.bar(places, shares, 0.24, yerr=noises, capsize=3, error_kw={"ecolor": INK, "elinewidth": 1.2}, **look)
    axes.axhline(0.0, color=INK, linewidth=0.8)
    axes.set_xticks(range(len(counts)), [format_number(count) for count in counts])
    axes.grid(visible=False, axis="x")
    axes.set_xlabel("worlds")
    axes.set_ylabel("time of a frame,\nmore than as shipped [%]")
    drawing.legend(loc="outside upper center", ncols=3)
    return drawing
