"""What the page of the history shows: the numbers that say most, over all editions."""

import pandas as pd
from markupsafe import Markup

from measured_report.changes.history import points
from measured_report.pages.chapters import Releases
from measured_report.parts.section import Section, Table
from measured_report.values.format import unit_label
from report.sections.upgrade.ends import released
from report.sections.upgrade.tables import HEADLINES


def derive(releases: Releases, shown: str) -> Section:
    """Derive the table of the page, which is the same for each release; ``releases`` are oldest first."""
    return Section(tables={"numbers": _numbers(released(releases, shown))})


def _numbers(releases: Releases) -> Table:
    labels: list[Markup] = []
    columns: dict[str, list[Markup]] = {name: [] for name in releases}
    for headline in HEADLINES:
        if found := points(releases, headline):
            labels.append(Markup("{} [{}]").format(headline.label, unit_label(headline.unit)))
            marks = {point.release: point.mark for point in found}
            for name, column in columns.items():
                column.append(_marked(headline.cell(releases[name], name).bare, marks.get(name, "")))
    return Table(pd.DataFrame(columns, index=pd.Index(labels, name="number"), dtype=object))


def _marked(number: Markup, mark: str) -> Markup:
    return Markup('{} <span class="moved {}">{}</span>').format(number, mark, mark) if mark else number
