"""What the scene has and does not use, what each of it costs, and that nothing changes without it."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

from measured_report.claims.claim import HOLDS, Claim, Outcome, all_of, at_least, at_most, decided, greater, within
from measured_report.parts.section import Section
from measured_report.values.quantities import Value
from measured_report.values.results import Results, Row
from report.names import case_html, cases_html, worlds_name
from report.sections.leave_out.double import change_in_double, double_table, same_in_double
from report.sections.leave_out.tables import audit_table, case_table, cost_figure, cost_table, same_table
from report.sections.leave_out.variants import ALL, REFERENCE, Runs, Timed, is_identical, reference_of
from report.shared.arithmetic import DEVICES, difference, largest_size, noise_floor, ratio
from report.shared.timing import cell, frame_spread

order = 150
page = "cost"
label = "what to leave out"

MANY_COUNT = 16384
"""The most worlds, for which there is a target."""
BASELINE = "as-shipped"


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
    doubles = [row for row in results.rows if row.case.startswith("double-")]
    changes = [change_in_double(results, row) for row in doubles]
    return Section(
        tables={
            "cases": case_table(runs),
            "audit": audit_table(results),
            "cost": cost_table(timed, runs),
            "same": same_table(runs, differences),
            "double": double_table(doubles, changes),
        },
        figures={"cost": cost_figure(timed, panels)},
        claims=[
            _faster_on_gpu(results, timed),
            _faster_on_cpu(results, timed),
            _buffers_on_cpu(results, timed),
            _less_memory(results, timed),
            *(_same_slip(results, runs, differences, device) for device in DEVICES),
            _each_helps(results, timed, panels),
            _rest_helps(results, timed, panels),
            _same_bits(results, runs),
            same_in_double(results, doubles, changes),
        ],
    )


def _gain(results: Results, timed: Timed, device: str, worlds: int) -> Value:
    """Derive how many times as fast the scene is with all left out."""
    rows = {case: timed.get((device, case, worlds)) for case in (REFERENCE, ALL)}
    where = f"in a batch of {worlds} on a {DEVICES[device]}"
    times = (cell(results, row, "frame_ms", f"{case} {where}") for case, row in rows.items())
    formula = "time of a frame exactly as shipped over that without all that is unneeded"
    return ratio(results, f"{device}_gain_{worlds}", formula, *times)


def _faster_on_gpu(results: Results, timed: Timed) -> Claim:
    one, many = (_gain(results, timed, "cuda", worlds) for worlds in (1, MANY_COUNT))
    smaller = results.value("cuda_gain", "smaller of the gains with one world and with the most", min, one, many)
    bound = results.chosen("cuda_gain_bound", "a gain worth having on a GPU", 1.25)
    row = timed.get(("cuda", ALL, MANY_COUNT))
    numbers = {"one": one, "many": many, "bound": bound, "worlds": row.worlds if row else ""}
    return Claim("faster_on_gpu", at_least(smaller, bound), numbers)


def _faster_on_cpu(results: Results, timed: Timed) -> Claim:
    gain = _gain(results, timed, "cpu", 1)
    bound = results.chosen("cpu_gain_bound", "a gain worth having on a CPU", 4.0)
    return Claim("faster_on_cpu", at_least(gain, bound), {"gain": gain, "bound": bound})


def _buffers_on_cpu(results: Results, timed: Timed) -> Claim:
    """Tell whether smaller buffers alone make a frame faster on a CPU, by more than frames of one run spread."""
    rows = [timed.get(("cpu", case, 1)) for case in (REFERENCE, "without-buffers")]
    before, time = (cell(results, row, "frame_ms", "the scene with and without large buffers on a CPU") for row in rows)
    spread = frame_spread(results, "cpu_buffers_spread", *rows)
    numbers = {"before": before, "time": time, "spread": spread}
    return Claim("buffers_on_cpu", greater(before, time, noise=spread), numbers)


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
    numbers = {"saving": saving, "bound": bound, "before": before, "after": after}
    return Claim("less_memory", at_least(saving, bound), numbers)


def _difference(results: Results, runs: Runs, device: str, case: str) -> Value:
    reference = reference_of(runs, device)
    of_reference = cell(results, reference, "slip_mm", "a run to the end")
    name = f"{device}_{case}_difference".replace("-", "_")
    formula = f"slip of {case} less that of {reference.case if reference else REFERENCE}, on the same device"
    return difference(results, name, formula, runs[device, case].slip_mm, of_reference)


def _same_slip(results: Results, runs: Runs, differences: Mapping[tuple[str, str], Value], device: str) -> Claim:
    """Of the means over the worlds that each case was run in."""
    floor = noise_floor(results, "slip_floor")
    ran = {key[1]: differences[key] for key, run in runs.items() if key[0] == device and run.slip_mm.value is not None}
    formula = "largest difference in slip from the reference of that device, either way"
    largest = largest_size(results, f"{device}_largest_difference", formula, ran.values(), unit="mm")
    most = [max(ran, key=lambda case: abs(ran[case].value or 0.0))] if ran else []
    # On a CPU the difference is exact; on a GPU both it and the floor are chance.
    judge = within if device == "cuda" else at_most
    outcome = judge(largest, floor) if ran else Outcome("unknown", "no case was run to the end there")
    numbers = {"largest": largest, "floor": floor, "most": cases_html(most)}
    return Claim(f"same_slip_on_{DEVICES[device].lower()}", outcome, numbers)


def _each_helps(results: Results, timed: Timed, panels: Sequence[tuple[str, int]]) -> Claim:
    """Tell whether each thing left out alone makes a frame faster at all, with any number of worlds, on any device."""
    outcomes: dict[str, list[Outcome]] = {}
    for device, case, worlds in timed:
        if case not in (REFERENCE, ALL, BASELINE) and (device, worlds) in panels:
            outcomes.setdefault(case, []).append(_is_faster(results, timed, device, worlds, REFERENCE, case))
    helping = [case for case, found in outcomes.items() if HOLDS in found]
    idle = [case for case in outcomes if case not in helping]
    outcome = decided(not idle) if outcomes else Outcome("unknown", "nothing was left out alone")
    reads = all_of(*(outcome for found in outcomes.values() for outcome in found)).reads
    numbers = {"helping": cases_html(helping), "idle": cases_html(idle)}
    return Claim("each_helps", replace(outcome, reads=reads), numbers)


def _rest_helps(results: Results, timed: Timed, panels: Sequence[tuple[str, int]]) -> Claim:
    """Tell whether what this report's baseline still has of it counts, where there are most worlds."""
    device, worlds = max(panels, key=lambda panel: panel[1], default=("cuda", MANY_COUNT))
    rows = (timed.get((device, case, worlds)) for case in (BASELINE, ALL))
    before, after = (cell(results, row, "frame_ms", "the baseline, or the scene without it all,") for row in rows)
    numbers = {"baseline": case_html(BASELINE), "worlds": worlds_name(worlds), "device": DEVICES[device]}
    outcome = _is_faster(results, timed, device, worlds, BASELINE, ALL)
    return Claim("rest_helps", outcome, numbers | {"before": before, "after": after})


