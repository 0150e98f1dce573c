"""Figures: one look for all of them, drawn as SVG that takes its colours from the page."""

import io
import re
from collections.abc import Callable

import matplotlib
from cycler import cycler
from markupsafe import Markup
from matplotlib.axes import Axes
from matplotlib.figure import Figure as Drawing

INK = "#1b1f24"
FAINT = "#c9ced4"
SERIES = ("#0b62a8", "#b8480c", "#0a7a5c", "#8b3d91", "#8a6400", "#4a5560")
"""Colours that are told apart by colour-blind readers; the stylesheet has a lighter set for dark pages."""

PAGE_COLOURS = {INK: "currentColor", FAINT: "var(--faint)"} | {
    colour: f"var(--series-{number})" for number, colour in enumerate(SERIES, start=1)
}

STYLE = {
    "svg.fonttype": "none",
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


def new_figure(width: float = 7.2, height: float = 3.4, **subplots) -> tuple[Drawing, Axes]:
    """A figure of ``width`` × ``height`` inches with the axes that ``Figure.subplots`` makes."""
    drawing = Drawing(figsize=(width, height))
    return drawing, drawing.subplots(**subplots)


def draw_svg(draw: Callable[[], Drawing], *, name: str, alt: str) -> Markup:
    """The figure as an SVG element: its ids begin with ``name``, and the same data give the same bytes."""
    with matplotlib.rc_context({**STYLE, "svg.hashsalt": name}):
        buffer = io.StringIO()
        draw().savefig(buffer, format="svg", metadata={"Date": None})
    svg = UNWANTED.sub("", buffer.getvalue())
    svg = IDENTIFIER.sub(rf"\g<1>{name}-", svg)
    for colour, replacement in PAGE_COLOURS.items():
        svg = svg.replace(colour, replacement)
    opening = Markup('<svg viewBox="{}" role="img" aria-label="{}">')
    return Markup(OPENING.sub(lambda found: opening.format(found[1], alt), svg, count=1).strip())
