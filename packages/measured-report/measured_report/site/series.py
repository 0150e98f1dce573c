"""Series: the page that shows each headline over all editions, and where it changed."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup

from measured_report.changes.query import Point, Query, points
from measured_report.files.config import Page, config
from measured_report.findings.chapters import Releases
from measured_report.pages.prose import Templates
from measured_report.parts.macros import macros
from measured_report.parts.prose import Prose
from measured_report.values.format import unit_label

PAGE = Page("history")
WIDTH, HEIGHT, EDGE = 288.0, 48.0, 4.0  # of a chart, in the units of its drawing


@dataclass(frozen=True)
class Series:
    """Hold what all editions say of a headline, as its chart and its table have it."""

    query: Query
    points: Sequence[Point]
    releases: Releases

    @property
    def name(self) -> str:
        return f"{self.query.label} [{unit_label(self.query.unit)}]"

    def number(self, point: Point) -> Any:
        """Return the number of an edition with its source."""
        number = self.query.quantity(self.releases[point.release])
        return getattr(number, "bare", number)

    @property
    def changes(self) -> Iterator[tuple[Point, Point]]:
        """Yield the editions on either side of each change."""
        return (pair for pair in zip(self.points, self.points[1:], strict=False) if pair[1].mark)

    @property
    def dots(self) -> Iterator[tuple[Point, float, float, float, float]]:
        """Yield the place of each edition, its number's, and those of the ends of its noise."""
        reaches = [(float(point.answer), point.noise or 0.0) for point in self.points]
        low, high = min(number - noise for number, noise in reaches), max(number + noise for number, noise in reaches)
        scale, names = (HEIGHT - 2 * EDGE) / ((high - low) or 1.0), [*self.releases]  # one axis for all charts
        for point, (number, noise) in zip(self.points, reaches, strict=True):
            heights = (HEIGHT - EDGE - (end - low) * scale for end in (number, number - noise, number + noise))
            place = WIDTH * (names.index(point.release) + 0.5) / len(names)
            yield (point, *(round(end, 1) for end in (place, *heights)))  # type: ignore[misc]


def series_page(releases: Releases, templates: Templates) -> Prose | None:
    """Put the headlines into words that two editions answer, or more; None where there is none."""
    queries = (Query(value, label=label) for label, value in config().changes.headlines.items())
    series = [Series(query, points(releases, query), releases) for query in queries]
    shown = [each for each in series if len(each.points) > 1]
    if not shown or PAGE.name in {page.name for page in config().pages}:
        return None
    table = macros().series(shown, config(), Markup(f'viewBox="0 0 {WIDTH:g} {HEIGHT:g}"'), HEIGHT)
    return templates.prose("series.md.j2", PAGE.name, {"table": table}, level=1)