def _is_faster(results: Results, timed: Timed, device: str, worlds: int, case: str, other: str) -> Outcome:
    """Tell whether a frame takes longer in ``case`` than in ``other``, by more than frames of one run spread."""
    rows = [timed.get((device, name, worlds)) for name in (case, other)]
    before, after = (cell(results, row, "frame_ms", f"{case} or {other}") for row in rows)
    spread = frame_spread(results, f"{device}_{case}_{other}_{worlds}_spread".replace("-", "_"), *rows)
    return greater(before, after, noise=spread)


def _same_bits(results: Results, runs: Runs) -> Claim:
    """Judged on the CPU: a GPU adds up in another order each time, and does not even repeat itself."""
    reference = reference_of(runs, "cpu")
    compared = [row for row in runs.values() if row.device == "cpu" and "differing_frame_count" in row]
    others = [row for row in compared if row is not reference]
    formula = "largest distance of any body in any frame from where it is in the reference, on the CPU"
    cells = [row.pose_difference_mm for row in others]
    largest = results.value("cpu_pose_difference", formula, max, *cells, unit="mm")
    same, apart = ([row.case for row in others if is_identical(row) == identical] for identical in (True, False))
    outcome = Outcome("unknown", "nothing was run to the end on a CPU, and a GPU does not repeat itself to the bit")
    if others:
        outcome = decided(not apart, largest)
    numbers = {"same": cases_html(same), "apart": cases_html(apart)}
    return Claim("same_bits", outcome, numbers | {"reference": cases_html([reference.case] if reference else [])})
