"""The tables and the figure of what releases have side by side."""

from collections.abc import Mapping, Sequence

from markupsafe import Markup

from measured_report.changes.query import Query, points
from measured_report.files.config import config
from measured_report.findings.chapters import Releases
from measured_report.parts.section import Figure, Table
from measured_report.values.format import unit_label
from measured_report.values.quantities import Quantity
from report.shared.tables import table_of

SHIPPED, SWITCHED = "as-shipped", "as-shipped-kf-off"
TAKEN, GIVEN = "as-shipped-friction-timeconst-off", "as-shipped-friction-timeconst-on"
"""Cases of this section: the scene, and with the time constant of the friction rows taken away, given, switched off."""
SLIP = Query(f"upgrade.{SHIPPED}.slip_mm")
MUJOCO_CONTACTS = Query("upgrade.as-shipped-mujoco-contacts.slip_mm")
MUJOCO_C, PYRAMID = Query("reproduction.as-shipped-mujoco-c.slip_mm"), Query("solver.cone-pyramidal.slip_mm")
SPEEDS = (
    Query(f"speed.{SHIPPED}.frame_ms", label="a frame with shipped pads [ms]"),
    Query("speed.fixed.frame_ms", label="a frame with stiff pads, all trimmed [ms]"),
    Query("scaling.worlds-16384.frame_ms", label="a frame of the most worlds [ms]"),
    Query("leave_out.untrimmed.frame_ms", label="on the CPU, a frame exactly as shipped [ms]", device="cpu"),
    Query("leave_out.without-all.frame_ms", label="on the CPU, a frame without what is unneeded [ms]", device="cpu"),
)
TRIED = {
    label: Query(f"upgrade.{case}.slip_mm")
    for case, label in {
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
    }.items()
}
SETTING_SECTIONS = ("upgrade", "defaults")
DRAWN = {
    SLIP: "shipped pads",
    MUJOCO_CONTACTS: "MuJoCo's contacts",
    Query("upgrade.hold.slip_mm"): "arm held still",
    Query("upgrade.stiff-pads.slip_mm"): "stiff pads",
}


def side_by_side(heading: str, releases: Releases, queries: Mapping[str, Query]) -> Table:
    lines = [[each.cell(chapters, release).bare for release, chapters in releases.items()] for each in queries.values()]
    columns = dict(zip(map(config().short_name, releases), zip(*lines, strict=True), strict=True))
    return table_of(heading, queries, columns)


def option_table(releases: Releases) -> Table:
    kinds = config().changes.settings  # of rows that are no runs: each has a name and a value
    settings: dict[str, dict[str, Quantity | str]] = {}
    measured = {release: sections for release, sections in releases.items() if "upgrade" in sections}
    for release, sections in measured.items():
        for row in (row for name in SETTING_SECTIONS if name in sections for row in sections[name].results.rows):
            if row.kind in kinds:
                settings.setdefault(f"{kinds[row.kind]} {row.name}", {})[release] = row["value"]
    differing = {
        name: values
        for name, values in settings.items()
        if len({getattr(values.get(release), "value", values.get(release)) for release in measured}) > 1
    } or {"none": dict.fromkeys(measured, "")}
    lines = {release: [values.get(release, "–") for values in differing.values()] for release in measured}
    columns = {config().short_name(release): list(map(Markup("{}").format, line)) for release, line in lines.items()}
    return table_of("", differing, columns)


def slip_figure(releases: Releases, steps: Sequence[tuple[str, str]]) -> Figure:
    slips = [(config().name_of(release), SLIP.cell(releases[release], release)) for release in releases]
    sources = [headline.cell(releases[release], release) for headline in DRAWN for release in releases]
    return Figure(lambda: _draw_slips(releases), sources, {"slips": slips, "steps": steps})


def _draw_slips(releases: Releases):
    # Matplotlib takes long to import, and whoever only compares draws nothing.
    from measured_report.parts.figures import INK, new_figure, tick_125
    from report.shared import drawing as shared

    drawing, axes = new_figure(7.2, 3.4)
    looks = ((shared.SHIPPED, "-"), (shared.SHIPPED, "--"), (INK, "-"), (shared.STIFF, "-"))
    for (headline, label), (colour, dashes) in zip(DRAWN.items(), looks, strict=True):
        points = [(place, headline.cell(each, name).value) for place, (name, each) in enumerate(releases.items())]
        shared.mark_points(axes, points, color=colour, linestyle=dashes, marker="o", label=label)
    axes.set_yscale("log")
    tick_125(axes.yaxis)
    axes.set_xticks(range(len(releases)), [config().short_name(name) for name in releases])
    axes.set(xlim=(-0.3, len(releases) - 0.5), xlabel="Newton release", ylabel="slip [mm]")
    drawing.legend(loc="outside upper left", ncols=2)
    return drawing


def number_table(releases: Releases) -> Table:
    """Show how the headlines moved from release to release, marked where one differs from the one before."""
    labels: list[Markup] = []
    columns: dict[str, list[Markup]] = {name: [] for name in releases}
    for headline in (Query(value, label=label) for label, value in config().changes.headlines.items()):
        if history := points(releases, headline):
            unit = headline.cell(releases[history[0].release]).unit
            labels.append(Markup("{} [{}]").format(headline.label, unit_label(unit)))
            marks = {point.release: point.mark for point in history}
            for name, column in columns.items():
                number, mark = headline.cell(releases[name], name).bare, marks.get(name, "")
                moved = Markup('{} <span class="moved {}">{}</span>').format(number, mark, mark)
                column.append(moved if mark else number)
    return table_of("number", labels, {config().short_name(name): column for name, column in columns.items()})
