"""A hand that swings a capsule: up to which step does it hold, and is it the law of the creep that ends it?"""

from collections.abc import Mapping, Sequence

import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claims import Claim, all_of, at_least, at_most
from measured_report.parts.figures import INK, SERIES, is_narrow, new_figure, tick_at
from measured_report.parts.parts import Figure, Section, Table
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.names import case_html
from report.shared.arithmetic import cell_count, departure, extreme, ratio, share

order = 183
page = "scenes"
label = "a firm grasp"

STEPS = ("0.5", "1", "2", "4", "8", "16", "32", "64")
"""In ms, as cases have them."""
CREEPING = ("implicitfast", "euler", "rk4", "pyramidal", "own-timeconst", "warp", "through-newton")
SETTINGS = (*CREEPING, "term")
ALIKE = ("euler", "warp", "through-newton")
"""Settings that should change nothing."""
DRAWN = {
    "implicitfast": "MuJoCo C",
    "warp": "MuJoCo Warp",
    "through-newton": "through Newton",
    "rk4": "C, RK4",
    "own-timeconst": "C, MuJoCo's own timeconst",
    "term": "C, term put back",
}
LAWS = ("implicitfast", "rk4", "own-timeconst")
"""Those of the drawn settings that the law tells apart."""
MARKERS = ("o", "s", "D", "^", "v", "P")


def derive(results: Results) -> Section:
    found = {setting: results.row[setting] for setting in SETTINGS}
    runs = {setting: [results.row[f"{step}ms-{setting}"] for step in STEPS] for setting in SETTINGS}
    least = {setting: _least_step(results, setting, rows) for setting, rows in runs.items()}
    plain = results.row["2ms-implicitfast"]
    figure = Figure(
        draw=lambda: _draw(runs, found["implicitfast"].lost_mm),
        sources=[row.slip_mm for rows in runs.values() for row in rows],
        numbers={"lost": found["implicitfast"].lost_mm, "plain": plain.slip_mm, "step": plain.step_ms},
    )
    return Section(
        tables={"settings": _table(results, found, least)},
        figures={"slips": figure},
        claims=[
            _is_firm(results, plain),
            _lost_by_creep(results, found),
            _slip_by_law(results, runs),
            _softer_with_the_step(results),
            _rk4_halves(results, found),
            _short_steps_lose(results, found, least["own-timeconst"]),
            _term_holds(results, found),
            _same_in_all_engines(results, found),
        ],
    )


def _least_step(results: Results, setting: str, runs: Sequence[Row]) -> Value:
    held = [row.step_ms for row in runs if row.slip_mm.value is not None]
    return extreme(results, f"{setting}_least_step", "shortest step tried that holds", min, held)


def _is_firm(results: Results, plain: Row) -> Claim:
    times = ratio(results, "firmness", "sum of the normal forces, of the weight", plain.normal_force_n, plain.weight_n)
    bound = results.chosen("firm_bound", "friction of 1 could carry many times the weight", 10.0)
    numbers = {"force": plain.normal_force_n, "weight": plain.weight_n}
    return Claim("is_firm", at_least(times, bound), numbers)


def _lost_by_creep(results: Results, found: Mapping[str, Row]) -> Claim:
    formula = "largest step that holds less that of the law, in size, of the latter"
    off = [
        departure(
            results, f"{name}_step_off", formula, found[name].largest_step_ms, found[name].predicted_largest_step_ms
        )
        for name in CREEPING
    ]
    largest = extreme(results, "step_off", "largest of the departures from the law's largest step", max, off)
    bound = results.chosen("step_bound", "near enough to choose a step by", 20.0, unit="%")
    count = cell_count(results, "creeping_count", "settings with such a step", off)
    plain = found["implicitfast"]
    numbers = {"largest": plain.largest_step_ms, "law": plain.predicted_largest_step_ms, "count": count, "off": largest}
    return Claim("lost_by_creep", at_most(largest, bound), numbers)


