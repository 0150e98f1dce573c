"""The overview: every variant of every section on one axis, against the baseline."""

import math
import re
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing
from matplotlib.lines import Line2D

from report.figures import FAINT, INK, SERIES, new_figure
from report.parts import Figure
from report.quantities import Quantity
from report.results import Results, Row

BASELINE = "as-shipped"
SHAKE = ("shake_amplitude_m", "shake_frequency_hz", "shake_duration_s")
"""What a run must share with the baseline, where it says it, for their slips to say the same thing."""
SHAKE_TOLERANCE = 0.05
"""How much of it may differ: a run may reach the shake some frames sooner or later."""
SERIES_LENGTH = 7
"""Cases that differ in nothing but the numbers in their names share a line when there are more of them than this."""
NUMBER = re.compile(r"\d[\d.]*(e[+-]?\d+)?")
LINE_HEIGHT = 0.155
"""Height of a line of the figure [in]."""
DOT: dict[str, Any] = {"marker": "o", "markersize": 4, "markevery": 1, "color": SERIES[0], "linestyle": "none"}
MARKS = {
    "the baseline's shake": DOT,
    "another shake or duration": DOT | {"markerfacecolor": "none"},
    "dropped": DOT | {"marker": "x", "color": INK, "markersize": 5},
}


@dataclass(frozen=True)
class Line:
    """One line of the figure: a variant, or a series of them."""

    section: str
    label: str
    rows: tuple[Row, ...]


def overview(chapters: Mapping[str, Results]) -> Figure | None:
    """The figure of all rows that have a slip, in the order of the page; None without a baseline to compare with.

    Args:
        chapters: Results of the sections that are shown, by name.
    """
    baseline = _baseline(chapters)
    lines = [line for name, results in chapters.items() for line in _lines(name, results)]
    if baseline is None or not lines:
        return None
    noise = chapters["noise"].derived.get("slip_floor") if "noise" in chapters else None
    counted = {
        "runs": str(sum(len(line.rows) for line in lines)),
        "sections": str(len({line.section for line in lines})),
    }
    return Figure(
        draw=lambda: _draw(lines, baseline, noise),
        sources=[row.slip_mm for line in lines for row in line.rows],
        numbers={"baseline": baseline.slip_mm, "noise": noise, "has_noise": bool(noise and noise.value), **counted},
    )


def _baseline(chapters: Mapping[str, Results]) -> Row | None:
    rows = (results.row[BASELINE] for results in chapters.values() if BASELINE in results.row)
    return next((row for row in rows if "slip_mm" in row and row.slip_mm.value), None)


def _lines(section: str, results: Results) -> Iterator[Line]:
    """The section's runs that have a slip, those of one case or of one long series together.

    A row that has no drift, or does not say whether the run failed, is a look at a part of a run and not at all of it.
    """
    rows = [row for row in results.rows if all(name in row for name in ("slip_mm", "drift_mm_s", "failure"))]
    stems = [NUMBER.sub("…", row.case) for row in rows]
    counts = Counter(stems)
    lines: dict[str, list[Row]] = {}
    for row, stem in zip(rows, stems, strict=True):
        lines.setdefault(stem if counts[stem] > SERIES_LENGTH else row.case, []).append(row)
    for label, members in lines.items():
        yield Line(section, label if len(members) == 1 else f"{label} ({len(members)})", tuple(members))


def _draw(lines: list[Line], baseline: Row, noise: Quantity | None) -> Drawing:
    sections = list(dict.fromkeys(line.section for line in lines))
    places: dict[Line, int] = {}
    for line in lines:
        places[line] = len(places) + sections.index(line.section) + 1
    drawing, axes = new_figure(7.2, 1.0 + LINE_HEIGHT * (len(lines) + len(sections)))
    slip = baseline.slip_mm.value
    axes.axvline(slip, color=SERIES[1], linewidth=1.2, zorder=1)
    if noise is not None and noise.value is not None:
        axes.axvspan(
            max(slip - noise.value, 0.0), slip + noise.value, color=SERIES[1], alpha=0.3, linewidth=0, zorder=0.9
        )
    _draw_dots(axes, places, baseline)
    axes.set_xscale("log")
    axes.set_ylim(len(lines) + len(sections), -0.2)
    axes.set_yticks(list(places.values()), [line.label for line in places], fontsize=7.5)
    axes.tick_params(axis="y", length=0)
    axes.tick_params(axis="x", labeltop=True)
    axes.grid(axis="y", linewidth=0.3)
    _name_sections(
        axes, {section: min(places[line] for line in lines if line.section == section) for section in sections}
    )
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.set_xlabel("slip [mm]")
    drawing.legend(handles=_legend(), loc="outside upper left", ncols=3, fontsize=8)
    return drawing


def _name_sections(axes: Axes, places: Mapping[str, int]) -> None:
    for section, place in places.items():
        axes.text(
            -0.01,
            place - 1,
            section.replace("_", " "),
            transform=axes.get_yaxis_transform(),
            fontsize=8.5,
            fontweight="bold",
            va="center",
            ha="right",
        )
        axes.axhline(place - 1.5, color=FAINT, linewidth=0.8)


def _draw_dots(axes: Axes, places: Mapping[Line, int], baseline: Row) -> None:
    marks: dict[str, list[tuple[float, int]]] = {}
    for line, place in places.items():
        there = [row for row in line.rows if row.slip_mm.value is not None]
        for row in there:
            marks.setdefault(_mark(row, baseline), []).append((row.slip_mm.value, place))
        if lost := len(line.rows) - len(there):
            side = axes.get_yaxis_transform()
            axes.text(1.01, place, f"{lost} without result", transform=side, fontsize=7.5, va="center")
    for mark, dots in marks.items():
        axes.plot(*zip(*dots, strict=True), **MARKS[mark])


def _mark(row: Row, baseline: Row) -> str:
    if "dropped" in row and row.dropped:
        return "dropped"
    said = [(row[name].value, baseline[name].value) for name in SHAKE if name in row and name in baseline]
    same = all(math.isclose(*pair, rel_tol=SHAKE_TOLERANCE) for pair in said)
    return "the baseline's shake" if same else "another shake or duration"


def _legend() -> list[Line2D]:
    return [Line2D([], [], **style, label=mark) for mark, style in MARKS.items()]
