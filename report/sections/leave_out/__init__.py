"""What the scene has and does not use, what each of it costs, and that nothing changes without it."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from measured_report.parts.claim import HOLDS, Claim, Outcome, all_of, at_least, decided, greater, within
from measured_report.parts.section import Section
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results, Row
from report.names import case_html, cases_html
from report.sections.leave_out.tables import ALL, REFERENCE, Timed, audit_table, cost_figure, cost_table
from report.shared.arithmetic import DEVICES, cell_count, difference, largest_size, noise_floor, ratio, told
from report.shared.timing import cell, ratio_cell, resolution
from report.shared.timing import resolutions as largest_resolution

order = 150
page = "cost"
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
BASELINE = "as-shipped"
NOT_TIMED = Outcome("unknown", "it was not timed on this machine")
Runs = Mapping[tuple[str, str], Row]
"""A row of each device and case: the run to the end is the same in those of all numbers of worlds."""
Faster = Mapping[tuple[str, str, int], Outcome]
"""Whether a case is faster than exactly as shipped, by device, case and number of worlds."""


def derive(results: Results) -> Section:
    rows = [row for row in results.rows if "device" in row and row.device in DEVICES]
    timed = {(row.device, row.case, row.worlds.value): row for row in rows}
    runs: dict[tuple[str, str], Row] = {}
    for row in rows:
        runs.setdefault((row.device, row.case), row)
    differences = {key: _difference(results, runs, *key) for key in runs}
    # Devices and numbers of worlds for which the untrimmed scene was timed, to compare with.
    untrimmed = [(key, row) for key, row in timed.items() if key[1] == REFERENCE]
    panels = [(device, worlds) for (device, _, worlds), row in untrimmed if row.frame_ms.value is not None]
    least = results.chosen("saved_least", "a gain worth naming", 1.0, unit="%")
    faster = {
        key: _is_faster(results, timed, least, *key)
        for key in timed
        if key[1] not in (REFERENCE, BASELINE) and (key[0], key[2]) in panels
    }
    resolutions, apart = _resolutions(results, timed), _medians_apart(results, timed)
    return Section(
        tables={
            "audit": audit_table(results),
            "cost": cost_table(timed, differences, resolutions, apart, _reference_of(runs, "cpu")),
        },
        figures={"cost": cost_figure(timed, panels)},
        claims=[
            _faster_on_gpu(results, timed, faster),
            _faster_on_cpu(results, timed, faster),
            _buffers_on_cpu(results, timed, faster),
            _less_memory(results, timed),
            _same_slip_on_gpu(results, runs, differences),
            _each_helps(faster, [*resolutions.values(), *apart.values()], least),
            _same_bits(results, runs),
        ],
    )


def _resolutions(results: Results, timed: Timed) -> dict[str, Value]:
    """Derive by device to within what its ratios are known."""
    return {
        device: largest_resolution(
            results, f"{device}_resolution", (row for key, row in timed.items() if key[0] == device)
        )
        for device in DEVICES
    }


def _medians_apart(results: Results, timed: Timed) -> dict[str, Value]:
    """Derive by device how far ratios of the medians are from those timed in turn, at most [%]."""
    formula = "how far the ratio of a median to that exactly as shipped is from that timed in turn, of it, at most"
    cells: dict[str, list[Quantity]] = {device: [] for device in DEVICES}
    for (device, _, worlds), row in timed.items():
        before = timed.get((device, REFERENCE, worlds))
        if before and before.frame_ms.value is not None and row.frame_ratio.value is not None:
            cells[device] += row.frame_ms, before.frame_ms, row.frame_ratio
    return {
        device: results.value(f"{device}_medians_apart", formula, _farthest, *found, unit="%", is_noise=True)
        for device, found in cells.items()
    }


def _farthest(*cells: float) -> float:
    triples = zip(cells[::3], cells[1::3], cells[2::3], strict=True)
    return max(100 * abs(time / before / taken - 1) for time, before, taken in triples)


def _gain(results: Results, timed: Timed, device: str, worlds: int) -> Value:
    """Derive how many times as fast the scene is with all left out."""
    formula = "time of a frame exactly as shipped over that without all that is unneeded, timed in turn"
    taken = ratio_cell(results, timed.get((device, ALL, worlds)))
    return results.value(f"{device}_gain_{worlds}", formula, lambda taken: 1 / taken, taken)


def _faster_on_gpu(results: Results, timed: Timed, faster: Faster) -> Claim:
    """Tell whether it is faster both with one world and with the most, by more than the resolution."""
    one, many = (_gain(results, timed, "cuda", worlds) for worlds in (1, MANY_COUNT))
    outcome = all_of(*(faster.get(("cuda", ALL, worlds), NOT_TIMED) for worlds in (1, MANY_COUNT)))
    row = timed.get(("cuda", ALL, MANY_COUNT))
    return Claim("faster_on_gpu", outcome, {"one": one, "many": many, "worlds": row.worlds if row else ""})


def _faster_on_cpu(results: Results, timed: Timed, faster: Faster) -> Claim:
    """Tell how many times as fast it is at least: cores are shared, so that the ratio there is known badly."""
    row = timed.get(("cpu", ALL, 1))
    formula = (
        "time of a frame on the CPU exactly as shipped over that without all that is unneeded, less its resolution"
    )
    sources = ratio_cell(results, row), cell(results, row, "ratio_resolution", "this case")
    gain = results.value("cpu_gain_least", formula, lambda taken, seen: 1 / taken / (1 + seen), *sources, is_noise=True)
    return Claim("faster_on_cpu", faster.get(("cpu", ALL, 1), NOT_TIMED).having_read(gain), {"gain": gain})


def _buffers_on_cpu(results: Results, timed: Timed, faster: Faster) -> Claim:
    """Tell whether smaller buffers alone take more off a frame on a CPU than all the rest does."""
    rows = [timed.get(("cpu", case, 1)) for case in (REFERENCE, "without-buffers", ALL)]
    before, time, least = (cell(results, row, "frame_ms", "the scene with and without large buffers") for row in rows)
    formula = "time that smaller buffers alone take off a frame on the CPU, of that which all of it takes off"
    times = before, time, least
    part = results.value("cpu_buffers_part", formula, lambda a, b, c: 100 * (a - b) / (a - c), *times, unit="%")
    is_faster = faster.get(("cpu", "without-buffers", 1), NOT_TIMED)
    outcome = all_of(is_faster, at_least(part, 50.0, why="most of it"))
    taken = ratio_cell(results, rows[1])
    return Claim("buffers_on_cpu", outcome, told(taken, {"time": time}))


def _less_memory(results: Results, timed: Timed) -> Claim:
    """Where the saving is least, of all devices and numbers of worlds."""
    sizes = {key: row.buffer_bytes_per_world for key, row in timed.items()}
    sizes = {key: size for key, size in sizes.items() if size.value is not None}
    none = cell(results, None, "buffer_bytes_per_world", "the memory before and after")
    untrimmed = ((size, (device, ALL, worlds)) for (device, case, worlds), size in sizes.items() if case == REFERENCE)
    pairs = [(before, sizes[after]) for before, after in untrimmed if after in sizes]
    before, after = min(pairs, key=lambda pair: pair[0].value / (pair[1].value or math.inf), default=(none, none))
    formula = "contact and constraint memory per world exactly as shipped over that without all that is unneeded"
    saving = ratio(results, "memory_saving", formula, before, after)
    bound = results.chosen("memory_saving_bound", "a saving worth having", 20.0)
    numbers = {"saving": saving, "before": before, "after": after}
    return Claim("less_memory", at_least(saving, bound), numbers)


def _reference_of(runs: Runs, device: str) -> Row | None:
    """Find what slip and trajectory are compared with: the untrimmed scene, or the first that was run to the end."""
    ran = (row for (of_device, _), row in runs.items() if of_device == device and row.slip_mm.value is not None)
    return next(ran, None)


def _difference(results: Results, runs: Runs, device: str, case: str) -> Value:
    reference = _reference_of(runs, device)
    of_reference = cell(results, reference, "slip_mm", "a run to the end")
    name = f"{device}_{case}_difference".replace("-", "_")
    formula = f"slip of {case} less that of {reference.case if reference else REFERENCE}, on the same device"
    return difference(results, name, formula, runs[device, case].slip_mm, of_reference)


def _same_slip_on_gpu(results: Results, runs: Runs, differences: Mapping[tuple[str, str], Value]) -> Claim:
    """Of the means over the worlds that each case was run in."""
    floor = noise_floor(results, "slip_floor")
    there = {case: run for (device, case), run in runs.items() if device == "cuda"}
    ran = {case: differences["cuda", case] for case, run in there.items() if run.slip_mm.value is not None}
    formula = "largest difference in slip from the reference of that device, either way"
    largest = largest_size(results, "cuda_largest_difference", formula, ran.values(), unit="mm")
    most = [max(ran, key=lambda case: abs(ran[case].value or 0.0))] if ran else []
    outcome = within(largest, floor) if ran else Outcome("unknown", "no case was run to the end there")
    numbers = {"largest": largest, "floor": floor, "most": cases_html(most)}
    return Claim("same_slip_on_gpu", outcome, numbers)


def _each_helps(faster: Faster, known_within: Sequence[Value], least: Value) -> Claim:
    """Tell whether each thing left out alone makes a frame faster, with any number of worlds, on any device."""
    alone = {case: [faster[key] for key in faster if key[1] == case] for _, case, _ in faster if case != ALL}
    helping = [case for case, found in alone.items() if HOLDS in found]
    outcome = decided(len(helping) == len(alone)) if alone else Outcome("unknown", "nothing was left out alone")
    reads = all_of(*(outcome for found in alone.values() for outcome in found)).reads
    outcome = replace(outcome, reads=reads).having_read(*known_within)
    return Claim("each_helps", outcome, {"helping": cases_html(helping), "least": least})


def _is_faster(results: Results, timed: Timed, least: Value, device: str, case: str, worlds: int) -> Outcome:
    """Tell whether a frame is faster than exactly as shipped by what is worth naming, as well as the ratio is known."""
    row, name = timed.get((device, case, worlds)), f"{device}_{case}_{worlds}".replace("-", "_")
    formula = "what a frame takes less than exactly as shipped"
    saved = results.value(f"{name}_saved", formula, lambda taken: 100 * (1 - taken), ratio_cell(results, row), unit="%")
    return greater(saved, least, noise=resolution(results, f"{name}_resolution", row))


def _same_bits(results: Results, runs: Runs) -> Claim:
    """Judged on the CPU: a GPU adds up in another order each time, and does not even repeat itself."""
    reference = _reference_of(runs, "cpu")
    compared = [row for row in runs.values() if row.device == "cpu" and "differing_frame_count" in row]
    others = [row for row in compared if row is not reference]
    differing = [row.differing_frame_count for row in others]
    numbers: dict[str, Any] = {
        "differing": results.value(
            "cpu_differing_count", "runs on the CPU with a frame unlike the reference's", _count_differing, *differing
        ),
        "count": cell_count(results, "cpu_compared_count", "runs on the CPU compared with the reference", differing),
        "reference": case_html(reference.case) if reference else "",
    }
    formula = "largest distance of any body in any frame from where it is in the reference, on the CPU"
    cells = [row.pose_difference_mm for row in others]
    largest = results.value("cpu_pose_difference", formula, max, *cells, unit="mm")
    outcome = Outcome("unknown", "nothing was run to the end on a CPU, and a GPU does not repeat itself to the bit")
    if others:
        outcome = decided(numbers["differing"].value == 0, numbers["differing"], largest)
    return Claim("same_bits", outcome, numbers)


def _count_differing(*frame_counts: float) -> int:
    return sum(count > 0 for count in frame_counts)