def _slip_by_law(results: Results, runs: Mapping[str, Sequence[Row]]) -> Claim:
    """In all runs that hold and are not cured of it."""
    held = [row for name in CREEPING for row in runs[name] if row.slip_mm.value is not None]
    formula = "slip less that of the law, in size, of the latter"
    off = [departure(results, f"{row.case}_off", formula, row.slip_mm, row.predicted_slip_mm) for row in held]
    largest = extreme(results, "slip_off", "largest of the departures from the law's slip", max, off)
    bound = results.chosen("slip_bound", "the same slip", 10.0, unit="%")
    count = cell_count(results, "held_count", "runs that hold", off)
    plain = results.row["8ms-implicitfast"]
    numbers = {"count": count, "largest": largest, "slip": plain.slip_mm, "law": plain.predicted_slip_mm}
    return Claim("slip_by_law", at_most(largest, bound), numbers)


def _softer_with_the_step(results: Results) -> Claim:
    """Less slip with longer steps up to half the timeconst, and from there on slip in proportion to the step."""
    short, middle, long = (results.row[f"{step}ms-implicitfast"] for step in ("0.5", "2", "8"))
    less = share(
        results,
        "short_step_share",
        "slip at half the timeconst, of that at a short step",
        middle.slip_mm,
        short.slip_mm,
    )
    most = results.chosen("short_step_bound", "less", 90.0, unit="%")
    times = ratio(
        results, "slip_growth", "slip with a long step, of that at half the timeconst", long.slip_mm, middle.slip_mm
    )
    steps = ratio(results, "step_growth", "the long step, of half the timeconst", long.step_ms, middle.step_ms)
    off = departure(
        results, "growth_off", "growth of the slip less that of the step, in size, of the latter", times, steps
    )
    bound = results.chosen("growth_bound", "in proportion", 10.0, unit="%")
    numbers = {"times": times, "steps": steps}
    for name, row in (("short", short), ("middle", middle), ("long", long)):
        numbers |= {name: row.slip_mm, f"{name}_step": row.step_ms}
    return Claim("softer_with_the_step", all_of(at_most(less, most), at_most(off, bound)), numbers)


def _rk4_halves(results: Results, found: Mapping[str, Row]) -> Claim:
    rk4, plain = found["rk4"].largest_step_ms, found["implicitfast"].largest_step_ms
    part = share(results, "rk4_share", "largest step with RK4, of that with implicitfast", rk4, plain)
    bound = results.chosen("rk4_bound", "about half", 60.0, unit="%")
    return Claim("rk4_halves", at_most(part, bound), {"rk4": rk4, "plain": plain, "share": part})


def _short_steps_lose(results: Results, found: Mapping[str, Row], least: Value) -> Claim:
    """With MuJoCo's own timeconst, which is longer, the least step that holds is not the shortest that was tried."""
    shortest = results.row["0.5ms-own-timeconst"].step_ms
    times = ratio(results, "own_step_ratio", "least step tried that holds, of the shortest", least, shortest)
    bound = results.chosen("own_bound", "longer by far", 2.0)
    own, plain = (
        results.value(f"{name}_timeconst", "timeconst", lambda a: 1e3 * a, found[name].timeconst_s, unit="ms")
        for name in ("own-timeconst", "implicitfast")
    )
    softer = ratio(results, "own_softness", "MuJoCo's own timeconst, of that of the other runs", own, plain)
    numbers = {"least": least, "shortest": shortest, "own": own, "plain": plain}
    return Claim("short_steps_lose", all_of(at_least(times, bound), at_least(softer, bound)), numbers)


