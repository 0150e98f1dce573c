"""A box on a table that turns: does it walk outward as the law says, and what stops it?"""

from collections.abc import Mapping, Sequence
from dataclasses import replace

import pandas as pd
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from measured_report import ROOT
from measured_report.claims.claims import FAILS, Claim, all_of, at_least, at_most, greater
from measured_report.parts.figures import INK, SERIES, is_narrow, new_figure
from measured_report.parts.parts import Download, Figure, Section, Table
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.names import case_html, name_of
from report.shared.arithmetic import cell_count, departure, extreme, size_share

order = 141
page = "cure"
label = "box on a turntable"

ENGINES = {"warp": "MuJoCo Warp", "c": "MuJoCo C"}
BIAS_FILE = ROOT / "assets/fix/contact_bias.py"
NO_HELP = ("noslip", "impratio", "pyramidal")
"""What one would try against sliding."""
CURED = ("term-rk4-impratio", "term-centred-impratio")


VARIANTS = (
    *("plain", "noslip", "impratio", "pyramidal", "euler", "rk4", "half-timeconst", "half-step"),
    *("term", "term-pyramidal", "term-rk4", "term-centred", *CURED),
)
"""In the order of the figure: without the term and with it."""


def derive(results: Results) -> Section:
    resolution = results.chosen(
        "resolution",
        "a place 200 mm from the axis is rounded to 15 nm in single precision; half of it in each step of 2 ms is "
        "0.0019 % of the radius a second, and slower walks are compared by their difference and not as a share",
        2e-3,
        unit="%/s",
    )
    rows = {case: results.row[case] for case in (f"{variant}-{engine}" for variant in VARIANTS for engine in ENGINES)}
    measured = {case: _percent(results, row, "growth_per_s") for case, row in rows.items()}
    law = {case: _percent(results, row, "predicted_growth_per_s") for case, row in rows.items()}
    rates = Figure(
        draw=lambda: _draw(measured, law),
        sources=[row.growth_per_s for row in rows.values()],
        numbers={"plain": measured["plain-warp"], "term": measured["term-warp"]},
    )
    return Section(
        tables={"runs": _table(rows, measured, law)},
        figures={"rates": rates},
        claims=[
            _follows_law(results, measured, law, resolution),
            _same_in_both(results, measured, resolution),
            _no_setting_stops_it(results, measured, resolution),
            _goes_with_timeconst(measured, resolution),
            _term_leaves_step(results, measured, resolution),
            _cured(results, measured, resolution),
        ],
        downloads=[Download(BIAS_FILE.name, BIAS_FILE.read_text(encoding="utf-8"))],
    )


def _percent(results: Results, row: Row, column: str) -> Value:
    formula = f"{column} of {row.case}, in percent of the distance from the axis"
    return results.value(f"{row.case}_{column}", formula, lambda rate: 100 * rate, row[column], unit="%/s")


def _follows_law(results: Results, measured: Mapping[str, Value], law: Mapping[str, Value], resolution: Value) -> Claim:
    there = [case for case in measured if measured[case].value is not None]
    fast = [case for case in there if law[case].value is not None and abs(law[case].value) > resolution.value]
    formula = "growth less that of the law, in size, of the latter"
    shares = [departure(results, f"{case}_off", formula, measured[case], law[case]) for case in fast]
    largest = extreme(results, "law_off", "largest of the departures from the law", max, shares)
    slow = [case for case in there if case not in fast]
    formula = "largest difference from the law, of the runs for which it gives less than the resolution"
    rest = _largest_gap(results, "law_gap", formula, [(measured[case], law[case]) for case in slow])
    count = cell_count(results, "fast_count", "runs for which it gives more", shares)
    bound = results.chosen("law_bound", "the same growth", 0.5, unit="%")
    numbers = {"growth": measured["plain-warp"], "law": law["plain-warp"], "largest": largest, "count": count}
    return Claim(
        "follows_law",
        all_of(at_most(largest, bound), at_most(rest, resolution)),
        numbers=numbers | {"rest": rest, "resolution": resolution},
    )


def _largest_gap(results: Results, name: str, formula: str, pairs: Sequence[tuple[Quantity, Quantity]]) -> Value:
    return results.value(
        name,
        formula,
        lambda *cells: max(abs(a - b) for a, b in zip(cells[::2], cells[1::2], strict=True)),
        *(cell for pair in pairs for cell in pair),
        unit="%/s",
    )


def _same_in_both(results: Results, measured: Mapping[str, Value], resolution: Value) -> Claim:
    pairs = [(measured[f"{variant}-warp"], measured[f"{variant}-c"]) for variant in VARIANTS]
    there = [pair for pair in pairs if pair[0].value is not None]
    largest = _largest_gap(results, "engine_gap", "largest difference between the growths in the two engines", there)
    return Claim("same_in_both", at_most(largest, resolution), numbers={"largest": largest, "resolution": resolution})


