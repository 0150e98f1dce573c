"""A box on a table that turns: does it walk outward as the law says, and what stops it?"""

from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import chain
from typing import Any

from matplotlib.figure import Figure as Drawing

from measured_report import ROOT
from measured_report.claims.claim import FAILS, Claim, all_of, at_least, at_most, greater
from measured_report.parts.figures import INK, SERIES, is_narrow, new_figure
from measured_report.parts.section import Download, Figure, Section
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.names import case_html, name_of
from report.shared.arithmetic import Column, cell_count, departure, extreme, largest_size, size_share, table_of
from report.shared.drawing import mark_cells, name_lines

order = 141
page = "cure"
label = "box on a turntable"

ENGINES = {"warp": "MuJoCo Warp", "c": "MuJoCo C"}
BIAS_FILE = ROOT / "assets/fix/contact_bias.py"
NO_HELP = ("noslip", "impratio", "pyramidal")
"""What one would try against sliding."""
CURED = ("term-rk4-impratio", "term-centred-impratio")
VARIANTS: tuple[str, ...] = ("plain", *NO_HELP, "euler", "rk4", "half-timeconst", "half-step")
VARIANTS += ("term", "term-pyramidal", "term-rk4", "term-centred", *CURED)
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
    measured, law = (
        {case: _percent(results, row, column) for case, row in rows.items()}
        for column in ("growth_per_s", "predicted_growth_per_s")
    )
    columns: dict[str, Column] = {label: _of_engine(measured, engine) for engine, label in ENGINES.items()}
    columns |= {"law": _of_engine(law, "c"), "start": "start_radius_mm", "end": "end_radius_mm"}
    numbers = {"plain": measured["plain-warp"], "term": measured["term-warp"]}
    rates = Figure(lambda: _draw(measured, law), [row.growth_per_s for row in rows.values()], numbers)
    return Section(
        tables={"runs": table_of("run", map(case_html, VARIANTS), columns, _of_engine(rows, "c"))},
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


def _of_engine(found: Mapping[str, Any], engine: str) -> list:
    return [found[f"{variant}-{engine}"] for variant in VARIANTS]


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
    numbers = {"growth": measured["plain-warp"], "law": law["plain-warp"], "largest": largest, "rest": rest}
    numbers |= {"count": cell_count(results, "fast_count", "runs for which it gives more", shares)}
    outcome = all_of(at_most(largest, 0.5, why="the same growth"), at_most(rest, resolution))
    return Claim("follows_law", outcome, numbers | {"resolution": resolution})


def _largest_gap(results: Results, name: str, formula: str, pairs: Sequence[tuple[Quantity, Quantity]]) -> Value:
    def largest(*found: float) -> float:
        return max(abs(a - b) for a, b in zip(found[::2], found[1::2], strict=True))

    return results.value(name, formula, largest, *chain.from_iterable(pairs), unit="%/s")


def _same_in_both(results: Results, measured: Mapping[str, Value], resolution: Value) -> Claim:
    pairs = zip(*(_of_engine(measured, engine) for engine in ENGINES), strict=True)
    there = [pair for pair in pairs if pair[0].value is not None]
    largest = _largest_gap(results, "engine_gap", "largest difference between the growths in the two engines", there)
    return Claim("same_in_both", at_most(largest, resolution), {"largest": largest})


def _no_setting_stops_it(results: Results, measured: Mapping[str, Value], resolution: Value) -> Claim:
    """In C, which has noslip in all releases."""
    plain, formula = measured["plain-c"], "change of the growth, in size, of the growth with nothing done"
    found = {variant: measured[f"{variant}-c"] for variant in NO_HELP}
    changes = [departure(results, f"{variant}_change", formula, growth, plain) for variant, growth in found.items()]
    largest = results.value("setting_change", "largest of these changes", max, *changes, unit="%")
    there = at_least(plain, resolution)
    outcome = all_of(at_most(largest, 10.0, why="a remedy would take more of it away"), there)
    if there == FAILS:
        outcome = replace(outcome, name="unknown", reason="there is no growth to stop")
    return Claim("no_setting_stops_it", outcome, {"plain": plain, "largest": largest, **found})


def _goes_with_timeconst(measured: Mapping[str, Value], resolution: Value) -> Claim:
    plain, half = measured["plain-warp"], measured["half-timeconst-warp"]
    return Claim("goes_with_timeconst", greater(plain, half, noise=resolution), {"plain": plain, "half": half})


def _term_leaves_step(results: Results, measured: Mapping[str, Value], resolution: Value) -> Claim:
    plain, term = measured["plain-warp"], measured["term-warp"]
    formula = "growth with the term put back, in size, of that with nothing done"
    left = size_share(results, "term_share", formula, term, plain)
    inward = greater(0.0, term, noise=resolution, why="neither outward nor inward")
    outcome = all_of(at_most(left, 10.0, why="most of it is gone"), inward)
    return Claim("term_leaves_step", outcome, {"plain": plain, "term": term, "share": left})


def _cured(results: Results, measured: Mapping[str, Value], resolution: Value) -> Claim:
    formula = "largest growth, in size, with the term, without the error of the step and with a high impratio"
    growths = (measured[f"{variant}-{engine}"] for variant in CURED for engine in ENGINES)
    largest = largest_size(results, "cured_growth", formula, growths, unit="%/s")
    return Claim("cured", at_most(largest, resolution), {"largest": largest, "resolution": resolution})


def _draw(measured: Mapping[str, Value], law: Mapping[str, Value]) -> Drawing:
    drawing, axes = new_figure(7.2, 0.9 + (0.36 if is_narrow() else 0.27) * len(VARIANTS))
    marks = {"warp": {"marker": "o", "markersize": 9, "markerfacecolor": "none"}, "c": {"marker": "x", "markersize": 6}}
    for number, (engine, label) in enumerate(ENGINES.items()):
        mark_cells(axes, _of_engine(measured, engine), SERIES[number], label, **marks[engine])
    mark_cells(axes, _of_engine(law, "c"), INK, "law", marker="|", markersize=15)
    axes.axvline(0.0, color=INK, linewidth=0.8, marker="")
    name_lines(axes, map(name_of, VARIANTS))
    axes.set_xlabel("growth of the distance from the axis [%/s]")
    drawing.legend(loc="outside upper center", ncols=3)
    return drawing
