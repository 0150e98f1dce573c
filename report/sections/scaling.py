"""Compare time and memory by number of worlds with the engine's own benchmark."""

from itertools import takewhile

from report.shared import (
    PERCENT,
    TIMED_WORLDS,
    Claim,
    Results,
    Section,
    absent,
    at_least,
    combined,
    resolution,
    table_of,
    worlds_name,
)

order = 170
page = "error"
label = "many worlds"

LOOPS = {  # names of the loops; each changes one setting of the loop before it
    "testspeed": "mujoco_warp.testspeed",
    "each-step-waited-for": "the same loop, run by this report",
    "steps-in-one-graph": "16 steps as one graph",
    "collision-once": "contacts found once per frame",
    "our-engine-steps": "contacts and rows as built by Newton",
    "whole": "whole frames: control, IK, collision, recording",
}
COLUMNS = {
    "frame": "frame_ms",
    "steps": "mjw_step_ms",
    "frame / steps": "frame_ratio",
    "all substeps": "world_substeps_per_s",
    "memory": "bytes_per_world",
    "buffers": "buffer_bytes_per_world",
}


def derive(results: Results) -> Section:
    rows = [row for row in results.rows if "way" not in row]
    worst = resolution(results, "resolution", rows)
    names = [str(row.worlds) for row in rows]
    tables = {"worlds": table_of("worlds", names, COLUMNS, rows, resolution=worst)}

    alone = rows[0].frame_ms
    limit = results.chosen(
        "cheap_bound",
        "a frame takes at most this many times as long as with one world",
        2.0,
    )
    cheap = results.value(
        "cheap_worlds",
        "largest number of worlds up to which no frame takes longer than cheap_bound"
        " times the time of one world",
        _cheap_worlds,
        limit,
        *(cell for row in rows for cell in (row.worlds, row.frame_ms)),
    )
    times = (row.frame_ms for row in rows if row.worlds.value == cheap.value)
    ratio = results.value(
        "cheap_ratio",
        "time of a frame with this number of worlds divided by the time with one world",
        next(times, alone) / alone,
    )
    more = (
        rows[1].worlds
        if len(rows) > 1
        else absent("1", "larger numbers of worlds were not timed")
    )
    numbers = {"cheap": cheap, "ratio": ratio, "bound": limit, "next": more}
    claims = [Claim("first_worlds_are_cheap", at_least(cheap, more), numbers)]
    if len(rows) == len(
        results.rows
    ):  # CPU records and older records do not contain the loops
        return Section(tables=tables, claims=claims, unmeasured=("faster", "ways"))

    # The benchmark prints its speed only, and the time of a frame follows from that.
    gains = []
    columns: dict[str, list] = {}
    for count in TIMED_WORLDS:
        loops = {name: results.row[f"{name}-{count}"] for name in LOOPS}
        own = loops["each-step-waited-for"]
        benchmark = loops["testspeed"]
        time = own.frame_ratio * own.world_substeps_per_s
        gain = results.value(
            f"gain_{count}",
            "time of the same loop divided by the time of our frames, timed in turn, multiplied"
            " by its speed and divided by the speed of the benchmark",
            time / benchmark.world_substeps_per_s,
        )
        gains.append(gain)
        columns[worlds_name(count)] = [
            results.value(
                f"length_{name}_{count}".replace("-", "_"),
                "time of a frame divided by the time of a whole frame, timed in turn",
                PERCENT * (gain if name == "testspeed" else row.frame_ratio),
            )
            for name, row in loops.items()
        ]
    columns["contacts"] = [row.contact_count for row in loops.values()]
    columns["rows"] = [row.row_count for row in loops.values()]
    timed = [row for row in results.rows if "way" in row and row.way != "testspeed"]
    worst = resolution(results, "table_resolution", timed)
    tables["ways"] = table_of("loop", LOOPS.values(), columns, resolution=worst)
    least = results.value(
        "least_gain",
        "smallest of the ratios with 1, 4096 and 16384 worlds",
        combined(min, *gains),
    )
    faster = at_least(least, 1.0, "the same speed")
    numbers = dict(zip(("one", "some", "many"), gains, strict=True))
    claims.append(Claim("faster", faster, numbers))
    return Section(tables=tables, claims=claims)


def _cheap_worlds(limit: float, *cells: float) -> float:
    """Return the number of worlds up to which frames stay below ``limit`` times the
    first. The arguments alternate between numbers of worlds and frame times.
    """
    times = zip(cells[::2], cells[1::2], strict=True)
    cheap = takewhile(lambda timed: timed[1] <= limit * cells[1], times)
    return max(worlds for worlds, _ in cheap)
