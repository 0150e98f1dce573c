"""Time and memory against the number of worlds, with the engine's own steps in the same frames as the floor."""

import math
from collections.abc import Mapping, Sequence
from itertools import takewhile
from typing import Any

import pandas as pd
from matplotlib.figure import Figure as Drawing

from measured_report.claims.claims import Claim, at_least, at_most
from measured_report.parts.figures import INK, new_figure
from measured_report.parts.parts import Figure, Section, Table
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import departure, difference, ratio, share
from report.shared.timing import cell, decade_axis, draw_line, world_axis

order = 170
page = "cost"
label = "many worlds"

FLOOR_COUNTS = (1, 4096, 16384)
"""Numbers of worlds for which the floor is a target."""
RATE_COUNT = 16384


def derive(results: Results) -> Section:
    rows = results.rows
    ends = [rows[0], rows[-1]]
    over_floor = {row.worlds.value: _over_floor(results, row) for row in rows}
    floor_bound = results.chosen("over_floor_bound", "what a frame may cost beside its steps", 1.15)
    rate_bound = results.chosen("rate_bound", "what this GPU should reach", 6.0, unit="million world-substeps/s")
    times = Figure(
        draw=lambda: _draw_times(rows, over_floor, floor_bound),
        sources=[row.frame_ms for row in rows],
        numbers={"ends": ends},
    )
    capacity = Figure(
        draw=lambda: _draw_capacity(rows), sources=[row.world_substeps_per_s for row in rows], numbers={"ends": ends}
    )
    return Section(
        tables={"worlds": _table(results, rows, over_floor)},
        figures={"times": times, "capacity": capacity},
        claims=[
            _near_floor(results, over_floor, floor_bound),
            _rate(results, rate_bound),
            _first_worlds_are_cheap(results, rows),
            _memory_settles(results, rows),
        ],
    )


def _over_floor(results: Results, row: Row) -> Value:
    formula = "time of a whole frame over that of the engine's own steps in it"
    return ratio(results, f"over_floor_{row.worlds.value}", formula, row.frame_ms, row.mjw_step_ms)


def _near_floor(results: Results, over_floor: Mapping[int, Value], bound: Value) -> Claim:
    """The bound holds for each of FLOOR_COUNTS, so one that wasn't measured leaves it open."""
    cells = [_at(results, over_floor, count) for count in FLOOR_COUNTS]
    worst = results.value("over_floor_worst", "largest of those at 1, 4096 and 16384 worlds", max, *cells)
    sides: dict[bool, list[dict[str, Any]]] = {True: [], False: []}
    for count, of_bare in zip(FLOOR_COUNTS, cells, strict=True):
        if of_bare.value is not None:
            sides[of_bare.value <= bound.value].append(_against_bound(results, count, of_bare, bound))
    return Claim(
        "near_floor",
        at_most(worst, bound),
        numbers={"bound": bound, "within": sides[True], "over": sides[False], "measured": sides[False] + sides[True]},
    )


def _at(results: Results, cells: Mapping[int, Value], count: int) -> Quantity:
    return cells.get(count) or cell(results, None, "frame_ms", f"a batch of {count} worlds")


def _against_bound(results: Results, count: int, of_bare: Quantity, bound: Value) -> dict[str, Any]:
    """A frame with so many worlds, in its bare steps, and by how much that is over the bound, where it is."""
    measured: dict[str, Any] = {"times": of_bare, "worlds": _count(results, count), "is_one": count == 1}
    if of_bare.value <= bound.value:
        return measured
    excess = results.value(
        f"over_bound_{count}",
        "how far the time of a frame is over the bound, of the bound",
        lambda part, whole: 100 * (part / whole - 1),
        of_bare,
        bound,
        unit="%",
    )
    return measured | {"excess": excess}


def _count(results: Results, count: int) -> Quantity:
    return next(row.worlds for row in results.rows if row.worlds.value == count)


def _rate(results: Results, bound: Value) -> Claim:
    row = results.row.get(f"worlds-{RATE_COUNT}")
    rate = results.value(
        "rate",
        "world-substeps per second with the most worlds aimed for, in millions",
        lambda per_second: 1e-6 * per_second,
        cell(results, row, "world_substeps_per_s", f"a batch of {RATE_COUNT} worlds"),
        unit="million world-substeps/s",
    )
    return Claim(
        "rate", at_least(rate, bound), numbers={"worlds": row.worlds if row else "", "rate": rate, "bound": bound}
    )


