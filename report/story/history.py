"""What the page of the history shows: the numbers that say most, over all editions."""

from collections.abc import Sequence

import pandas as pd
from markupsafe import Markup

from measured_report.changes.history import Point, points
from measured_report.pages.chapters import Releases
from measured_report.parts.section import Section, Table
from measured_report.values.format import unit_label
from measured_report.values.quantities import alike
from report.sections.upgrade.ends import released
from report.sections.upgrade.tables import HEADLINES

WIDTH, HEIGHT, EDGE = 60.0, 24.0, 4.0  # of the line beside a number's name, which keeps from the edges [px]
DRAWING = Markup('<svg viewBox="0 0 {0:g} {1:g}" style="width: {0:g}px; height: {1:g}px" aria-hidden="true">{2}</svg>')
BAND = Markup('<path d="M{}Z" style="fill: var(--series-2); fill-opacity: 0.35"/>')
LINE = Markup('<path d="M{}" style="fill: none; stroke: var(--series-1); stroke-width: 1.5"/>')
DOT = Markup('<circle cx="{:.1f}" cy="{:.1f}" r="2.5" style="fill: var(--series-1)"/>')


def derive(releases: Releases, shown: str) -> Section:
    """Derive the table of the page, which is the same for each release; ``releases`` are oldest first."""
    return Section(tables={"numbers": _numbers(released(releases, shown))})


def _numbers(releases: Releases) -> Table:
    labels: list[Markup] = []
    columns: dict[str, list[Markup]] = {name: [] for name in ("line", *releases)}
    for headline in HEADLINES:
        found = points(releases, headline)
        if found:
            labels.append(Markup("{} [{}]").format(headline.label, unit_label(headline.unit)))
            marks = {point.release: point.mark for point in found}
            numbers = alike([headline.cell(each, name) for name, each in releases.items()])
            cells = (_marked(number, marks.get(name, "")) for number, name in zip(numbers, releases, strict=True))
            line = [_line(found, list(releases)), *cells]
            for column, content in zip(columns.values(), line, strict=True):
                column.append(content)
    return Table(pd.DataFrame(columns, index=pd.Index(labels, name="number"), dtype=object))


def _marked(number: Markup, mark: str) -> Markup:
    return Markup('{} <span class="moved {}">{}</span>').format(number, mark, mark) if mark else number


def _line(found: Sequence[Point], releases: Sequence[str]) -> Markup:
    """Draw a number over the editions, from zero up, with the noise around it as a band."""
    across = (WIDTH - 2 * EDGE) / max(1, len(releases) - 1)
    lowest, highest = min(0.0, *(point.ends[0] for point in found)), max(0.0, *(point.ends[1] for point in found))

    def place(point: Point, value: float) -> tuple[float, float]:
        height = (value - lowest) / (highest - lowest or 1.0)
        return EDGE + across * releases.index(point.release), HEIGHT - EDGE - height * (HEIGHT - 2 * EDGE)

    band = [place(point, point.ends[1]) for point in found] + [place(point, point.ends[0]) for point in reversed(found)]
    line = [place(point, float(point.answer)) for point in found]
    dots = Markup("").join(DOT.format(*spot) for spot in line)
    return DRAWING.format(WIDTH, HEIGHT, BAND.format(_path(band)) + LINE.format(_path(line)) + dots)


def _path(places: Sequence[tuple[float, float]]) -> str:
    return "L".join(f"{x:.1f} {y:.1f}" for x, y in places)
