"""Figures: one look for all of them, drawn as SVG that takes its colours from the page."""

import io
import math
import re
import textwrap
from collections.abc import Callable, Mapping, Sequence
from contextvars import ContextVar, copy_context
from functools import cache
from typing import Any

from cycler import cycler
from markupsafe import Markup, escape
from matplotlib import rcParams, style, ticker
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.backends.backend_mixed import MixedModeRenderer
from matplotlib.backends.backend_svg import FigureCanvasSVG, RendererSVG
from matplotlib.figure import Figure as Drawing
from matplotlib.font_manager import FontProperties, findfont, get_font
from matplotlib.text import Text
from matplotlib.textpath import TextToPath

from measured_report.parts.macros import Picture
from measured_report.values.format import (
    format_number,
    format_power,
    format_short,
    number_pattern,
)
from measured_report.values.quantities import Quantity

INK = "#1b1f24"
FAINT = "#c9ced4"
MAP_INK = "#101418"  # for what is drawn on a map: a map keeps its colours on a dark page, and so does this
# Colours that are told apart by colour-blind readers; the stylesheet has a lighter set for dark pages.
SERIES = ("#0b62a8", "#b8480c", "#0a7a5c", "#8b3d91", "#8a6400", "#4a5560")
PAGE_COLOURS = {
    colour: f"var(--series-{number})" for number, colour in enumerate(SERIES, start=1)
}
PAGE_COLOURS |= {INK: "currentColor", FAINT: "var(--faint)"}
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
    "axes.formatter.limits": (
        -99,
        99,
    ),  # a factor aside of an axis is read as a number of its own
    "axes.titley": 1.0,  # otherwise all that stands above the axes is laid out to find the title's place
    "axes.titlelocation": "left",
    "grid.color": FAINT,
    "grid.linewidth": 0.6,
    "lines.linewidth": 1.6,
    "lines.markersize": 4.5,
    # Line and mark differ as well as colour, so that a series is found without seeing colours.
    "axes.prop_cycle": cycler(color=SERIES)
    + cycler(linestyle=("-", "--", "-.", ":", (0, (6, 1, 1, 1, 1, 1)), (0, (8, 3))))
    + cycler(marker=("o", "s", "^", "D", "v", "P"))
    + cycler(markevery=(0.1,) * len(SERIES)),
}

NARROW_WIDTH = 3.6  # width of a figure on a narrow screen [in]; at 390 px a point of it is more than 1.3 px
LEAST_SIZE = 7.0  # size of the smallest text of a narrow figure [pt], which is 9 px on a screen of 390 px
LONGEST_NAME, LONGEST_LINE = (
    18,
    36,
)  # characters of a name beside a narrow figure, and along it, before it is folded
PIECE = re.compile(
    r'(?P<tick><g id="[xy]tick_\d+">)|(?P<open><g\b(?: id="(?P<id>[a-z]+)[^"]*")?[^>]*(?<!/)>)|(?P<close></g>)'
    r'|(?P<mark><use\b[^>]* x="(?P<x>[^"]*)" y="(?P<y>[^"]*)"[^>]*)/>|<text\b[^>]*>[^<]*</text>'
)  # pieces that tell where a drawn text or mark stands: a tick's group, another group, the end of one, and either
REFERENCE = re.compile(r'(?:xlink:href="#|url\(#)([^")]+)')
PLACES = re.compile(r'(?<= )(?:d|x|y)="[^"]*"')
DECIMALS = re.compile(
    r"(\.\d\d)\d+"
)  # a hundredth of a point is enough for anything that is drawn
UNWANTED = re.compile(
    r'(?s)<metadata>.*?</metadata>|<style.*?</style>|^.*?(?=<svg )|<!--.*?-->| font-family: [^;"]*;'
)
OPENING = re.compile(r'<svg [^>]*?viewBox="([^"]*)"[^>]*>')


_kind = ContextVar("kind", default="broad")  # of the screen that is drawn for
_sources: ContextVar[dict[str, list[str]]] = ContextVar("sources")
"""Where each number is from that a drawing has, in order, by how it is written."""


