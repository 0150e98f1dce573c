"""Time and memory against the number of worlds: the engine's own steps as the floor, and its benchmark beside them."""

import math
from collections.abc import Iterable, Mapping, Sequence
from itertools import takewhile

from matplotlib.figure import Figure as Drawing

from measured_report.parts.claim import HOLDS, Claim, all_of, at_least, at_most
from measured_report.parts.figures import new_figure
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.sections.scaling.testspeed import compare_with_benchmark
from report.shared.arithmetic import Column, departure, ratio, share, table_of
from report.shared.timing import (
    TIMED_WORLDS,
    cell,
    decade_axis,
    draw_line,
    fine_enough,
    ratio_cell,
    resolutions,
    world_axis,
)

order = 170
page = "cost"
label = "many worlds"

RATE_COUNT = 16384


def derive(results: Results) -> Section:
    rows = [row for row in results.rows if "way" not in row]
    formula = "time of a whole frame over that of the engine's own steps, timed in turn"
    over_floor = {
        row.worlds.value: results.value(
            f"over_floor_{row.worlds.value}", formula, lambda taken: taken, ratio_cell(results, row)
        )
        for row in rows
    }
    floor_bound = results.chosen("over_floor_bound", "what a frame may cost beside its steps", 1.15)
    resolution = resolutions(results, "resolution", rows)
    cheap = _first_worlds_are_cheap(results, rows)
    numbers = {**cheap.numbers, "is_cheap": cheap.outcome == HOLDS, "ends": [rows[0], rows[-1]]}
    times = Figure(lambda: _draw_times(rows), [row.frame_ms for row in rows], numbers)
    claims = [
        _near_floor(results, rows, over_floor, floor_bound, resolution),
        _rate(results),
        cheap,
        _memory_settles(results, rows),
    ]
    tables = {"worlds": _table(rows, over_floor, resolution)}
    if len(rows) == len(results.rows):  # on a CPU, and in releases that were measured before
        return Section(
            tables=tables, figures={"times": times}, claims=claims, unmeasured=("faster", "explained", "ways")
        )
    tables["ways"], found = compare_with_benchmark(results)
    return Section(tables=tables, figures={"times": times}, claims=claims + found)


def _near_floor(
    results: Results, rows: Sequence[Row], over_floor: Mapping[int, Value], bound: Value, resolution: Value
) -> Claim:
    """The bound holds for each of TIMED_WORLDS, so one that wasn't measured leaves it open."""
    lost = {count: cell(results, None, "frame_ms", f"a batch of {count} worlds") for count in TIMED_WORLDS}
    cells = {count: over_floor.get(count, lost[count]) for count in TIMED_WORLDS}
    worst = results.value("over_floor_worst", "largest of those at 1, 4096 and 16384 worlds", max, *cells.values())
    counts = [row.worlds for row in rows if row.worlds.value in TIMED_WORLDS]
    outcome = all_of(at_most(worst, bound), fine_enough(resolution))
    return Claim("near_floor", outcome, {"bound": bound, "worst": worst, "counts": counts})


def _rate(results: Results) -> Claim:
    bound = results.chosen("rate_bound", "what this GPU should reach", 6.0, unit="million world-substeps/s")
    row = results.row.get(f"worlds-{RATE_COUNT}")
    per_second = cell(results, row, "world_substeps_per_s", f"a batch of {RATE_COUNT} worlds")
    formula = "world-substeps per second with the most worlds aimed for, in millions"
    rate = results.value("rate", formula, lambda number: 1e-6 * number, per_second, unit=bound.unit)
    return Claim("rate", at_least(rate, bound), {"worlds": row.worlds if row else "", "rate": rate, "bound": bound})


def _first_worlds_are_cheap(results: Results, rows: Sequence[Row]) -> Claim:
    """Whether some worlds more cost next to nothing, as long as the machine is not full."""
    first, second = rows[:2]
    times = [quantity for row in rows for quantity in (row.worlds, row.frame_ms)]

    def cheap_count(limit: float, *cells: float) -> float:
        return max(worlds for worlds, _ in takewhile(lambda pair: pair[1] <= limit * cells[1], _paired(cells)))

    def cost_of(count: float, *cells: float) -> float:
        return next((time for worlds, time in _paired(cells) if worlds == count), math.nan) / cells[1]

    bound = results.chosen("cheap_bound", "a frame no longer than this many times that of one world", 2.0)
    formula = (
        "most worlds with which, as with all fewer, a frame takes no longer than the bound times that of one world"
    )
    cheap = results.value("cheap_worlds", formula, cheap_count, bound, *times)
    formula = "time of a frame with as many worlds as that, over that of one world"
    most = results.value("cheap_cost", formula, cost_of, cheap, *times)
    cost = ratio(results, "second_cost", "time of a frame over that of one world", second.frame_ms, first.frame_ms)
    numbers = {"cheap": cheap, "bound": bound, "most": most, "second": second.worlds, "cost": cost}
    return Claim("first_worlds_are_cheap", at_least(cheap, second.worlds), numbers)


def _paired(cells: Sequence[float]) -> Iterable[tuple[float, float]]:
    """Numbers of worlds with the times of their frames, of cells that have these in turn."""
    return zip(cells[::2], cells[1::2], strict=True)


def _memory_settles(results: Results, rows: Sequence[Row]) -> Claim:
    before, last = rows[-2:]
    formula = "change of the memory per world from the second most worlds to the most, either way"
    change = departure(results, "memory_change", formula, last.bytes_per_world, before.bytes_per_world)
    bound = results.chosen("memory_bound", "the same memory per world", 10.0, unit="%")
    formula = "contact and constraint buffers, of the memory per world with the most worlds"
    share(results, "buffer_share", formula, last.buffer_bytes_per_world, last.bytes_per_world)
    numbers = {"last": last.bytes_per_world, "worlds": last.worlds, "fewer": before.worlds}
    return Claim("memory_settles", at_most(change, bound), {**numbers, "change": change, "bound": bound})


def _table(rows: Sequence[Row], over_floor: Mapping[int, Value], resolution: Value) -> Table:
    columns: dict[str, Column] = {
        **{"frame": "frame_ms", "steps": "mjw_step_ms", "frame / steps": lambda row: over_floor[row.worlds.value]},
        **{"all substeps": "world_substeps_per_s", "memory": "bytes_per_world", "buffers": "buffer_bytes_per_world"},
    }
    return table_of("worlds", [str(row.worlds) for row in rows], columns, rows, resolution=resolution)


def _draw_times(rows: Sequence[Row]) -> Drawing:
    counts = [row.worlds.value for row in rows]
    drawing, axes = new_figure(7.2, 3.4)
    draw_line(axes, counts, [row.frame_ms for row in rows], 0, "whole frame")
    draw_line(axes, counts, [row.mjw_step_ms for row in rows], 1, "its engine steps alone")
    decade_axis(axes)
    axes.set(xlabel="worlds", ylabel="time [ms]")
    axes.legend(loc="upper left")
    world_axis(axes, counts)
    return drawing
