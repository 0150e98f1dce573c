"""Time and memory against the number of worlds: the engine's own steps as the floor, and its benchmark beside them."""

from collections.abc import Sequence
from itertools import takewhile

from report.shared import (
    PERCENT,
    TIMED_WORLDS,
    Claim,
    Column,
    Results,
    Row,
    Section,
    Table,
    Value,
    absent,
    all_of,
    at_least,
    combined,
    fine_enough,
    resolution,
    table_of,
    worlds_name,
)

order = 170
page = "error"
label = "many worlds"

WAYS = {  # names of the ways to run, each a switch from the one before
    "testspeed": "mujoco_warp.testspeed",
    "each-step-waited-for": "the same, run here",
    "steps-in-one-graph": "16 steps as one graph",
    "collision-once": "contacts found once a frame",
    "our-engine-steps": "contacts and rows as Newton makes them",
    "whole": "whole frames: control, IK, collision, recording",
}


def derive(results: Results) -> Section:
    rows = [row for row in results.rows if "way" not in row]
    worst = resolution(results, "resolution", rows)
    columns: dict[str, Column] = {
        "frame": "frame_ms",
        "steps": "mjw_step_ms",
        "frame / steps": "frame_ratio",
    }
    columns |= {"all substeps": "world_substeps_per_s"}
    columns |= {"memory": "bytes_per_world", "buffers": "buffer_bytes_per_world"}
    tables = {
        "worlds": table_of(
            "worlds", [str(row.worlds) for row in rows], columns, rows, resolution=worst
        )
    }
    cheap = _first_worlds_are_cheap(results, rows)
    if len(rows) == len(
        results.rows
    ):  # on a CPU, and in releases that were measured before
        return Section(tables=tables, claims=[cheap], unmeasured=("faster", "ways"))
    tables["ways"], faster = _beside_benchmark(results)
    return Section(tables=tables, claims=[cheap, faster])


def _first_worlds_are_cheap(results: Results, rows: Sequence[Row]) -> Claim:
    times = [quantity for row in rows for quantity in (row.worlds, row.frame_ms)]

    def cheap_count(limit: float, *cells: float) -> float:
        pairs = zip(cells[::2], cells[1::2], strict=True)
        return max(
            worlds
            for worlds, _ in takewhile(lambda pair: pair[1] <= limit * cells[1], pairs)
        )

    bound = results.chosen(
        "cheap_bound", "a frame no longer than this many times that of one world", 2.0
    )
    cheap = results.value(
        "cheap_worlds",
        "most worlds with which, as with all fewer, a frame takes no longer than so many times that of one",
        cheap_count,
        bound,
        *times,
    )
    following = (
        rows[1].worlds if len(rows) > 1 else absent("1", "no more worlds were timed")
    )
    taken = next(
        (row.frame_ms for row in rows if row.worlds.value == cheap.value), times[1]
    )
    ratio = results.value(
        "cheap_ratio",
        "time of a frame with so many worlds over that of one",
        taken / times[1],
    )
    numbers = {"cheap": cheap, "ratio": ratio, "bound": bound, "next": following}
    return Claim("first_worlds_are_cheap", at_least(cheap, following), numbers)


def _beside_benchmark(results: Results) -> tuple[Table, Claim]:
    """Say what a frame takes in each of the ways, of a whole one; the benchmark's follows from its speed."""
    gains: list[Value] = []
    columns: dict[str, Column] = {}
    for count in TIMED_WORLDS:
        rows = {way: results.row[f"{way}-{count}"] for way in WAYS}
        benchmark, loop = rows["testspeed"], rows["each-step-waited-for"]
        gain = (
            loop.frame_ratio
            * loop.world_substeps_per_s
            / benchmark.world_substeps_per_s
        )
        gains.append(
            results.value(
                f"gain_{count}",
                "time of that loop over that of our frames, timed in turn, times its speed over the benchmark's",
                gain,
            )
        )
        columns[worlds_name(count)] = lengths = []
        for way, row in rows.items():
            name = f"length_{way}_{count}".replace("-", "_")
            taken = gains[-1] if way == "testspeed" else row.frame_ratio
            lengths.append(
                results.value(
                    name,
                    "time of a frame over that of a whole one, timed in turn",
                    PERCENT * taken,
                )
            )
    columns |= {
        name: [row[f"{name[:-1]}_count"] for row in rows.values()]
        for name in ("contacts", "rows")
    }
    timed = [row for row in results.rows if "way" in row and row.way != "testspeed"]
    worst = resolution(results, "table_resolution", timed)
    least = results.value(
        "least_gain",
        "least of those with 1, 4096 and 16384 worlds",
        combined(min, *gains),
    )
    numbers = dict(zip(("one", "some", "many"), gains, strict=True))
    outcome = all_of(at_least(least, 1.0, why="as fast"), fine_enough(worst))
    return table_of("way", WAYS.values(), columns, resolution=worst), Claim(
        "faster", outcome, numbers
    )
