"""Draw slip against run time, with one line over the time steps for each remedy."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import islice
from typing import NamedTuple

from matplotlib.axes import Axes

from report.sections import step_cost
from report.sections.time_step.ladder import NEWTON, RULE
from report.shared import (
    FRAME_RATE,
    HOLDS,
    Figure,
    Quantity,
    Row,
    Sections,
    absent,
    all_of,
    at_least,
    at_most,
    is_held,
    worlds_name,
)
from report.shared.drawing import (
    CURE,
    INK,
    SERIES,
    SHIPPED,
    STIFF,
    Drawing,
    is_narrow,
    mark_points,
    name_ends,
    new_figure,
    tick_at,
    write,
    write_beside,
)
from report.story.frontier import ALONE, BOUNDS, MANY, SETUPS

GREY = SERIES[5]
"""The colour of lines that another line beats at the same run time."""
OTHERS = (
    "Kamino, DVI",
    "Steel",
    "Kamino",
)  # the first of these solvers that was timed is drawn


@dataclass(frozen=True)
class Line:
    """Runs of one remedy at several time steps."""

    name: str
    setting: str  # of section time_step
    pads: str  # of section time_step
    cost: str  # setting of section step_cost
    colour: str
    marker: str
    worlds: int = ALONE

    @property
    def label(self) -> str:
        if self.worlds == ALONE:
            return self.name
        return f"{self.name}, {worlds_name(self.worlds)}"


BY_RULE = Line("stiff pads by the rule", NEWTON, RULE, step_cost.STIFF, STIFF, "D")
ROOT_CURE = Line("the root cure, stiff pads", "cure", RULE, "cure", CURE, "o")
FIXED = "stiff pads, the same at each step"
LINES = (
    Line("shipped pads", NEWTON, "shipped", step_cost.STIFF, SHIPPED, "o"),
    Line(FIXED, NEWTON, "stiff", step_cost.STIFF, GREY, "s"),
    BY_RULE,
    Line("RK4", "rk4", RULE, "rk4", GREY, "^"),
    ROOT_CURE,
    replace(BY_RULE, worlds=MANY),
    replace(ROOT_CURE, worlds=MANY),
)
RULE_ID = "line-by-rule"  # in the SVG; assets/step.js finds the line by it
IN_C = Line("MuJoCo C", "c", RULE, "", SERIES[4], "v")


class Point(NamedTuple):
    """Holds one run: its run time, its slip [mm] and its step [ms]."""

    time: Quantity
    slip: Quantity
    step: Quantity


def figure(sections: Sections) -> Figure:
    """Draw the slip in the whole shake against the time of a frame."""
    lines = {line: _points(sections, line) for line in LINES}
    in_c = _points_in_c(sections)
    shipped = next(
        (
            row.frame_ms
            for row in sections.rows("step_cost")
            if (row.case, row.plain["worlds"]) == ("as-shipped", ALONE)
        ),
        absent("ms", "section step_cost was not measured"),
    )
    solver = _other_solver(sections)
    bounds = [sections.value(*place) for place in BOUNDS.values()]
    points = [point for line in (*lines.values(), in_c) for point in line]
    cells = [cell for point in points for cell in point]
    if solver:
        cells += [shipped, *solver[1:]]
    gain = sections.value("reproduction", "stiff_gain")
    stiff = SETUPS[1].slip(sections)
    is_cut = all_of(
        at_least(gain, 10.0, "an order of magnitude"), at_most(stiff, bounds[0])
    )
    known = [bound for bound in bounds if bound.value is not None]

    def draw() -> Drawing:
        drawing, axes = _draw(lines, in_c, known)
        if solver and shipped.value is not None:
            name, slip, ratio = solver
            place = (shipped.number * ratio.number, slip.number)
            mark_points(axes, [place], color=INK, marker="*", markersize=9)
            write_beside(
                axes,
                name,
                place,
                (-8, 0),
                color=INK,
                ha="right",
                va="center",
                fontsize=9,
            )
        return drawing

    numbers = {"gain": gain, "is_cut": is_cut == HOLDS}
    return Figure(draw, [*cells, *bounds], numbers)


def _other_solver(sections: Sections) -> tuple[str, Quantity, Quantity] | None:
    """Return the name, the slip and the relative run time of another solver of Newton."""
    setups = {setup.name: setup for setup in SETUPS}
    for name in OTHERS:
        ratio = setups[name].ratios(sections).get(ALONE)
        slip = setups[name].slip(sections)
        if ratio and slip.value is not None:
            return name, slip, ratio
    return None


def _points(sections: Sections, line: Line) -> list[Point]:
    """Return the runs of a remedy that keep the cube and were timed, the longest step first."""
    times = {
        row.plain["substeps"]: row.frame_ms
        for row in sections.rows("step_cost")
        if (row.plain["setting"], row.plain["worlds"]) == (line.cost, line.worlds)
    }
    runs = _runs(sections, line.setting, line.pads)
    return [
        Point(times[count], row.slip_mm, row.substep_ms)
        for count, row in runs.items()
        if count in times and times[count].value is not None
    ]


def _points_in_c(sections: Sections) -> list[Point]:
    """Return the runs of MuJoCo's C engine with the run time of a simulated second."""
    runs = _runs(sections, "c", RULE)
    times = {
        count: sections.cell("error_runtime", f"stiff/c/substeps-{count}", "ms_per_s")
        for count in runs
    }
    return [
        Point(times[count], row.slip_mm, row.substep_ms)
        for count, row in runs.items()
        if times[count].value is not None
    ]


