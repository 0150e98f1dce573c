"""The tables and the figure of what releases have side by side."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from measured_report.changes.moves import Move
from measured_report.changes.query import Query
from measured_report.files.config import config
from measured_report.pages.chapters import Releases
from measured_report.parts.figures import INK, is_narrow, new_figure, tick_125, write
from measured_report.parts.section import Figure, Table
from measured_report.values.format import unit_label
from measured_report.values.noise import EDGES
from measured_report.values.quantities import Quantity, alike
from measured_report.values.results import Results
from report.sections.upgrade.ends import machines_differ, with_mark
from report.shared import drawing as colours
from report.shared.arithmetic import table_of

SHIPPED, SWITCHED = "as-shipped", "as-shipped-kf-off"
TAKEN, GIVEN = "as-shipped-friction-timeconst-off", "as-shipped-friction-timeconst-on"
"""Cases of this section: the scene, and with the time constant of the friction rows taken away, given, switched off."""
HEADLINES = tuple(Query(value, label=label) for label, value in config().changes.headlines.items())
SLIP = Query(f"upgrade.{SHIPPED}.slip_mm")
MUJOCO_CONTACTS = Query("upgrade.as-shipped-mujoco-contacts.slip_mm")
MUJOCO_C, PYRAMID = Query("reproduction.as-shipped-mujoco-c.slip_mm"), Query("solver.cone-pyramidal.slip_mm")
SPEEDS = (
    Query(f"speed.{SHIPPED}.frame_ms", label="a frame with shipped pads"),
    Query("speed.fixed.frame_ms", label="a frame of the fixed scene"),
    Query("scaling.worlds-16384.frame_ms", label="a frame of the most worlds"),
    Query("leave_out.untrimmed.frame_ms", label="on the CPU, a frame exactly as shipped", device="cpu"),
    Query("leave_out.without-all.frame_ms", label="on the CPU, a frame without all that is unneeded", device="cpu"),
)
ONE_WORLD, ON_CPU = SPEEDS[0], SPEEDS[3]
FLOORS = {"mm": "slip_floor", "mm/s": "drift_floor"}
TRIED = {
    SHIPPED: "shipped pads",
    TAKEN: "friction rows' time constant taken out",
    GIVEN: "two substeps written into it",
    SWITCHED: "switched off: kf below zero",
    "as-shipped-kf-100": "kf 100",
    "as-shipped-kf-10": "kf 10",
    "as-shipped-kf-3": "kf 3",
    "as-shipped-mujoco-contacts": "contacts found by MuJoCo",
    "stiff-pads": "stiff pads",
    "stiff-pads-mujoco-contacts": "stiff pads, contacts found by MuJoCo",
    "hold": "arm held still",
}
SETTINGS = config().changes.settings
"""Kinds of rows that are no runs: each has a name and a value."""
SETTING_SECTIONS = ("upgrade", "defaults")
DRAWN = {
    SLIP: ("shipped pads", colours.SHIPPED, "-"),
    MUJOCO_CONTACTS: ("MuJoCo's contacts", colours.SHIPPED, "--"),
    Query("upgrade.hold.slip_mm"): ("arm held still", INK, "-"),
    Query("upgrade.stiff-pads.slip_mm"): ("stiff pads", colours.STIFF, "-"),
}
"""What is drawn: its name, colour and dashes."""


def _table(headlines: Sequence[Query], columns: Mapping[str, Sequence]) -> Table:
    labels = [f"{headline.label} [{unit_label(headline.unit)}]".removesuffix(" []") for headline in headlines]
    return table_of("", labels, columns)


def speed_table(results: Results, releases: Releases) -> Table:
    columns: dict[str, list[Markup]] = {f"Newton {release}": [] for release in releases}
    for headline in SPEEDS:
        differ = machines_differ(releases, headline.section)
        cells = [headline.cell(chapters, release) for release, chapters in releases.items()]
        for release, found, number in zip(releases, cells, alike(cells), strict=True):
            name = f"{headline.section}_{headline.case}_{headline.column}_{headline.device}_{headline.worlds}_{release}"
            edges = [edge(headline, end).cell(releases[release], release) for end in EDGES]
            spread = results.value(f"{name}_spread", "95th less 5th percentile", lambda a, b: b - a, *edges, unit="ms")
            is_told = None not in (cells[0].value, found.value, spread.value) and not differ
            mark = Move(headline.column, cells[0], found, spread.value).mark if is_told else ""
            columns[f"Newton {release}"].append(with_mark(number, mark))
    return _table(SPEEDS, columns)


def edge(headline: Query, end: str) -> Query:
    return replace(headline, text=headline.text + end)


def tried_table(releases: Releases) -> Table:
    cells = dict(_cells(releases, [Query(f"upgrade.{case}.slip_mm") for case in TRIED]))
    lines = [alike(line) for line in zip(*cells.values(), strict=True)]
    return table_of("slip [mm]", TRIED.values(), dict(zip(cells, zip(*lines, strict=True), strict=True)))


def _cells(releases: Releases, asked: Sequence[Query]) -> Iterator[tuple[str, list[Quantity]]]:
    for release, chapters in releases.items():
        yield f"Newton {release}", [each.cell(chapters, release) for each in asked]


def option_table(releases: Releases) -> Table:
    found: dict[str, dict[str, Quantity | str]] = {}
    measured = {release: sections for release, sections in releases.items() if "upgrade" in sections}
    for release, sections in measured.items():
        for row in (row for name in SETTING_SECTIONS if name in sections for row in sections[name].results.rows):
            if row.kind in SETTINGS:
                found.setdefault(f"{SETTINGS[row.kind]} {row.name}", {})[release] = row["value"]
    differing = {
        name: values
        for name, values in found.items()
        if len({getattr(values.get(release), "value", values.get(release)) for release in measured}) > 1
    } or {"none": dict.fromkeys(measured, "")}
    columns = {
        f"Newton {release}": [Markup("{}").format(values.get(release, "–")) for values in differing.values()]
        for release in measured
    }
    return table_of("", differing, columns)


def slip_figure(releases: Releases, steps: Sequence[tuple[str, str]]) -> Figure:
    slips = [(release, SLIP.cell(releases[release], release)) for release in releases]
    return Figure(
        draw=lambda: _draw_slips(releases),
        sources=[headline.cell(releases[release], release) for headline in DRAWN for release in releases],
        numbers={"slips": slips, "steps": steps},
    )


def _apart(values: Sequence[float], step: float = 1.3) -> list[float]:
    """Return the values, each at least ``step`` times as large as the one below it, so that they can be read."""
    heights: dict[int, float] = {}
    for index in sorted(range(len(values)), key=lambda index: values[index]):
        heights[index] = max(values[index], step * max(heights.values(), default=0.0))
    return [heights[index] for index in range(len(values))]


def _draw_slips(releases: Releases) -> Drawing:
    drawing, axes = new_figure(7.2, 3.4)
    ends: list[tuple[int, Quantity, str, str]] = []
    for headline, (name, colour, dashes) in DRAWN.items():
        cells = enumerate(headline.cell(chapters, release) for release, chapters in releases.items())
        if there := [(place, found) for place, found in cells if found.value is not None]:
            x, y = zip(*((place, found.value) for place, found in there), strict=True)
            axes.plot(x, y, color=colour, linestyle=dashes, marker="o", markevery=1)
            ends.append((*there[-1], name, colour))
    heights = _apart([found.value for _, found, *_ in ends])
    for (place, found, name, colour), height in zip(ends, heights, strict=True):
        text = f"{write(found)} {name}"
        axes.annotate(text, (place, height), xytext=(7, 0), textcoords="offset points", va="center", color=colour)
    axes.set_yscale("log")
    tick_125(axes.yaxis)
    axes.set_xticks(range(len(releases)), [name.replace("+", "\n+") for name in releases])
    axes.set(xlim=(-0.3, (1.5 if is_narrow() else 1.3) * len(releases)), xlabel="Newton release", ylabel="slip [mm]")
    return drawing
