"""Compare the measured creep with the predicted one, in all scenes."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from report.shared import (
    HOLDS,
    Claim,
    Figure,
    Outcome,
    Results,
    Section,
    Sections,
    Value,
    all_of,
    at_least,
    at_most,
    cell_count,
    combined,
    constant,
)
from report.shared.drawing import (
    FAINT,
    INK,
    SERIES,
    Drawing,
    is_narrow,
    mark_points,
    new_figure,
)

SCENES = {  # scenes with a measured and a predicted creep
    "slope": "box on a slope",
    "capsule": "pinched capsule",
    "pick": "Panda's grasps",
    "turntable": "box on a turntable",
    "contacts": "shake test",
}
OTHERS = {
    "turntable": "cure",
    "contacts": "contacts",
}  # the sections that have their rows
# Columns with the measured and predicted motion, for scenes without a column of plain
# creep, or with jolts in it.
COLUMNS = {
    "turntable": ("growth_per_s", "predicted_growth_per_s"),
    "contacts": ("slide_mm", "predicted_slide_mm"),
    "capsule": ("steady_creep_mm_s", "forecast_creep_mm_s"),
}
MARKERS = ("o", "s", "^", "D", "v")
# The slide was recorded for two periods of the shake, each of two cycles of 1 s.
SHAKE_S = 4.0


class Point(NamedTuple):
    """Holds one run of a scene."""

    scene: str
    measured: Value
    predicted: Value
    factor: Value  # ratio of the larger to the smaller


def derive(results: Results) -> Section:
    points = [point for scene in SCENES for point in _points(results, scene)]
    predicted = [point for point in points if point.factor.value is not None]
    factors = [point.factor for point in predicted]
    measured = [point.measured for point in predicted]
    names = {point.scene for point in predicted}
    largest = results.value(
        "largest_factor",
        "largest factor between measured and predicted creep",
        combined(max, *factors),
        across=True,
    )
    fast = results.value(
        "fastest_creep", "fastest measured creep", combined(max, *measured), across=True
    )
    slow = results.value(
        "slowest_creep", "slowest measured creep", combined(min, *measured), across=True
    )
    spanned = results.value("creep_range", "fastest over slowest creep", fast / slow)
    count = results.value(
        "point_count",
        "runs with a measured and a predicted creep",
        cell_count(factors),
        across=True,
    )
    scenes = results.value(
        "scene_count",
        "scenes of these runs",
        lambda *_: len(names),
        *factors,
        across=True,
    )
    bound = results.chosen("factor_bound", "a useful prediction", 1.5)
    outcome = all_of(
        at_most(largest, bound),
        at_least(spanned, 1000.0, "a range wide enough to test it"),
    )
    if missing := [label for scene, label in SCENES.items() if scene not in names]:
        outcome = Outcome(
            "unknown", f"these scenes were not measured: {', '.join(missing)}"
        )
        outcome = outcome.having_read(largest, spanned)
    counts = {"count": count, "scenes": scenes}
    figure = Figure(
        lambda: _draw(predicted),
        [point.measured for point in points],
        {**counts, "bound": bound, "predicted": outcome == HOLDS},
    )
    numbers = {"largest": largest, **counts, "fast": fast, "slow": slow}
    claim = Claim("predicted", outcome, numbers)
    return Section(figures={"creep": figure}, claims=[claim])


def _points(results: Results, scene: str) -> Iterator[Point]:
    """Derive the measured and the predicted creep [mm/s] of runs whose creep is
    measurable. Both are absolute values.
    """
    resolution = Sections(results.others).value("cure", "resolution").value or 0.0
    columns = COLUMNS.get(scene, ("creep_mm_s", "forecast_creep_mm_s"))
    if scene in OTHERS:
        source = results.others.get(OTHERS[scene])
        rows = source.rows if source else []
    else:
        rows = [row for row in results.rows if row.scene == scene]
    for row in rows:
        if any(column not in row or row[column].value is None for column in columns):
            continue
        measured, predicted = (row[column] for column in columns)
        words = "creep"
        if scene == "turntable":
            # Single precision does not resolve a smaller growth; see section cure.
            if row.backend == "warp" and 100.0 * abs(predicted.value) < resolution:
                continue
            words = "growth times the distance at the start"
            measured, predicted = (
                cell * row.start_radius_mm for cell in (measured, predicted)
            )
        if scene == "contacts":
            words = f"slide by the {SHAKE_S:g} s"
            measured, predicted = (
                cell * (1 / constant(SHAKE_S, "s")) for cell in (measured, predicted)
            )
        if not predicted.value:
            continue
        name = f"{scene}_{row.case}"
        measured = results.value(
            f"{name}_measured", f"{words}, measured", abs(measured)
        )
        predicted = results.value(
            f"{name}_predicted", f"{words}, predicted", abs(predicted)
        )
        factor = results.value(
            f"{name}_factor",
            "ratio of measured and predicted creep, the larger over the smaller",
            combined(max, measured / predicted, predicted / measured),
        )
        yield Point(scene, measured, predicted, factor)


def _draw(points: list[Point]) -> Drawing:
    drawing, axes = new_figure(7.2, 4.6)
    ends = [
        cell.value for point in points for cell in (point.measured, point.predicted)
    ]
    line = np.array([min(ends) / 2.0, max(ends) * 2.0])
    axes.fill_between(line, line / 1.5, line * 1.5, color=FAINT, linewidth=0, alpha=0.6)
    axes.plot(line, line, color=INK, linewidth=0.8, marker="")
    for number, (scene, label) in enumerate(SCENES.items()):
        creeps = [
            (point.predicted.value, point.measured.value)
            for point in points
            if point.scene == scene
        ]
        mark_points(
            axes,
            creeps,
            color=SERIES[number],
            label=label,
            marker=MARKERS[number],
            markerfacecolor="none",
            markersize=7,
        )
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="predicted creep [mm/s]",
        ylabel="measured creep [mm/s]",
    )
    drawing.legend(loc="outside upper center", ncols=2 if is_narrow() else 3)
    return drawing
