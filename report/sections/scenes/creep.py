"""The creep predicted and measured, in every scene that there is."""

from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np
from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import FAINT, INK, SERIES, is_narrow, new_figure
from report.shared import (
    HOLDS,
    Claim,
    Figure,
    Outcome,
    Quantity,
    Results,
    Section,
    Value,
    all_of,
    at_least,
    at_most,
    cell_count,
    combined,
    constant,
    other_value,
)
from report.shared.drawing import mark_points

SCENES = {  # scenes that have a creep and its prediction
    "slope": "box on a slope",
    "capsule": "pinched capsule",
    "pick": "Panda's grasps",
    "turntable": "box on a turntable",
    "contacts": "shake test",
}
OTHERS = {
    "turntable": "cure",
    "contacts": "contacts",
}  # sections that have the rows of a scene, if another one
COLUMNS = {  # columns measured and predicted, where they are no creep, or one that comes in jolts as well
    "turntable": ("growth_per_s", "predicted_growth_per_s"),
    "contacts": ("slide_mm", "predicted_slide_mm"),
    "capsule": ("steady_creep_mm_s", "forecast_creep_mm_s"),
}
MARKERS = ("o", "s", "^", "D", "v")
SHAKE_S = 4.0  # how long the slide was watched: two periods of a motion that repeats every second cycle


class Point(NamedTuple):
    """One run of a scene."""

    scene: str
    measured: Value
    predicted: Value
    factor: Value  # ratio of the larger to the smaller


def derive(results: Results) -> Section:
    points = [point for scene in SCENES for point in _points(results, scene)]
    predicted = [point for point in points if point.factor.value is not None]
    claim = _predicted(results, predicted)
    numbers = {name: claim.numbers[name] for name in ("count", "scenes", "bound")}
    numbers["predicted"] = claim.outcome == HOLDS
    figure = Figure(
        lambda: _draw(predicted), [point.measured for point in points], numbers
    )
    return Section(figures={"creep": figure}, claims=[claim])


def _points(results: Results, scene: str) -> Iterator[Point]:
    """Derive measured and predicted creep [mm/s], in size, of the runs of a scene in which it would be seen."""
    least = other_value(results, "cure", "resolution").value
    columns = COLUMNS.get(scene, ("creep_mm_s", "forecast_creep_mm_s"))
    words = {
        "turntable": "growth times the distance at the start",
        "contacts": f"slide by the {SHAKE_S:g} s",
    }
    other = results.others.get(OTHERS[scene]) if scene in OTHERS else None
    for row in (
        other.rows if other else (row for row in results.rows if row.scene == scene)
    ):
        if any(column not in row or row[column].value is None for column in columns):
            continue
        # a growth [1/s] may be below what single precision shows, as that section has it [%/s].
        if (
            scene == "turntable"
            and row.backend == "warp"
            and 100.0 * abs(row[columns[1]].value) < (least or 0.0)
        ):
            continue
        scale: Quantity | float = row.start_radius_mm if scene == "turntable" else 1.0
        scale = 1 / constant(SHAKE_S, "s") if scene == "contacts" else scale
        creeps = dict(
            zip(
                ("measured", "predicted"),
                (abs(row[column] * scale) for column in columns),
                strict=True,
            )
        )
        if creeps["predicted"].value:
            name, formula = f"{scene}_{row.case}", words.get(scene, "creep")
            values = [
                results.value(f"{name}_{kind}", f"{formula}, {kind}", creep)
                for kind, creep in creeps.items()
            ]
            measured, predicted = values
            factor = combined(max, measured / predicted, predicted / measured)
            yield Point(
                scene,
                measured,
                predicted,
                results.value(
                    f"{name}_factor",
                    "the larger of measured and predicted creep, of the smaller",
                    factor,
                ),
            )


def _predicted(results: Results, points: list[Point]) -> Claim:
    factors, measured = (
        [point.factor for point in points],
        [point.measured for point in points],
    )
    largest = results.value(
        "largest_factor",
        "largest factor between measured and predicted creep",
        combined(max, *factors),
        across=True,
    )
    bound = results.chosen("factor_bound", "a prediction to go by", 1.5)
    fast = results.value(
        "fastest_creep", "fastest creep measured", combined(max, *measured), across=True
    )
    slow = results.value(
        "slowest_creep", "slowest creep measured", combined(min, *measured), across=True
    )
    spanned = results.value(
        "creep_range", "the first of these over the second", fast / slow
    )
    names, formula = (
        {point.scene for point in points},
        "runs with a creep and a prediction",
    )
    count = results.value("point_count", formula, cell_count(factors), across=True)
    scenes = results.value(
        "scene_count",
        "scenes that these runs are of",
        lambda *_: len(names),
        *factors,
        across=True,
    )
    outcome = all_of(
        at_most(largest, bound),
        at_least(spanned, 1000.0, why="a range to test it over"),
    )
    if missing := [label for scene, label in SCENES.items() if scene not in names]:
        outcome = Outcome(
            "unknown", f"nothing is there of: {', '.join(missing)}"
        ).having_read(largest, spanned)
    numbers: dict[str, Any] = {
        "largest": largest,
        "bound": bound,
        "count": count,
        "scenes": scenes,
    }
    return Claim("predicted", outcome, numbers | {"fast": fast, "slow": slow})


def _draw(points: list[Point]) -> Drawing:
    drawing, axes = new_figure(7.2, 4.6)
    ends = [
        cell.value for point in points for cell in (point.measured, point.predicted)
    ]
    line = np.array([min(ends) / 2.0, max(ends) * 2.0])
    axes.fill_between(
        line, line / 1.5, line * 1.5, color=FAINT, linewidth=0.0, alpha=0.6
    )
    axes.plot(line, line, color=INK, linewidth=0.8, marker="")
    for number, (scene, label) in enumerate(SCENES.items()):
        creeps = [
            (point.predicted.value, point.measured.value)
            for point in points
            if point.scene == scene
        ]
        hollow = {"marker": MARKERS[number], "markerfacecolor": "none", "markersize": 7}
        mark_points(axes, creeps, color=SERIES[number], label=label, **hollow)
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="creep predicted [mm/s]",
        ylabel="creep measured [mm/s]",
    )
    drawing.legend(loc="outside upper center", ncols=2 if is_narrow() else 3)
    return drawing
