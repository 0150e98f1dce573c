"""Parts that the scene has and does not use: the cost of each, and that nothing changes without it."""

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

from markupsafe import Markup
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from measured_report.parts.claim import HOLDS, Claim, Outcome, all_of, at_least, decided, greater, within
from measured_report.parts.figures import INK, new_figure, say_value, write
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import (
    DEVICES,
    Column,
    case_html,
    cases_html,
    cell_count,
    difference,
    largest_size,
    noise_floor,
    ratio,
    table_of,
)
from report.shared.drawing import SHIPPED, name_lines
from report.shared.timing import RowsBy, compared, resolution, worlds_name

order = 150
page = "cost"
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
BASELINE, REFERENCE, ALL = "as-shipped", "untrimmed", "without-all"
Timed = Mapping[tuple[str, str, int], Row]
"""Rows by device, case and number of worlds; a row without anything where nothing was measured."""
Faster = Mapping[tuple[str, str, int], Outcome]
"""Tests whether a case is faster than exactly as shipped, by device, case and number of worlds."""


@dataclass(frozen=True)
class Runs:
    """Runs to the end on a device, which are the same in the rows of all numbers of worlds."""

    rows: Mapping[str, Row]
    """Rows by case."""
    reference: Row
    """The untrimmed scene, or the first case that was run to the end."""
    differences: Mapping[str, Value]
    """Slip less that of the reference, by case."""


def derive(results: Results) -> Section:
    rows = [row for row in results.rows if "device" in row and row.device in DEVICES]
    timed: Timed = RowsBy(results, rows, "device", "case", "worlds")
    # Devices and numbers of worlds for which the untrimmed scene was timed, to compare with.
    untrimmed = [(key, row) for key, row in timed.items() if key[1] == REFERENCE]
    panels = [(device, worlds) for (device, _, worlds), row in untrimmed if row.frame_ms.value is not None]
    least = results.chosen("saved_least", "a gain worth naming", 1.0, unit="%")
    faster = {
        key: _is_faster(results, row, least, "_".join(map(str, key)).replace("-", "_"))
        for key, row in timed.items()
        if key[1] not in (REFERENCE, BASELINE) and (key[0], key[2]) in panels
    }
    runs, known, apart = {}, {}, {}
    for device in DEVICES:
        mine = {(case, worlds): row for (of, case, worlds), row in timed.items() if of == device}
        runs[device] = _runs_on(results, device, mine)
        known[device] = resolution(results, f"{device}_resolution", compared(mine.values()))
        apart[device] = _medians_apart(results, device, mine)
    differences = {(device, case): value for device, ran in runs.items() for case, value in ran.differences.items()}
    return Section(
        tables={
            "audit": audit_table(results),
            "cost": cost_table(timed, differences, known, apart, runs["cpu"].reference),
        },
        figures={"cost": cost_figure(timed, panels)},
        claims=[
            _faster_on_gpu(results, timed, faster),
            _faster_on_cpu(results, timed, faster),
            _less_memory(results, timed),
            _same_slip_on_gpu(results, runs["cuda"]),
            _each_helps(timed, faster, [*known.values(), *apart.values()], least),
            _same_bits(results, runs["cpu"]),
        ],
    )


def _is_faster(results: Results, row: Row, least: Value, name: str) -> Outcome:
    formula = "what a frame takes less than exactly as shipped"
    saved = results.value(f"{name}_saved", formula, lambda taken: 100 * (1 - taken), row.frame_ratio, unit="%")
    return greater(saved, least, noise=resolution(results, f"{name}_resolution", [row]))


def _found(faster: Faster, *key: Any) -> Outcome:
    return faster.get(key, Outcome("unknown", "it was not timed on this machine"))


def _runs_on(results: Results, device: str, timed: Mapping[tuple[str, int], Row]) -> Runs:
    rows: dict[str, Row] = {}
    for (case, _), row in timed.items():
        rows.setdefault(case, row)
    reference = next((row for row in rows.values() if row.slip_mm.value is not None), results.row[REFERENCE])
    differences = {}
    for case, row in rows.items():
        name = f"{device}_{case}_difference".replace("-", "_")
        formula = f"slip of {case} less that of {reference.case}, on the same device"
        differences[case] = difference(results, name, formula, row.slip_mm, reference.slip_mm)
    return Runs(rows, reference, differences)


def _medians_apart(results: Results, device: str, timed: Mapping[tuple[str, int], Row]) -> Value:
    cells: list[Quantity] = []
    for (_, worlds), row in timed.items():
        before = timed.get((REFERENCE, worlds))
        if before and before.frame_ms.value is not None and row.frame_ratio.value is not None:
            cells += row.frame_ms, before.frame_ms, row.frame_ratio

    def farthest(*cells: float) -> float:
        triples = zip(cells[::3], cells[1::3], cells[2::3], strict=True)
        return max(100 * abs(time / before / taken - 1) for time, before, taken in triples)

    formula = "how far the ratio of a median to that exactly as shipped is from that timed in turn, of it, at most"
    return results.value(f"{device}_medians_apart", formula, farthest, *cells, unit="%", is_noise=True)


