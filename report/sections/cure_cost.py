"""What the remedies cost: time of a frame with and without them, in one world and in many."""

from collections.abc import Iterator, Mapping, Sequence

from matplotlib.figure import Figure as Drawing

from measured_report.claims.claim import Claim, at_least, at_most
from measured_report.parts.figures import INK, SERIES, new_figure
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.format import format_number
from measured_report.values.quantities import Quantity, absent
from measured_report.values.results import Results
from report.names import case_html, name_of, worlds_name
from report.shared.arithmetic import excess, table_of
from report.shared.timing import CURE_WORLDS, cell

order = 144
page = "cure"
label = "what the cure costs"

CASES = ("as-shipped", "term", "kept", "best", "term-rk4")
CHEAP = ("term", "kept", "best")
"""Those that fit into one figure."""
Times = Mapping[tuple[str, int], Quantity]
"""Times of a frame, or what they are more than as shipped, by case and number of worlds."""


def derive(results: Results) -> Section:
    rows = {(row.case, row.worlds.value): row for row in results.rows}
    counts = [count for count in CURE_WORLDS if any(worlds == count for _, worlds in rows)]
    cells = [(case, count) for case in CASES for count in CURE_WORLDS]
    times = {place: cell(results, rows.get(place), "frame_ms", f"a batch of {place[1]} worlds") for place in cells}
    formula = "time of a frame with {} over that as shipped, less one"
    extra = {
        (case, count): excess(
            results, f"{case}_extra_{count}", formula.format(case), times[case, count], times[CASES[0], count]
        )
        for case, count in cells
        if case != CASES[0]
    }
    worlds = {place: row.worlds for place, row in rows.items()}
    claims = list(_claims(results, worlds, extra))
    costs = Figure(
        draw=lambda: _draw(counts, extra),
        sources=[times[case, count] for case in CHEAP for count in counts],
        numbers={case: results.derived[f"{case}_worst"] for case in ("term", "best")},
    )
    return Section(tables={"times": _table(counts, times, extra)}, figures={"costs": costs}, claims=claims)


def _claims(results: Results, worlds: Times, extra: Times) -> Iterator[Claim]:
    """Tell which remedies cost next to nothing, and that RK4 is dear."""
    for name, case, bound, why in (
        ("term_is_cheap", "term", 3.0, "next to nothing"),
        ("best_costs_nothing", "best", 1.0, "the same time: frames of one run are spread over more"),
    ):
        costs = [extra[case, count] for count in CURE_WORLDS]
        formula = "largest of these, over the numbers of worlds"
        largest = results.value(f"{case}_worst", formula, max, *costs, unit="%")
        most = results.chosen(f"{case}_bound", why, bound, unit="%")
        yield Claim(name, at_most(largest, most), _by_count(case, worlds, costs) | {"bound": most})

    costs = [extra["term-rk4", count] for count in CURE_WORLDS]
    formula = "time of a frame with the term and RK4 over that as shipped, least of all numbers of worlds"
    least = results.value("rk4_least", formula, lambda *found: min(1 + share / 100 for share in found), *costs)
    formula = "the same, most of all numbers of worlds"
    most = results.value("rk4_most", formula, lambda *found: max(1 + share / 100 for share in found), *costs)
    yield Claim("rk4_is_dear", at_least(least, 2.0, why="a price to think about"), {"least": least, "most": most})


def _by_count(case: str, worlds: Times, costs: Sequence[Quantity]) -> dict[str, Quantity | bool]:
    """Name what a case costs with each number of worlds, these numbers, and whether the cost is beyond the noise."""
    numbers: dict[str, Quantity | bool] = {}
    for name, count, cost in zip(("one", "some", "many"), CURE_WORLDS, costs, strict=True):
        numbers[f"{name}_worlds"] = worlds.get((case, count)) or absent("1", f"there is no run of {count} worlds")
        # Beyond its noise it is written as a number, and not as a bound.
        is_seen = None in (cost.value, cost.noise) or abs(cost.value) > cost.noise
        numbers |= {name: cost, f"{name}_seen": is_seen}
    return numbers


def _table(counts: Sequence[int], times: Times, extra: Times) -> Table:
    columns: dict[str, list[Quantity | str]] = {}
    for count in counts:
        worlds = worlds_name(count)
        columns[worlds] = [times[case, count] for case in CASES]
        columns[f"more, {worlds}"] = [extra.get((case, count), "") for case in CASES]
    return table_of("case", map(case_html, CASES), columns)


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
    axes.set(xlabel="worlds", ylabel="time of a frame,\nmore than as shipped [%]")
    drawing.legend(loc="outside upper center", ncols=3)
    return drawing
