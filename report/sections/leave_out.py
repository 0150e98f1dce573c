"""Parts that the scene has and does not use: the cost of each, and that nothing changes without it."""

import math
from collections.abc import Mapping, Sequence
from typing import Any

from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import FAINT, INK, new_figure, say_value, write
from report.shared import (
    DEVICES,
    PERCENT,
    Claim,
    Figure,
    Outcome,
    Quantity,
    Results,
    Row,
    RowsBy,
    Section,
    Table,
    Value,
    all_of,
    at_least,
    greater,
    largest_size,
    noise_floor,
    resolution,
    table_of,
    within,
    worlds_name,
)
from report.shared.drawing import STIFF, name_lines

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
ALONE_COUNT = 4096  # the number for which every step was timed alone
COUNTS = {"there": "present", "used": "used"}
REFERENCE, ALL = "untrimmed", "without-all"
Timed = Mapping[
    tuple[str, str, int], Row
]  # rows by device, case and number of worlds; empty where not measured
WHOLE = (REFERENCE, "as-shipped", ALL)  # cases that are more than one thing left out


def derive(results: Results) -> Section:
    rows = [row for row in results.rows if "device" in row and row.device in DEVICES]
    timed: Timed = RowsBy(results, rows, "device", "case", "worlds")
    # Of runs to the end, which are the same in the rows of all numbers of worlds.
    ran = {
        case: row
        for (device, case, _), row in reversed([*timed.items()])
        if device == "cuda"
    }
    base, differences, resolutions = (
        ran.pop(REFERENCE, results.row[REFERENCE]).slip_mm,
        {},
        {},
    )
    for case, row in ran.items():
        name, formula = (
            f"cuda_{case}_difference".replace("-", "_"),
            f"slip of {case} less that of {REFERENCE}",
        )
        differences[case] = results.value(
            name, f"{formula}, on the same device", row.slip_mm - base
        )
    for name in DEVICES:
        times = (row for (device, *_), row in timed.items() if device == name)
        resolutions[name] = resolution(results, f"{name}_resolution", times)
    device = max(
        (device for device, *_ in timed), default="cuda"
    )  # the GPU where there is one
    claims = [
        _faster_on_gpu(results, timed, resolutions["cuda"]),
        _faster_on_cpu(results, timed, resolutions["cpu"]),
    ]
    claims += [_less_memory(results, timed, device)]
    # Of means over the worlds that each case was run in.
    floor = noise_floor(results, "slip_floor")
    largest = results.value(
        "cuda_largest_difference",
        "largest difference in slip from the reference of that device, either way",
        largest_size(differences.values()),
    )
    claims += [
        Claim(
            "same_slip_on_gpu",
            within(largest, floor),
            {"largest": largest, "floor": floor},
        )
    ]
    figures = {"cost": cost_figure(results, timed, device)}
    return Section(
        tables={"audit": audit_table(results)}, figures=figures, claims=claims
    )


def _saved(
    results: Results, timed: Timed, device: str, case: str, worlds: int
) -> Value:
    """Derive, once, what a frame takes less than exactly as shipped."""
    name = f"{device}_{case}_{worlds}_less".replace("-", "_")
    cell = timed[device, case, worlds].frame_ratio
    return results.derived.get(name) or results.value(
        name,
        "what a frame takes less than exactly as shipped, timed in turn",
        PERCENT * (1 - cell),
    )


def _is_faster(results: Results, timed: Timed, device: str, worlds: int) -> Outcome:
    return greater(
        _saved(results, timed, device, ALL, worlds), 1.0, why="a gain worth naming"
    )


def _faster_on_gpu(results: Results, timed: Timed, resolved: Value) -> Claim:
    gains, outcomes = [], []
    for worlds in (1, MANY_COUNT):
        gains.append(
            results.value(
                f"cuda_gain_{worlds}",
                "time of a frame exactly as shipped over that without all that is unneeded, timed in turn",
                1 / timed["cuda", ALL, worlds].frame_ratio,
            )
        )
        outcomes.append(_is_faster(results, timed, "cuda", worlds))
    numbers = {
        "one": gains[0],
        "many": gains[1],
        "worlds": timed["cuda", ALL, MANY_COUNT].worlds,
    }
    return Claim("faster_on_gpu", all_of(*outcomes).having_read(resolved), numbers)


def _faster_on_cpu(results: Results, timed: Timed, resolved: Value) -> Claim:
    """Tell how many times as fast it is at least: cores are shared, so that the ratio there is known badly."""
    row = timed["cpu", ALL, 1]
    gain = results.value(
        "cpu_gain_least",
        "time of a frame on the CPU exactly as shipped over that without all of it, less its resolution",
        1 / row.frame_ratio / (1 + row.ratio_resolution),
        is_noise=True,
    )
    return Claim(
        "faster_on_cpu",
        _is_faster(results, timed, "cpu", 1).having_read(gain, resolved),
        {"gain": gain},
    )


