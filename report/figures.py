"""Figures: one look for all of them, drawn as SVG that takes its colours from the page."""

import io
import math
import re
from collections.abc import Callable, Sequence
from typing import Any

import matplotlib
from cycler import cycler
from markupsafe import Markup
from matplotlib.axis import Axis
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure as Drawing
from matplotlib.ticker import (
    FixedLocator,
    FuncFormatter,
    LogFormatter,
    LogFormatterMathtext,
    LogLocator,
    NullFormatter,
    NullLocator,
)

from report.format import format_code, format_number, format_power

INK = "#1b1f24"
FAINT = "#c9ced4"
MAP_INK = "#101418"
"""For what is drawn on a map: a map keeps its colours on a dark page, and so does this."""
SERIES = ("#0b62a8", "#b8480c", "#0a7a5c", "#8b3d91", "#8a6400", "#4a5560")
"""Colours that are told apart by colour-blind readers; the stylesheet has a lighter set for dark pages."""

PAGE_COLOURS = {INK: "currentColor", FAINT: "var(--faint)"} | {
    colour: f"var(--series-{number})" for number, colour in enumerate(SERIES, start=1)
}

STYLE: dict[str, Any] = {
    "svg.fonttype": "none",
    "text.parse_math": False,
    "figure.facecolor": "none",
    "axes.facecolor": "none",
    "savefig.facecolor": "none",
    "axes.edgecolor": INK,
    "axes.labelcolor": INK,
    "axes.titlecolor": INK,
    "axes.formatter.useoffset": False,
    "axes.titlesize": 10,
    "axes.titlelocation": "left",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": FAINT,
    "grid.linewidth": 0.6,
    "text.color": INK,
    "xtick.color": INK,
    "ytick.color": INK,
    "hatch.color": INK,
    "font.size": 10,
    "legend.frameon": False,
    "lines.linewidth": 1.6,
    "lines.markersize": 4.5,
    "figure.constrained_layout.use": True,
    # Line and mark differ as well as colour, so that a series is found without seeing colours.
    "axes.prop_cycle": cycler(color=SERIES)
    + cycler(linestyle=("-", "--", "-.", ":", (0, (6, 1, 1, 1, 1, 1)), (0, (8, 3))))
    + cycler(marker=("o", "s", "^", "D", "v", "P"))
    + cycler(markevery=(0.1,) * len(SERIES)),
}

IDENTIFIER = re.compile(r'( id="|xlink:href="#|url\(#)')
UNWANTED = re.compile(r"<metadata>.*?</metadata>|<style .*?</style>|^.*?(?=<svg )", re.DOTALL)
OPENING = re.compile(r'<svg [^>]*?viewBox="([^"]*)"[^>]*>')


class LogLabels(LogFormatter):
    """Labels of a logarithmic axis as text; Matplotlib's own are formulas, which take long to typeset."""

    def __call__(self, value: float, position: int | None = None) -> str:
        if not super().__call__(value, position):
            return ""
        low, high = self.axis.get_view_interval()
        exponent = round(math.log10(value))
        if (low < 1e-4 or high > 1e5) and math.isclose(value, 10.0**exponent):
            return format_power(exponent)
        return format_number(value, digits=1)


def _label_plainly(axis: Axis) -> None:
    if isinstance(axis.get_major_formatter(), LogFormatterMathtext):
        axis.set_major_formatter(LogLabels())
    minor = axis.get_minor_formatter()
    if isinstance(minor, LogFormatterMathtext):
        axis.set_minor_formatter(LogLabels(labelOnlyBase=minor.labelOnlyBase))


def plain_labels(*, digits: int = 6) -> FuncFormatter:
    """Labels as plain numbers, without zeros at their ends."""
    return FuncFormatter(lambda value, _: format_code(value, digits=digits))


def tick_125(axis: Axis) -> None:
    """Label a logarithmic axis at 1, 2 and 5 of each decade, so that less than a decade has labels too."""
    axis.set_major_locator(LogLocator(subs=(1.0, 2.0, 5.0), numticks=12))
    axis.set_major_formatter(plain_labels())
    axis.set_minor_formatter(NullFormatter())


def tick_decades(axis: Axis) -> None:
    """Ticks of a logarithmic axis at whole powers of ten alone."""
    axis.set_major_locator(LogLocator(numticks=12))
    axis.set_minor_locator(NullLocator())


def tick_at(axis: Axis, places: Sequence[float], *, digits: int = 6) -> None:
    """Ticks at ``places`` alone."""
    axis.set_major_locator(FixedLocator(places))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(plain_labels(digits=digits))


def new_figure(width: float = 7.2, height: float = 3.4, **subplots) -> tuple[Drawing, Any]:
    """A figure of ``width`` × ``height`` inches with the axes, or the array of them, that ``Figure.subplots`` makes."""
    drawing = Drawing(figsize=(width, height))
    return drawing, drawing.subplots(**subplots)


def draw_svg(draw: Callable[[], Drawing], *, name: str, alt: str) -> Markup:
    """The figure as an SVG element: its ids begin with ``name``, and the same data give the same bytes."""
    with matplotlib.rc_context():
        matplotlib.rcdefaults()  # the user's own settings count for nothing
        matplotlib.rcParams.update({**STYLE, "svg.hashsalt": name})
        buffer = io.StringIO()
        # ``savefig`` would draw every figure twice, the first time in order to lay it out, which drawing does as well.
        drawing = draw()
        for axes in drawing.axes:
            _label_plainly(axes.xaxis)
            _label_plainly(axes.yaxis)
        FigureCanvasSVG(drawing).print_svg(buffer, metadata={"Date": None})
    svg = UNWANTED.sub("", buffer.getvalue())
    svg = IDENTIFIER.sub(rf"\g<1>{name}-", svg)
    for colour, replacement in PAGE_COLOURS.items():
        svg = svg.replace(colour, replacement)
    opening = Markup('<svg viewBox="{}" role="img" aria-label="{}">')
    return Markup(OPENING.sub(lambda found: opening.format(found[1], alt), svg, count=1).strip())
