"""A hand that swings a capsule: up to which step does it hold, and is it the law of the creep that ends it?"""

from collections.abc import Iterator, Mapping, Sequence

from matplotlib.figure import Figure as Drawing

from measured_report.parts.claim import HOLDS, Claim, all_of, at_least, at_most
from measured_report.parts.figures import INK, SERIES, is_narrow, new_figure, tick_at
from measured_report.parts.section import Figure, Section
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import cell_count, departure, difference, extreme, ratio, share
from report.shared.drawing import TERM, mark_points

STEPS = ("0.5", "1", "2", "4", "8", "16", "32", "64")
"""Steps in ms, as cases have them."""
CREEPING = ("implicitfast", "euler", "rk4", "pyramidal", "own-timeconst", "warp", "through-newton")
SETTINGS = (*CREEPING, "term")
DRAWN = {
    "implicitfast": "MuJoCo C",
    "warp": "MuJoCo Warp",
    "through-newton": "through Newton",
    "rk4": "C, RK4",
    "own-timeconst": "C, MuJoCo's own timeconst",
    "term": "C, term put back",
}
COLOURS = dict(zip(DRAWN, (SERIES[0], SERIES[5], SERIES[5], SERIES[3], SERIES[4], TERM), strict=True))
LAWS = ("implicitfast", "rk4", "own-timeconst")
"""Drawn settings that the law tells apart."""
MARKERS = ("o", "s", "D", "^", "v", "P")


def derive(results: Results) -> Section:
    found = {setting: results.row[setting] for setting in SETTINGS}
    runs = {setting: [results.row[f"{step}ms-{setting}"] for step in STEPS] for setting in SETTINGS}
    held = {name: [row.step_ms for row in rows if row.slip_mm.value is not None] for name, rows in runs.items()}
    formula = "shortest step tried that holds"
    least = {name: extreme(results, f"{name}_least_step", formula, min, steps) for name, steps in held.items()}
    plain, lost = results.row["2ms-implicitfast"], found["implicitfast"].lost_mm
    by_creep, slip = _follows_law(results, found, runs)
    rk4, own, term = _other_settings(results, found, least)
    figure = Figure(
        draw=lambda: _draw(runs, lost),
        sources=[row.slip_mm for rows in runs.values() for row in rows],
        numbers={"lost": lost, "plain": plain.slip_mm, "step": plain.step_ms}
        | {"is_creep": all_of(by_creep.outcome, term.outcome) == HOLDS},
    )
    claims = [by_creep, _is_firm(results, plain), slip, _softer_with_the_step(results), rk4, own, term]
    return Section(figures={"slips": figure}, claims=claims)


def _is_firm(results: Results, plain: Row) -> Claim:
    force, weight = plain.normal_force_n, plain.weight_n
    times = ratio(results, "firmness", "sum of the normal forces, of the weight", force, weight)
    outcome = at_least(times, 10.0, why="friction of 1 could carry many times the weight")
    return Claim("is_firm", outcome, {"force": force, "weight": weight})


def _follows_law(results: Results, found: Mapping[str, Row], runs: Mapping[str, Sequence[Row]]) -> Iterator[Claim]:
    steps = {name: (found[name].largest_step_ms, found[name].predicted_largest_step_ms) for name in CREEPING}
    formula = "largest step that holds less that of the law, in size, of the latter"
    off = [departure(results, f"{name}_step_off", formula, *cells) for name, cells in steps.items()]
    most = extreme(results, "step_off", "largest of the departures from the law's largest step", max, off)
    count = cell_count(results, "creeping_count", "settings with such a step", off)
    largest, law = steps["implicitfast"]
    numbers = {"largest": largest, "law": law, "count": count, "off": most}
    yield Claim("lost_by_creep", at_most(most, 20.0, why="near enough to choose a step by"), numbers)

    kept = {name: [row for row in rows if row.slip_mm.value is not None] for name, rows in runs.items()}
    held = [row for name in CREEPING for row in kept[name]]
    formula = "slip less that of the law, in size, of the latter"
    off = [departure(results, f"{row.case}_off", formula, row.slip_mm, row.predicted_slip_mm) for row in held]
    largest = extreme(results, "slip_off", "largest of the departures from the law's slip", max, off)
    count = cell_count(results, "held_count", "runs that hold", off)
    slips = [row.slip_mm for rows in kept.values() for row in rows]
    every = cell_count(results, "kept_count", "all runs that hold", slips)
    others = difference(results, "other_count", "those with the term put back", every, count)
    numbers = {"count": count, "largest": largest, "kept": every, "others": others}
    outcome = at_most(largest, 10.0, why="the same slip").having_read(every, others)
    yield Claim("slip_by_law", outcome, numbers)


