"""Show the cost of parts that the scene does not use, and the slip without these parts."""

import math

from markupsafe import Markup

from report.shared import (
    DEVICES,
    PERCENT,
    Claim,
    Figure,
    Quantity,
    Results,
    Row,
    RowsBy,
    Section,
    Value,
    all_of,
    at_least,
    greater,
    largest_size,
    negligible,
    relevance,
    resolution,
    table_of,
    worlds_name,
)
from report.shared.drawing import (
    FAINT,
    INK,
    STIFF,
    Drawing,
    name_lines,
    new_figure,
    write,
    write_beside,
)

order = 150
page = "error"
label = "unneeded parts"
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

MANY_COUNT = 16384  # the largest number of worlds that is timed
ALONE_COUNT = 4096  # the number of worlds with which each part was timed by itself
REFERENCE = "untrimmed"
ALL = "without-all"
WHOLE = (REFERENCE, "as-shipped", ALL)  # cases that leave out several parts or none


def derive(results: Results) -> Section:
    rows = [row for row in results.rows if row.plain.get("device") in DEVICES]
    timed = RowsBy(results, rows, "device", "case", "worlds")
    device = max((device for device, *_ in timed), default="cuda")  # prefers the GPU
    cuda_known, cpu_known = (
        resolution(
            results,
            f"{device}_resolution",
            [row for row in timed.values() if row.device == device],
        )
        for device in DEVICES
    )

    def saved(device: str, case: str, worlds: int) -> Value:
        """Derive the reduction of the frame time relative to the scene exactly as
        shipped.
        """
        name = f"{device}_{case}_{worlds}_less".replace("-", "_")
        return results.derived.get(name) or results.value(
            name,
            "reduction of the frame time relative to exactly as shipped, timed in turn",
            PERCENT * (1 - timed[device, case, worlds].frame_ratio),
        )

    gains = []
    faster = []
    for count in (1, MANY_COUNT):
        gain = results.value(
            f"cuda_gain_{count}",
            "time of a frame exactly as shipped divided by the time without the unneeded parts,"
            " timed in turn",
            1 / timed["cuda", ALL, count].frame_ratio,
        )
        gains.append(gain)
        reduction = saved("cuda", ALL, count)
        faster.append(greater(reduction, 1.0, "a gain worth naming"))
    on_gpu = all_of(*faster).having_read(cuda_known)

    # The ratio on the CPU is not precise, because its cores are shared. The smallest gain
    # within its interval is printed.
    row = timed["cpu", ALL, 1]
    cpu_gain = results.value(
        "cpu_gain_least",
        "time of a frame on the CPU exactly as shipped divided by the time without the unneeded"
        " parts, at the lower end of its interval",
        1 / row.frame_ratio / (1 + row.ratio_resolution),
        is_noise=True,
    )
    on_cpu = greater(saved("cpu", ALL, 1), 1.0, why="a gain worth naming")

    before = timed[device, REFERENCE, 1].buffer_bytes_per_world
    after = timed[device, ALL, 1].buffer_bytes_per_world
    saving = results.value(
        "memory_saving",
        "contact and constraint memory per world exactly as shipped divided by the memory without"
        " the unneeded parts",
        before / after,
    )

    # All rows of a case have the same slip, for every number of worlds.
    ran = {row.case: row for row in reversed(timed.values()) if row.device == "cuda"}
    base = ran.pop(REFERENCE, results.row[REFERENCE]).slip_mm
    differences = [
        results.value(
            f"cuda_{case}_difference".replace("-", "_"),
            f"slip of {case} minus the slip of {REFERENCE}, on the same device",
            row.slip_mm - base,
        )
        for case, row in ran.items()
    ]
    largest = results.value(
        "cuda_largest_difference",
        "largest absolute difference in slip from the reference",
        largest_size(differences),
    )
    share = results.value(
        "cuda_largest_share",
        "this difference, relative to the slip of the reference",
        PERCENT * largest / abs(base),
    )
    bound = relevance(results, base)

    # Compare the cost of each part, with the number of worlds in which it was timed by
    # itself.
    counts = [
        worlds for kind, case, worlds in timed if (kind, case) == (device, REFERENCE)
    ]
    most = max(counts, default=1)
    alone = ALONE_COUNT if ALONE_COUNT in counts else most
    steps = [
        (saved(device, case, alone), timed[device, case, alone])
        for case in dict.fromkeys(case for _, case, _ in timed)
        if case not in WHOLE
    ]
    steps = [
        (reduction, row) for reduction, row in steps if reduction.value is not None
    ]
    whole = {
        "one world": saved(device, ALL, 1),
        worlds_name(most): saved(device, ALL, most),
        "one world, CPU": saved("cpu", ALL, 1),
    }
    whole = {
        name: reduction
        for name, reduction in whole.items()
        if reduction.value is not None
    }
    frames = [timed[device, case, alone].frame_ms for case in (REFERENCE, ALL)]
    cost = Figure(
        lambda: _draw_costs(steps, whole),
        [*(reduction for reduction, _ in steps), *whole.values(), *frames],
        {
            "worlds": worlds_name(alone),
            "before": frames[0],
            "after": frames[1],
            "times": Markup("; ").join(
                Markup("{}: {}").format(*item) for item in whole.items()
            ),
        },
    )
    many = timed["cuda", ALL, MANY_COUNT].worlds
    return Section(
        tables={"audit": _audit_table(results)},
        figures={"cost": cost},
        claims=[
            Claim(
                "faster_on_gpu",
                on_gpu,
                {"one": gains[0], "many": gains[1], "worlds": many},
            ),
            Claim(
                "faster_on_cpu",
                on_cpu.having_read(cpu_gain, cpu_known),
                {"gain": cpu_gain},
            ),
            Claim(
                "less_memory",
                at_least(saving, 20.0, "a worthwhile saving"),
                {"saving": saving, "before": before, "after": after},
            ),
            Claim(
                "same_slip_on_gpu",
                negligible(share, bound),
                {"share": share, "bound": bound},
            ),
        ],
    )