def _faster_on_gpu(results: Results, timed: Timed, faster: Faster) -> Claim:
    rows = {name: timed["cuda", ALL, worlds] for name, worlds in (("one", 1), ("many", MANY_COUNT))}
    formula = "time of a frame exactly as shipped over that without all that is unneeded, timed in turn"
    gains = {
        name: results.value(f"cuda_gain_{worlds}", formula, lambda taken: 1 / taken, rows[name].frame_ratio)
        for name, worlds in (("one", 1), ("many", MANY_COUNT))
    }
    outcome = all_of(*(_found(faster, "cuda", ALL, worlds) for worlds in (1, MANY_COUNT)))
    return Claim("faster_on_gpu", outcome, gains | {"worlds": rows["many"].worlds})


def _faster_on_cpu(results: Results, timed: Timed, faster: Faster) -> Claim:
    """Tell how many times as fast it is at least: cores are shared, so that the ratio there is known badly."""
    row = timed["cpu", ALL, 1]
    formula = (
        "time of a frame on the CPU exactly as shipped over that without all that is unneeded, less its resolution"
    )
    sources = row.frame_ratio, row.ratio_resolution
    gain = results.value("cpu_gain_least", formula, lambda taken, seen: 1 / taken / (1 + seen), *sources, is_noise=True)
    return Claim("faster_on_cpu", _found(faster, "cpu", ALL, 1).having_read(gain), {"gain": gain})


def _less_memory(results: Results, timed: Timed) -> Claim:
    """Tell how much less memory it takes where the saving is least, of all devices and numbers of worlds."""
    pairs = [(row, timed[device, ALL, worlds]) for (device, case, worlds), row in timed.items() if case == REFERENCE]
    sizes = [tuple(row.buffer_bytes_per_world for row in pair) for pair in pairs]
    there = [pair for pair in sizes if all(size.value for size in pair)]
    lost = results.row[REFERENCE].buffer_bytes_per_world
    before, after = min(there, key=lambda pair: pair[0].value / pair[1].value, default=(lost, lost))
    formula = "contact and constraint memory per world exactly as shipped over that without all that is unneeded"
    saving = ratio(results, "memory_saving", formula, before, after)
    bound = results.chosen("memory_saving_bound", "a saving worth having", 20.0)
    return Claim("less_memory", at_least(saving, bound), {"saving": saving, "before": before, "after": after})


def _same_slip_on_gpu(results: Results, runs: Runs) -> Claim:
    """Compare means over the worlds that each case was run in."""
    floor = noise_floor(results, "slip_floor")
    ran = {case: runs.differences[case] for case, run in runs.rows.items() if run.slip_mm.value is not None}
    formula = "largest difference in slip from the reference of that device, either way"
    largest = largest_size(results, "cuda_largest_difference", formula, ran.values(), unit="mm")
    most = [max(ran, key=lambda case: abs(ran[case].value or 0.0))] if ran else []
    outcome = within(largest, floor) if ran else Outcome("unknown", "no case was run to the end there")
    farthest = cases_html(runs.rows[case] for case in most)
    return Claim("same_slip_on_gpu", outcome, {"largest": largest, "floor": floor, "most": farthest})


def _each_helps(timed: Timed, faster: Faster, known_within: Sequence[Value], least: Value) -> Claim:
    alone = {case: [faster[key] for key in faster if key[1] == case] for _, case, _ in faster if case != ALL}
    helping = [by_case(timed)[case] for case, found in alone.items() if HOLDS in found]
    outcome = decided(len(helping) == len(alone)) if alone else Outcome("unknown", "nothing was left out alone")
    reads = all_of(*(outcome for found in alone.values() for outcome in found)).reads
    outcome = replace(outcome, reads=reads).having_read(*known_within)
    return Claim("each_helps", outcome, {"helping": cases_html(helping), "least": least})


def _same_bits(results: Results, runs: Runs) -> Claim:
    """Judge on the CPU: a GPU adds up in another order each time, and does not even repeat itself."""
    others = [row for row in runs.rows.values() if "differing_frame_count" in row and row is not runs.reference]
    counts = [row.differing_frame_count for row in others]
    formula = "runs on the CPU with a frame unlike the reference's"
    differing = results.value("cpu_differing_count", formula, lambda *found: sum(n > 0 for n in found), *counts)
    count = cell_count(results, "cpu_compared_count", "runs on the CPU compared with the reference", counts)
    formula = "largest distance of any body in any frame from where it is in the reference, on the CPU"
    largest = results.value("cpu_pose_difference", formula, max, *(row.pose_difference_mm for row in others), unit="mm")
    outcome = Outcome("unknown", "nothing was run to the end on a CPU, and a GPU does not repeat itself to the bit")
    if others:
        outcome = decided(differing.value == 0, differing, largest)
    numbers = {"differing": differing, "count": count, "reference": case_html(runs.reference)}
    return Claim("same_bits", outcome, numbers)


