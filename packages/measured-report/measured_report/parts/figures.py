"""Draw figures in one style, as SVG files that take their colours from the page."""

import io
import math
import re
import textwrap
from collections.abc import Callable
from contextvars import ContextVar, copy_context
from typing import Any

from cycler import cycler
from matplotlib import style, ticker
from matplotlib.axis import Axis
from matplotlib.backends.backend_svg import FigureCanvasSVG
from matplotlib.figure import Figure as Drawing
from matplotlib.text import Text

from measured_report.files.errors import ReportError
from measured_report.values.format import format_number, format_power

INK = "#1b1f24"
FAINT = "#c9ced4"
# Colour-blind readers can distinguish these colours. The stylesheet has a lighter set
# for dark pages.
SERIES = ("#0b62a8", "#b8480c", "#0a7a5c", "#8b3d91", "#8a6400", "#4a5560")
PAGE_COLOURS = {
    colour: f"var(--series-{number})" for number, colour in enumerate(SERIES, start=1)
}
PAGE_COLOURS |= {INK: "currentColor", FAINT: "var(--faint)"}
SPARSE = 0.1
"""The distance between the markers of a long line, as a share of the figure."""
LONG_LINE = 40  # chosen: the markers of a line with more points would overlap
STYLE: dict[str, Any] = {
    **dict.fromkeys(
        ("svg.fonttype", "figure.facecolor", "axes.facecolor", "savefig.facecolor"),
        "none",
    ),
    **dict.fromkeys(
        ("axes.edgecolor", "axes.labelcolor", "axes.titlecolor", "text.color"), INK
    ),
    **dict.fromkeys(("xtick.color", "ytick.color", "hatch.color"), INK),
    **dict.fromkeys(
        ("text.parse_math", "axes.formatter.useoffset", "legend.frameon"), False
    ),
    **dict.fromkeys(("axes.spines.top", "axes.spines.right"), False),
    **dict.fromkeys(
        ("axes.grid", "axes.axisbelow", "figure.constrained_layout.use"), True
    ),
    **dict.fromkeys(("axes.titlesize", "font.size"), 10),
    # Never put a factor such as 1e6 at the end of an axis: readers take it for a
    # number.
    "axes.formatter.limits": (-99, 99),
    # Without a fixed place, Matplotlib lays out everything above the axes to find one.
    "axes.titley": 1.0,
    "axes.titlelocation": "left",
    "grid.color": FAINT,
    "grid.linewidth": 0.6,
    "lines.linewidth": 1.6,
    "lines.markersize": 4.5,
    # Line style and marker differ as well as the colour, for readers who cannot see it.
    "axes.prop_cycle": cycler(color=SERIES)
    + cycler(linestyle=("-", "--", "-.", ":", (0, (6, 1, 1, 1, 1, 1)), (0, (8, 3))))
    + cycler(marker=("o", "s", "^", "D", "v", "P"))
    + cycler(markevery=(SPARSE,) * len(SERIES)),
}

# The width of a figure on a narrow screen [in]. If the screen is 390 px wide, a point
# is more than 1.3 px.
NARROW_WIDTH = 3.6
# The smallest text of a narrow figure [pt]; it is 9 px on a screen of 390 px.
LEAST_SIZE = 7.0
LONGEST_NAME = 18  # a longer name beside a narrow figure is folded [characters]
LONGEST_LINE = 36  # a longer text along a narrow figure is folded [characters]
COORDINATES = re.compile(r'(?<= )(?:d|x|y)="[^"]*"')
DECIMALS = re.compile(r"(\.\d\d)\d+")
"""Matches the decimals after the second one, because a hundredth of a point is
invisible.
"""
UNWANTED = re.compile(
    r"""
    <metadata>.*?</metadata>
    | <style.*?</style>
    | ^.*?(?=<svg\ )  # the header
    | <!--.*?-->
    | \ font-family:\ [^;"]*;  # the page determines the font
    """,
    re.VERBOSE | re.DOTALL,
)

_kind = ContextVar("kind", default="broad")  # `broad` or `narrow`: the kind of screen


def new_figure(
    width: float = 7.2, height: float = 3.4, **subplots: Any
) -> tuple[Drawing, Any]:
    """Return a figure of ``width`` × ``height`` inches and its axes.

    For a narrow screen, all panels are in one column.
    """
    if not is_narrow():
        drawing = Drawing(figsize=(width, height))
        return drawing, drawing.subplots(**subplots)
    rows, columns = subplots.get("nrows", 1), subplots.get("ncols", 1)
    drawing = Drawing(figsize=(min(width, NARROW_WIDTH), height * columns))
    axes = drawing.subplots(
        **{**subplots, "nrows": rows * columns, "ncols": 1, "squeeze": False}
    )
    for panel in axes[:, 0]:
        panel.tick_params(labelbottom=True)
    grid = axes.reshape(rows, columns)
    return drawing, grid.squeeze()[()] if subplots.get("squeeze", True) else grid


def is_narrow() -> bool:
    """Return whether the figure is drawn for a narrow screen."""
    return _kind.get() == "narrow"


