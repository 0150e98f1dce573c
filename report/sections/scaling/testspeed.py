"""The engine's own benchmark beside our frames, and the steps between the two."""

from collections.abc import Iterable, Mapping

from measured_report.parts.claim import Claim, all_of, at_least, at_most
from measured_report.parts.section import Table
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.names import worlds_name
from report.shared.arithmetic import Column, departure, resolved, table_of
from report.shared.timing import TIMED_WORLDS, cell, fine_enough, ratio_cell, resolution

LOOP = "each-step-waited-for"
"""The benchmark's loop, run here."""
WAYS = {
    "testspeed": "mujoco_warp.testspeed",
    LOOP: "the same, run here",
    "steps-in-one-graph": "16 steps as one graph",
    "collision-once": "contacts found once a frame",
    "our-engine-steps": "contacts and rows as Newton makes them",
    "whole": "whole frames: control, IK, collision, recording",
    "without-recording": "whole frames without recording",
    "without-inverse-kinematics": "whole frames without IK",
    "without-control": "whole frames without control",
    "without-collision": "whole frames without collision",
}
"""Names of the ways to run, each a switch from the one before; the last are switches from whole frames."""
SAME = 10.0
"""How near the benchmark's speed and that of its loop run here count as the same [%]."""


Rows = Mapping[tuple[str, int], Row | None]
"""Rows by way and number of worlds."""


def compare_with_benchmark(results: Results) -> tuple[Table, list[Claim]]:
    rows = {(way, count): results.row.get(f"{way}-{count}") for way in WAYS for count in TIMED_WORLDS}
    rates, gains, apart = {}, {}, {}
    for count in TIMED_WORLDS:
        both = (rows[way, count] for way in (LOOP, "testspeed"))
        loop, rates[count] = (cell(results, row, "world_substeps_per_s", f"a batch of {count}") for row in both)
        formula = "distance of the benchmark's loop run here from mujoco_warp.testspeed, of that"
        apart[count] = departure(results, f"apart_{count}", formula, loop, rates[count])
        formula = "time of that loop over that of our frames, timed in turn, times its speed over the benchmark's"
        sources = ratio_cell(results, rows[LOOP, count]), loop, rates[count]
        gains[count] = results.value(f"gain_{count}", formula, lambda a, b, c: a * b / c, *sources)
    worst = resolution(results, "ways_resolution", *(row for (way, _), row in rows.items() if way != "testspeed"))
    claims = [_faster(results, gains, rows), _explained(results, apart.values(), worst)]
    return _table(results, rows, rates, gains, worst), claims


def _faster(results: Results, gains: Mapping[int, Value], rows: Rows) -> Claim:
    """Tell it as well as the benchmark's loop run here, in turn with our frames, lets one."""
    seen = resolution(results, "loop_resolution", *(rows[LOOP, count] for count in TIMED_WORLDS))
    least = results.value("least_gain", "least of those with 1, 4096 and 16384 worlds", min, *gains.values())
    numbers = dict(zip(("one", "some", "many"), gains.values(), strict=True))
    for name, count in zip(("some_worlds", "many_worlds"), TIMED_WORLDS[1:], strict=True):
        numbers[name] = cell(results, rows["whole", count], "worlds", f"a batch of {count}")
    return Claim("faster", all_of(at_least(least, 1.0, why="as fast"), fine_enough(seen)), numbers)


def _explained(results: Results, apart: Iterable[Value], unseen: Value) -> Claim:
    formula = "largest of those with 1, 4096 and 16384 worlds"
    worst = results.value("apart_worst", formula, max, *apart, unit="%")
    bound = results.chosen("apart_bound", "the same speed", SAME, unit="%")
    outcome = all_of(at_most(worst, bound), resolved(unseen, SAME, why="the same speed"))
    return Claim("explained", outcome, {"worst": worst, "bound": bound})


def _table(
    results: Results, rows: Rows, rates: Mapping[int, Quantity], gains: Mapping[int, Value], worst: Value
) -> Table:
    columns: dict[str, Column] = {
        worlds_name(count): [_length(results, way, count, rows[way, count], gains[count]) for way in WAYS]
        for count in TIMED_WORLDS
    }
    most = [rows[way, TIMED_WORLDS[-1]] for way in WAYS]
    for above, column in (("contacts", "contact_count"), ("rows", "row_count")):
        columns[above] = [cell(results, row, column, "a batch") for row in most]
    numbers = dict(zip(("one", "some", "many"), rates.values(), strict=True)) | {"resolution": worst}
    for name, column in (("nconmax", "contact_max"), ("njmax", "constraint_max")):
        numbers[name] = cell(results, most[0], column, "a batch")
    return table_of("way", WAYS.values(), columns, **numbers)


def _length(results: Results, way: str, count: int, row: Row | None, gain: Value) -> Value:
    """Derive the share that a frame of a way takes of a whole one; of the benchmark it follows from its speed."""
    formula, taken = "time of a frame over that of a whole one, timed in turn", ratio_cell(results, row)
    if way == "testspeed":
        formula, taken = "how many times as many steps a second our frames do as the benchmark", gain
    return results.value(f"length_{way}_{count}".replace("-", "_"), formula, lambda share: 100 * share, taken, unit="%")
