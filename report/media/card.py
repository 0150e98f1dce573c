"""The picture that others show with a link to the site: the slip of every release, with shipped and with stiff pads."""

import io
from collections.abc import Mapping

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure as Drawing

from measured_report.parts.figures import INK, own_style
from measured_report.values.quantities import Quantity
from report.shared.drawing import SHIPPED, STIFF

TITLE = "Slip of a shaken cube, Newton's contacts"


def draw_card(slips: Mapping[str, Mapping[str, Quantity | None]]) -> bytes:
    """Draw the picture as PNG, of 1200 × 630 pixels; ``slips`` are by release, and by what they are of."""
    with own_style({"figure.facecolor": "#fdfdfc", "savefig.facecolor": "#fdfdfc"}):
        drawing = Drawing(figsize=(12, 6.3), dpi=100, layout="constrained")
        axes = drawing.subplots()
        for place, pair in enumerate(slips.values()):
            for shift, colour, (label, slip) in zip((-0.18, 0.18), (SHIPPED, STIFF), pair.items(), strict=True):
                there = slip is not None and slip.value is not None
                lost = "run failed" if slip is not None and slip.source else "not measured"
                width, text = (slip.value, str(slip)) if there else (0.0, lost)
                axes.barh(place + shift, width, height=0.34, color=colour, label=label)
                axes.text(width, place + shift, f" {text}", va="center", fontsize=22, color=INK)
        axes.set_yticks(range(len(slips)), [f"Newton {release}" for release in slips], fontsize=24)
        axes.invert_yaxis()
        axes.margins(x=0.2)
        axes.grid(visible=False)
        axes.tick_params(bottom=False, labelbottom=False)
        axes.spines[["bottom", "left"]].set_visible(False)
        drawing.suptitle(TITLE, fontsize=30)
        handles = dict(zip(*reversed(axes.get_legend_handles_labels()), strict=True))
        drawing.legend(handles.values(), handles.keys(), loc="outside lower left", ncols=2, fontsize=22)
        buffer = io.BytesIO()
        FigureCanvasAgg(drawing).print_png(buffer, metadata={"Software": None})
        return buffer.getvalue()