def _runs(sections: Sections, setting: str, pads: str) -> dict[int, Row]:
    """Return the runs that keep the cube, with the number of substeps as keys."""
    rows = [
        row
        for row in sections.rows("time_step")
        if (row.plain["setting"], row.plain["pads"]) == (setting, pads) and is_held(row)
    ]
    return {row.plain["substeps"]: row for row in rows}


def _draw(
    lines: Mapping[Line, list[Point]], in_c: list[Point], bounds: list[Quantity]
) -> tuple[Drawing, Axes]:
    drawing, axes = new_figure(7.2, 5.2)
    for bound in bounds:
        axes.axhline(
            bound.number, color=INK, alpha=0.4, linewidth=0.9, linestyle="--", marker=""
        )
        write_beside(
            axes,
            f"{write(bound)} mm",
            (0.99 if is_narrow() else 0.01, bound.number),
            (0, 1),
            xycoords=("axes fraction", "data"),
            ha="right" if is_narrow() else "left",
            fontsize=8.5,
        )
    ends = []
    for line, points in (*lines.items(), (IN_C, in_c)):
        per_frame = FRAME_RATE if line is IN_C else line.worlds
        times = [point.time.number / per_frame for point in points]
        if points:
            _draw_line(axes, times, points, line)
            # The lower end of the line of MuJoCo C is close to other lines.
            end = 0 if line is IN_C else -1
            slip = points[end].slip.number
            ends.append((times[end], slip, line.name, line.colour))
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="time of a frame, divided by the number of worlds [ms]",
        ylabel="slip in the whole shake [mm]",
    )
    axes.set_xlim(1e-4, 2e3)
    axes.set_ylim(2e-3, 20.0)
    tick_at(axes.xaxis, [10.0**power for power in range(-3, 4)])
    tick_at(axes.yaxis, [10.0**power for power in range(-2, 2)])
    if is_narrow() and ends:
        drawing.legend(loc="outside upper left", ncols=1)
    if not is_narrow():
        name_ends(axes, ends, offset=6, near=30.0)
    write_beside(
        axes, "↙ better", (0.01, 0.01), (0, 0), xycoords="axes fraction", fontsize=8.5
    )
    return drawing, axes


def _draw_line(axes: Axes, times: list[float], points: list[Point], line: Line) -> None:
    [drawn] = axes.plot(
        times,
        [point.slip.number for point in points],
        color=line.colour,
        marker=line.marker,
        linestyle="-" if line.worlds == ALONE else "--",
        linewidth=1.1,
        markevery=1,
        label=line.label,
    )
    if line is BY_RULE:
        drawn.set_gid(RULE_ID)
    look = {"color": line.colour, "fontsize": 8.5}
    if (line.pads, line.cost) == (RULE, step_cost.STIFF) and not is_narrow():
        place = (times[0], points[0].slip.number)
        write_beside(axes, worlds_name(line.worlds), place, (0, 8), ha="center", **look)
        # Every second step has a label, because labels need room.
        pairs = zip(times, points, strict=True)
        for time, point in islice(pairs, 0, None, 2 if len(points) > 4 else 1):
            write_beside(
                axes,
                f"{write(point.step, is_short=True)} ms",
                (time, point.slip.number),
                (-5, -3),
                ha="right",
                va="top",
                **{**look, "fontsize": 7},
            )
