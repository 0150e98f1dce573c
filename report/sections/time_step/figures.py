"""Draw the slip against the time step."""

from report.sections.time_step.ladder import NEWTON, RULE, Ladder
from report.shared import Figure, Row, is_held
from report.shared.drawing import (
    CURE,
    SERIES,
    SHIPPED,
    STIFF,
    Drawing,
    name_ends,
    new_figure,
    tick_at,
)

REMEDIES = {
    (NEWTON, "shipped"): ("shipped pads", SHIPPED, "o"),
    (NEWTON, "stiff"): ("the same stiff pads", SERIES[5], "s"),
    (NEWTON, RULE): ("the rule", STIFF, "D"),
    ("cure", "shipped"): ("root cure, shipped pads", CURE, "o"),
    ("rk4", RULE): ("RK4, the rule", SERIES[5], "^"),
    ("c", RULE): ("MuJoCo C, the rule", SERIES[4], "v"),
}
"""Name, colour and marker of each line in the figure, by setting and pads."""


def slip_figure(ladder: Ladder) -> Figure:
    """Draw the slip of each remedy against the step."""
    lines = {}
    for key in REMEDIES:
        rows = [ladder.row(*key, count) for count in ladder.substeps(*key)]
        lines[key] = [row for row in rows if is_held(row)]
    cells = [row.slip_mm for rows in lines.values() for row in rows]
    return Figure(lambda: _draw(lines), cells)


def _draw(lines: dict[tuple[str, str], list[Row]]) -> Drawing:
    drawing, axes = new_figure(7.2, 4.2)
    ends = []
    for key, rows in lines.items():
        if not rows:
            continue
        name, colour, marker = REMEDIES[key]
        steps = [row.substep_ms.number for row in rows]
        slips = [row.slip_mm.number for row in rows]
        axes.plot(steps, slips, color=colour, marker=marker, linestyle="-", markevery=1)
        ends.append((steps[-1], slips[-1], name, colour))
    name_ends(axes, ends, offset=-6, near=3.0, ha="right")
    axes.set(
        xscale="log",
        yscale="log",
        xlabel="time step [ms]",
        ylabel="slip in the whole shake [mm]",
    )
    axes.set_xlim(left=0.02)
    tick_at(axes.xaxis, [0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0])
    return drawing
