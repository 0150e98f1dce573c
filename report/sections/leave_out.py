"""Parts that the scene has and does not use: the cost of each, and that nothing changes without it."""

from collections.abc import Mapping, Sequence
from typing import Any

from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from measured_report.parts.claim import Claim, Outcome, all_of, at_least, greater, within
from measured_report.parts.figures import INK, new_figure, say_value, write
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import DEVICES, Column, case_html, difference, largest_size, noise_floor, ratio, table_of
from report.shared.drawing import SHIPPED, name_lines
from report.shared.timing import RowsBy, compared, resolution, worlds_name

order = 150
page = "error"
reads = ("noise",)
label = "what to leave out"
labels = {
    "untrimmed": "exactly as shipped",
    "as-shipped": "shipped pads",
    "without-all": "without all of it",
    "without-buffers": "without room in the buffers",
    "without-ik-in-turn": "without waiting for IK",
    "without-ik-iterations": "without most IK iterations",
    "without-state-sync": "without writing the state",
    "without-cube-gap": "without the cube's wide gap",
    "without-hand-box": "without the hand's box",
    "without-visuals": "without visual shapes",
    "without-broad-phase": "without the broad phase",
}

MANY_COUNT = 16384
"""The most worlds, for which there is a target."""
REFERENCE, ALL = "untrimmed", "without-all"
Timed = Mapping[tuple[str, str, int], Row]
"""Rows by device, case and number of worlds; a row without anything where nothing was measured."""


def derive(results: Results) -> Section:
    rows = [row for row in results.rows if "device" in row and row.device in DEVICES]
    timed: Timed = RowsBy(results, rows, "device", "case", "worlds")
    # Of runs to the end, which are the same in the rows of all numbers of worlds.
    ran = {case: row for (device, case, _), row in reversed([*timed.items()]) if device == "cuda"}
    formula = f"slip of {{}} less that of {REFERENCE}, on the same device"
    differences = {
        case: difference(
            results,
            f"cuda_{case}_difference".replace("-", "_"),
            formula.format(case),
            row.slip_mm,
            ran.get(REFERENCE, results.row[REFERENCE]).slip_mm,
        )
        for case, row in ran.items()
    }
    known = {
        device: resolution(
            results, f"{device}_resolution", compared(row for (of, *_), row in timed.items() if of == device)
        )
        for device in DEVICES
    }
    return Section(
        tables={"audit": audit_table(results), "cost": cost_table(timed, differences, known)},
        figures={"cost": cost_figure(timed)},
        claims=[
            _faster_on_gpu(results, timed, known["cuda"]),
            _faster_on_cpu(results, timed, known["cpu"]),
            _less_memory(results, timed),
            _same_slip_on_gpu(results, differences),
        ],
    )


def _device(timed: Timed) -> str:
    """Return the GPU where there is one."""
    return max((device for device, *_ in timed), default="cuda")


def _is_faster(results: Results, row: Row, name: str) -> Outcome:
    formula = "what a frame takes less than exactly as shipped"
    saved = results.value(f"{name}_saved", formula, lambda taken: 100 * (1 - taken), row.frame_ratio, unit="%")
    noise = resolution(results, f"{name}_resolution", [row])
    return greater(saved, 1.0, noise=noise, why="a gain worth naming")


def _faster_on_gpu(results: Results, timed: Timed, known: Value) -> Claim:
    formula = "time of a frame exactly as shipped over that without all that is unneeded, timed in turn"
    gains, outcomes = [], []
    for worlds in (1, MANY_COUNT):
        row = timed["cuda", ALL, worlds]
        gains.append(results.value(f"cuda_gain_{worlds}", formula, lambda taken: 1 / taken, row.frame_ratio))
        outcomes.append(_is_faster(results, row, f"cuda_without_all_{worlds}"))
    numbers = {"one": gains[0], "many": gains[1], "worlds": timed["cuda", ALL, MANY_COUNT].worlds}
    return Claim("faster_on_gpu", all_of(*outcomes).having_read(known), numbers)


def _faster_on_cpu(results: Results, timed: Timed, known: Value) -> Claim:
    """Tell how many times as fast it is at least: cores are shared, so that the ratio there is known badly."""
    row = timed["cpu", ALL, 1]
    formula = (
        "time of a frame on the CPU exactly as shipped over that without all that is unneeded, less its resolution"
    )
    sources = row.frame_ratio, row.ratio_resolution
    gain = results.value("cpu_gain_least", formula, lambda taken, seen: 1 / taken / (1 + seen), *sources, is_noise=True)
    return Claim(
        "faster_on_cpu", _is_faster(results, row, "cpu_without_all_1").having_read(gain, known), {"gain": gain}
    )