def _audit_table(results: Results):
    def whole(row: Row, column: str) -> Quantity:
        """Return a count as an exact whole number. A mean stays as measured."""
        measured = row[column]
        if measured.value is None or measured.value % 1:
            return measured
        name = f"{row.case}_{column}".replace("-", "_")
        return results.value(name, "the count, as a whole number", round, measured)

    rows = [row for row in results.rows if "item" in row]
    items = [row.item.partition(", against ") for row in rows]
    columns = {
        "present": [whole(row, "present") for row in rows],
        "used": [whole(row, "used") for row in rows],
        "counted as used": [against for _, _, against in items],
    }
    return table_of("part", [part for part, _, _ in items], columns)


def _draw_costs(steps: list[tuple[Value, Row]], whole: dict[str, Value]) -> Drawing:
    """Draw bars for the parts.

    The savings below the line are not measurable and not ranked.
    """
    timed = []
    for saved, row in steps:
        interval = 100 * (row.ratio_resolution.value or 0.0)
        timed.append((saved, interval, abs(saved.number) > interval, row.label))
    timed.sort(key=lambda step: -step[0].number if step[2] else math.inf)
    drawing, axes = new_figure(7.2, 1.2 + 0.28 * len(timed))
    distinct_count = sum(is_distinct for _, _, is_distinct, _ in timed)
    axes.axhline(distinct_count - 0.5, color=INK, linewidth=0.8, linestyle=":")
    for place, (saved, interval, is_distinct, _) in enumerate(timed):
        colour = STIFF if is_distinct else FAINT
        axes.barh(place, saved.number, height=0.62, linewidth=0, color=colour)
        axes.errorbar(
            saved.number, place, xerr=interval, color=INK, linewidth=1.0, marker=""
        )
        end = (max(saved.number, 0.0) + interval, place)
        text = f"{write(saved)} %" if is_distinct else "not measurable"
        write_beside(axes, text, end, (6, 0), fontsize=8.5, va="center", zorder=6)
    lines = [f"{name}: −{write(saved)} %" for name, saved in whole.items()]
    axes.text(
        0.98,
        0.5,
        "\n".join(["all together", *lines]),
        transform=axes.transAxes,
        ha="right",
        va="center",
        fontsize=9,
    )
    name_lines(axes, [label for *_, label in timed])
    axes.set_xlim(right=1.25 * max((saved.number for saved, *_ in timed), default=1.0))
    axes.set_xlabel("reduction of the frame time [%]")
    axes.grid(axis="y", visible=False)
    return drawing
