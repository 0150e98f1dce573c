"""What the scene has and does not use, what each of it costs, and that nothing changes without it."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import pandas as pd
from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from report.claims import FAILS, HOLDS, Claim, Outcome, at_least, at_most, greater
from report.figures import INK, SERIES, new_figure
from report.format import format_number
from report.parts import Figure, Section, Table
from report.quantities import Quantity, Value
from report.results import Results, Row
from report.sections._common import noise_floor, ratio
from report.sections._timing import cell, frame_spread
from report.sections._variants import beyond_noise

order = 150

REFERENCE, ALL = "untrimmed", "without-all"
MANY_COUNT = 16384
"""The most worlds, for which there is a target."""
DEVICES = {"cuda": "GPU", "cpu": "CPU"}
LEFT_OUT = {
    REFERENCE: "nothing: exactly as shipped",
    "without-buffers": "room for contacts and constraints beyond the peak",
    "without-ik-iterations": "most iterations of the inverse kinematics",
    "without-ik-in-turn": "waiting for the inverse kinematics",
    "without-state-sync": "Newton's state and targets written before every substep",
    "without-cube-gap": "the cube's default contact gap",
    "without-hand-box": "collision of the hand",
    "without-visuals": "shapes for looking at",
    "without-fixed-joints": "bodies fixed to one another",
    "without-broad-phase": "testing all pairs of shapes",
    ALL: "all of these",
    "as-shipped": "buffers, IK iterations, waiting for IK, state writes: this report's baseline",
}


@dataclass(frozen=True)
class Variant:
    """One way to leave something out, on one device."""

    device: str
    case: str
    rows: Sequence[Row]
    """One for each number of worlds."""

    @property
    def name(self) -> str:
        return f"{self.device}_{self.case.replace('-', '_')}"

    @property
    def run(self) -> Row:
        """The run to the end, which is the same in the rows of all numbers of worlds."""
        return self.rows[0]

    def at(self, worlds: int) -> Row | None:
        return next((row for row in self.rows if row.worlds.value == worlds), None)


def derive(results: Results) -> Section:
    variants = _variants(results)
    differences = {variant.name: _difference(results, variants, variant) for variant in variants}
    panels = _panels(variants)
    return Section(
        tables={
            "cases": _case_table(variants),
            "audit": _audit_table(results),
            "cost": _cost_table(variants),
            "same": _same_table(variants, differences),
        },
        figures={"cost": _cost_figure(variants, panels)},
        claims=[
            _faster_on_gpu(results, variants),
            _faster_on_cpu(results, variants),
            _less_memory(results, variants),
            _same_slip(results, variants, differences),
            _each_helps(results, variants, panels),
            _same_bits(results, variants),
        ],
    )


def _variants(results: Results) -> list[Variant]:
    timed = [row for row in results.rows if "device" in row]
    keys = dict.fromkeys((row.device, row.case) for row in timed)
    return [Variant(*key, [row for row in timed if (row.device, row.case) == key]) for key in keys]


def _find(variants: Sequence[Variant], device: str, case: str) -> Variant | None:
    return next((variant for variant in variants if (variant.device, variant.case) == (device, case)), None)


def _reference(variants: Sequence[Variant], device: str) -> Variant | None:
    """What slip and trajectory are compared with: the untrimmed scene, or the first that was run to the end."""
    of_device = [variant for variant in variants if variant.device == device]
    return next((variant for variant in of_device if variant.run.slip_mm.value is not None), None)


def _gain(results: Results, variants: Sequence[Variant], device: str, worlds: int) -> Value:
    """How many times as fast the scene is with all left out."""
    times = []
    for case in (REFERENCE, ALL):
        variant = _find(variants, device, case)
        row = variant.at(worlds) if variant else None
        times.append(
            cell(results, row, "frame_ms", f"{case} in a batch of {format_number(worlds)} on a {DEVICES[device]}")
        )
    formula = "time of a frame exactly as shipped over that without all that is unneeded"
    return ratio(results, f"{device}_gain_{worlds}", formula, *times)


def _faster_on_gpu(results: Results, variants: Sequence[Variant]) -> Claim:
    one, many = (_gain(results, variants, "cuda", worlds) for worlds in (1, MANY_COUNT))
    smaller = results.value("cuda_gain", "smaller of the gains with one world and with the most", min, one, many)
    bound = results.chosen("cuda_gain_bound", "a gain worth having on a GPU", 1.25)
    full = _find(variants, "cuda", ALL)
    row = full.at(MANY_COUNT) if full else None
    return Claim(
        "faster_on_gpu",
        at_least(smaller, bound),
        holds="Without what the scene does not need, a frame on the GPU is {one} times as fast with one world and "
        "{many} times with {worlds}.",
        fails="Without what the scene does not need, a frame on the GPU is {one} times as fast with one world and "
        "{many} times with {worlds}; aimed for were {bound} times with either.",
        unknown="How much faster the scene is on a GPU without what it does not need cannot be told.",
        numbers={"one": one, "many": many, "bound": bound, "worlds": row.worlds if row else ""},
    )


def _faster_on_cpu(results: Results, variants: Sequence[Variant]) -> Claim:
    gain = _gain(results, variants, "cpu", 1)
    bound = results.chosen("cpu_gain_bound", "a gain worth having on a CPU", 4.0)
    buffers = _find(variants, "cpu", "without-buffers")
    time = cell(results, buffers and buffers.run, "frame_ms", "the scene without large buffers on a CPU")
    reference = _find(variants, "cpu", REFERENCE)
    before = cell(results, reference and reference.run, "frame_ms", "the scene exactly as shipped on a CPU")
    return Claim(
        "faster_on_cpu",
        at_least(gain, bound),
        holds="On the CPU a frame is {gain} times as fast without it all; the buffers alone take a frame from {before} "
        "to {time}.",
        fails="On the CPU a frame is {gain} times as fast without it all, less than the {bound} times aimed for.",
        unknown="How much faster the scene is on a CPU without what it does not need cannot be told.",
        numbers={"gain": gain, "bound": bound, "before": before, "time": time},
    )


def _less_memory(results: Results, variants: Sequence[Variant]) -> Claim:
    """Where the saving is least, of all devices and numbers of worlds."""
    pairs = [
        (before.buffer_bytes_per_world, after.buffer_bytes_per_world)
        for full in variants
        if full.case == REFERENCE and (lean := _find(variants, full.device, ALL))
        for before, after in zip(full.rows, lean.rows, strict=True)
        if None not in (before.buffer_bytes_per_world.value, after.buffer_bytes_per_world.value)
    ]
    none = cell(results, None, "buffer_bytes_per_world", "the memory before and after")
    before, after = min(pairs, key=lambda pair: pair[0].value / pair[1].value, default=(none, none))
    formula = "contact and constraint memory per world exactly as shipped over that without all that is unneeded"
    saving = ratio(results, "memory_saving", formula, before, after)
    bound = results.chosen("memory_saving_bound", "a saving worth having", 20.0)
    return Claim(
        "less_memory",
        at_least(saving, bound),
        holds="Contacts and constraints take {after} per world in place of {before}, {saving} times less.",
        fails="Contacts and constraints take {after} per world in place of {before}: {saving} times less, where "
        "{bound} times was aimed for.",
        unknown="How much less memory contacts and constraints take cannot be told.",
        numbers={"saving": saving, "bound": bound, "before": before, "after": after},
    )


def _difference(results: Results, variants: Sequence[Variant], variant: Variant) -> Value:
    reference = _reference(variants, variant.device)
    of_reference = cell(results, reference and reference.run, "slip_mm", "a run to the end")
    return results.value(
        f"{variant.name}_difference",
        f"slip of {variant.case} less that of {reference.case if reference else REFERENCE}, on the same device",
        lambda slip, before: slip - before,
        variant.run.slip_mm,
        of_reference,
        unit="mm",
    )


def _same_slip(results: Results, variants: Sequence[Variant], differences: dict[str, Value]) -> Claim:
    floor = noise_floor(results, "slip_floor")
    changed = [variant for variant in variants if variant.run.slip_mm.value is not None]
    largest = results.value(
        "largest_difference",
        "largest difference in slip from the reference of the same device, either way",
        lambda *difference: max(map(abs, difference)),
        *(differences[variant.name] for variant in changed),
        unit="mm",
    )
    named = {
        Markup("<code>{}</code> on the {}").format(variant.case, DEVICES[variant.device]): differences[variant.name]
        for variant in variants
    }
    return Claim(
        "same_slip",
        at_most(largest, floor),
        holds="The slip stays the same: it differs by at most {largest}, and runs of one and the same case by up to "
        "{floor}.",
        fails="The slip does not stay the same in all of them: beyond the {floor} by which runs of one and the same "
        "case differ, it changes for {beyond}.",
        unknown="The slip differs by at most {largest}; whether that is more than noise cannot be told.",
        numbers={"largest": largest, "floor": floor, "beyond": beyond_noise(named, floor)},
    )


def _each_helps(results: Results, variants: Sequence[Variant], panels: Sequence[tuple[str, int]]) -> Claim:
    """Whether each thing left out alone makes a frame faster at all, with any number of worlds, on any device."""
    outcomes: dict[str, list[Outcome]] = {}
    for device, worlds in panels:
        reference = _find(variants, device, REFERENCE)
        for variant in variants:
            before, after = reference.at(worlds), variant.at(worlds)
            if variant.device == device and after and variant.case not in (REFERENCE, ALL, "as-shipped"):
                spread = frame_spread(results, f"{variant.name}_{worlds}_spread", before, after)
                outcome = greater(before.frame_ms, after.frame_ms, noise=spread)
                outcomes.setdefault(variant.case, []).append(outcome)
    helping = [case for case, found in outcomes.items() if HOLDS in found]
    idle = [case for case in outcomes if case not in helping]
    return Claim(
        "each_helps",
        HOLDS if helping and not idle else FAILS if idle else Outcome("unknown", "nothing was left out alone"),
        holds="Each that was left out alone makes a frame faster by more than frames of one run spread: {helping}.",
        fails="Not all of it helps. Alone, a frame gets faster by more than frames of one run spread only for "
        "{helping}; not for {idle}.",
        unknown="Which of it helps cannot be told.",
        numbers={"helping": _named(helping), "idle": _named(idle)},
    )


def _same_bits(results: Results, variants: Sequence[Variant]) -> Claim:
    """Judged on the CPU: a GPU adds up in another order each time, and does not even repeat itself."""
    reference = _reference(variants, "cpu")
    others = [variant for variant in variants if variant.device == "cpu" and "bit_identical" in variant.run]
    others = [variant for variant in others if variant is not reference]
    largest = results.value(
        "cpu_pose_difference",
        "largest distance of any body in any frame from where it is in the reference, on the CPU",
        lambda *apart: max(apart, default=math.nan),
        *(variant.run.pose_difference_mm for variant in others),
        unit="mm",
    )
    outcome = Outcome("unknown", "nothing was run to the end on a CPU, and a GPU does not repeat itself to the bit")
    if others:
        outcome = HOLDS if all(variant.run.bit_identical for variant in others) else FAILS
    same, apart = (
        [variant.case for variant in others if variant.run.bit_identical == identical] for identical in (True, False)
    )
    return Claim(
        "same_bits",
        outcome,
        holds="On the CPU, where a run can be repeated to the last bit, every trajectory is the same to the last bit.",
        fails="On the CPU, where a run can be repeated to the last bit, the trajectory stays the same to the last bit "
        "for {same}, against that of {reference}. It does not for {apart}: some body is up to {largest} from where it "
        "was.",
        unknown="Whether the trajectories are the same to the last bit cannot be told.",
        numbers={
            "same": _named(same),
            "apart": _named(apart),
            "reference": _named([reference.case] if reference else []),
            "largest": largest,
        },
    )


def _named(cases: Sequence[str]) -> Markup:
    return Markup(", ").join(map(Markup("<code>{}</code>").format, cases)) or Markup("none")


def _panels(variants: Sequence[Variant]) -> list[tuple[str, int]]:
    """Devices and numbers of worlds for which the untrimmed scene was timed, to compare with."""
    return [
        (variant.device, row.worlds.value)
        for variant in variants
        for row in variant.rows
        if variant.case == REFERENCE and row.frame_ms.value is not None
    ]


def _audit_table(results: Results) -> Table:
    rows = [row for row in results.rows if "item" in row]
    items = [row.item.split(", against ") for row in rows]
    columns = {
        "there": [_whole(results, row, "present") for row in rows],
        "used": [_whole(results, row, "used") for row in rows],
        "counted as used": [", ".join(item[1:]) for item in items],
        "not used": [row.note for row in rows],
    }
    columns = {name: cells for name, cells in columns.items() if any(cells)}
    caption = "What the scene has, exactly as shipped, against what a run through the first cycle of the shake used."
    return Table(pd.DataFrame(columns, index=pd.Index([item[0] for item in items], name="")), caption)


def _whole(results: Results, row: Row, column: str) -> Quantity:
    """A count as the whole number that it is; a mean stays as it was measured."""
    measured = row[column]
    if measured.value is None or measured.value % 1:
        return measured
    return results.value(f"{row.case}_{column}".replace("-", "_"), "the count, as a whole number", round, measured)


def _case_table(variants: Sequence[Variant]) -> Table:
    names = list(dict.fromkeys(variant.case for variant in variants))
    columns = {"left out": [LEFT_OUT.get(name, "") for name in names]}
    return Table(pd.DataFrame(columns, index=pd.Index(names, name="case")), "What each case leaves out.")


def _cost_table(variants: Sequence[Variant]) -> Table:
    counts = sorted({row.worlds.value for variant in variants for row in variant.rows})
    columns: dict[str, list] = {"on": [DEVICES[variant.device] for variant in variants]}
    for count in counts:
        rows = [variant.at(count) for variant in variants]
        name = f"{format_number(count)} world{'s' * (count > 1)}"
        columns[name] = [row.frame_ms if row else "" for row in rows]
    columns["memory"] = [variant.run.buffer_bytes_per_world for variant in variants]
    index = pd.Index([variant.case for variant in variants], name="case")
    caption = "Time of a frame by number of worlds, median, and memory for contacts and constraints per world."
    return Table(pd.DataFrame(columns, index=index), caption)


def _same_table(variants: Sequence[Variant], differences: dict[str, Value]) -> Table:
    columns = {
        "on": [DEVICES[variant.device] for variant in variants],
        "slip": [variant.run.slip_mm for variant in variants],
        "change": [differences[variant.name] for variant in variants],
        "drift": [variant.run.drift_mm_s for variant in variants],
        "same bits": [_bits(variants, variant) for variant in variants],
        "apart": [variant.run.pose_difference_mm for variant in variants],
    }
    index = pd.Index([variant.case for variant in variants], name="case")
    caption = (
        "Runs to the end, against the reference of that device. Slip and drift are means of several worlds on a GPU; "
        "on the CPU all cases have buffers of the scene's size. Apart: the largest distance of any body of the first "
        "world, in any frame, from where it is in the reference."
    )
    return Table(pd.DataFrame(columns, index=index), caption)


def _bits(variants: Sequence[Variant], variant: Variant) -> bool | str:
    if variant is _reference(variants, variant.device):
        return "reference"
    return variant.run.bit_identical if "bit_identical" in variant.run else "not run"


def _cost_figure(variants: Sequence[Variant], panels: Sequence[tuple[str, int]]) -> Figure:
    return Figure(
        draw=lambda: _draw_cost(variants, panels),
        caption="Time of a frame, of that of the scene exactly as shipped (line) on the same device with as many "
        "worlds. The whisker is from the 5th to the 95th percentile; a case without a bar was not timed there.",
        alt="; ".join(
            f"{variant.case} on the {DEVICES[variant.device]} with {row.worlds} worlds: {row.frame_ms}"
            for variant in variants
            for row in variant.rows
        ),
        sources=[row.frame_ms for variant in variants for row in variant.rows],
    )


def _draw_cost(variants: Sequence[Variant], panels: Sequence[tuple[str, int]]) -> Drawing:
    names = list(dict.fromkeys(variant.case for variant in variants))
    drawing, grid = new_figure(7.2, 1.3 + 0.28 * len(names), ncols=len(panels), sharey=True, squeeze=False)
    for axes, (device, worlds) in zip(grid[0], panels, strict=True):
        whole = _find(variants, device, REFERENCE).at(worlds).frame_ms.value
        for variant in variants:
            row = variant.at(worlds)
            if variant.device == device and row and row.frame_ms.value is not None:
                middle, low, high = (
                    100 * row[name].value / whole for name in ("frame_ms", "frame_ms_p5", "frame_ms_p95")
                )
                place = names.index(variant.case)
                axes.barh(place, middle, height=0.62, color=SERIES[0], edgecolor=INK, linewidth=0.6)
                axes.plot([low, high], [place, place], color=INK, linestyle="-", marker="|", markevery=1, linewidth=1.2)
        axes.axvline(100, color=INK, linewidth=1, linestyle="--")
        axes.set_xlim(left=0)
        axes.set_title(f"{DEVICES[device]}\n{format_number(worlds)} world{'s' * (worlds > 1)}")
        axes.grid(axis="y", visible=False)
    grid[0][0].set_yticks(range(len(names)), names)
    grid[0][0].invert_yaxis()
    drawing.supxlabel("time of a frame, of that exactly as shipped [%]", fontsize=10)
    return drawing
