"""The overview: a line for each section, all of its runs on one axis, and what moves the slip most by its name."""

import math
import textwrap
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import INK, SERIES, fold, is_narrow, new_figure, write
from measured_report.parts.section import Figure
from measured_report.values.quantities import Quantity
from measured_report.values.results import Results, Row
from report.names import name_of

BASELINE = "as-shipped"
SHAKE = ("shake_amplitude_m", "shake_frequency_hz", "shake_duration_s")
"""What a run must share with the baseline, where it says it, for their slips to say the same thing."""
SHAKE_TOLERANCE = 0.05
"""How much of it may differ: a run may reach the shake some frames sooner or later."""
SAME_AGAIN = ("noise", "leave_out")
"""Sections of many runs that are meant to be the same."""
REFERENCE = "stiff-pads"
"""Cases that begin so are what others are compared with, as shipped pads are; what a section tries is beside them."""
HARDLY, LITTLE = 0.01, 0.1
"""Chosen: a section none of whose runs changes the slip by more than these shares of it is one that does hardly
anything, or little. Section reproduction has them as values, in percent."""
DOT: dict[str, Any] = {"marker": "o", "markersize": 5, "markevery": 1, "color": SERIES[0], "linestyle": "none"}
SAME_SHAKE, STIFF, OTHER_SHAKE = "the baseline's shake", "stiff pads, to compare", "another shake or duration"
DROPPED = "dropped"
MARKS = {
    SAME_SHAKE: DOT,
    STIFF: DOT | {"color": SERIES[2]},
    OTHER_SHAKE: DOT | {"markerfacecolor": "none"},
    DROPPED: DOT | {"marker": "x", "color": INK, "markersize": 5},
}


@dataclass(frozen=True)
class Line:
    """The runs of one section."""

    label: str
    rows: Sequence[Row]
    alike: Sequence[Row]
    """Those with a slip and the baseline's shake, stiff pads for comparison left out."""
    farthest: Row | None
    """Of these the one whose slip is farthest from the baseline's; None where none changes it by more than LITTLE."""
    change_mm: float
    change_share: float
    """By how much these slips are apart from the section's own with shipped pads, at most, and of it."""

    @property
    def does_little(self) -> bool:
        """Whether nothing that was tried changes the slip by more than LITTLE."""
        tried = [row for row in self.rows if not row.case.startswith(REFERENCE)]
        return self.farthest is None and len(self.alike) == len(tried) > 1


def overview(chapters: Mapping[str, Results]) -> Figure | None:
    """Make the figure of all runs that have a slip, in the order of the page; None without a baseline to compare with.

    Args:
        chapters: Results of the sections that are shown, by name.
    """
    shown = {name: results for name, results in chapters.items() if name not in SAME_AGAIN}
    rows = (results.row[BASELINE] for results in chapters.values() if BASELINE in results.row)
    baseline = next((row for row in rows if "slip_mm" in row and row.slip_mm.value), None)
    lines = lines_of(shown, baseline) if baseline else []
    if not lines:
        return None
    noise = chapters["noise"].derived.get("slip_floor") if "noise" in chapters else None
    bounds = chapters["reproduction"].derived if "reproduction" in chapters else {}
    numbers = {
        "baseline": baseline.slip_mm,
        "noise": noise,
        "has_noise": bool(noise and noise.value),
        "little": bounds.get("little_effect"),
        "hardly": bounds.get("hardly_any_effect"),
        "runs": str(sum(len(line.rows) for line in lines)),
        "sections": str(len(lines)),
        "idle": ", ".join(line.label for line in lines if line.does_little),
        "moving": ", ".join(line.label for line in lines if line.farthest),
    }
    slips = [row.slip_mm for line in lines for row in line.rows]
    return Figure(lambda: _draw(lines, baseline, noise), slips, numbers)


def lines_of(chapters: Mapping[str, Results], baseline: Row) -> list[Line]:
    """Make a line for each section that has runs with a slip, and among them one that can be compared.

    A row that has no drift, or does not say whether the run failed, is a look at a part of a run and not at all of it.
    """
    lines = []
    for results in chapters.values():
        rows = [row for row in results.rows if all(name in row for name in ("slip_mm", "drift_mm_s", "failure"))]
        alike = [row for row in rows if row.slip_mm.value and _mark(row, baseline) == SAME_SHAKE]
        if alike:
            own = next((row for row in alike if row.case == BASELINE), baseline).slip_mm.value
            change_mm = max(abs(row.slip_mm.value - own) for row in alike)
            lines.append(Line(results.label, rows, alike, _farthest(alike, baseline), change_mm, change_mm / own))
    return lines


def _farthest(alike: Sequence[Row], baseline: Row) -> Row | None:
    """Find the run that changes the slip most, by ratio; of those that do the same the one with the shortest name."""
    far = max(alike, key=lambda row: _distance(row, baseline))
    if _distance(far, baseline) <= LITTLE:
        return None
    return min((row for row in alike if _distance(row, far) <= LITTLE), key=lambda row: len(name_of(row.case)))


