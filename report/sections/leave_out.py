"""Parts that the scene has and does not use: the cost of each, and that nothing changes without it."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

from measured_report.parts.claim import Claim, Outcome, all_of, at_least, greater, within
from measured_report.parts.figures import INK, new_figure, say_value, write
from measured_report.parts.section import Figure, Section, Table
from measured_report.values.quantities import PERCENT, Quantity, Value
from measured_report.values.results import Results, Row
from report.shared.arithmetic import DEVICES, largest_size, noise_floor
from report.shared.drawing import CURE, SHIPPED, STIFF, name_lines
from report.shared.tables import table_of
from report.shared.timing import RowsBy, resolution, worlds_name

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

MANY_COUNT = 16384  # the most worlds, for which there is a target
COUNTS = {"there": "present", "used": "used"}
REFERENCE, ALL = "untrimmed", "without-all"
Timed = Mapping[tuple[str, str, int], Row]  # rows by device, case and number of worlds; empty where not measured
WHOLE = (REFERENCE, "as-shipped", ALL)  # cases that are more than one thing left out


def derive(results: Results) -> Section:
    rows = [row for row in results.rows if "device" in row and row.device in DEVICES]
    timed: Timed = RowsBy(results, rows, "device", "case", "worlds")
    # Of runs to the end, which are the same in the rows of all numbers of worlds.
    ran = {case: row for (device, case, _), row in reversed([*timed.items()]) if device == "cuda"}
    base, differences, resolutions = ran.get(REFERENCE, results.row[REFERENCE]).slip_mm, {}, {}
    for case, row in ran.items():
        name, formula = f"cuda_{case}_difference".replace("-", "_"), f"slip of {case} less that of {REFERENCE}"
        differences[case] = results.value(name, f"{formula}, on the same device", row.slip_mm - base)
    for device in DEVICES:
        times = (row for (of, *_), row in timed.items() if of == device)
        resolutions[device] = resolution(results, f"{device}_resolution", times)
    tables = {"audit": audit_table(results)}
    figures = {"cost": cost_figure(results, timed)}
    claims = [_faster_on_gpu(results, timed, resolutions["cuda"]), _faster_on_cpu(results, timed, resolutions["cpu"])]
    claims += [_less_memory(results, timed), _same_slip_on_gpu(results, differences)]
    return Section(tables=tables, figures=figures, claims=claims)


def _device(timed: Timed) -> str:
    """Return the GPU where there is one."""
    return max((device for device, *_ in timed), default="cuda")


def _saved(results: Results, timed: Timed, device: str, case: str, worlds: int) -> Value:
    """Derive, once, what a frame takes less than exactly as shipped."""
    name = f"{device}_{case}_{worlds}_less".replace("-", "_")
    formula = "what a frame takes less than exactly as shipped, timed in turn"
    cell = timed[device, case, worlds].frame_ratio
    return results.derived.get(name) or results.value(name, formula, PERCENT * (1 - cell))


def _is_faster(results: Results, timed: Timed, device: str, worlds: int) -> Outcome:
    return greater(_saved(results, timed, device, ALL, worlds), 1.0, why="a gain worth naming")


def _faster_on_gpu(results: Results, timed: Timed, resolved: Value) -> Claim:
    formula = "time of a frame exactly as shipped over that without all that is unneeded, timed in turn"
    gains, outcomes = [], []
    for worlds in (1, MANY_COUNT):
        row = timed["cuda", ALL, worlds]
        gains.append(results.value(f"cuda_gain_{worlds}", formula, 1 / row.frame_ratio))
        outcomes.append(_is_faster(results, timed, "cuda", worlds))
    numbers = {"one": gains[0], "many": gains[1], "worlds": timed["cuda", ALL, MANY_COUNT].worlds}
    return Claim("faster_on_gpu", all_of(*outcomes).having_read(resolved), numbers)


def _faster_on_cpu(results: Results, timed: Timed, resolved: Value) -> Claim:
    """Tell how many times as fast it is at least: cores are shared, so that the ratio there is known badly."""
    row = timed["cpu", ALL, 1]
    formula = "time of a frame on the CPU exactly as shipped over that without all of it, less its resolution"
    gain = results.value("cpu_gain_least", formula, 1 / row.frame_ratio / (1 + row.ratio_resolution), is_noise=True)
    return Claim("faster_on_cpu", _is_faster(results, timed, "cpu", 1).having_read(gain, resolved), {"gain": gain})


def _less_memory(results: Results, timed: Timed) -> Claim:
    before, after = (timed[_device(timed), case, 1].buffer_bytes_per_world for case in (REFERENCE, ALL))
    formula = "contact and constraint memory per world exactly as shipped over that without all that is unneeded"
    saving = results.value("memory_saving", formula, before / after)
    bound = results.chosen("memory_saving_bound", "a saving worth having", 20.0)
    return Claim("less_memory", at_least(saving, bound), {"saving": saving, "before": before, "after": after})


def _same_slip_on_gpu(results: Results, differences: Mapping[str, Value]) -> Claim:
    """Compare means over the worlds that each case was run in."""
    floor = noise_floor(results, "slip_floor")
    formula = "largest difference in slip from the reference of that device, either way"
    largest = results.value("cuda_largest_difference", formula, largest_size(differences.values()))
    return Claim("same_slip_on_gpu", within(largest, floor), {"largest": largest, "floor": floor})


def audit_table(results: Results) -> Table:
    rows = [row for row in results.rows if "item" in row]
    items = [row.item.partition(", against ") for row in rows]
    columns = {above: [_whole(results, row, name) for row in rows] for above, name in COUNTS.items()}
    columns["counted as used"] = [item[2] for item in items]
    return table_of("part", [item[0] for item in items], columns)


def _whole(results: Results, row: Row, column: str) -> Quantity:
    """Write a count as the whole number that it is; a mean stays as it was measured."""
    measured = row[column]
    if measured.value is None or measured.value % 1:
        return measured
    return results.value(f"{row.case}_{column}".replace("-", "_"), "the count, as a whole number", round, measured)


@dataclass(frozen=True)
class Fall:
    """What frames of so many worlds take less, in percent of one exactly as shipped."""

    worlds: int
    steps: Mapping[str, tuple[Quantity, Row]]  # by case, with one thing left out, timed in turn with all
    rest: Value  # what all left out together save beyond the sum of these
    ends: tuple[Row, Row]  # exactly as shipped, and without all of it


def _fall(results: Results, timed: Timed, device: str, worlds: int) -> Fall:
    alone = dict.fromkeys(case for _, case, _ in timed if case not in WHOLE)
    steps = {case: (_saved(results, timed, device, case, worlds), timed[device, case, worlds]) for case in alone}
    formula = "what a frame without all of it takes less, less what it takes less for each thing that was timed alone"
    whole, parts = _saved(results, timed, device, ALL, worlds), (step for step, _ in steps.values())
    beyond = whole - sum(part for part in parts if part.value is not None)
    rest = results.value(f"{device}_together_{worlds}_less", formula, beyond)
    return Fall(worlds, steps, rest, (timed[device, REFERENCE, worlds], timed[device, ALL, worlds]))


def cost_figure(results: Results, timed: Timed) -> Figure:
    """Show the fewest worlds and the most."""
    device = _device(timed)
    counts = sorted({1, *(worlds for of, case, worlds in timed if (of, case) == (device, REFERENCE))})
    falls = [_fall(results, timed, device, worlds) for worlds in dict.fromkeys((counts[-1], 1))]
    line, ends = Markup("{}: {}, then {}"), [[end.frame_ms for end in fall.ends] for fall in falls]
    lines = [line.format(worlds_name(fall.worlds), *each) for fall, each in zip(falls, ends, strict=True)]
    before, after = ends[0]
    numbers: dict[str, Any] = {"times": Markup("; ").join(lines), "worlds": worlds_name(counts[-1])}
    sources = [cell for fall in falls for cell in (*(step for step, _ in fall.steps.values()), fall.rest)]
    numbers |= {"before": before, "after": after}
    return Figure(lambda: _draw_falls(falls), [*sources, before, after], numbers)


def _draw_falls(falls: Sequence[Fall]) -> Drawing:
    first = falls[0].steps
    order = sorted(first, key=lambda case: -(first[case][0].value or -1e3))
    drawing, grid = new_figure(7.2, 1.4 + 0.26 * len(order), ncols=len(falls), sharey=True, squeeze=False)
    for axes, fall in zip(grid[0], falls, strict=True):
        _draw_fall(axes, fall, order)
        axes.set_title(worlds_name(fall.worlds))
    names = [first[case][1].label for case in order]
    name_lines(grid[0][0], ["exactly as shipped", *names, "together, beyond these", "without all of it"])
    drawing.supxlabel("time of a frame [% of that exactly as shipped]", fontsize=10)
    return drawing


def _draw_fall(axes: Axes, fall: Fall, order: Sequence[str]) -> None:
    """Draw a bar from what is left before a thing is left out to what is left after, with its interval."""
    left = 100.0
    style: dict[str, Any] = {"height": 0.62, "linewidth": 0}
    axes.barh(0, left, color=SHIPPED, **style)
    say_value(axes, left, 0, f"{write(fall.ends[0].frame_ms)} ms")
    steps = [(fall.steps[case][0], fall.steps[case][1].ratio_resolution.value) for case in order]
    for place, (saved, seen) in enumerate([*steps, (fall.rest, None)], 1):
        if saved.value is None:
            say_value(axes, 0.0, place, "not timed alone")
            continue
        axes.barh(place, -saved.value, left=left, color=STIFF if saved.value > 0 else INK, **style)
        right, left = max(left, left - saved.value), left - saved.value
        axes.errorbar(left, place, xerr=100 * (seen or 0.0), color=INK, linewidth=1.0, capsize=0, marker="")
        say_value(axes, right, place, f"{write(saved)} %")
    end = len(order) + 2
    axes.barh(end, 100 * (fall.ends[1].frame_ratio.value or 0.0), color=CURE, **style)
    say_value(axes, 100 * (fall.ends[1].frame_ratio.value or 0.0), end, f"{write(fall.ends[1].frame_ms)} ms")
    axes.set_xlim(0, 135)
    axes.grid(axis="y", visible=False)
