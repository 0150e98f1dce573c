"""The engine's own benchmark beside our frames, and what lies between the two."""

from measured_report.parts.claim import Claim, all_of, at_least, at_most
from measured_report.parts.section import Section, Table
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results
from report.names import worlds_name
from report.shared.arithmetic import Column, departure, resolved, table_of
from report.shared.timing import CURE_WORLDS, cell, fine_enough, ratio_cell, resolution

order = 172
page = "cost"
label = "the engine's benchmark"

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
"""What each way to run is called, each a switch from the one before; the last are switches from whole frames."""
SAME = 10.0
"""How near the benchmark's speed and that of its loop run here count as the same [%]."""


def derive(results: Results) -> Section:
    rates = {
        (way, count): cell(results, results.row.get(f"{way}-{count}"), "world_substeps_per_s", f"a batch of {count}")
        for way in ("testspeed", LOOP)
        for count in CURE_WORLDS
    }
    gains, apart = {}, {}
    for count in CURE_WORLDS:
        loops = rates[LOOP, count], rates["testspeed", count]
        formula = "distance of the benchmark's loop run here from mujoco_warp.testspeed, of that"
        apart[count] = departure(results, f"apart_{count}", formula, *loops)
        formula = "time of that loop over that of our frames, timed in turn, times its speed over the benchmark's"
        slower = ratio_cell(results, results.row.get(f"{LOOP}-{count}"))
        gains[count] = results.value(f"gain_{count}", formula, lambda a, b, c: a * b / c, slower, *loops)
    compared = [results.row.get(f"{way}-{count}") for way in WAYS if way != "testspeed" for count in CURE_WORLDS]
    worst = resolution(results, "resolution", *compared)
    return Section(
        tables={"ways": _table(results, rates, gains, worst)},
        claims=[_faster(results, gains), _explained(results, list(apart.values()), worst)],
    )


def _faster(results: Results, gains: dict[int, Value]) -> Claim:
    """Tell it as well as the benchmark's loop run here, in turn with our frames, lets one."""
    loops = (results.row.get(f"{LOOP}-{count}") for count in CURE_WORLDS)
    seen = resolution(results, "loop_resolution", *loops)
    least = results.value("least_gain", "least of those with 1, 4096 and 16384 worlds", min, *gains.values())
    one, some, many = gains.values()
    some_worlds, many_worlds = (
        cell(results, results.row.get(f"whole-{count}"), "worlds", f"a batch of {count}") for count in CURE_WORLDS[1:]
    )
    numbers = {"one": one, "some": some, "many": many, "some_worlds": some_worlds, "many_worlds": many_worlds}
    return Claim("faster", all_of(at_least(least, 1.0, why="as fast"), fine_enough(seen)), numbers)


def _explained(results: Results, apart: list[Value], unseen: Value) -> Claim:
    formula = "largest of those with 1, 4096 and 16384 worlds"
    worst = results.value("apart_worst", formula, max, *apart, unit="%")
    bound = results.chosen("apart_bound", "the same speed", SAME, unit="%")
    outcome = all_of(at_most(worst, bound), resolved(unseen, SAME, why="the same speed"))
    return Claim("explained", outcome, {"worst": worst, "bound": bound})


def _length(results: Results, way: str, count: int, gain: Value) -> Value:
    """What a frame of a way takes of a whole one; of the benchmark that follows from its speed."""
    formula = "time of a frame over that of a whole one, timed in turn"
    taken = ratio_cell(results, results.row.get(f"{way}-{count}"))
    if way == "testspeed":
        formula, taken = "how many times as many steps a second our frames do as the benchmark", gain
    return results.value(f"length_{way}_{count}".replace("-", "_"), formula, lambda share: 100 * share, taken, unit="%")


def _table(results: Results, rates: dict[tuple[str, int], Quantity], gains: dict[int, Value], worst: Value) -> Table:
    columns: dict[str, Column] = {
        worlds_name(count): [_length(results, way, count, gains[count]) for way in WAYS] for count in CURE_WORLDS
    }
    rows = [results.row.get(f"{way}-{CURE_WORLDS[-1]}") for way in WAYS]
    for above, column in (("contacts", "contact_count"), ("rows", "row_count")):
        columns[above] = [cell(results, row, column, "a batch") for row in rows]
    nconmax, njmax = (cell(results, rows[0], column, "a batch") for column in ("contact_max", "constraint_max"))
    one, some, many = (rates["testspeed", count] for count in CURE_WORLDS)
    return table_of(
        "way", WAYS.values(), columns, resolution=worst, nconmax=nconmax, njmax=njmax, one=one, some=some, many=many
    )
