"""Write the page History: all headlines in all editions, with marks for changes."""

from measured_report.changes.query import Query, points, schema_of
from measured_report.files.config import Page
from measured_report.findings.chapters import Releases
from measured_report.pages.prose import Templates
from measured_report.parts.macros import macros
from measured_report.parts.prose import Prose
from measured_report.values.format import unit_label

PAGE = Page("history")


def series_page(releases: Releases, templates: Templates) -> Prose | None:
    """Return a page with the headlines that at least two editions have, or None."""
    columns = next(filter(None, map(schema_of, releases.values())), None)
    if columns is None or PAGE.name in {page.name for page in columns.settings.pages}:
        return None
    rows = []
    for label, value in columns.settings.changes.headlines.items():
        query = Query(value, label=label)
        marks = {point.release: point.mark for point in points(releases, query)}
        if len(marks) > 1:
            quantities = {name: query.quantity(releases[name]) for name in marks}
            # The row has the unit, so the numbers are printed without it.
            numbers = {
                name: getattr(quantity, "bare", quantity)
                for name, quantity in quantities.items()
            }
            name = f"{label} [{unit_label(columns[query.column].unit)}]"
            rows.append((name, numbers, marks))
    if not rows:
        return None
    table = macros().series(rows, columns.settings, list(releases))
    return templates.prose("series.md.j2", PAGE.name, {"table": table}, level=1)
