"""Time and memory against the number of worlds: the engine's own steps as the floor, and its benchmark beside them."""

from collections.abc import Mapping, Sequence
from itertools import takewhile

from matplotlib.figure import Figure as Drawing

from measured_report.parts.claim import HOLDS, Claim, all_of, at_least, at_most
from measured_report.parts.figures import new_figure
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import Column, departure, ratio, resolved, share, table_of
from report.shared.timing import (
    TIMED_WORLDS,
    compared,
    decade_axis,
    draw_line,
    fine_enough,
    resolution,
    world_axis,
    worlds_name,
)

order = 170
page = "cost"
label = "many worlds"

RATE_COUNT = 16384


def derive(results: Results) -> Section:
    rows = [row for row in results.rows if "way" not in row]
    formula = "time of a whole frame over that of the engine's own steps, timed in turn"
    over_floor = {
        row.worlds.value: results.value(f"over_floor_{row.worlds.value}", formula, lambda taken: taken, row.frame_ratio)
        for row in rows
    }
    worst = resolution(results, "resolution", compared(rows))
    cheap = _first_worlds_are_cheap(results, rows)
    numbers = {**cheap.numbers, "is_cheap": cheap.outcome == HOLDS, "ends": [rows[0], rows[-1]]}
    figures = {"times": Figure(lambda: _draw_times(rows), [row.frame_ms for row in rows], numbers)}
    near = _near_floor(results, rows, over_floor, worst)
    claims = [near, _rate(results), cheap, _memory_settles(results, rows)]
    columns: dict[str, Column] = {
        **{"frame": "frame_ms", "steps": "mjw_step_ms", "frame / steps": list(over_floor.values())},
        **{"all substeps": "world_substeps_per_s", "memory": "bytes_per_world", "buffers": "buffer_bytes_per_world"},
    }
    tables = {"worlds": table_of("worlds", [str(row.worlds) for row in rows], columns, rows, resolution=worst)}
    if len(rows) == len(results.rows):  # on a CPU, and in releases that were measured before
        return Section(tables=tables, figures=figures, claims=claims, unmeasured=("faster", "explained", "ways"))
    tables["ways"], found = compare_with_benchmark(results)
    return Section(tables=tables, figures=figures, claims=claims + found)


def _near_floor(results: Results, rows: Sequence[Row], over_floor: Mapping[int, Value], resolution: Value) -> Claim:
    """Tell whether the bound holds for each of TIMED_WORLDS, so one that wasn't measured leaves it open."""
    bound = results.chosen("over_floor_bound", "what a frame may cost beside its steps", 1.15)
    cells = [over_floor.get(count, results.row[f"worlds-{count}"].frame_ratio) for count in TIMED_WORLDS]
    worst = results.value("over_floor_worst", "largest of those at 1, 4096 and 16384 worlds", max, *cells)
    counts = [row.worlds for row in rows if row.worlds.value in TIMED_WORLDS]
    outcome = all_of(at_most(worst, bound), fine_enough(resolution))
    return Claim("near_floor", outcome, {"bound": bound, "worst": worst, "counts": counts})


def _rate(results: Results) -> Claim:
    bound = results.chosen("rate_bound", "what this GPU should reach", 6.0, unit="million world-substeps/s")
    row = results.row[f"worlds-{RATE_COUNT}"]
    formula = "world-substeps per second with the most worlds aimed for, in millions"
    rate = results.value("rate", formula, lambda number: 1e-6 * number, row.world_substeps_per_s, unit=bound.unit)
    return Claim("rate", at_least(rate, bound), {"worlds": row.worlds, "rate": rate, "bound": bound})


def _first_worlds_are_cheap(results: Results, rows: Sequence[Row]) -> Claim:
    first, second = rows[:2]
    times = [quantity for row in rows for quantity in (row.worlds, row.frame_ms)]

    def cheap_count(limit: float, *cells: float) -> float:
        pairs = zip(cells[::2], cells[1::2], strict=True)
        return max(worlds for worlds, _ in takewhile(lambda pair: pair[1] <= limit * cells[1], pairs))

    def cost_of(count: float, *cells: float) -> float:
        return dict(zip(cells[::2], cells[1::2], strict=True))[count] / cells[1]

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