def _less_memory(results: Results, timed: Timed) -> Claim:
    before, after = (timed[_device(timed), case, 1].buffer_bytes_per_world for case in (REFERENCE, ALL))
    formula = "contact and constraint memory per world exactly as shipped over that without all that is unneeded"
    saving = ratio(results, "memory_saving", formula, before, after)
    bound = results.chosen("memory_saving_bound", "a saving worth having", 20.0)
    return Claim("less_memory", at_least(saving, bound), {"saving": saving, "before": before, "after": after})


def _same_slip_on_gpu(results: Results, differences: Mapping[str, Value]) -> Claim:
    """Compare means over the worlds that each case was run in."""
    floor = noise_floor(results, "slip_floor")
    formula = "largest difference in slip from the reference of that device, either way"
    largest = largest_size(results, "cuda_largest_difference", formula, differences.values(), unit="mm")
    return Claim("same_slip_on_gpu", within(largest, floor), {"largest": largest, "floor": floor})


def audit_table(results: Results) -> Table:
    rows = [row for row in results.rows if "item" in row]
    items = [row.item.partition(", against ") for row in rows]
    columns: dict[str, Column] = {"there": lambda row: _whole(results, row, "present")}
    columns |= {"used": lambda row: _whole(results, row, "used"), "counted as used": [item[2] for item in items]}
    return table_of("part", [item[0] for item in items], columns, rows)


def _whole(results: Results, row: Row, column: str) -> Quantity:
    """Write a count as the whole number that it is; a mean stays as it was measured."""
    measured = row[column]
    if measured.value is None or measured.value % 1:
        return measured
    return results.value(f"{row.case}_{column}".replace("-", "_"), "the count, as a whole number", round, measured)


def cost_table(timed: Timed, differences: Mapping[str, Value], known: Mapping[str, Value]) -> Table:
    cases = {case: row for (_, case, _), row in timed.items()}
    places = sorted({(device, worlds) for device, _, worlds in timed}, key=lambda place: (place[0] == "cpu", place))
    columns: dict[str, Column] = {
        f"{DEVICES[device]}, {worlds_name(worlds)}": [
            timed[device, case, worlds].frame_ms if (device, case, worlds) in timed else "" for case in cases
        ]
        for device, worlds in places
    }
    columns["memory"] = [timed[_device(timed), case, 1].buffer_bytes_per_world for case in cases]
    if differences:
        columns["slip, GPU"] = [differences.get(case, "") for case in cases]
    said: dict[str, Any] = {f"on_{device}": within for device, within in known.items()}
    return table_of("case", map(case_html, cases.values()), columns, **said)


def cost_figure(timed: Timed) -> Figure:
    """Show the fewest worlds and the most."""
    device = _device(timed)
    counts = sorted({1, *(worlds for of, case, worlds in timed if (of, case) == (device, REFERENCE))})
    shown = [1, *counts[1:][-1:]]
    ends = {(case, worlds): timed[device, case, worlds].frame_ms for worlds in shown for case in (REFERENCE, ALL)}
    times = Markup("; ").join(
        Markup("{}, {}: {}").format(worlds_name(worlds), labels[case], time) for (case, worlds), time in ends.items()
    )
    numbers: dict[str, Any] = {"times": times, "device": DEVICES[device], "worlds": worlds_name(shown[-1])}
    numbers |= {"before": ends[REFERENCE, shown[-1]], "after": ends[ALL, shown[-1]]}
    sources = [row.frame_ms for (of, _, worlds), row in timed.items() if of == device and worlds in shown]
    return Figure(lambda: _draw_cost(timed, device, shown), sources, numbers)


def _draw_cost(timed: Timed, device: str, shown: Sequence[int]) -> Drawing:
    cases = {case: row for (_, case, _), row in timed.items()}
    drawing, grid = new_figure(7.2, 1.3 + 0.28 * len(cases), ncols=len(shown), sharey=True, squeeze=False)
    for axes, worlds in zip(grid[0], shown, strict=True):
        for place, case in enumerate(cases):
            row = timed[device, case, worlds]
            share = 100 * (row.frame_ratio.value or 0.0)
            axes.barh(place, share, height=0.62, color=SHIPPED, edgecolor=INK, linewidth=0.6)
            say_value(axes, share, place, f"{write(row.frame_ms)} ms" if share else "not timed")
        axes.set_xlim(0, 135)
        axes.set_title(f"{DEVICES[device]}, {worlds_name(worlds)}")
        axes.grid(axis="y", visible=False)
    name_lines(grid[0][0], [row.label for row in cases.values()])
    drawing.supxlabel("time of a frame as a share of that exactly as shipped, timed in turn [%]", fontsize=10)
    return drawing
