"""The tables and the figure of what releases have side by side."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from measured_report.changes.query import Query
from measured_report.deriving.chapters import Releases
from measured_report.files.config import config
from measured_report.parts.figures import new_figure, say_value, write
from measured_report.parts.section import Figure, Table
from measured_report.values.format import unit_label
from measured_report.values.noise import EDGES
from measured_report.values.quantities import Quantity, Value
from measured_report.values.results import Results
from report.sections.upgrade.ends import change, machines_differ, marked
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
LIVE = {
    "timeconst_s": "time constant",
    "dampratio": "damping ratio",
    "friction_timeconst_s": "friction rows' own time constant",
    "friction_dampratio": "friction rows' own damping ratio",
    "friction_damping_per_s": "friction rows' damping, measured",
    "friction": "friction",
    "dmin": "dmin",
    "dmax": "dmax",
    "dim": "rows a contact",
    "peak_contact_count": "most contacts",
}
"""Columns that say what a live contact of the scene as shipped has."""
TRIED = {
    SHIPPED: "shipped pads",
    TAKEN: "friction rows' time constant taken out",
    GIVEN: "two substeps written into it",
    SWITCHED: "switched off: kf below zero",
    "as-shipped-kf-100": "kf 100",
    "as-shipped-kf-30": "kf 30",
    "as-shipped-kf-10": "kf 10",
    "as-shipped-kf-3": "kf 3",
    "as-shipped-mujoco-contacts": "contacts found by MuJoCo",
    "stiff-pads": "stiff pads",
    "stiff-pads-kf-off": "stiff pads, kf below zero",
    "stiff-pads-mujoco-contacts": "stiff pads, contacts found by MuJoCo",
    "hold": "arm held still",
    "hold-kf-off": "arm held still, kf below zero",
}
SETTINGS = {"option": "solver option", "default": "default", "sum": "sum of the engine's"}
"""Kinds of rows that are no runs: each has a name and a value."""
DRAWN = (HEADLINES[0], *HEADLINES[2:6])


def headline_table(results: Results, releases: Releases, floors: Mapping[str, Value]) -> Table:
    columns: dict[str, list[Markup]] = {f"Newton {release}": [] for release in releases}
    for headline in HEADLINES:
        cells = {release: headline.cell(releases[release], release) for release in releases}
        base = next((release for release in releases if cells[release].value is not None), None)
        for release, found in cells.items():
            is_moved = base not in (None, release)
            moved = change(results, f"{_name(headline)}_{release}", cells[base], found) if is_moved else None
            text = marked(moved, floors[headline.unit], headline.column, cells.get(base, found), found)
            columns[f"Newton {release}"].append(text)
    return _table(HEADLINES, columns | {"noise": [floors[headline.unit].bare for headline in HEADLINES]})


def _table(headlines: Sequence[Query], columns: Mapping[str, Sequence]) -> Table:
    """Make a table with a line for each headline, with its unit, which the cells of a line share."""
    labels = [f"{headline.label} [{unit_label(headline.unit)}]".removesuffix(" []") for headline in headlines]
    return table_of("", labels, columns)


def _name(headline: Query) -> str:
    place = f"_{headline.device}_{headline.worlds}" if headline.device else ""
    return f"{headline.section}_{headline.case}_{headline.column}{place}"


def speed_table(results: Results, releases: Releases) -> Table:
    columns: dict[str, list[Markup]] = {f"Newton {release}": [] for release in releases}
    for headline in SPEEDS:
        differ = machines_differ(releases, headline.section)
        cells = {release: headline.cell(chapters, release) for release, chapters in releases.items()}
        base = next(iter(cells.values()))
        for release, found in cells.items():
            name = f"{_name(headline)}_{release}"
            edges = [edge(headline, end).cell(releases[release], release) for end in EDGES]
            spread = results.value(f"{name}_spread", "95th less 5th percentile", lambda a, b: b - a, *edges, unit="ms")
            moved = None if differ else change(results, name, base, found)
            columns[f"Newton {release}"].append(marked(moved, spread, headline.column, base, found))
    return _table(SPEEDS, columns)


def edge(headline: Query, end: str) -> Query:
    return replace(headline, text=headline.text + end)


def live_table(releases: Releases) -> Table:
    asked = [Query(f"upgrade.{SHIPPED}.{column}", label=label) for column, label in LIVE.items()]
    return _table(asked, {release: [each.bare for each in cells] for release, cells in _cells(releases, asked)})


def tried_table(releases: Releases) -> Table:
    tried = [Query(f"upgrade.{case}.slip_mm") for case in TRIED]
    return table_of("", TRIED.values(), dict(_cells(releases, tried)))


def _cells(releases: Releases, asked: Sequence[Query]) -> Iterator[tuple[str, list[Quantity]]]:
    """Yield a column for each release."""
    for release, chapters in releases.items():
        yield f"Newton {release}", [each.cell(chapters, release) for each in asked]


def option_table(releases: Releases) -> Table:
    """Show solver options and defaults that the releases do not have alike."""
    found: dict[str, dict[str, Quantity | str]] = {}
    measured = {release: sections["upgrade"].results for release, sections in releases.items() if "upgrade" in sections}
    for release, results in measured.items():
        for row in results.rows:
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


def slip_figure(releases: Releases) -> Figure:
    return Figure(
        draw=lambda: _draw_slips(releases),
        sources=[headline.cell(releases[release], release) for headline in DRAWN for release in releases],
        numbers={"slips": [(release, SLIP.cell(releases[release], release)) for release in releases]},
    )


def _apart(values: Sequence[float], step: float = 1.22) -> list[float]:
    """The values, each at least ``step`` times as large as the one below it, so that they can be read."""
    heights: dict[int, float] = {}
    for index in sorted(range(len(values)), key=lambda index: values[index]):
        heights[index] = max(values[index], step * max(heights.values(), default=0.0))
    return [heights[index] for index in range(len(values))]


def _draw_slips(releases: Releases) -> Drawing:
    drawing, axes = new_figure(7.2, 3.4)
    ends: list[tuple[int, Quantity]] = []
    for headline in DRAWN:
        cells = enumerate(headline.cell(chapters, release) for release, chapters in releases.items())
        if there := [(place, found) for place, found in cells if found.value is not None]:
            x, y = zip(*((place, found.value) for place, found in there), strict=True)
            axes.plot(x, y, label=headline.label.removeprefix("slip "), markevery=1)
            ends.append(there[-1])
    heights = _apart([found.value for _, found in ends])
    for (place, found), height in zip(ends, heights, strict=True):
        say_value(axes, place, height, write(found))
    axes.set_yscale("log")
    axes.set_xticks(range(len(releases)), list(releases))
    axes.set(xlim=(-0.3, len(releases) - 0.6), xlabel="Newton release", ylabel="slip [mm]")
    drawing.legend(loc="outside upper left", ncols=3, fontsize=9)
    return drawing