class LogLabels(ticker.LogFormatter):
    """Label a logarithmic axis in text; Matplotlib's own labels are formulas, which take long to typeset."""

    def __call__(self, value: float, position: int | None = None) -> str:
        if not super().__call__(value, position):
            return ""
        low, high = self.axis.get_view_interval()
        exponent = round(math.log10(value))
        if (low < 1e-4 or high > 1e5) and math.isclose(value, 10.0**exponent):
            return format_power(exponent)
        return format_number(value, noise=0.0)


def plain_labels(*, digits: int = 6) -> ticker.FuncFormatter:
    """Format labels as plain numbers, without zeros at their ends."""
    return ticker.FuncFormatter(lambda value, _: f"{value:.{digits}g}")


def write(quantity: Quantity, *, is_short: bool = False) -> str:
    """Write a number, if ``is_short`` in four characters, for the figure being drawn, which says where it is from."""
    text = format_short(quantity.number) if is_short else quantity.written
    if quantity.source and (sources := _sources.get(None)) is not None:
        sources.setdefault(text, []).append(quantity.source)
    return text


def tick_125(axis: Axis) -> None:
    """Label a logarithmic axis at 1, 2 and 5 of each decade, so that less than a decade has labels too."""
    axis.set_major_locator(ticker.LogLocator(subs=(1.0, 2.0, 5.0), numticks=12))
    axis.set_major_formatter(plain_labels())
    axis.set_minor_locator(ticker.NullLocator())


def tick_at(axis: Axis, places: Sequence[float], *, digits: int = 6) -> None:
    axis.set_major_locator(ticker.FixedLocator(places))
    axis.set_minor_locator(ticker.NullLocator())
    axis.set_major_formatter(plain_labels(digits=digits))


def new_figure(
    width: float = 7.2, height: float = 3.4, **subplots: Any
) -> tuple[Drawing, Any]:
    """Make a figure of ``width`` × ``height`` inches and its axes; for a narrow screen panels stand on each other."""
    if not is_narrow():
        drawing = _Drawing(figsize=(width, height))
        return drawing, drawing.subplots(**subplots)
    rows, columns = subplots.get("nrows", 1), subplots.get("ncols", 1)
    drawing = _Drawing(figsize=(min(width, NARROW_WIDTH), height * columns))
    axes = drawing.subplots(
        **{**subplots, "nrows": rows * columns, "ncols": 1, "squeeze": False}
    )
    for panel in axes[:, 0]:
        panel.tick_params(labelbottom=True)
    grid = axes.reshape(rows, columns)
    return drawing, grid.squeeze()[()] if subplots.get("squeeze", True) else grid


def say_value(axes: Axes, x: float, y: float, text: str, *, gap: float = 6.0) -> None:
    """Write the value of a mark or a bar, ``gap`` points to the right of it."""
    axes.annotate(
        text,
        (x, y),
        xytext=(gap, 0),
        textcoords="offset points",
        fontsize=8.5,
        va="center",
        zorder=6,
    )


def is_narrow() -> bool:
    return _kind.get() == "narrow"


class _Drawing(Drawing):
    """Keep legends of a figure no wider than a narrow screen."""

    def legend(
        self, *args: Any, loc: str = "best", ncols: int = 1, **keywords: Any
    ) -> Any:
        if not is_narrow():
            return super().legend(*args, loc=loc, ncols=ncols, **keywords)
        if loc.startswith("outside"):
            loc = "outside upper left" if "upper" in loc else "outside lower left"
        keywords |= {"loc": loc, "fontsize": 8, "columnspacing": 1.0}
        legend = super().legend(*args, ncols=min(ncols, 2), **keywords)
        if ncols > 1 and any(
            len(text.get_text()) > LONGEST_NAME for text in legend.get_texts()
        ):
            legend.remove()
            legend = super().legend(*args, ncols=1, **keywords)
        return legend


