"""The engine's own benchmark beside our frames, and the steps between the two."""

from collections.abc import Mapping, Sequence

from measured_report.parts.claim import Claim, all_of, at_least, at_most
from measured_report.parts.section import Table
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import Column, departure, resolved, table_of
from report.shared.timing import TIMED_WORLDS, fine_enough, resolution, worlds_name

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
    worst = resolution(results, "ways_resolution", (row for (way, _), row in rows.items() if way != "testspeed"))

    columns: dict[str, Column] = {
        worlds_name(count): [_length(results, way, count, rows[way, count], gains[count]) for way in WAYS]
        for count in TIMED_WORLDS
    }
    most = [rows[way, TIMED_WORLDS[-1]] for way in WAYS]
    columns |= {"contacts": [row.contact_count for row in most], "rows": [row.row_count for row in most]}
    numbers = {"nconmax": most[0].contact_max, "njmax": most[0].constraint_max, "resolution": worst}
    table = table_of("way", WAYS.values(), columns, **_by_amount(rates), **numbers)
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