def _softer_with_the_step(results: Results) -> Claim:
    """Less slip with longer steps up to half the timeconst, and from there on slip in proportion to the step."""
    short, middle, long = (results.row[f"{step}ms-implicitfast"] for step in ("0.5", "2", "8"))
    formula = "slip at half the timeconst, of that at a short step"
    less = share(results, "short_step_share", formula, middle.slip_mm, short.slip_mm)
    formula = "slip with a long step, of that at half the timeconst"
    times = ratio(results, "slip_growth", formula, long.slip_mm, middle.slip_mm)
    steps = ratio(results, "step_growth", "the long step, of half the timeconst", long.step_ms, middle.step_ms)
    formula = "growth of the slip less that of the step, in size, of the latter"
    off = departure(results, "growth_off", formula, times, steps)
    numbers: dict[str, Quantity] = {}
    for name, row in (("short", short), ("middle", middle), ("long", long)):
        numbers |= {name: row.slip_mm, f"{name}_step": row.step_ms}
    outcome = all_of(at_most(less, 90.0, why="less"), at_most(off, 10.0, why="in proportion"))
    return Claim("softer_with_the_step", outcome, numbers)


def _other_settings(results: Results, found: Mapping[str, Row], least: Mapping[str, Value]) -> Iterator[Claim]:
    plain, rk4, term = (found[name].largest_step_ms for name in ("implicitfast", "rk4", "term"))
    part = share(results, "rk4_share", "largest step with RK4, of that with implicitfast", rk4, plain)
    yield Claim("rk4_halves", at_most(part, 60.0, why="about half"), {"rk4": rk4, "plain": plain})

    shortest, holds = results.row["0.5ms-own-timeconst"].step_ms, least["own-timeconst"]
    formula = "least step tried that holds, of the shortest"
    times = ratio(results, "own_step_ratio", formula, holds, shortest)
    own, other = (
        results.value(f"{name}_timeconst", "timeconst", lambda a: 1e3 * a, found[name].timeconst_s, unit="ms")
        for name in ("own-timeconst", "implicitfast")
    )
    softer = ratio(results, "own_softness", "MuJoCo's own timeconst, of that of the other runs", own, other)
    outcome = all_of(*(at_least(longer, 2.0, why="longer by far") for longer in (times, softer)))
    yield Claim("short_steps_lose", outcome, {"least": holds, "shortest": shortest, "own": own, "plain": other})

    before, after = results.row["2ms-implicitfast"].slip_mm, results.row["2ms-term"].slip_mm
    left = share(results, "term_share", "slip with the term put back, of that without", after, before)
    times = ratio(results, "term_gain", "largest step with the term put back, of that without", term, plain)
    outcome = all_of(at_most(left, 10.0, why="most of it is gone"), at_least(times, 2.0, why="a longer step by far"))
    numbers = {"before": before, "after": after, "plain": plain, "term": term}
    yield Claim("term_holds", outcome, numbers)


def _draw(runs: Mapping[str, Sequence[Row]], lost: Quantity) -> Drawing:
    drawing, axes = new_figure(7.2, 4.2)
    for number, (setting, label) in enumerate(DRAWN.items()):
        slips = [(row.step_ms.value, row.slip_mm.value) for row in runs[setting]]
        hollow = {"marker": MARKERS[number], "markerfacecolor": "none", "markersize": 6 + 2 * (number in (1, 2))}
        mark_points(axes, slips, color=COLOURS[setting], label=label, **hollow)
        height = lost.value * 1.25 ** (1 + number)
        gone = [(step, height) for step, slip in slips if slip is None]
        mark_points(axes, gone, marker="x", color=COLOURS[setting])
    line = {"color": INK, "linewidth": 0.8, "marker": ""}
    for number, setting in enumerate(LAWS):
        law = [(row.step_ms.value, row.predicted_slip_mm.value) for row in runs[setting]]
        mark_points(axes, law, linestyle="-", label="" if number else "law", **line)
    axes.axhline(lost.value, linestyle=":", **line)
    axes.set(xscale="log", yscale="log", xlabel="step [ms]", ylabel="slip in the hand [mm]")
    tick_at(axes.xaxis, [float(step) for step in STEPS])
    drawing.legend(loc="outside upper center", ncols=2 if is_narrow() else 4)
    return drawing
