"""Creep as predicted and as measured, in every scene that there is."""

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
import pandas as pd
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claims import Claim, Outcome, all_of, at_least, at_most
from measured_report.parts.figures import FAINT, INK, SERIES, is_narrow, new_figure
from measured_report.parts.parts import Figure, Section, Table
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.names import cases_html
from report.shared.arithmetic import extreme, other_value

order = 184  # after all SCENES, which it reads
page = "scenes"
label = "predicted creep"
leads = True

SCENES = {
    "forecast": "box on a slope",
    "capsule": "pinched capsule",
    "pick": "Panda's grasps",
    "turntable": "box on a turntable",
    "contacts": "shake test",
}
"""Sections whose records have a creep and its prediction."""
COLUMNS = {
    "turntable": ("growth_per_s", "predicted_growth_per_s"),
    "contacts": ("slide_mm", "predicted_slide_mm"),
    "capsule": ("steady_creep_mm_s", "forecast_creep_mm_s"),
}
"""Of what is measured and what is predicted, where they are no creep, or one that comes in jolts as well."""
MARKERS = ("o", "s", "^", "D", "v")
SHAKE_S = 4.0
"""How long the slide of the shake test was watched: two periods of a motion that repeats every second cycle of 1 Hz."""


@dataclass(frozen=True)
class Point:
    """One run of a scene."""

    scene: str
    case: str
    measured: Value
    predicted: Value
    factor: Value
    """By how many times they differ, 1 or more."""


def derive(results: Results) -> Section:
    points = [point for scene in SCENES for point in _points(results, scene)]
    there = [point for point in points if point.factor.value is not None]
    claim = _predicted(results, there)
    figure = Figure(
        draw=lambda: _draw(there),
        sources=[point.measured for point in points],
        numbers={name: claim.numbers[name] for name in ("count", "scenes", "bound")},
    )
    return Section(tables={"scenes": _table(results, there)}, figures={"creep": figure}, claims=[claim])


def _points(results: Results, scene: str) -> Iterator[Point]:
    resolution = other_value(results, "turntable", "resolution", unit="%/s")
    record = results if scene == "forecast" else results.others.get(scene)
    for row in record.rows if record else ():
        found = _creep(results, scene, row, resolution)
        if found is None:
            continue
        measured, predicted = found
        factor = results.value(
            f"{scene}_{row.case}_factor",
            "the larger of measured and predicted creep, of the smaller",
            lambda a, b: max(a / b, b / a),
            measured,
            predicted,
        )
        yield Point(scene, row.case, measured, predicted, factor)


def _below(rate: Quantity, resolution: Quantity) -> bool:
    """Whether a growth [1/s] is too slow for single precision, of which section turntable says what it shows [%/s]."""
    return None not in (rate.value, resolution.value) and 100.0 * abs(rate.value) < resolution.value


def _creep(results: Results, scene: str, row: Row, resolution: Quantity) -> tuple[Value, Value] | None:
    """Measured and predicted [mm/s], in size; None for a row that is about something else, or too slow to be seen."""
    measured_in, predicted_in = COLUMNS.get(scene, ("creep_mm_s", "forecast_creep_mm_s"))
    if any(cell not in row or row[cell].value is None for cell in (measured_in, predicted_in)):
        return None
    if scene == "turntable" and row.backend == "warp" and _below(row[predicted_in], resolution):
        return None
    radius = (row.start_radius_mm,) if scene == "turntable" else ()
    seconds = SHAKE_S if scene == "contacts" else 1.0
    formula = {"turntable": "growth times the distance at the start", "contacts": f"slide by the {SHAKE_S:g} s"}

    def value(kind: str, cell: Quantity) -> Value:
        return results.value(
            f"{scene}_{row.case}_{kind}",
            f"{formula.get(scene, 'creep')}, {kind}",
            lambda a, *by: abs(a * math.prod(by)) / seconds,
            cell,
            *radius,
            unit="mm/s",
        )

    predicted = value("predicted", row[predicted_in])
    return (value("measured", row[measured_in]), predicted) if predicted.value else None


def _count(results: Results, points: list[Point]) -> Value:
    factors = [point.factor for point in points]
    return results.value(
        "point_count", "runs with a creep and a prediction", lambda *found: len(found), *factors, across=True
    )


def _predicted(results: Results, points: list[Point]) -> Claim:
    formula = "largest factor between measured and predicted creep"
    largest = results.value("largest_factor", formula, max, *(point.factor for point in points), across=True)
    bound = results.chosen("factor_bound", "a prediction to go by", 1.5)
    fast, slow = (
        results.value(
            f"{name}_creep",
            f"{name} creep measured",
            choose,
            *(point.measured for point in points),
            across=True,
            unit="mm/s",
        )
        for name, choose in (("fastest", max), ("slowest", min))
    )
    decades = results.value(
        "decades", "powers of ten between fastest and slowest", lambda a, b: math.log10(a / b), fast, slow
    )
    least = results.chosen("least_decades", "a range to test it over", 3.0)
    outside = [point.case for point in points if point.factor.value > bound.value]
    formula = "scenes that these runs are of"
    factors = [point.factor for point in points]
    names = {point.scene for point in points}
    scenes = results.value("scene_count", formula, lambda *_: len(names), *factors, across=True)
    numbers: dict[str, Any] = {"largest": largest, "bound": bound, "count": _count(results, points), "scenes": scenes}
    numbers |= {"fast": fast, "slow": slow, "outside": cases_html(outside)}
    outcome = all_of(at_most(largest, bound), at_least(decades, least))
    if missing := [label for scene, label in SCENES.items() if scene not in names]:
        outcome = Outcome("unknown", f"nothing is there of: {', '.join(missing)}").having_read(largest, decades)
    return Claim("predicted", outcome, numbers)


def _table(results: Results, points: list[Point]) -> Table:
    lines: dict[str, Mapping[str, object]] = {}
    for scene, label in SCENES.items():
        mine = [point for point in points if point.scene == scene]
        if not mine:
            continue
        lines[label] = {
            "runs": results.value(
                f"{scene}_count", "runs", lambda *found: len(found), *(point.factor for point in mine)
            ),
            "slowest": extreme(results, f"{scene}_slowest", "slowest creep", min, [point.measured for point in mine]),
            "fastest": extreme(results, f"{scene}_fastest", "fastest creep", max, [point.measured for point in mine]),
            "largest factor": extreme(
                results, f"{scene}_largest", "largest factor", max, [point.factor for point in mine]
            ),
        }
    return Table(pd.DataFrame(lines).T.rename_axis("scene"))


def _draw(points: list[Point]) -> Drawing:
    drawing, axes = new_figure(7.2, 4.6)
    ends = [cell.value for point in points for cell in (point.measured, point.predicted)]
    line = np.array([min(ends) / 2.0, max(ends) * 2.0])
    axes.fill_between(line, line / 1.5, line * 1.5, color=FAINT, linewidth=0.0, alpha=0.6)
    axes.plot(line, line, color=INK, linewidth=0.8, marker="")
    for number, (scene, label) in enumerate(SCENES.items()):
        mine = [point for point in points if point.scene == scene]
        axes.plot(
            [point.predicted.value for point in mine],
            [point.measured.value for point in mine],
            linestyle="",
            marker=MARKERS[number],
            markerfacecolor="none",
            markersize=7,
            markevery=1,
            color=SERIES[number],
            label=label,
        )
    axes.set(xscale="log", yscale="log", xlabel="creep predicted [mm/s]", ylabel="creep measured [mm/s]")
    drawing.legend(loc="outside upper center", ncols=2 if is_narrow() else 3)
    return drawing
