"""What a section module makes of its results."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import pandas as pd
from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from report.claims import Claim
from report.figures import draw_svg
from report.format import unit_label
from report.quantities import Quantity
from report.results import ResultsError, Trace


@dataclass(frozen=True)
class Table:
    """A table whose cells are Quantities, text, or yes and no; the index names the rows."""

    frame: pd.DataFrame
    caption: str

    def __html__(self) -> Markup:
        units = {column: _common_unit(self.frame[column]) for column in self.frame}
        head = Markup("").join(
            Markup('<th scope="col"{}>{}{}</th>').format(
                Markup(' class="number"') if _has_numbers(self.frame[column]) else "",
                column,
                _bracketed(unit),
            )
            for column, unit in units.items()
        )
        body = Markup("\n").join(
            Markup('<tr><th scope="row">{}</th>{}</tr>').format(
                name, Markup("").join(_cell(value, units[column]) for column, value in row.items())
            )
            for name, row in self.frame.astype(object).iterrows()
        )
        corner = Markup('<th scope="col">{}</th>').format(self.frame.index.name or "")
        return Markup(
            '<figure class="table"><figcaption>{}</figcaption><div class="wide" tabindex="0"><table>\n'
            "<thead><tr>{}{}</tr></thead>\n<tbody>\n{}\n</tbody></table></div></figure>"
        ).format(self.caption, corner, head, body)


@dataclass(frozen=True)
class Figure:
    """A figure that is drawn only after everything else has been checked."""

    draw: Callable[[], Drawing]
    caption: str
    alt: str
    """What it shows, for those who can't see it."""
    sources: Sequence[Quantity | Trace]
    """What it draws; when none of it exists the page says why in place of the figure."""


@dataclass(frozen=True)
class PlacedFigure:
    """A figure at its place on the page, where it is drawn when the page is written."""

    name: str
    """Unique on the page."""
    figure: Figure

    def drawn(self) -> Markup:
        there = [source.source for source in self.figure.sources if source.value is not None]
        if not there:
            reasons = [source.reason for source in self.figure.sources] or ["there is nothing to draw"]
            return Markup('<p class="left-out">A figure is left out here: {}.</p>').format(reasons[0])
        files = dict.fromkeys(source.partition("#")[0] for source in there)
        names = [file.rpartition("/")[2] for file in files]
        links = Markup(", ").join(
            # The same file of several releases is told apart by its folder.
            Markup('<a href="data/{}">{}</a>').format(file, name if names.count(name) == 1 else file)
            for file, name in zip(files, names, strict=True)
        )
        return Markup(
            '<figure id="{}"><div class="wide" tabindex="0">{}</div>'
            '<figcaption>{} <span class="source">Data: {}</span></figcaption></figure>'
        ).format(
            self.name,
            draw_svg(self.figure.draw, name=self.name, alt=self.figure.alt),
            self.figure.caption,
            links,
        )


@dataclass(frozen=True)
class Download:
    """A file that the site offers below ``download/``; printed, it is its text with a link to it."""

    name: str
    text: str

    @property
    def link(self) -> Markup:
        return Markup('<a href="download/{0}" download>{0}</a>').format(self.name)

    def __html__(self) -> Markup:
        return Markup('<figure><pre tabindex="0"><code>{}</code></pre><figcaption>{}</figcaption></figure>').format(
            self.text, self.link
        )


@dataclass(frozen=True)
class Section:
    """All that a section's template can name, besides what ``assemble`` gives to all of them."""

    tables: Mapping[str, Table] = field(default_factory=dict)
    figures: Mapping[str, Figure] = field(default_factory=dict)
    claims: Sequence[Claim] = ()
    downloads: Sequence[Download] = ()


def _common_unit(cells: pd.Series) -> str | None:
    """The unit of all numbers of a column, which then stands in its head; None when they differ."""
    units = {cell.unit for cell in cells if isinstance(cell, Quantity)}
    return units.pop() if len(units) == 1 else None


def _has_numbers(cells: pd.Series) -> bool:
    return any(isinstance(cell, Quantity) for cell in cells)


def _bracketed(unit: str | None) -> str:
    label = unit_label(unit or "1")
    return f" [{label}]" if label else ""


def _cell(value: Quantity | bool | str | None, unit: str | None) -> Markup:
    if isinstance(value, Quantity):
        return Markup('<td class="number">{}</td>').format(value.bare if unit else value)
    if isinstance(value, bool):
        value = "yes" if value else "no"
    if isinstance(value, int | float) and not pd.isna(value):
        raise ResultsError(f"the number {value} in a table says nothing of where it comes from")
    return Markup("<td>{}</td>").format("" if pd.isna(value) else value)