def _distance(row: Row, other: Row) -> float:
    """Compute how far two slips are apart: the logarithm of their ratio, which for a small one is the share."""
    return abs(math.log(row.slip_mm.value / other.slip_mm.value))


def _mark(row: Row, baseline: Row) -> str:
    if "dropped" in row and row.dropped:
        return DROPPED
    said = [(row[name].value, baseline[name].value) for name in SHAKE if name in row and name in baseline]
    if not all(math.isclose(*pair, rel_tol=SHAKE_TOLERANCE) for pair in said):
        return OTHER_SHAKE
    return STIFF if row.case.startswith(REFERENCE) else SAME_SHAKE


def _draw(lines: Sequence[Line], baseline: Row, noise: Quantity | None) -> Drawing:
    drawing, axes = new_figure(7.2, 1.0 + (0.5 if is_narrow() else 0.38) * len(lines))
    slip = baseline.slip_mm.value
    axes.axvline(slip, color=SERIES[1], linewidth=1.2, zorder=1)
    if noise is not None and noise.value is not None:
        edges = max(slip - noise.value, 0.0), slip + noise.value
        axes.axvspan(*edges, color=SERIES[1], alpha=0.3, linewidth=0, zorder=0.9)
    axes.set_xscale("log")
    axes.set_ylim(len(lines) - 0.3, -0.8)
    _draw_dots(axes, lines, baseline)
    for place, line in enumerate(lines):
        if line.farthest:
            _name_farthest(axes, place, line.farthest)
    axes.set_yticks(range(len(lines)), [_label(line, noise) for line in lines], fontsize=8.5)
    axes.tick_params(axis="y", length=0)
    axes.grid(axis="y", linewidth=0.3)
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.set_xlabel("slip [mm]")
    above: dict[str, Any] = {"xycoords": ("data", "axes fraction"), "xytext": (4, 4), "textcoords": "offset points"}
    text = f"shipped pads: {write(baseline.slip_mm)} mm"
    axes.annotate(text, (slip, 1.0), **above, color=SERIES[1], fontsize=8.5, ha="center")
    handles = [axes.plot([], [], **style, label=mark)[0] for mark, style in MARKS.items() if mark != DROPPED]
    drawing.legend(handles=handles, loc="outside lower left", ncols=3, fontsize=8)
    return drawing


def _label(line: Line, noise: Quantity | None) -> str:
    """Name a line, and say how many runs it has, how many are lost, and where it does little, how little."""
    lost_count = sum(row.slip_mm.value is None for row in line.rows)
    lost = f", {lost_count} without result" if lost_count else ""
    effect = ": hardly any effect" if line.change_share <= HARDLY else ": little effect"
    if noise is not None and line.change_mm <= (noise.value or 0.0):
        effect = ": no effect"
    runs = f"{len(line.rows)} run{'s' * (len(line.rows) > 1)}"
    return f"{line.label}\n{runs}{lost}{effect if line.does_little else ''}"


def _name_farthest(axes: Axes, place: int, row: Row) -> None:
    """Name a run and its slip above its mark, towards the wider side; where there is little room, from the edge on.

    It takes no part in the layout, which would give it room by making the axes narrow.
    """
    text = f"{textwrap.shorten(name_of(row.case), 48, placeholder=' …')}: {write(row.slip_mm)}"
    share = axes.transAxes.inverted().transform(axes.transData.transform((row.slip_mm.value, place)))[0]
    above: dict[str, Any] = {"textcoords": "offset points", "fontsize": 8, "annotation_clip": False}
    if is_narrow():
        above |= {"xycoords": ("axes fraction", "data"), "xytext": (3, 5)}
        said = axes.annotate(fold(text), (0.0, place), **above)
    else:
        above |= {"ha": "left", "xytext": (-3, 5)} if share < 0.5 else {"ha": "right", "xytext": (3, 5)}
        said = axes.annotate(text, (row.slip_mm.value, place), **above)
    said.set_in_layout(False)


def _draw_dots(axes: Axes, lines: Sequence[Line], baseline: Row) -> None:
    """Draw each run; count those that dropped at the edge: how far away a dropped cube lies says nothing."""
    marks: dict[str, list[tuple[float, int]]] = {}
    for place, line in enumerate(lines):
        for row in line.rows:
            if row.slip_mm.value is not None:
                marks.setdefault(_mark(row, baseline), []).append((row.slip_mm.value, place))
    dropped = Counter(place for _, place in marks.pop(DROPPED, []))
    for mark, dots in marks.items():
        axes.plot(*zip(*dots, strict=True), **MARKS[mark])
    slips = [slip for dots in marks.values() for slip, _ in dots]
    axes.set_xlim(0.7 * min(slips), 3.0 * max(slips))
    above: dict[str, Any] = {"xycoords": ("axes fraction", "data"), "xytext": (0, 5), "textcoords": "offset points"}
    for place, count in sorted(dropped.items()):
        axes.plot([0.97], [place], transform=axes.get_yaxis_transform(), **MARKS[DROPPED])
        axes.annotate(f"{count} dropped", (0.99, place), fontsize=8, ha="right", **above).set_in_layout(False)