def _fit_narrow(drawing: Drawing) -> None:
    """Adapt a figure to a narrow screen: enlarge and fold texts, and reduce ticks."""
    for legend in [*drawing.legends]:
        names = [text.get_text() for text in legend.get_texts()]
        is_long = max(map(len, names), default=0) > LONGEST_NAME
        legend.remove()
        drawing.legend(
            legend.legend_handles,
            names,
            loc="outside upper left",
            ncols=1 if is_long else min(legend._ncols, 2),
            fontsize=8,
            columnspacing=1.0,
        )
    for axes in drawing.axes:
        # get_yticklabels lays out the axis, which is slow. Numbers are always short.
        has_names = not isinstance(
            axes.yaxis.get_major_formatter(), ticker.ScalarFormatter
        )
        names = (
            [label.get_text() for label in axes.get_yticklabels()] if has_names else []
        )
        if is_long := any(len(name) > LONGEST_NAME for name in names):
            axes.set_yticks(
                axes.get_yticks(), [fold(name, LONGEST_NAME) for name in names]
            )
        axes.tick_params(labelsize=LEAST_SIZE if is_long else 8)
        axes.set_title(fold(axes.get_title("left")), fontsize=9)
        if isinstance(axes.xaxis.get_major_locator(), ticker.AutoLocator):
            axes.xaxis.set_major_locator(
                ticker.MaxNLocator(nbins=5, steps=(1, 2, 2.5, 5, 10))
            )
        for axis in (axes.xaxis, axes.yaxis):
            axis.label.set(text=fold(axis.label.get_text()), fontsize=9)
    if drawing.get_supxlabel():
        drawing.supxlabel(fold(drawing.get_supxlabel()), fontsize=9)
    for text in drawing.findobj(Text):
        text.set_fontsize(max(text.get_fontsize(), LEAST_SIZE))


def fold(text: str, longest: int = LONGEST_LINE) -> str:
    """Return a text with line breaks for a narrow figure.

    Line breaks of the text are kept. A number stays on the line of the word before it.
    """
    unbroken = re.sub(r" (?=\d)", "\u00a0", text)
    lines = (textwrap.fill(line, longest) for line in unbroken.split("\n"))
    return "\n".join(lines).replace("\u00a0", " ")


def draw_svgs(draw: Callable[[], Drawing], *, name: str) -> list[str]:
    """Return a figure as SVG for broad and for narrow screens.

    ``name`` determines the ids in the SVG, so that the same figure has the same bytes.
    """
    return [copy_context().run(_svg, draw, kind, name) for kind in ("broad", "narrow")]


def _svg(draw: Callable[[], Drawing], kind: str, name: str) -> str:
    _kind.set(kind)
    # "default" removes the settings of the user's matplotlibrc.
    with style.context(["default", {**STYLE, "svg.hashsalt": name}]):
        drawing = draw()
        if not any(axes.has_data() for axes in getattr(drawing, "axes", ())):
            raise ReportError("its function does not return a drawing with data")
        _refuse_hidden(drawing)
        for axes in drawing.axes:
            for line in axes.lines:
                is_long = len(line.get_xdata()) > LONG_LINE
                if line.get_markevery() == SPARSE and not is_long:
                    line.set_markevery(None)
            for axis in (axes.xaxis, axes.yaxis):
                if isinstance(axis.get_major_formatter(), ticker.LogFormatterMathtext):
                    _label_decades(axis)
        if is_narrow():
            _fit_narrow(drawing)
        buffer = io.StringIO()
        # ``savefig`` would draw each figure twice, the first time for its layout.
        FigureCanvasSVG(drawing).print_svg(buffer, metadata={"Date": None})
    svg = UNWANTED.sub("", buffer.getvalue())
    svg = COORDINATES.sub(lambda match: DECIMALS.sub(r"\1", match[0]), svg)
    for colour, replacement in PAGE_COLOURS.items():
        svg = svg.replace(colour, replacement)
    return re.sub(r' (?:width|height)="[\d.]+pt"', "", svg, count=2)


def _refuse_hidden(drawing: Drawing) -> None:
    """Raise ReportError if axes do not write any label of their lines, or if a line with
    a label is above or below its axes.

    Parts of a line beside its axes can be left out on purpose.
    """
    written = {text.get_text() for text in drawing.findobj(Text)}
    for axes in drawing.axes:
        _, labels = axes.get_legend_handles_labels()
        if labels and written.isdisjoint(labels):
            raise ReportError(f"the label {labels[0]!r} is not shown: add a legend")
        view = axes.viewLim
        for line in axes.lines:
            is_named = line.get_label() in labels
            if (
                is_named
                and line.get_transform() == axes.transData
                and any(
                    view.containsx(x) and math.isfinite(y) and not view.containsy(y)
                    for x, y in line.get_xydata()
                )
            ):
                raise ReportError(
                    f"the line {line.get_label()!r} leaves its axes: widen them, or do "
                    "not draw this part"
                )


def _label_decades(axis: Axis) -> None:
    """Label a logarithmic axis with text.

    Matplotlib's own labels are formulas, and typesetting them is slow.
    """
    low, high = axis.get_view_interval()
    has_powers = low < 1e-4 or high > 1e5

    def label(value: float, position: int | None) -> str:
        if has_powers:
            return format_power(round(math.log10(value)))
        return format_number(value, noise=0.0)

    axis.set_major_formatter(label)
    if high > 10 * low:  # a range below one decade needs the minor labels
        axis.set_minor_locator(ticker.NullLocator())
    else:
        axis.set_minor_formatter(label)