def _memory_settles(results: Results, rows: Sequence[Row]) -> Claim:
    before, last = rows[-2:]
    formula = "change of the memory per world from the second most worlds to the most, either way"
    change = departure(results, "memory_change", formula, last.bytes_per_world, before.bytes_per_world)
    bound = results.chosen("memory_bound", "the same memory per world", 10.0, unit="%")
    formula = "contact and constraint buffers, of the memory per world with the most worlds"
    share(results, "buffer_share", formula, last.buffer_bytes_per_world, last.bytes_per_world)
    numbers = {"last": last.bytes_per_world, "worlds": last.worlds, "fewer": before.worlds}
    return Claim("memory_settles", at_most(change, bound), {**numbers, "change": change, "bound": bound})


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


LOOP = "each-step-waited-for"
"""The benchmark's loop, run here."""
WAYS = {
    "testspeed": "mujoco_warp.testspeed",
    LOOP: "the same, run here",
    "steps-in-one-graph": "16 steps as one graph",
    "collision-once": "contacts found once a frame",
    "our-engine-steps": "contacts and rows as Newton makes them",
    "whole": "whole frames: control, IK, collision, recording",
}
"""Names of the ways to run, each a switch from the one before."""
SAME = 10.0
"""Chosen: how near the benchmark's speed and that of its loop run here count as the same [%]."""


def compare_with_benchmark(results: Results) -> tuple[Table, list[Claim]]:
    rows = {(way, count): results.row[f"{way}-{count}"] for way in WAYS for count in TIMED_WORLDS}
    rates, gains, apart = {}, {}, []
    for count in TIMED_WORLDS:
        rates[count] = rows["testspeed", count].world_substeps_per_s
        loops = rows[LOOP, count].world_substeps_per_s, rates[count]
        formula = "distance of the benchmark's loop run here from mujoco_warp.testspeed, of that"
        apart.append(departure(results, f"apart_{count}", formula, *loops))
        formula = "time of that loop over that of our frames, timed in turn, times its speed over the benchmark's"
        slower = rows[LOOP, count].frame_ratio
        gains[count] = results.value(f"gain_{count}", formula, lambda a, b, c: a * b / c, slower, *loops)
    worst = resolution(results, "table_resolution", (row for (way, _), row in rows.items() if way != "testspeed"))

    columns: dict[str, Column] = {
        worlds_name(count): [_length(results, way, count, rows[way, count], gains[count]) for way in WAYS]
        for count in TIMED_WORLDS
    }
    most = [rows[way, TIMED_WORLDS[-1]] for way in WAYS]
    columns |= {"contacts": [row.contact_count for row in most], "rows": [row.row_count for row in most]}
    numbers = {"nconmax": most[0].contact_max, "njmax": most[0].constraint_max, "resolution": worst}
    table = table_of("way", WAYS.values(), columns, (), **_by_amount(rates), **numbers)
    return table, [_faster(results, gains, rows), _explained(results, apart, worst)]


def _by_amount(cells: Mapping[int, Quantity]) -> dict[str, Quantity]:
    return dict(zip(("one", "some", "many"), cells.values(), strict=True))


def _length(results: Results, way: str, count: int, row: Row, gain: Value) -> Value:
    """Derive the share that a frame of a way takes of a whole one; of the benchmark it follows from its speed."""
    formula, taken = "time of a frame over that of a whole one, timed in turn", row.frame_ratio
    if way == "testspeed":
        formula, taken = "how many times as many steps a second our frames do as the benchmark", gain
    return results.value(f"length_{way}_{count}".replace("-", "_"), formula, lambda share: 100 * share, taken, unit="%")


def _faster(results: Results, gains: Mapping[int, Value], rows: Mapping[tuple[str, int], Row]) -> Claim:
    """Tell it as well as the benchmark's loop run here, in turn with our frames, lets one."""
    seen = resolution(results, "loop_resolution", (rows[LOOP, count] for count in TIMED_WORLDS))
    least = results.value("least_gain", "least of those with 1, 4096 and 16384 worlds", min, *gains.values())
    numbers = _by_amount(gains)
    for name, count in zip(("some_worlds", "many_worlds"), TIMED_WORLDS[1:], strict=True):
        numbers[name] = rows["whole", count].worlds
    return Claim("faster", all_of(at_least(least, 1.0, why="as fast"), fine_enough(seen)), numbers)


def _explained(results: Results, apart: Sequence[Value], unseen: Value) -> Claim:
    worst = results.value("apart_worst", "largest of those with 1, 4096 and 16384 worlds", max, *apart, unit="%")
    bound = results.chosen("apart_bound", "the same speed", SAME, unit="%")
    outcome = all_of(at_most(worst, bound), resolved(unseen, SAME, why="the same speed"))
    return Claim("explained", outcome, {"worst": worst, "bound": bound})
