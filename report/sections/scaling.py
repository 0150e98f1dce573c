"""Time and memory against the number of worlds, with the engine's own steps in the same frames as the floor."""

from collections.abc import Mapping, Sequence

import pandas as pd
from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from report.claims import Claim, at_least, at_most
from report.figures import INK, new_figure
from report.parts import Figure, Section, Table
from report.quantities import Quantity, Value
from report.results import Results, Row
from report.sections._common import departure, difference, ratio, share
from report.sections._timing import cell, decade_axis, draw_line, world_axis

order = 170

FLOOR_COUNTS = (1, 4096, 16384)
"""Numbers of worlds for which the floor is a target."""
RATE_COUNT = 16384


def derive(results: Results) -> Section:
    rows = results.rows
    over_floor = {row.worlds.value: _over_floor(results, row) for row in rows}
    floor_bound = results.chosen("over_floor_bound", "what a frame may cost beside its steps", 1.15)
    rate_bound = results.chosen("rate_bound", "what this GPU should reach", 6.0, unit="million world-substeps/s")
    times = Figure(
        draw=lambda: _draw_times(rows, over_floor, floor_bound),
        caption="Above: time of a whole frame and of the engine's own steps in it. Below: the one over the other; the "
        "line is the bound.",
        alt="; ".join(f"{row.worlds} worlds: frame {row.frame_ms}, steps {row.mjw_step_ms}" for row in rows),
        sources=[row.frame_ms for row in rows],
    )
    capacity = Figure(
        draw=lambda: _draw_capacity(rows),
        caption="Above: substeps of all worlds together in a second. Below: memory per world.",
        alt="; ".join(f"{row.worlds} worlds: {row.world_substeps_per_s}, {row.bytes_per_world}" for row in rows),
        sources=[row.world_substeps_per_s for row in rows],
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
    sides = {True: [], False: []}
    for count, of_bare in zip(FLOOR_COUNTS, cells, strict=True):
        if of_bare.value is not None:
            sides[of_bare.value <= bound.value].append(_floor_phrase(results, count, of_bare, bound))
    return Claim(
        "near_floor",
        at_most(worst, bound),
        holds="A whole frame takes little more than its engine steps alone: {within}.",
        fails="A whole frame takes {over}; the bound is {bound} times."
        + (" Within it: {within}." if sides[True] else ""),
        unknown="Whether a whole frame stays within {bound} times its bare engine steps for each number of worlds "
        "aimed for cannot be told" + ("; it takes {measured}." if any(sides.values()) else "."),
        numbers={
            "bound": bound,
            "within": Markup(", ").join(sides[True]),
            "over": Markup(", ").join(sides[False]),
            "measured": Markup(", ").join(sides[False] + sides[True]),
        },
    )


def _at(results: Results, cells: Mapping[int, Value], count: int) -> Quantity:
    return cells.get(count) or cell(results, None, "frame_ms", f"a batch of {count} worlds")


def _floor_phrase(results: Results, count: int, of_bare: Quantity, bound: Value) -> Markup:
    worlds = _count(results, count)
    phrase = Markup("{} times its bare steps with {} {}").format(of_bare, worlds, "world" if count == 1 else "worlds")
    if of_bare.value <= bound.value:
        return phrase
    excess = results.value(
        f"over_bound_{count}",
        "how far the time of a frame is over the bound, of the bound",
        lambda part, whole: 100 * (part / whole - 1),
        of_bare,
        bound,
        unit="%",
    )
    return phrase + Markup(" ({} over the bound)").format(excess)


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
        "rate",
        at_least(rate, bound),
        holds="With {worlds} worlds the whole scene runs at {rate}, above the {bound} aimed for.",
        fails="With {worlds} worlds the whole scene runs at {rate}, below the {bound} aimed for.",
        unknown="Whether the whole scene reaches {bound} cannot be told.",
        numbers={"worlds": row.worlds if row else "", "rate": rate, "bound": bound},
    )


def _first_worlds_are_cheap(results: Results, rows: Sequence[Row]) -> Claim:
    """Whether some worlds more cost next to nothing, as long as the machine is not full."""
    bound = results.chosen("cheap_bound", "a frame no longer than this many times that of one world", 2.0)
    cheap = results.value(
        "cheap_worlds",
        "most worlds with which a frame takes no longer than the bound times that of one world",
        lambda limit, *cells: max(
            worlds for worlds, time in zip(cells[::2], cells[1::2], strict=True) if time <= limit * cells[1]
        ),
        bound,
        *(quantity for row in rows for quantity in (row.worlds, row.frame_ms)),
    )
    most = results.value(
        "cheap_cost",
        "time of a frame with as many worlds as that, over that of one world",
        lambda worlds, *cells: (
            next(time for at, time in zip(cells[::2], cells[1::2], strict=True) if at == worlds) / cells[1]
        ),
        cheap,
        *(quantity for row in rows for quantity in (row.worlds, row.frame_ms)),
    )
    second = rows[1]
    cost = ratio(results, "second_cost", "time of a frame over that of one world", second.frame_ms, rows[0].frame_ms)
    return Claim(
        "first_worlds_are_cheap",
        at_least(cheap, second.worlds),
        holds="More worlds cost little at first: with {cheap} a frame takes {most} times as long as with one, and up "
        "to there no number of them takes more than {bound} times as long.",
        fails="More worlds take more time from the start: with {second} a frame takes {cost} times as long as with "
        "one.",
        unknown="From how many worlds on more of them cost more time cannot be told.",
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
    buffers = share(results, "buffer_share", formula, last.buffer_bytes_per_world, last.bytes_per_world)
    return Claim(
        "memory_settles",
        at_most(change, bound),
        holds="Memory grows with the number of worlds: {last} for each of {worlds}, within {change} of what each takes "
        "with {fewer}; contact and constraint buffers are {share} of it.",
        fails="Memory does not just grow with the number of worlds: {last} for each of {worlds}, {change} away from "
        "what each takes with {fewer}.",
        unknown="How much memory a world takes in all cannot be told; contact and constraint buffers are {buffers} of "
        "it.",
        numbers={
            "last": last.bytes_per_world,
            "worlds": last.worlds,
            "fewer": before.worlds,
            "change": change,
            "share": buffers,
            "buffers": last.buffer_bytes_per_world,
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
    caption = (
        "Whole frames against their substeps as bare engine steps, medians; substeps of all worlds together; memory "
        "per world, and of it the buffers for contacts and constraint rows."
    )
    return Table(pd.DataFrame(columns, index=index), caption)


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
