"""Where the grasp holds, creeps, drops and explodes: maps, the largest stable step, and what is safe."""

from collections.abc import Mapping, Sequence

import numpy as np
import pandas as pd
from markupsafe import Markup

from report.format import format_number
from report.parts import Figure, Section, Table
from report.quantities import Quantity, Value, absent
from report.results import Results, Row
from report.sections import _stability_extremes as extremes
from report.sections import _stability_steps as limits
from report.sections._common import by_case, cell_or_absent
from report.sections._stability import CLASSES, family, is_stable
from report.sections._stability_figures import (
    draw_loads,
    draw_long,
    draw_maps,
    draw_plateau,
    draw_sizes,
    draw_steps,
)

order = 145

LET_GO = "the fingers let the cube go"


def derive(results: Results) -> Section:
    critical, default_kd = family(results, "ke-critical"), family(results, "ke-kd-100")
    depth = results.chosen("depth_largest", "depth in stiff pads, of the edge", 1.0, unit="%")
    searched = family(results, "largest-step")
    plain = sorted((row for row in searched if row.of == "ke-kd-100"), key=lambda row: row.pad_ke.value)
    predicted = {row.case: limits.predict_step(results, row) for row in plain}
    return Section(
        tables={
            "largest_step": _largest_step_table(searched, predicted),
            "clamp": _clamp_table(family(results, "clamp")),
            "others": _others_table(results),
            "overlap": _overlap_table(family(results, "overlap")),
        },
        figures={
            "maps": _maps(critical, default_kd),
            "steps": _figure(
                lambda: draw_steps(family(results, "steps")),
                family(results, "steps"),
                "Size of the drift over the step, with the pads as shipped and with stiff pads. The bands are a factor "
                "of two either way about the drift with the smallest step; open marks: it goes the other way.",
                "Drift over the step for pads as shipped and stiff pads.",
            ),
            "plateau": _figure(
                lambda: draw_plateau(critical),
                critical,
                "How deep the pads sink into the cube at the same grip, damping ratio 1. Filled marks: the clamp is at "
                "work.",
                "Depth over pad ke for several steps: it falls with ke and is flat where the clamp is at work.",
            ),
            "loads": _loads(results),
            "sizes": _figure(
                lambda: draw_sizes(family(results, "size"), depth.value),
                family(results, "size"),
                "Depth in stiff pads over the edge of the cube, by the edge. On the upper border: cubes that were "
                "lost. The line is the bound.",
                "Depth over edge falls steeply as the cube grows; the smallest cubes are lost.",
            ),
            "long": _long_figure(results),
        },
        claims=[
            limits.safe(results, critical, default_kd),
            limits.steps(results),
            limits.plateau(results, critical),
            limits.boundary(results, default_kd),
            limits.clamp(results),
            limits.largest_step(results, [found for _, found in predicted.values()]),
            extremes.crossover(results, "shake", "Shaken harder and harder"),
            extremes.crossover(results, "grip", "Gripped less and less"),
            extremes.friction(results),
            extremes.mass(results),
            extremes.size(results, depth),
            extremes.overlap(results),
            extremes.gravity(results),
            extremes.freed(results),
            extremes.long(results),
            extremes.buffers(results),
            extremes.neighbours(results),
            extremes.repeats_agree(results),
        ],
    )


def _figure(draw, rows: Sequence[Row], caption: str, alt: str) -> Figure:
    sources = [row.step_ms for row in rows] or [absent("s", "it was not measured")]
    return Figure(draw=draw, caption=caption, alt=alt, sources=sources)


def _maps(critical: Sequence[Row], default_kd: Sequence[Row]) -> Figure:
    def clamped_from(ke: np.ndarray) -> np.ndarray:
        return 0.5 / np.sqrt(ke)

    def explicit(ke: np.ndarray) -> np.ndarray:
        kd = default_kd[0].pad_kd.value
        return (np.sqrt(kd**2 + 4.0 * ke) - kd) / ke

    def draw():
        return draw_maps(
            [
                ("kd = 2√ke", critical, clamped_from, "timeconst is clamped to 2 dt"),
                ("kd at its default", default_kd, explicit, "dt² ke + 2 dt kd > 4"),
            ]
        )

    ends = {name: sum(row["class"] == name for row in (*critical, *default_kd)) for name in CLASSES}
    return _figure(
        draw,
        [*critical, *default_kd] if critical and default_kd else [],
        "How each run ends, by pad ke and step. Numbers are rates of creep. Each cell is the worst of its repeats.",
        "Two maps of how runs end over pad ke and step: "
        + ", ".join(f"{number} {name}" for name, number in ends.items() if number),
    )


