"""Where the grasp holds, creeps, drops and explodes: maps, the largest stable step, and what is safe."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from measured_report.parts.section import Figure, Section, Table
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results, Row
from report.sections.stability import extremes
from report.sections.stability import steps as limits
from report.sections.stability.families import count, family, family_claim
from report.sections.stability.figures import draw_loads, draw_long, draw_maps, draw_plateau, draw_sizes, draw_steps
from report.sections.stability.passing import CLASSES, DEPTH_LARGEST, LIMIT_MARGIN, NEAR_FACTOR, is_stable, passing
from report.shared.arithmetic import Column, by_case, cell_or_absent, table_of

order = 145
page = "limits"
label = "limits"

LET_GO = absent("mm/s", "the fingers let the cube go")
STARTS = {"pads-as-shipped": "shipped pads", "pads-stiff": "stiff pads", "ground": "the ground"}
STARTS |= {"ground-springy": "springy ground"}
"""What a cube starts too deep in."""
THROWN = {"overlap": "overlap_mm", "exit speed": "exit_speed_mm_s", "undamped spring": "exit_bound_mm_s"}
THROWN |= {"ends": "class"}


def derive(results: Results) -> Section:
    critical, default_kd = family(results, "ke-critical"), family(results, "ke-kd-100")
    near = results.chosen("near_factor", "alike", NEAR_FACTOR)
    margin = results.chosen("limit_margin", "well below the limit, or well above", LIMIT_MARGIN, unit="%")
    depth = results.chosen("depth_largest", "depth in stiff pads, of the edge", DEPTH_LARGEST, unit="%")
    searched, thrown, trace = family(results, "largest-step"), family(results, "overlap"), results.trace("long")
    plain = sorted((row for row in searched if row.of == "ke-kd-100"), key=lambda row: row.pad_ke.value)
    predicted = {row.case: limits.predict_step(results, row) for row in plain}
    return Section(
        tables={
            "largest_step": _largest_step_table(searched, predicted),
            "clamp": _clamp_table(family(results, "clamp")),
            "others": _others_table(results),
            "overlap": table_of("start in", (STARTS.get(row.start, row.start) for row in thrown), THROWN, thrown),
        },
        figures={
            "maps": _maps(results, critical, default_kd),
            "steps": _figure(draw_steps, family(results, "steps"), near=near),
            "plateau": _figure(draw_plateau, critical),
            "loads": _loads(results),
            "sizes": _figure(lambda rows: draw_sizes(rows, depth.value), family(results, "size")),
            "long": Figure(lambda: draw_long(trace), [trace]),
        },
        claims=[
            limits.safe(results, critical, default_kd),
            limits.lifted_stands_more(results),
            limits.steps(results, near),
            limits.steps_order(results),
            limits.gain_goes(results),
            family_claim(results, "clamp_plateau", [row for row in critical if row.clamped], near=near),
            family_claim(results, "explicit_boundary", default_kd, near=near),
            limits.clamp(results),
            limits.leans_on_clamp(results),
            limits.largest_step(results, [found for _, found in predicted.values()]),
            *(extremes.crossover(results, name, margin) for name in ("shake", "grip")),
            extremes.friction(results),
            *extremes.masses(results),
            extremes.size(results, depth),
            extremes.overlap(results),
            *extremes.gravity(results),
            *extremes.long(results),
            extremes.buffers(results),
            extremes.neighbours(results),
            extremes.repeats_agree(results),
        ],
    )


def _figure(draw: Callable[[Sequence[Row]], Drawing], rows: Sequence[Row], **numbers: Markup | Value) -> Figure:
    return Figure(lambda: draw(rows), [row.step_ms for row in rows] or [absent("s", "it was not measured")], numbers)


def _maps(results: Results, critical: Sequence[Row], default_kd: Sequence[Row]) -> Figure:
    kd = default_kd[0].pad_kd.value if default_kd else np.nan
    panels = [
        ("kd = 2√ke", critical, lambda ke: 0.5 / np.sqrt(ke), "timeconst is clamped to 2 dt"),
        ("kd at its default", default_kd, lambda ke: (np.sqrt(kd**2 + 4.0 * ke) - kd) / ke, "dt² ke + 2 dt kd > 4"),
    ]
    rows = [*critical, *default_kd]
    mine = {name: [row for row in rows if row["class"] == name] for name in CLASSES}
    formula = "cells of both maps that are"
    ends = [(count(results, f"maps_{name}_count", f"{formula} {name}", found), name) for name, found in mine.items()]
    said = Markup(", ").join(Markup("{} {}").format(*end) for end in ends if end[0].value)
    return _figure(lambda _: draw_maps(panels), rows if critical and default_kd else [], ends=said)


def _loads(results: Results) -> Figure:
    shakes = family(results, "shake")
    frequencies = [row.shake_frequency_hz.value for row in shakes]
    common = max(set(frequencies), key=frequencies.count, default=0.0)
    by_kind = {
        "amplitude": [row for row in shakes if row.shake_frequency_hz.value == common],
        "frequency": [row for row in shakes if row.shake_frequency_hz.value != common],
        "grip force": family(results, "grip"),
    }
    series = [(label, rows) for label, rows in by_kind.items() if rows]
    return _figure(lambda _: draw_loads(series), [row for _, rows in series for row in rows])


def _largest_step_table(rows: Sequence[Row], predicted: Mapping[str, tuple[Value, Value]]) -> Table:
    by_ke: dict[float, dict[str, Row]] = {}
    for row in sorted(rows, key=lambda row: row.pad_ke.value):
        by_ke.setdefault(row.pad_ke.value, {})[row.of] = row
    columns: dict[str, Column] = {
        label: [found[of].largest_step_ms if of in found else "" for found in by_ke.values()]
        for label, of in (("kd = 2√ke", "ke-critical"), ("default kd", "ke-kd-100"))
    }
    theory = [predicted[found["ke-kd-100"].case] if "ke-kd-100" in found else ("", "") for found in by_ke.values()]
    columns |= {"predicted": [step for step, _ in theory], "found over predicted": [found for _, found in theory]}
    return table_of("ke", [next(iter(found.values())).pad_ke.bare for found in by_ke.values()], columns)


def _clamp_table(rows: Sequence[Row]) -> Table:
    ratios = {row.timeconst_steps.value: row.timeconst_steps for row in rows}
    found = {(row.clamp, row.timeconst_steps.value): row["class"] for row in rows}
    for row in filter(is_stable, rows):
        found[row.clamp, row.timeconst_steps.value] += Markup(" {}").format(row.creep_mm_s)
    falling = sorted(ratios, reverse=True)
    columns = {label: [found.get((way, ratio), "") for ratio in falling] for way, label in limits.UNCLAMPED.items()}
    return table_of("timeconst over dt", [ratios[ratio].bare for ratio in falling], columns)


def _others_table(results: Results) -> Table:
    families = [family(results, name) for name in ("friction", "mass", "gravity", "buffers")]
    columns: dict[str, Column] = {
        "ends": lambda row: "let go" if _is_freed(row) else row["class"],
        "drift": lambda row: LET_GO if _is_freed(row) else row.drift_mm_s,
        "creep": lambda row: LET_GO if _is_freed(row) else row.creep_mm_s,
        **{"depth": "penetration_mm", "hand sinks": "hand_sink_mm", "friction needed": _friction_needed},
        "as expected": [bool(passes) for members in families for passes in passing(members)],
    }
    return by_case([row for members in families for row in members], columns)


def _is_freed(row: Row) -> bool:
    return "freed" in row and row.freed


def _friction_needed(row: Row) -> Quantity:
    if _is_freed(row):
        return absent("1", LET_GO.reason)
    if "pad_mu" in row and row.pad_mu.value == 0.0:
        return absent("1", "there is no friction to use")
    return cell_or_absent(row, "load", "1")
