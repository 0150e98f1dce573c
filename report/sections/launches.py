"""Whose the launches of a frame are, and what a frame takes without some of them."""

from measured_report.parts.claim import Claim, all_of, at_least, at_most
from measured_report.parts.section import Section, Table
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.names import worlds_name
from report.shared.arithmetic import Column, cell_or_absent, extreme, share, table_of, total
from report.shared.timing import fine_enough, ratio_cell, resolution

order = 174
page = "cost"
label = "launches of a frame"

OWNERS = {"engine": "MuJoCo Warp", "newton": "Newton", "scene": "this scene", "warp": "memory operations"}
SWITCHED = {
    "recording": "recording",
    "watching": "watching the buffers in each substep",
    "inverse-kinematics": "inverse kinematics",
    "control": "targets and inverse kinematics",
    "collision": "collision",
    "contacts-once": "contacts into the engine in each substep, but once",
    "state-once": "the state into Newton in each substep, but once",
    "sensors": "the engine's sensor stage",
    "limits": "looking for joints at their limits",
}
"""What is left out, in words, by the name in the record."""
SHOWN_COUNT = 12
"""Kernels in the table."""


def derive(results: Results) -> Section:
    kernels = [row for row in results.rows if "kernel" in row]
    counts = sorted({row.worlds.value for row in results.rows})
    first = [row for row in kernels if row.worlds.value == counts[0]]
    launches = {
        owner: total(
            results,
            f"launches_{owner}",
            f"launches of a frame with one world: {words}",
            [row.launch_count for row in first if row.owner == owner],
        )
        for owner, words in OWNERS.items()
    }
    every = total(results, "launches", "launches of a frame with one world", list(launches.values()))
    part = share(results, "engine_share", "launches of the engine, of all of a frame", launches["engine"], every)
    claim = Claim("mostly_the_engine", at_least(part, 50.0, why="most"), {"part": part, "every": every, **launches})
    switched = _switched(results, counts)
    tables = {"switched": switched, "kernels": _kernels(results, first, counts)}
    return Section(tables=tables, claims=[claim, _little_to_leave_out(results, counts, switched.numbers["resolution"])])


def _little_to_leave_out(results: Results, counts: list[int], resolution: Value) -> Claim:
    """Tell whether any one part less makes a frame much shorter."""
    saved = [results.derived[_saved_name(name, count)] for count in counts for name in SWITCHED]
    largest = extreme(results, "saved_most", "most of a frame's time that one part takes", max, saved)
    bound = results.chosen("saved_bound", "little", 10.0, unit="%")
    outcome = all_of(at_most(largest, bound), fine_enough(resolution))
    return Claim("little_to_leave_out", outcome, {"largest": largest, "bound": bound})


def _saved(results: Results, row: Row | None, name: str, count: int) -> Value:
    """Derive how much less of a frame's time is taken without this [%]."""
    taken = ratio_cell(results, row)
    formula = f"one less the time of a frame without {SWITCHED[name]} over that of a whole frame"
    return results.value(_saved_name(name, count), formula, lambda taken: 100 * (1 - taken), taken, unit="%")


def _saved_name(name: str, count: int) -> str:
    return f"saved_{name}_{count}".replace("-", "_")


def _switched(results: Results, counts: list[int]) -> Table:
    columns: dict[str, Column] = {}
    compared: list[Row | None] = []
    for count in counts:
        rows = {name: results.row.get(f"without-{name}-{count}") for name in SWITCHED}
        columns[worlds_name(count)] = [_saved(results, row, name, count) for name, row in rows.items()]
        compared += rows.values()
    worst = resolution(results, "resolution", *compared)
    return table_of("without", SWITCHED.values(), columns, resolution=worst)


def _kernels(results: Results, first: list[Row], counts: list[int]) -> Table:
    """Show the kernels that take the longest with the most worlds, or are launched most where none is timed."""
    most = {row.kernel: row for row in results.rows if "kernel" in row and row.worlds.value == counts[-1]}
    alone = {row.kernel: row for row in first}
    order = sorted(alone, key=lambda kernel: -_weight(most.get(kernel)))[:SHOWN_COUNT]
    columns = {
        "whose": [OWNERS[alone[kernel].owner] for kernel in order],
        "launches": [alone[kernel].launch_count for kernel in order],
    }
    for count, rows in dict.fromkeys(((counts[0], "alone"), (counts[-1], "most"))):
        found = alone if rows == "alone" else most
        columns[f"time, {worlds_name(count)}"] = [
            cell_or_absent(found.get(kernel), "kernels_ms", "ms", "it was not launched") for kernel in order
        ]
    return table_of("kernel", [kernel.split("__locals__")[0] for kernel in order], columns)


def _weight(row: Row | None) -> float:
    found = (row.kernels_ms.value, row.launch_count.value) if row else (None, None)
    return found[0] or (found[1] or 0.0) / 1e6