def audit_table(results: Results) -> Table:
    rows = [row for row in results.rows if "item" in row]
    items = [row.item.split(", against ") for row in rows]
    columns: dict[str, Column] = {
        "there": lambda row: _whole(results, row, "present"),
        "used": lambda row: _whole(results, row, "used"),
        "counted as used": [", ".join(item[1:]) for item in items],
    }
    return table_of("part", [item[0] for item in items], columns, rows)


def _whole(results: Results, row: Row, column: str) -> Quantity:
    """Write a count as the whole number that it is; a mean stays as it was measured."""
    measured = row[column]
    if measured.value is None or measured.value % 1:
        return measured
    return results.value(f"{row.case}_{column}".replace("-", "_"), "the count, as a whole number", round, measured)


def by_case(timed: Timed) -> dict[str, Row]:
    return {case: row for (_, case, _), row in timed.items()}


def cost_table(
    timed: Timed,
    differences: Mapping[tuple[str, str], Value],
    resolutions: Mapping[str, Value],
    apart: Mapping[str, Value],
    cpu_reference: Row,
) -> Table:
    names = list(dict.fromkeys(case for _, case, _ in timed))
    places = sorted({(device, worlds) for device, _, worlds in timed}, key=lambda place: (place[0] == "cpu", place))
    columns: dict[str, Column] = {}
    for device, worlds in places:
        rows = [timed.get((device, name, worlds)) for name in names]
        columns[f"{DEVICES[device]}, {worlds_name(worlds)}"] = [row.frame_ms if row else "" for row in rows]
    runs = {name: row for (device, name, _), row in reversed(list(timed.items())) if device == places[0][0]}
    columns["memory"] = [runs[name].buffer_bytes_per_world if name in runs else "" for name in names]
    for device in dict.fromkeys(device for device, _ in places):
        columns[f"slip, {DEVICES[device]}"] = [differences.get((device, name), "") for name in names]
    other = case_html(cpu_reference) if cpu_reference.case != REFERENCE else ""
    said: dict[str, Any] = {f"on_{device}": within for device, within in resolutions.items()}
    said |= {f"apart_{device}": most for device, most in apart.items()}
    return table_of("case", map(case_html, by_case(timed).values()), columns, cpu_reference=other, **said)


def cost_figure(timed: Timed, panels: Sequence[tuple[str, int]]) -> Figure:
    """Show each device with the number of worlds that most cases were timed with, the largest of such."""
    count = Counter((device, worlds) for (device, _, worlds), row in timed.items() if row.frame_ms.value is not None)
    most = dict(sorted(panels, key=lambda panel: (count[panel], panel[1])))
    shown = [(device, most[device]) for device in DEVICES if device in most]
    ends = {
        (device, worlds, case): timed[device, case, worlds].frame_ms
        for device, worlds in shown
        for case in (REFERENCE, ALL)
    }
    times = Markup("; ").join(
        Markup("{} on the {}, {}: {}").format(by_case(timed)[case].label, DEVICES[device], worlds_name(worlds), time)
        for (device, worlds, case), time in ends.items()
    )
    device, worlds = max(shown, key=lambda panel: panel[1])
    numbers: dict[str, Any] = {"times": times, "device": DEVICES[device], "worlds": worlds_name(worlds)}
    numbers |= {"before": ends[device, worlds, REFERENCE], "after": ends[device, worlds, ALL]}
    sources = [row.frame_ms for (device, _, worlds), row in timed.items() if (device, worlds) in shown]
    return Figure(lambda: _draw_cost(timed, shown), sources, numbers)


def _draw_cost(timed: Timed, panels: Sequence[tuple[str, int]]) -> Drawing:
    names = list(dict.fromkeys(case for _, case, _ in timed))
    drawing, grid = new_figure(7.2, 1.3 + 0.28 * len(names), ncols=len(panels), sharey=True, squeeze=False)
    for axes, (device, worlds) in zip(grid[0], panels, strict=True):
        whole = timed[device, REFERENCE, worlds].frame_ms.value
        for place, case in enumerate(names):
            row = timed[device, case, worlds]
            if whole and row.frame_ms.value is not None:
                _draw_time(axes, place, row, whole)
            else:
                say_value(axes, 0.0, place, "not timed")
        axes.axvline(100, color=INK, linewidth=1, linestyle="--")
        axes.set_xlim(0, 1.15 * axes.get_xlim()[1])
        axes.set_title(f"{DEVICES[device]}\n{worlds_name(worlds)}")
        axes.grid(axis="y", visible=False)
    name_lines(grid[0][0], [row.label for row in by_case(timed).values()])
    drawing.supxlabel("time of a frame as a share of that exactly as shipped [%]", fontsize=10)
    return drawing


def _draw_time(axes: Axes, place: int, row: Row, whole: float) -> None:
    middle, low, high = (100 * row[name].value / whole for name in ("frame_ms", "frame_ms_p5", "frame_ms_p95"))
    axes.barh(place, middle, height=0.62, color=SHIPPED, edgecolor=INK, linewidth=0.6)
    # Beside the line, and not on it.
    say_value(axes, max(high, 100) if high > 80 else high, place, write(row.frame_ms))
    axes.plot([low, high], [place, place], color=INK, linestyle="-", marker="|", markevery=1, linewidth=1.2)