def _less_memory(results: Results, timed: Timed, device: str) -> Claim:
    before, after = (
        timed[device, case, 1].buffer_bytes_per_world for case in (REFERENCE, ALL)
    )
    saving = results.value(
        "memory_saving",
        "contact and constraint memory per world exactly as shipped over that without all that is unneeded",
        before / after,
    )
    bound = results.chosen("memory_saving_bound", "a saving worth having", 20.0)
    return Claim(
        "less_memory",
        at_least(saving, bound),
        {"saving": saving, "before": before, "after": after},
    )


def audit_table(results: Results) -> Table:
    rows = [row for row in results.rows if "item" in row]
    items = [row.item.partition(", against ") for row in rows]
    columns = {
        above: [_whole(results, row, name) for row in rows]
        for above, name in COUNTS.items()
    }
    columns["counted as used"] = [item[2] for item in items]
    return table_of("part", [item[0] for item in items], columns)


def _whole(results: Results, row: Row, column: str) -> Quantity:
    """Write a count as the whole number that it is; a mean stays as it was measured."""
    measured = row[column]
    if measured.value is None or measured.value % 1:
        return measured
    return results.value(
        f"{row.case}_{column}".replace("-", "_"),
        "the count, as a whole number",
        round,
        measured,
    )


def cost_figure(results: Results, timed: Timed, device: str) -> Figure:
    """Show what each thing costs by itself, with the number of worlds for which each was timed alone."""
    counts = sorted(
        {
            1,
            *(
                worlds
                for of, case, worlds in timed
                if (of, case) == (device, REFERENCE)
            ),
        }
    )
    worlds = ALONE_COUNT if ALONE_COUNT in counts else counts[-1]
    cases = dict.fromkeys(case for _, case, _ in timed if case not in WHOLE)
    steps = [
        (_saved(results, timed, device, case, worlds), timed[device, case, worlds])
        for case in cases
    ]
    many = (worlds_name(counts[-1]), device, counts[-1])
    ends = dict.fromkeys((("one world", device, 1), many, ("one world, CPU", "cpu", 1)))
    whole = {name: _saved(results, timed, of, ALL, count) for name, of, count in ends}
    whole = {name: saved for name, saved in whole.items() if saved.value is not None}
    before, after = (timed[device, case, worlds].frame_ms for case in (REFERENCE, ALL))
    numbers: dict[str, Any] = {
        "worlds": worlds_name(worlds),
        "before": before,
        "after": after,
    }
    numbers["times"] = Markup("; ").join(
        Markup("{}: {}").format(*item) for item in whole.items()
    )
    cells = [saved for saved, _ in steps if saved.value is not None]
    return Figure(
        lambda: _draw_costs(steps, whole),
        [*cells, *whole.values(), before, after],
        numbers,
    )


def _draw_costs(
    steps: Sequence[tuple[Value, Row]], whole: Mapping[str, Value]
) -> Drawing:
    """Draw a bar for each step that was timed, unranked below the line if not seen, and all together beside them."""
    timed = [
        (saved, 100 * (row.ratio_resolution.value or 0.0), row)
        for saved, row in steps
        if saved.value is not None
    ]
    timed.sort(
        key=lambda step: -step[0].number if abs(step[0].number) > step[1] else math.inf
    )
    drawing, axes = new_figure(7.2, 1.2 + 0.28 * len(timed))
    seen_count = sum(abs(saved.number) > interval for saved, interval, _ in timed)
    axes.axhline(seen_count - 0.5, color=INK, linewidth=0.8, linestyle=":", marker="")
    for place, (saved, interval, _) in enumerate(timed):
        is_seen = place < seen_count
        axes.barh(
            place,
            saved.number,
            height=0.62,
            linewidth=0,
            color=STIFF if is_seen else FAINT,
        )
        axes.errorbar(
            saved.number,
            place,
            xerr=interval,
            color=INK,
            linewidth=1.0,
            capsize=0,
            marker="",
        )
        say_value(
            axes,
            max(saved.number, 0.0) + interval,
            place,
            f"{write(saved)} %" if is_seen else "not seen",
        )
    lines = [
        "all together",
        *(f"{name}: −{write(saved)} %" for name, saved in whole.items()),
    ]
    axes.text(
        0.98,
        0.5,
        "\n".join(lines),
        transform=axes.transAxes,
        ha="right",
        va="center",
        fontsize=9,
    )
    name_lines(axes, [row.label for *_, row in timed])
    axes.set_xlim(right=1.25 * max((saved.number for saved, *_ in timed), default=1.0))
    axes.set_xlabel("what a frame then takes less [%]")
    axes.grid(axis="y", visible=False)
    return drawing
