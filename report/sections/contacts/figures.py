"""What the left-out acceleration gives of slide, beside what the contact rows show."""

from collections.abc import Sequence

from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import FAINT, INK, new_figure, say_value, write
from measured_report.values.quantities import Quantity
from report.shared.drawing import SHIPPED, STIFF, TERM, name_lines

PADS = {"shipped pads": SHIPPED, "stiff pads": STIFF}


def draw_slide(bars: Sequence[tuple[Quantity, Quantity, Quantity]]) -> Drawing:
    """Draw for each pads three bars: slide from the left-out term, slide of the rows, and that with the term put
    back."""
    drawing, axes = new_figure(7.2, 2.6)
    names: list[str] = []
    for (pads, colour), cells in zip(PADS.items(), bars, strict=True):
        whats = ("from the left-out term", "measured in the rows", "with the term put back")
        for what, cell, face in zip(whats, cells, (FAINT, colour, TERM), strict=True):
            if cell.value is not None:
                axes.barh(len(names), cell.value, height=0.7, color=face, edgecolor=INK, linewidth=0.5)
                say_value(axes, max(cell.value, 0.0), len(names), write(cell))
            names.append(f"{pads}, {what}")
    name_lines(axes, names)
    axes.axvline(0.0, color=INK, linewidth=0.8)
    axes.margins(x=0.12)
    axes.grid(axis="y", visible=False)
    axes.set_xlabel("slide of the friction rows along the main axis [mm]")
    return drawing