def _loads(results: Results) -> Figure:
    shakes = family(results, "shake")
    frequencies = [row.shake_frequency_hz.value for row in shakes]
    common = max(set(frequencies), key=frequencies.count, default=0.0)
    series = [
        ("amplitude", [row for row in shakes if row.shake_frequency_hz.value == common]),
        ("frequency", [row for row in shakes if row.shake_frequency_hz.value != common]),
        ("grip force", family(results, "grip")),
    ]
    series = [(label, rows) for label, rows in series if rows]
    return _figure(
        lambda: draw_loads(series),
        [row for _, rows in series for row in rows],
        "Runs by the share of the friction limit that they need, computed from the grip force and the motion of the "
        "hand that were measured in the same run. The limit is at one; in the band nothing is asked.",
        "Runs that need less than the friction limit hold, runs that need more drop.",
    )


def _long_figure(results: Results) -> Figure:
    trace = results.trace("long")
    return Figure(
        draw=lambda: draw_long(trace),
        caption="Displacement of the cube in the hand over the long shake, with stiff pads.",
        alt="Displacement over minutes along three axes.",
        sources=[trace],
    )


def _largest_step_table(rows: Sequence[Row], predicted: Mapping[str, tuple[Value, Value]]) -> Table:
    by_ke: dict[float, dict[str, Row]] = {}
    for row in rows:
        by_ke.setdefault(row.pad_ke.value, {})[row.of] = row
    table = []
    for ke in sorted(by_ke):
        critical, plain = (by_ke[ke].get(name) for name in ("ke-critical", "ke-kd-100"))
        table.append([_step_cell(critical), _step_cell(plain), *(predicted[plain.case] if plain else ("", ""))])
    frame = pd.DataFrame(table, columns=["kd = 2√ke", "default kd", "predicted", "found over predicted"])
    frame.index = pd.Index([format_number(ke) for ke in sorted(by_ke)], name="ke")
    return Table(
        frame,
        "The largest step that keeps the cube, by bisection. It is the largest that was tried where none fails. The "
        "prediction is that of the explicit bound for the default kd; what is found is the geometric mean of the "
        "largest step that holds and the least that was seen to fail.",
    )


def _step_cell(row: Row | None) -> Quantity | str:
    return row.largest_step_ms if row else ""


def _clamp_table(rows: Sequence[Row]) -> Table:
    ratios = sorted({row.timeconst_steps.value for row in rows}, reverse=True)
    found = {(row.clamp, row.timeconst_steps.value): row for row in rows}
    table = [
        {
            label: _ending(found.get((clamp, ratio)))
            for clamp, label in (("off", "clamp off"), ("direct", "direct solref"))
        }
        for ratio in ratios
    ]
    frame = pd.DataFrame(table, columns=["clamp off", "direct solref"])
    frame.index = pd.Index([format_number(ratio) for ratio in ratios], name="timeconst over dt")
    return Table(frame, "Damping ratio 1 at the shipped step, without the clamp: how the run ends, and its creep.")


def _ending(row: Row | None) -> Markup | str:
    if row is None:
        return ""
    return Markup("{} {}").format(row["class"], row.creep_mm_s) if is_stable(row) else row["class"]


def _overlap_table(rows: Sequence[Row]) -> Table:
    columns = {
        "overlap": [row.overlap_mm for row in rows],
        "exit speed": [row.exit_speed_mm_s for row in rows],
        "undamped spring": [row.exit_bound_mm_s for row in rows],
        "ends": [row["class"] for row in rows],
    }
    return Table(
        pd.DataFrame(columns, index=pd.Index([row.start for row in rows], name="start in")),
        "Starts that overlap: how fast the cube leaves, how fast an undamped spring of the contact's stiffness would "
        "throw it, overlap times √k, and how the run ends. Between two pads it is pushed from both sides and stays. "
        "Springy ground is the same ground under a cube so stiff that their contact is hardly damped.",
    )


def _others_table(results: Results) -> Table:
    names = ("friction", "mass", "gravity", "buffers")
    rows = [row for name in names for row in family(results, name)]
    columns = {
        "ends": ["let go" if _is_freed(row) else row["class"] for row in rows],
        "drift": [absent("mm/s", LET_GO) if _is_freed(row) else row.drift_mm_s for row in rows],
        "creep": [absent("mm/s", LET_GO) if _is_freed(row) else row.creep_mm_s for row in rows],
        "depth": [row.penetration_mm for row in rows],
        "friction used": [_friction_used(row) for row in rows],
        "passes": [bool(row.passes) for row in rows],
    }
    return by_case(
        rows,
        columns,
        "The other extremes, the worst repeat of each: how the run ends, drift along the shake's main axis, creep in "
        "any direction, depth in the pads, and friction needed over friction there is. A run passes when it stays "
        "finite, drops if there is no friction at all, gains no energy if the cube is let go, and names the buffer if "
        "one is too small.",
    )


def _is_freed(row: Row) -> bool:
    return "freed" in row and row.freed


def _friction_used(row: Row) -> Quantity:
    if _is_freed(row):
        return absent("1", LET_GO)
    if "pad_mu" in row and row.pad_mu.value == 0.0:
        return absent("1", "there is no friction to use")
    return cell_or_absent(row, "load", "1")