def _first_worlds_are_cheap(results: Results, rows: Sequence[Row]) -> Claim:
    """Whether some worlds more cost next to nothing, as long as the machine is not full."""
    bound = results.chosen("cheap_bound", "a frame no longer than this many times that of one world", 2.0)
    cheap = results.value(
        "cheap_worlds",
        "most worlds with which, as with all fewer, a frame takes no longer than the bound times that of one world",
        lambda limit, *cells: max(
            worlds
            for worlds, _ in takewhile(
                lambda pair: pair[1] <= limit * cells[1], zip(cells[::2], cells[1::2], strict=True)
            )
        ),
        bound,
        *(quantity for row in rows for quantity in (row.worlds, row.frame_ms)),
    )
    most = results.value(
        "cheap_cost",
        "time of a frame with as many worlds as that, over that of one world",
        lambda worlds, *cells: (
            next((time for at, time in zip(cells[::2], cells[1::2], strict=True) if at == worlds), math.nan) / cells[1]
        ),
        cheap,
        *(quantity for row in rows for quantity in (row.worlds, row.frame_ms)),
    )
    second = rows[1]
    cost = ratio(results, "second_cost", "time of a frame over that of one world", second.frame_ms, rows[0].frame_ms)
    return Claim(
        "first_worlds_are_cheap",
        at_least(cheap, second.worlds),
        numbers={"cheap": cheap, "bound": bound, "most": most, "second": second.worlds, "cost": cost},
    )


def _memory_settles(results: Results, rows: Sequence[Row]) -> Claim:
    before, last = rows[-2:]
    change = departure(
        results,
        "memory_change",
        "change of the memory per world from the second most worlds to the most, either way",
        last.bytes_per_world,
        before.bytes_per_world,
    )
    bound = results.chosen("memory_bound", "the same memory per world", 10.0, unit="%")
    formula = "contact and constraint buffers, of the memory per world with the most worlds"
    share(results, "buffer_share", formula, last.buffer_bytes_per_world, last.bytes_per_world)
    return Claim(
        "memory_settles",
        at_most(change, bound),
        numbers={
            "last": last.bytes_per_world,
            "worlds": last.worlds,
            "fewer": before.worlds,
            "change": change,
            "bound": bound,
        },
    )


def _table(results: Results, rows: Sequence[Row], over_floor: Mapping[int, Value]) -> Table:
    columns = {
        "frame": [row.frame_ms for row in rows],
        "steps": [row.mjw_step_ms for row in rows],
        "frame / steps": [over_floor[row.worlds.value] for row in rows],
        "rest": [_beside(results, row) for row in rows],
        "all substeps": [row.world_substeps_per_s for row in rows],
        "memory": [row.bytes_per_world for row in rows],
        "buffers": [row.buffer_bytes_per_world for row in rows],
    }
    index = pd.Index([str(row.worlds) for row in rows], name="worlds")
    return Table(pd.DataFrame(columns, index=index))


def _beside(results: Results, row: Row) -> Value:
    return difference(
        results,
        f"beside_{row.worlds.value}",
        "time of a whole frame less that of its substeps as bare engine steps",
        row.frame_ms,
        row.mjw_step_ms,
    )


def _draw_times(rows: Sequence[Row], over_floor: Mapping[int, Value], bound: Value) -> Drawing:
    counts = [row.worlds.value for row in rows]
    drawing, (times, ratios) = new_figure(7.2, 5.0, nrows=2, sharex=True, height_ratios=(2, 1))
    draw_line(times, counts, [row.frame_ms for row in rows], 0, "whole frame")
    draw_line(times, counts, [row.mjw_step_ms for row in rows], 1, "its engine steps alone")
    decade_axis(times)
    times.set_ylabel("time [ms]")
    times.legend(loc="upper left")
    draw_line(ratios, counts, list(over_floor.values()), 0, "")
    ratios.axhline(bound.value, color=INK, linewidth=1, linestyle="--")
    ratios.set_ylim(bottom=1.0)
    ratios.set_ylabel("whole / alone")
    ratios.set_xlabel("worlds")
    world_axis(ratios, counts)
    return drawing


def _draw_capacity(rows: Sequence[Row]) -> Drawing:
    counts = [row.worlds.value for row in rows]
    drawing, (rates, memory) = new_figure(7.2, 4.6, nrows=2, sharex=True)
    draw_line(rates, counts, [row.world_substeps_per_s for row in rows], 0, "")
    decade_axis(rates)
    rates.set_ylabel("world-substeps/s")
    draw_line(memory, counts, [row.bytes_per_world for row in rows], 0, "all", scale=1e-3)
    draw_line(memory, counts, [row.buffer_bytes_per_world for row in rows], 1, "contacts and constraints", scale=1e-3)
    decade_axis(memory)
    memory.set_ylabel("per world [kB]")
    memory.set_xlabel("worlds")
    memory.legend()
    world_axis(memory, counts)
    return drawing
