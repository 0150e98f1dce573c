"""Make the tables and the figure that compare releases side by side."""

from dataclasses import dataclass

from markupsafe import Markup

from measured_report.changes.query import Query, points
from measured_report.findings.chapters import Releases
from measured_report.values.format import unit_label
from measured_report.values.results import Results, Row
from report.shared import Figure, Quantity, Table, settings_of, table_of

SHIPPED = "as-shipped"
SWITCHED = "as-shipped-kf-off"
TAKEN = "as-shipped-friction-timeconst-off"
GIVEN = "as-shipped-friction-timeconst-on"
"""Cases that are as shipped, or whose friction rows have the time constant switched off,
removed or added.
"""
SLIP = Query(f"upgrade.{SHIPPED}.slip_mm")
MUJOCO_CONTACTS = Query("upgrade.as-shipped-mujoco-contacts.slip_mm")
MUJOCO_C = Query("reproduction.as-shipped-mujoco-c.slip_mm")
PYRAMID = Query("solver.cone-pyramidal.slip_mm")


@dataclass(frozen=True)
class CpuQuery(Query):
    """Looks up the run of a case on the CPU, with the least work if there are several."""

    def row_of(self, results: Results) -> Row | None:
        terms = results.columns.settings.cost_terms
        rows = [
            row
            for row in results.rows
            if row.case == self.case and row.plain.get("device") == "cpu"
        ]
        return min(
            rows,
            key=lambda row: [row.plain.get(term) or 0 for term in terms],
            default=None,
        )


SPEEDS = {
    "a frame with shipped pads [ms]": Query(f"speed.{SHIPPED}.frame_ms"),
    "a frame with stiff pads, without all unneeded parts [ms]": Query(
        "speed.fixed.frame_ms"
    ),
    "a frame of the largest batch [ms]": Query("scaling.worlds-16384.frame_ms"),
    "on the CPU, a frame exactly as shipped [ms]": CpuQuery(
        "leave_out.untrimmed.frame_ms"
    ),
    "on the CPU, a frame without the unneeded parts [ms]": CpuQuery(
        "leave_out.without-all.frame_ms"
    ),
}
TRIED = {
    label: Query(f"upgrade.{case}.slip_mm")
    for case, label in {
        SHIPPED: "shipped pads",
        TAKEN: "time constant of the friction rows removed",
        GIVEN: "time constant of two substeps added",
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
DRAWN = {
    SLIP: "shipped pads",
    MUJOCO_CONTACTS: "MuJoCo's contacts",
    Query("upgrade.hold.slip_mm"): "arm held still",
    Query("upgrade.stiff-pads.slip_mm"): "stiff pads",
}


def side_by_side(heading: str, releases: Releases, queries: dict[str, Query]) -> Table:
    settings = settings_of(releases)
    columns = {
        settings.short_name(release): [
            query.cell(chapters, release).bare for query in queries.values()
        ]
        for release, chapters in releases.items()
    }
    return table_of(heading, queries, columns)


def option_table(releases: Releases) -> Table:
    """Make a table of the settings that differ between the releases."""
    report_settings = settings_of(releases)
    kinds = report_settings.changes.settings
    measured = {
        name: chapters for name, chapters in releases.items() if "upgrade" in chapters
    }
    settings: dict[str, dict[str, Quantity | str]] = {}
    for release, chapters in measured.items():
        for section in ("upgrade", "defaults"):
            rows = chapters[section].results.rows if section in chapters else ()
            for row in rows:
                if row.kind in kinds:
                    name = f"{kinds[row.kind]} {row.name}"
                    settings.setdefault(name, {})[release] = row["value"]

    def differs(values: dict[str, Quantity | str]) -> bool:
        cells = (values.get(release) for release in measured)
        return len({getattr(cell, "value", cell) for cell in cells}) > 1

    differing = {name: row for name, row in settings.items() if differs(row)}
    differing = differing or {"none": dict.fromkeys(measured, "")}
    columns = {
        report_settings.short_name(release): [
            Markup("{}").format(values.get(release, "–"))
            for values in differing.values()
        ]
        for release in measured
    }
    return table_of("", differing, columns)


def slip_figure(releases: Releases, steps: list[tuple[str, str]]) -> Figure:
    lines = {
        query: [query.cell(chapters, name) for name, chapters in releases.items()]
        for query in DRAWN
    }
    names = map(settings_of(releases).name_of, releases)
    slips = zip(names, lines[SLIP], strict=True)
    cells = [cell for line in lines.values() for cell in line]
    numbers = {"slips": list(slips), "steps": steps}
    return Figure(lambda: _draw_slips(releases, lines), cells, numbers)


def _draw_slips(releases: Releases, lines: dict[Query, list[Quantity]]):
    # Imported here because Matplotlib is slow, and a comparison does not draw.
    from report.shared import drawing as shared
    from report.shared.drawing import INK, new_figure, tick_125

    drawing, axes = new_figure(7.2, 3.4)
    looks = (
        {"color": shared.SHIPPED, "linestyle": "-"},
        {"color": shared.SHIPPED, "linestyle": "--"},
        {"color": INK, "linestyle": "-"},
        {"color": shared.STIFF, "linestyle": "-"},
    )
    for (query, label), look in zip(DRAWN.items(), looks, strict=True):
        points = enumerate(cell.value for cell in lines[query])
        shared.mark_points(axes, points, marker="o", label=label, **look)
    axes.set_yscale("log")
    tick_125(axes.yaxis)
    axes.set_xticks(
        range(len(releases)), map(settings_of(releases).short_name, releases)
    )
    axes.set(
        xlim=(-0.3, len(releases) - 0.5), xlabel="Newton release", ylabel="slip [mm]"
    )
    drawing.legend(loc="outside upper left", ncols=2)
    return drawing


def number_table(releases: Releases) -> Table:
    """Make a table of the headlines that marks those that moved since the last release."""
    settings = settings_of(releases)
    names = []
    columns: dict[str, list[Markup]] = {name: [] for name in releases}
    for label, text in settings.changes.headlines.items():
        query = Query(text)
        history = points(releases, query)
        if not history:
            continue
        unit = query.cell(releases[history[0].release]).unit
        names.append(Markup("{} [{}]").format(label, unit_label(unit)))
        marks = {point.release: point.mark for point in history}
        for name, chapters in releases.items():
            number = query.cell(chapters, name).bare
            mark = marks.get(name)
            if mark:
                moved = Markup('{} <span class="moved {}">{}</span>')
                number = moved.format(number, mark, mark)
            columns[name].append(number)
    columns = {settings.short_name(name): cells for name, cells in columns.items()}
    return table_of("number", names, columns)
