"""What the sections on time and memory share."""

import math
from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from matplotlib.axes import Axes

from measured_report.parts.claim import HOLDS, Outcome, all_of, at_most
from measured_report.parts.figures import SERIES, is_narrow
from measured_report.values.format import format_number
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import cell_or_absent, resolved

TIMED_WORLDS = (1, 4096, 16384)
"""Numbers of worlds that are timed wherever not all are."""


def cell(results: Results, row: Row | None, column: str, what: str) -> Quantity:
    """A cell of a row that is not measured on every machine: ``what`` says which one, where it isn't there."""
    unit = results.record.units.get(column, "1")
    return cell_or_absent(row, column, unit, f"{what} was not measured on this machine")


def ratio_cell(results: Results, row: Row | None) -> Quantity:
    """Look up a row's time over that of the case that it was timed in turn with."""
    return cell(results, row, "frame_ratio", "this case")


def resolution(results: Results, name: str, *rows: Row | None) -> Value:
    """Derive to within what share the ratios of these rows are known [%], the largest of them."""
    formula = "half the 95 % interval of the ratio of two times measured in turn, the largest"
    cells = [cell(results, row, "ratio_resolution", "this case") for row in rows]
    return results.value(name, formula, lambda *found: 100 * max(found), *cells, unit="%", is_noise=True)


def resolutions(results: Results, name: str, rows: Iterable[Row]) -> Value:
    """Derive the same of those rows that were compared."""
    return resolution(results, name, *(row for row in rows if "ratio_resolution" in row and row.ratio_resolution.value))


def fine_enough(unseen: Quantity) -> Outcome:
    """Tell whether times are known well enough to say that nothing is slower, from what share would be seen [%]."""
    return resolved(unseen, 3.0, why="a slowdown that would matter")


def as_said(results: Results, name: str, outcome: Outcome, taken: Quantity, *times: Quantity) -> Outcome:
    """Let an outcome stand if the two times that words name are in about the ratio that was measured in turn."""
    formula = "how far the ratio of the two medians is from that measured in turn, of it"
    apart = results.value(name, formula, lambda taken, a, b: 100 * abs(a / b / taken - 1), taken, *times, unit="%")
    agree = at_most(apart, 10.0, why="the medians say the same")
    both = all_of(outcome, agree)
    reason = agree.reason or "the times do not stand in the ratio that was measured"
    if agree == HOLDS:
        return both
    return replace(both, name="unknown", reason=reason, is_opposite=False, is_inconclusive=False)


def world_axis(axes: Axes, counts: list[int]) -> None:
    """A logarithmic axis of numbers of worlds, with a tick at each that was measured; on a narrow screen every second
    has its label, the last among them."""
    axes.set_xscale("log")
    axes.minorticks_off()
    labelled = counts[::-2] if is_narrow() else counts
    axes.set_xticks(counts, [format_number(count) if count in labelled else "" for count in counts])


def decade_axis(axes: Axes) -> None:
    """A logarithmic vertical axis over whole powers of ten, so that it has labels however little is drawn."""
    low, high = axes.dataLim.intervaly
    axes.set_yscale("log")
    if 0 < low <= high:
        axes.set_ylim(10 ** math.floor(math.log10(low)), 10 ** (math.floor(math.log10(high)) + 1))
    axes.minorticks_off()


def draw_line(axes: Axes, counts: list[int], cells: list[Quantity], series: int, label: str) -> None:
    """What there is of ``cells`` against the number of worlds, as the series of that number."""
    there = [(count, cell.value) for count, cell in zip(counts, cells, strict=True) if cell.value is not None]
    if there:
        line, marker = (("-", "o"), ("--", "s"))[series]
        style: dict[str, Any] = {"color": SERIES[series], "linestyle": line, "marker": marker, "markevery": 1}
        axes.plot(*zip(*there, strict=True), label=label, **style)