def _no_setting_stops_it(results: Results, measured: Mapping[str, Value], resolution: Value) -> Claim:
    """In C, which has noslip in all releases."""
    plain, *found = (measured[f"{variant}-c"] for variant in ("plain", *NO_HELP))
    formula = "change of the growth, in size, of the growth with nothing done"
    changes = [
        departure(results, f"{variant}_change", formula, growth, plain)
        for variant, growth in zip(NO_HELP, found, strict=True)
    ]
    largest = results.value("setting_change", "largest of these changes", max, *changes, unit="%")
    bound = results.chosen("setting_bound", "a remedy would take more of it away", 10.0, unit="%")
    numbers = {"plain": plain, "largest": largest, **dict(zip(NO_HELP, found, strict=True))}
    outcome = all_of(at_most(largest, bound), at_least(plain, resolution))
    if at_least(plain, resolution) == FAILS:
        outcome = replace(outcome, name="unknown", reason="there is no growth to stop")
    return Claim("no_setting_stops_it", outcome, numbers=numbers)


def _goes_with_timeconst(measured: Mapping[str, Value], resolution: Value) -> Claim:
    plain, half = measured["plain-warp"], measured["half-timeconst-warp"]
    outcome = greater(plain, half, noise=resolution)
    return Claim("goes_with_timeconst", outcome, numbers={"plain": plain, "half": half})


def _term_leaves_step(results: Results, measured: Mapping[str, Value], resolution: Value) -> Claim:
    plain, term = measured["plain-warp"], measured["term-warp"]
    none = results.chosen("no_growth", "neither outward nor inward", 0.0, unit="%/s")
    formula = "growth with the term put back, in size, of that with nothing done"
    left = size_share(results, "term_share", formula, term, plain)
    bound = results.chosen("term_bound", "most of it is gone", 10.0, unit="%")
    outcome = all_of(at_most(left, bound), greater(none, term, noise=resolution))
    return Claim("term_leaves_step", outcome, numbers={"plain": plain, "term": term, "share": left})


def _cured(results: Results, measured: Mapping[str, Value], resolution: Value) -> Claim:
    largest = results.value(
        "cured_growth",
        "largest growth, in size, with the term, without the error of the step and with a high impratio",
        lambda *found: max(map(abs, found)),
        *(measured[f"{variant}-{engine}"] for variant in CURED for engine in ENGINES),
        unit="%/s",
    )
    return Claim("cured", at_most(largest, resolution), numbers={"largest": largest, "resolution": resolution})


def _table(rows: Mapping[str, Row], measured: Mapping[str, Value], law: Mapping[str, Value]) -> Table:
    columns = {label: [measured[f"{variant}-{engine}"] for variant in VARIANTS] for engine, label in ENGINES.items()}
    columns["law"] = [law[f"{variant}-c"] for variant in VARIANTS]
    columns["start"] = [rows[f"{variant}-c"].start_radius_mm for variant in VARIANTS]
    columns["end"] = [rows[f"{variant}-c"].end_radius_mm for variant in VARIANTS]
    return Table(pd.DataFrame(columns, index=pd.Index(map(case_html, VARIANTS), name="run")))


def _draw(measured: Mapping[str, Value], law: Mapping[str, Value]) -> Drawing:
    drawing, axes = new_figure(7.2, 0.9 + (0.36 if is_narrow() else 0.27) * len(VARIANTS))
    marks = {"warp": {"marker": "o", "markersize": 9, "markerfacecolor": "none"}, "c": {"marker": "x", "markersize": 6}}
    for number, (engine, label) in enumerate(ENGINES.items()):
        _mark(axes, [measured[f"{variant}-{engine}"] for variant in VARIANTS], label, SERIES[number], **marks[engine])
    _mark(axes, [law[f"{variant}-c"] for variant in VARIANTS], "law", INK, marker="|", markersize=15)
    axes.axvline(0.0, color=INK, linewidth=0.8, marker="")
    axes.set_yticks(range(len(VARIANTS)), map(name_of, VARIANTS))
    axes.invert_yaxis()
    axes.set_xlabel("growth of the distance from the axis [%/s]")
    drawing.legend(loc="outside upper center", ncols=3)
    return drawing


def _mark(axes: Axes, cells: Sequence[Value], label: str, colour: str, **style) -> None:
    """A mark for each cell that there is, in the line of its place."""
    places = [place for place, cell in enumerate(cells) if cell.value is not None]
    values = [cells[place].value for place in places]
    axes.plot(values, places, linestyle="", markevery=1, color=colour, label=label, **style)
