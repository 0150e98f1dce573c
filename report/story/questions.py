"""Draw the settings with a stable grasp, and the gain of a scene without unneeded parts."""

import numpy as np

from experiments.facts.case import AS_SHIPPED
from report.sections.stability.figures import draw_map
from report.shared import TIMED_WORLDS, Figure, Quantity, Row, Sections, worlds_name
from report.shared.drawing import (
    MAP_INK,
    SHIPPED,
    STIFF,
    Drawing,
    draw_line,
    name_lines,
    new_figure,
    write,
)

WORLDS = (TIMED_WORLDS[0], TIMED_WORLDS[-1])


def figure(sections: Sections) -> Figure:
    rows = [
        row
        for row in sections.rows("stability")
        if row.plain["family"] == "ke-critical"
    ]
    gains = [sections.value("leave_out", f"cuda_gain_{count}") for count in WORLDS]
    cells = [row.creep_mm_s for row in rows]
    return Figure(lambda: _draw(rows, gains), [*cells, *gains])


def _draw(rows: list[Row], gains: list[Quantity]) -> Drawing:
    drawing, (left, right) = new_figure(7.2, 2.7, ncols=2)
    left.set_title("Stable? Darker creeps faster, ▼ is lost")
    if rows:
        draw_map(left, rows, {"shipped": AS_SHIPPED.pad_ke}, has_numbers=False)
        low, high = left.get_ylim()
        steps_ms = np.geomspace(low, high, 50)
        ke = (1e3 / steps_ms) ** 2 / 4.0
        draw_line(left, ke, steps_ms, color=MAP_INK, scalex=False)
    left.set(xlabel="pad ke, with kd = 2√ke (line: the rule)", ylabel="step [ms]")
    right.set_title("Leave out? Speed of a frame")
    known = [
        (worlds_name(count), gain)
        for count, gain in zip(WORLDS, gains, strict=True)
        if gain.value is not None
    ]
    for place, (_, gain) in enumerate(known):
        right.barh(place, gain.number, height=0.5, color=STIFF)
        right.annotate(
            f"{write(gain)} ×",
            (gain.number, place),
            xytext=(4, 0),
            textcoords="offset points",
            va="center",
        )
    right.axvline(1.0, color=SHIPPED, linewidth=1.2, linestyle="-", marker="")
    name_lines(right, [name for name, _ in known])
    right.set_xlim(0.0, 1.3 * max((gain.number for _, gain in known), default=1.0))
    right.set_xlabel("relative to the scene exactly as shipped")
    right.grid(axis="y", visible=False)
    return drawing