def _term_holds(results: Results, found: Mapping[str, Row]) -> Claim:
    """Without its cause the creep is gone, and a longer step holds."""
    before, after = results.row["2ms-implicitfast"].slip_mm, results.row["2ms-term"].slip_mm
    left = share(results, "term_share", "slip with the term put back, of that without", after, before)
    bound = results.chosen("term_bound", "most of it is gone", 10.0, unit="%")
    plain, term = found["implicitfast"].largest_step_ms, found["term"].largest_step_ms
    times = ratio(results, "term_gain", "largest step with the term put back, of that without", term, plain)
    least = results.chosen("term_gain_bound", "a longer step by far", 2.0)
    numbers = {"before": before, "after": after, "share": left, "plain": plain, "term": term, "times": times}
    return Claim("term_holds", all_of(at_most(left, bound), at_least(times, least)), numbers)


def _same_in_all_engines(results: Results, found: Mapping[str, Row]) -> Claim:
    plain, slip = found["implicitfast"].largest_step_ms, results.row["8ms-implicitfast"].slip_mm
    formula = "less that in C with implicitfast, in size, of the latter"
    steps, slips = (
        extreme(
            results,
            f"engine_{name}",
            f"largest of the departures of the {name}",
            max,
            [
                departure(results, f"{setting}_{name}", f"{name} {formula}", cell, own)
                for setting, cell in cells.items()
            ],
        )
        for name, own, cells in (
            ("step", plain, {setting: found[setting].largest_step_ms for setting in ALIKE}),
            ("slip", slip, {setting: results.row[f"8ms-{setting}"].slip_mm for setting in ALIKE}),
        )
    )
    bound = results.chosen("engine_bound", "what the search for the step resolves", 1.0, unit="%")
    numbers = {"steps": steps, "slips": slips, "bound": bound}
    return Claim("same_in_all_engines", all_of(at_most(steps, bound), at_most(slips, bound)), numbers)


def _table(results: Results, found: Mapping[str, Row], least: Mapping[str, Value]) -> Table:
    columns: dict[str, list] = {
        "holds from": [least[name] for name in SETTINGS],
        "up to": [row.largest_step_ms for row in found.values()],
        "by the law": [found[name].predicted_largest_step_ms if name in CREEPING else "" for name in SETTINGS],
    }
    for step in ("2", "8"):
        columns[f"slip with {step} ms"] = [results.row[f"{step}ms-{name}"].slip_mm for name in SETTINGS]
    return Table(pd.DataFrame(columns, index=pd.Index(map(case_html, SETTINGS), name="setting")))


def _draw(runs: Mapping[str, Sequence[Row]], lost: Quantity) -> Drawing:
    drawing, axes = new_figure(7.2, 4.2)
    for number, (setting, label) in enumerate(DRAWN.items()):
        held = [row for row in runs[setting] if row.slip_mm.value is not None]
        gone = [row.step_ms.value for row in runs[setting] if row.slip_mm.value is None]
        _line(axes, held, number, label)
        height = lost.value * 1.25 ** (1 + number)
        axes.plot(gone, [height] * len(gone), linestyle="", marker="x", markevery=1, color=SERIES[number])
    for number, setting in enumerate(LAWS):
        held = [row for row in runs[setting] if row.predicted_slip_mm.value is not None]
        axes.plot(
            [row.step_ms.value for row in held],
            [row.predicted_slip_mm.value for row in held],
            color=INK,
            linewidth=0.8,
            linestyle="-",
            marker="",
            label="" if number else "law",
        )
    axes.axhline(lost.value, color=INK, linewidth=0.8, linestyle=":", marker="")
    axes.set(xscale="log", yscale="log", xlabel="step [ms]", ylabel="slip in the hand [mm]")
    tick_at(axes.xaxis, [float(step) for step in STEPS])
    drawing.legend(loc="outside upper center", ncols=2 if is_narrow() else 4)
    return drawing


def _line(axes: Axes, held: Sequence[Row], number: int, label: str) -> None:
    axes.plot(
        [row.step_ms.value for row in held],
        [row.slip_mm.value for row in held],
        linestyle="",
        marker=MARKERS[number],
        markerfacecolor="none",
        markersize=6 + 2 * (number in (1, 2)),
        markevery=1,
        color=SERIES[number],
        label=label,
    )
