"""Where the grasp holds, creeps, drops and explodes: maps, the largest stable step, and what is safe."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np
import pandas as pd
from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from measured_report.parts.parts import Figure, Section, Table
from measured_report.values.quantities import Quantity, Value, absent
from measured_report.values.results import Results, Row
from report.sections.stability import extremes
from report.sections.stability import steps as limits
from report.sections.stability.classes import CLASSES, is_stable
from report.sections.stability.families import count, family
from report.sections.stability.figures import draw_loads, draw_long, draw_maps, draw_plateau, draw_sizes, draw_steps
from report.sections.stability.passing import DEPTH_LARGEST, LIMIT_MARGIN, NEAR_FACTOR, passing
from report.shared.arithmetic import by_case, cell_or_absent

order = 145
page = "limits"
label = "limits"

LET_GO = "the fingers let the cube go"
STARTS = {
    "pads-as-shipped": "shipped pads",
    "pads-stiff": "stiff pads",
    "ground": "the ground",
    "ground-springy": "springy ground",
}
"""What a cube starts too deep in."""


def derive(results: Results) -> Section:
    critical, default_kd = family(results, "ke-critical"), family(results, "ke-kd-100")
    near = results.chosen("near_factor", "alike", NEAR_FACTOR)
    margin = results.chosen("limit_margin", "well below the limit, or well above", LIMIT_MARGIN, unit="%")
    depth = results.chosen("depth_largest", "depth in stiff pads, of the edge", DEPTH_LARGEST, unit="%")
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
            "maps": _maps(results, critical, default_kd),
            "steps": _figure(lambda: draw_steps(family(results, "steps")), family(results, "steps"), near=near),
            "plateau": _figure(lambda: draw_plateau(critical), critical),
            "loads": _loads(results),
            "sizes": _figure(lambda: draw_sizes(family(results, "size"), depth.value), family(results, "size")),
            "long": _long_figure(results),
        },
        claims=[
            limits.safe(results, critical, default_kd),
            limits.lifted_stands_more(results),
            limits.steps(results, near),
            limits.steps_order(results),
            limits.gain_goes(results),
            limits.plateau(results, critical, near),
            limits.boundary(results, default_kd, near),
            limits.clamp(results),
            limits.leans_on_clamp(results),
            limits.largest_step(results, [found for _, found in predicted.values()]),
            extremes.crossover(results, "shake", margin),
            extremes.crossover(results, "grip", margin),
            extremes.friction(results),
            extremes.mass(results),
            extremes.mass_grip(results),
            extremes.mass_drift(results),
            extremes.mass_sink(results),
            extremes.size(results, depth),
            extremes.overlap(results),
            extremes.gravity(results),
            extremes.arm_gives_way(results),
            extremes.freed(results),
            extremes.long(results),
            extremes.long_adds_up(results),
            extremes.buffers(results),
            extremes.neighbours(results),
            extremes.repeats_agree(results),
        ],
    )


def _figure(draw: Callable[[], Drawing], rows: Sequence[Row], **numbers: Markup | Value) -> Figure:
    sources = [row.step_ms for row in rows] or [absent("s", "it was not measured")]
    return Figure(draw=draw, sources=sources, numbers=numbers)


def _maps(results: Results, critical: Sequence[Row], default_kd: Sequence[Row]) -> Figure:
    def clamped_from(ke: np.ndarray) -> np.ndarray:
        return 0.5 / np.sqrt(ke)

    def explicit(ke: np.ndarray) -> np.ndarray:
        kd = default_kd[0].pad_kd.value
        return (np.sqrt(kd**2 + 4.0 * ke) - kd) / ke

    def draw() -> Drawing:
        return draw_maps(
            [
                ("kd = 2√ke", critical, clamped_from, "timeconst is clamped to 2 dt"),
                ("kd at its default", default_kd, explicit, "dt² ke + 2 dt kd > 4"),
            ]
        )

    ends = [_ending_count(results, name, [*critical, *default_kd]) for name in CLASSES]
    return _figure(
        draw,
        [*critical, *default_kd] if critical and default_kd else [],
        ends=Markup(", ").join(
            Markup("{} {}").format(end, name) for end, name in zip(ends, CLASSES, strict=True) if end.value
        ),
    )


def _ending_count(results: Results, name: str, rows: Sequence[Row]) -> Value:
    mine = [row for row in rows if row["class"] == name]
    return count(results, f"maps_{name}_count", f"cells of both maps that are {name}", mine)


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
    return _figure(lambda: draw_loads(series), [row for _, rows in series for row in rows])


def _long_figure(results: Results) -> Figure:
    trace = results.trace("long")
    return Figure(draw=lambda: draw_long(trace), sources=[trace])


def _largest_step_table(rows: Sequence[Row], predicted: Mapping[str, tuple[Value, Value]]) -> Table:
    by_ke: dict[float, dict[str, Row]] = {}
    for row in rows:
        by_ke.setdefault(row.pad_ke.value, {})[row.of] = row
    table = []
    for ke in sorted(by_ke):
        critical, plain = (by_ke[ke].get(name) for name in ("ke-critical", "ke-kd-100"))
        table.append([_step_cell(critical), _step_cell(plain), *(predicted[plain.case] if plain else ("", ""))])
    frame = pd.DataFrame(table, columns=["kd = 2√ke", "default kd", "predicted", "found over predicted"])
    frame.index = pd.Index([next(iter(by_ke[ke].values())).pad_ke.bare for ke in sorted(by_ke)], name="ke")
    return Table(frame)


def _step_cell(row: Row | None) -> Quantity | str:
    return row.largest_step_ms if row else ""


def _clamp_table(rows: Sequence[Row]) -> Table:
    ratios = {row.timeconst_steps.value: row.timeconst_steps for row in rows}
    found = {(row.clamp, row.timeconst_steps.value): row for row in rows}
    table = [
        {label: _ending(found.get((clamp, ratio))) for clamp, label in limits.UNCLAMPED.items()}
        for ratio in sorted(ratios, reverse=True)
    ]
    frame = pd.DataFrame(table, columns=list(limits.UNCLAMPED.values()))
    index = [ratios[ratio].bare for ratio in sorted(ratios, reverse=True)]
    frame.index = pd.Index(index, name="timeconst over dt")
    return Table(frame)


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
    index = pd.Index([STARTS.get(row.start, row.start) for row in rows], name="start in")
    return Table(pd.DataFrame(columns, index=index))


def _others_table(results: Results) -> Table:
    names = ("friction", "mass", "gravity", "buffers")
    families = [family(results, name) for name in names]
    rows = [row for members in families for row in members]
    columns = {
        "ends": ["let go" if _is_freed(row) else row["class"] for row in rows],
        "drift": [absent("mm/s", LET_GO) if _is_freed(row) else row.drift_mm_s for row in rows],
        "creep": [absent("mm/s", LET_GO) if _is_freed(row) else row.creep_mm_s for row in rows],
        "depth": [row.penetration_mm for row in rows],
        "hand sinks": [row.hand_sink_mm for row in rows],
        "friction needed": [_friction_needed(row) for row in rows],
        "as expected": [bool(passes) for members in families for passes in passing(members)],
    }
    return by_case(rows, columns)


def _is_freed(row: Row) -> bool:
    return "freed" in row and row.freed


def _friction_needed(row: Row) -> Quantity:
    if _is_freed(row):
        return absent("1", LET_GO)
    if "pad_mu" in row and row.pad_mu.value == 0.0:
        return absent("1", "there is no friction to use")
    return cell_or_absent(row, "load", "1")
