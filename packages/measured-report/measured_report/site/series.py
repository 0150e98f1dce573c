"""Series: the page that shows each headline over all editions, and where it changed."""

from itertools import pairwise
from typing import Any

from markupsafe import Markup

from measured_report.changes.query import Point, Query, points, schema_of
from measured_report.files.config import Page
from measured_report.findings.chapters import Releases
from measured_report.pages.prose import Templates
from measured_report.parts.macros import macros
from measured_report.parts.prose import Prose
from measured_report.values.format import unit_label

PAGE = Page("history")
WIDTH, HEIGHT, EDGE = 288.0, 48.0, 4.0  # of a chart, in the units of its drawing


def series_page(releases: Releases, templates: Templates) -> Prose | None:
    """Return a page with each headline that two editions have, or more; None without."""
    columns = next(filter(None, map(schema_of, releases.values())), None)
    if columns is None or PAGE.name in {page.name for page in columns.settings.pages}:
        return None
    series = []
    for label, value in columns.settings.changes.headlines.items():
        query = Query(value, label=label)
        answered = points(releases, query)
        if len(answered) > 1:
            unit = unit_label(columns[query.column].unit)
            series.append(_series(f"{label} [{unit}]", query, answered, releases))
    if not series:
        return None
    box = Markup(f'viewBox="0 0 {WIDTH:g} {HEIGHT:g}"')
    table = macros().series(series, columns.settings, box, HEIGHT, list(releases))
    return templates.prose("series.md.j2", PAGE.name, {"table": table}, level=1)


def _series(
    name: str, query: Query, answered: list[Point], releases: Releases
) -> dict[str, Any]:
    """Return what the chart and the table have of a headline: its numbers, with their
    sources, the places of its dots, and the numbers on either side of each change."""
    numbers = {}
    reaches = []
    for point in answered:
        quantity = query.quantity(releases[point.release])
        numbers[point.release] = getattr(quantity, "bare", quantity)
        reaches.append((float(point.answer), point.noise or 0.0))
    low = min(number - noise for number, noise in reaches)
    high = max(number + noise for number, noise in reaches)
    scale = (HEIGHT - 2 * EDGE) / ((high - low) or 1.0)
    names = list(releases)  # one axis for all charts
    dots = []
    for point, (number, noise) in zip(answered, reaches, strict=True):
        ends = number, number - noise, number + noise
        heights = (round(HEIGHT - EDGE - (end - low) * scale, 1) for end in ends)
        place = WIDTH * (names.index(point.release) + 0.5) / len(names)
        dots.append((point, round(place, 1), *heights))
    changes = [pair for pair in pairwise(answered) if pair[1].mark]
    return {
        "name": name,
        "points": answered,
        "numbers": numbers,
        "dots": dots,
        "changes": changes,
    }