def _fit_narrow(drawing: Drawing) -> None:
    """Make texts large enough to be read and short enough to leave room, and no more ticks than help."""
    for axes in drawing.axes:
        # To ask for labels lays the axis out, which takes long; those of numbers are never long.
        is_named = not isinstance(
            axes.yaxis.get_major_formatter(), ticker.ScalarFormatter
        )
        names = (
            [label.get_text() for label in axes.get_yticklabels()] if is_named else []
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
    """Fold a text for a narrow figure: its own breaks stay, and a number stays with the word before it."""
    unbroken = re.sub(r" (?=\d)", "\u00a0", text)
    return "\n".join(
        textwrap.fill(line, longest) for line in unbroken.split("\n")
    ).replace("\u00a0", " ")


def draw_svgs(draw: Callable[[], Drawing], *, name: str) -> list[Picture]:
    """Draw the figure for broad and for narrow screens in SVG whose ids begin with ``name``: always the same bytes."""
    return [
        copy_context().run(_picture, draw, kind, name) for kind in ("broad", "narrow")
    ]


def _picture(draw: Callable[[], Drawing], kind: str, name: str) -> Picture:
    _kind.set(kind)
    _sources.set({})
    # The user's own style counts for nothing.
    with style.context(["default", {**STYLE, "svg.hashsalt": name}]):
        drawing = _trimmed(draw())
        if is_narrow():
            _fit_narrow(drawing)
            name = f"narrow-{name}"
        return _svg(drawing, name)


class _Vectors(RendererSVG):
    """Measure a text and a font once for all figures: every step of a layout asks for them anew."""

    get_text_width_height_descent = staticmethod(
        cache(TextToPath().get_text_width_height_descent)
    )

    @staticmethod
    @cache
    def _get_font_height_metrics(font: FontProperties) -> Sequence[float | None]:
        table = get_font(findfont(font)).get_sfnt_table
        if not (metrics := table("OS/2")):
            return None, None, None  # Matplotlib then finds them
        scale = font.get_size_in_points() / table("head")["unitsPerEm"]
        return (
            scale * metrics["sTypoAscender"],
            -scale * metrics["sTypoDescender"],
            scale * metrics["sTypoLineGap"],
        )


def _svg(drawing: Drawing, name: str) -> Picture:
    buffer = io.StringIO()
    drawing.dpi = 72  # of the file, whose unit is the point; what is drawn as an image has that of Matplotlib
    inches, dpi = drawing.get_size_inches(), rcParams["figure.dpi"]
    vectors = _Vectors(*72 * inches, buffer, image_dpi=dpi, metadata={"Date": None})
    renderer = MixedModeRenderer(drawing, *inches, dpi, vectors)
    # ``savefig`` would draw every figure twice, the first time in order to lay it out, which drawing does as well.
    setattr(FigureCanvasSVG(drawing), "get_renderer", lambda: renderer)  # noqa: B010, else a layout has one of its own
    drawing.draw(renderer)
    renderer.finalize()
    svg = _linked(UNWANTED.sub("", buffer.getvalue()), drawing)
    used = set(
        REFERENCE.findall(svg)
    )  # names that nothing refers to, and digits that nobody sees, are left out
    svg = re.sub(
        r' id="([^"]+)"', lambda match: match[0] if match[1] in used else "", svg
    )
    svg = re.sub(
        r"\s*\n\s*", "\n", PLACES.sub(lambda match: DECIMALS.sub(r"\1", match[0]), svg)
    )
    svg = re.sub(r'( id="|xlink:href="#|url\(#)', rf"\g<1>{name}-", svg)
    for colour, replacement in PAGE_COLOURS.items():
        svg = svg.replace(colour, replacement)
    _, view, content = OPENING.split(svg, maxsplit=1)
    return Picture(_kind.get(), view, Markup(content.rstrip().removesuffix("</svg>")))


def _trimmed(drawing: Drawing) -> Drawing:
    """Leave out what takes long and nobody sees: ticks of a spine are placed for it anew, a label without text too."""
    for axes in drawing.axes:
        for spine in axes.spines.values():
            spine.set_in_layout(False)  # its ticks reach less far than their labels
        for axis in (axes.xaxis, axes.yaxis):
            if not axis.get_label_text():
                axis.set_label_coords(0.0, 0.0)
            low, high = axis.get_view_interval()
            if (
                axis.get_scale() == "log" and high > 10 * low
            ):  # of less than a decade they have the labels
                axis.set_minor_locator(ticker.NullLocator())
            if isinstance(axis.get_major_formatter(), ticker.LogFormatterMathtext):
                axis.set_major_formatter(LogLabels())
            if isinstance(
                minor := axis.get_minor_formatter(), ticker.LogFormatterMathtext
            ):
                axis.set_minor_formatter(LogLabels(labelOnlyBase=minor.labelOnlyBase))
    return drawing


def _linked(svg: str, drawing: Drawing) -> str:
    """Let texts of a drawing say where their numbers are from, and marks what they show."""
    # The longest first: a shorter number may be a part of it.
    sources = dict(sorted(_sources.get().items(), key=lambda item: -len(item[0])))
    patterns = {text: number_pattern(escape(text)) for text in sources}
    scales = cache(_scales)
    drawn = iter(sorted(drawing.axes, key=Axes.get_zorder))
    axes = drawing.axes[0]
    groups: list[str] = []  # those that are open, the innermost last

    def piece(match: re.Match[str]) -> str:
        nonlocal axes
        if match["close"]:
            groups.pop()
        elif match["tick"]:
            groups.append("tick")
            return '<g class="tick">'
        elif match["open"]:
            groups.append(match["id"] or "")
            if match["id"] == "axes":
                axes = next(drawn)
        elif match["mark"]:
            is_datum = "axes" in groups and not {"tick", "legend"} & {*groups}
            if is_datum and axes.axison:
                title = _title(axes, scales(axes), match)
                return f"{match['mark']}><title>{title}</title></use>"
        else:
            return text(match[0])
        return match[0]

    def text(element: str) -> str:
        opening, _, words = element.removesuffix("</text>").partition(">")
        if "tick" in groups and not re.search(r"[^\W\d_]", words):
            return element  # a number of an axis
        pointers = []
        remainder = words
        for number, places in sources.items():
            remainder, count = patterns[number].subn("", remainder)
            # Each is used up, unless it is the last.
            for _ in range(count):
                pointers.append(places.pop(0) if len(places) > 1 else places[0])
        if not pointers:
            return element
        source = escape(" ".join(pointers))
        return f'<text data-src="{source}"{opening[5:]}>{words}</text>'

    return PIECE.sub(piece, svg)


Scale = tuple[
    Mapping[float, str], str, str
]  # the names of an axis's ticks, and what its numbers are of, with the unit


def _scales(axes: Axes) -> list[Scale]:
    """Return what each axis is of; where it does not say, what another is."""
    scales: list[Scale] = []
    for axis in (axes.xaxis, axes.yaxis):
        labels = (tick.get_text() for tick in axis.get_majorticklabels())
        names = dict(zip(axis.get_majorticklocs(), labels, strict=False))
        titles = (
            getattr(panel, f"{axis.axis_name}axis").get_label_text()
            for panel in (axes, *axes.figure.axes)
        )
        above = getattr(axes.figure, f"get_sup{axis.axis_name}label")()
        called = next(filter(None, titles), above).removesuffix("]").partition("[")
        is_named = all(any(map(str.isalpha, name)) for name in names.values())
        scales.append((names if is_named else {}, called[0], called[2]))
    return scales


def _title(axes: Axes, scales: Sequence[Scale], mark: re.Match[str]) -> Markup:
    """Say where a mark stands: by the nearest of the names of an axis, or else by the number there."""
    point, readings = (
        (float(mark["x"]), 72 * axes.figure.get_figheight() - float(mark["y"])),
        [],
    )
    for value, (names, label, unit) in zip(
        axes.transData.inverted().transform(point), scales, strict=True
    ):
        nearest = min(names, key=lambda tick: abs(tick - value), default=None)
        readings.append(
            f"{label} {value:.4g} {unit}".strip() if nearest is None else names[nearest]
        )
    return escape(" ".join(", ".join(readings).split()))
