"""A section as its module derives it from results: claims, figures, tables; their words are in its template."""

import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from measured_report.files.columns import PLAIN, Schema, unlike
from measured_report.files.errors import ReportError, bug_of
from measured_report.parts.claim import Claim
from measured_report.parts.macros import Picture, macros
from measured_report.parts.words import Wording
from measured_report.values.format import ABSENT, unit_label
from measured_report.values.quantities import VALUES_FILE, Quantity
from measured_report.values.results import ResultsError, Series

if TYPE_CHECKING:  # these take long to import, and what is kept needs none of them
    import pandas as pd
    from matplotlib.figure import Figure as Drawing

UNDRAWN = "This cannot be drawn from what was measured"  # shown in place of a figure
FIGURE_SPACE, POINT_SPACE = "\u2007", "\u2008"
"""As wide as a digit and as a point; the stylesheet puts them there."""
SOURCE = re.compile('<data value="[^"][^>]* data-src="([^"]*)"')
"""The source of each number that there is, in HTML."""


@dataclass(frozen=True)
class Table:
    """Show a table whose cells are Quantities, text, or yes and no; the index names the rows."""

    frame: "pd.DataFrame | Markup"  # HTML where it is kept
    numbers: Mapping[str, Any] = field(default_factory=dict)  # named by its caption
    wording: Wording | None = None

    def __html__(self) -> Markup:
        return macros().captioned_table(self)

    def rendered(self) -> "Table":
        """Return the same as HTML: a unit for each column, and points below each other."""
        if isinstance(self.frame, Markup):
            return self
        index = self.frame.index
        columns = [_column(name, self.frame[name]) for name in self.frame]
        cells = zip(*(column["cells"] for column in columns), strict=True)
        rows = zip(index, cells if columns else [()] * len(index), strict=True)
        return replace(self, frame=macros().table(index.name or "", columns, rows))


def _column(name: str, values: "pd.Series") -> dict[str, Any]:
    """Return what the head of a column says, and the text and the filling of its cells."""
    numbers = [cell for cell in values if isinstance(cell, Quantity)]
    units = {cell.unit for cell in numbers}
    if clash := unlike(sorted(units)):
        clashing = " and ".join(clash)
        raise ResultsError(
            f"the column {name} of a table has {clashing}: give it one unit"
        )
    unit = units.pop() if len(units) == 1 else ""
    places = max(map(_place_count, numbers), default=0)

    def cell(value: Any) -> tuple[Any, str]:
        if isinstance(value, Quantity):
            if not unit:
                return value, ""
            count = _place_count(value)
            missing = (places - count) * FIGURE_SPACE
            if not missing or "×" in value.written:
                return value.bare, ""
            return value.bare, missing if count else POINT_SPACE + missing
        if isinstance(value, bool):
            return "yes" if value else "no", ""
        if value is None or value != value or value == "":
            return ABSENT, ""
        if isinstance(value, int | float):
            raise ResultsError(
                f"the number {value} in a table says nothing of where it comes from"
            )
        return value, ""

    return {
        "name": name,
        "label": unit_label(unit or PLAIN),
        "has_numbers": bool(numbers),
        "cells": [cell(value) for value in values.astype(object)],
    }


def _place_count(number: Quantity) -> int:
    """Count the digits behind the point of a number that has a source."""
    match = re.search(r"\.(\d*)$", number.written if number.source else "")
    return len(match[1]) if match else 0


@dataclass(frozen=True)
class Figure:
    """Show a figure, which is drawn once its section is derived."""

    draw: "Callable[[], Drawing] | None"  # None where it is kept as it was drawn
    sources: Sequence[
        Quantity | Series
    ]  # all that it draws; when none of it exists the page says why in its place
    numbers: Mapping[str, Any] = field(
        default_factory=dict
    )  # named by its caption and its alternative text
    wording: Wording | None = None
    anchor: str = ""
    pictures: Sequence[Picture] = ()  # for broad screens and for narrow ones
    fault: str = ""  # why there are none, though something of it exists

    @property
    def is_there(self) -> bool:
        return any(source.value is not None for source in self.sources)

    def drawn(self, anchor: str, columns: Schema) -> "Figure":
        """Return the same drawn: of its series it keeps only whether they are there."""
        pictures: Sequence[Picture] = ()
        fault = ""
        if self.is_there:
            from measured_report.parts.figures import draw_svgs

            try:
                pictures = draw_svgs(lambda: self._checked(columns), name=anchor)
            except Exception as error:
                if all(source.value is not None for source in self.sources):
                    bug = bug_of(error)
                    raise ReportError(
                        f"the figure {anchor} can't be drawn: {bug}"
                    ) from None
                fault = " ".join(str(error).split())
        sources = [
            replace(source, value=())
            if isinstance(source, Series) and source.value is not None
            else source
            for source in self.sources
        ]
        return replace(
            self,
            draw=None,
            sources=sources,
            anchor=anchor,
            pictures=pictures,
            fault=fault,
        )

    def _checked(self, columns: Schema) -> "Drawing":
        """Draw it; ReportError for what is no drawing, or an axis in a wrong unit."""
        from matplotlib.figure import Figure as Drawing

        assert self.draw, f"the figure {self.anchor} is drawn already"
        if not isinstance(drawing := self.draw(), Drawing):
            kind = f"{type(drawing).__module__}.{type(drawing).__name__}"
            raise ReportError(f"it draws a {kind}, and not a new_figure()")
        assert any(axes.has_data() for axes in drawing.axes), "it draws nothing"
        units = set(self._units(columns))
        labels = [
            label
            for axes in drawing.axes
            for label in (axes.get_xlabel(), axes.get_ylabel())
            if label
        ]
        said = {
            label: match[1]  # the unit at its end
            for label in labels
            if (match := re.search(r"\[([^\[\]]+)\]$", label))
        }
        unsaid = sorted(units - {*said.values()}) if PLAIN not in units else []
        for label in labels:
            unit = said.get(label)
            if unit is None and unsaid:
                raise ReportError(
                    f"its axis {label!r} has no unit, "
                    f"and no axis has {unsaid[0]}, which it draws"
                )
            if unit is None or unit in units:
                continue
            if " " not in unit and not columns.is_unit(unit):
                raise ReportError(
                    f"its axis {label!r} has a unit that is not known; "
                    "units in report.toml adds it"
                )
            for other in units:
                if unlike([other, unit]):
                    raise ReportError(
                        f"its axis {label!r} has another unit than what it draws, "
                        f"{other}"
                    )
        return drawing

    def _units(self, columns: Schema) -> Iterator[str]:
        """Yield the units of all that it draws."""
        for source in self.sources:
            if isinstance(source, Quantity):
                yield source.unit
            elif source.value is not None:
                yield from (columns[name].unit for name in source.value)

    def html(self, address: str = "", root: str = "") -> Markup:
        """Show it, where anything of it exists; drawings that are files are at ``address``."""
        pointers = [each.source for each in self.sources if each.value is not None]
        if not pointers:
            reasons = [source.reason for source in self.sources]
            reason = reasons[0] if reasons else "there is nothing to draw"
            return macros().left_out("A figure is left out here", reason)
        files: dict[str, None] = {}
        for file in (pointer.partition("#")[0] for pointer in pointers):
            files[file] = None
            if file.endswith(".json") and not file.endswith(VALUES_FILE):
                files[file.removesuffix("json") + "csv"] = None  # a record's rows
        names = [file.rpartition("/")[2] for file in files]
        # The same file of several releases is told apart by its folder.
        links = [
            (file, name if names.count(name) == 1 else file)
            for file, name in zip(files, names, strict=True)
        ]
        return macros().figure(self, self._shown(address), links, f"{root}data/")

    def _shown(self, address: str) -> Markup:
        """Return its pictures, with what they show in words and the sources of those."""
        if self.fault:
            return macros().left_out(UNDRAWN, self.fault)
        assert self.wording, f"the figure {self.anchor} has no words yet"
        assert self.pictures, f"the figure {self.anchor} is not drawn yet"
        text = self.wording("alt", self.numbers)
        alt = Markup(re.sub("<[^>]*>", "", text)).unescape().replace("\xa0", " ")
        sources = SOURCE.findall(text)
        if address:
            sizes = (picture.size for picture in self.pictures)
            return macros().picture(address, *sizes, alt, sources)
        drawings = (macros().drawing(each, alt, sources) for each in self.pictures)
        return Markup("").join(drawings)


@dataclass(frozen=True)
class Download:
    """Offer a file, which lies on the site below ``download/``; printed, it is its text with a link to it."""

    name: str
    text: str

    @property
    def link(self) -> Markup:
        return macros().download_link(self)

    def __html__(self) -> Markup:
        return macros().download(self)


@dataclass(frozen=True)
class Section:
    """Hold all that a section's template can name, besides what all of them can."""

    tables: Mapping[str, Any] = field(
        default_factory=dict
    )  # tables, and other things that print themselves
    figures: Mapping[str, Figure] = field(default_factory=dict)
    claims: Sequence[Claim] = ()
    downloads: Sequence[Download] = ()
    unmeasured: Collection[
        str
    ] = ()  # names that only other records have, so that the words for them stay unsaid

    def __post_init__(self) -> None:
        names = [claim.name for claim in self.claims]
        assert len(set(names)) == len(names), (
            f"two claims have one name: {', '.join(names)}"
        )
        for name, item in (*self.tables.items(), *self.figures.items()):
            is_shown = hasattr(item, "__html__") or hasattr(item, "draw")
            assert is_shown, f"{name} is no Table(frame), or Figure(draw, …)"

    def drawn(self, anchor: str, columns: Schema) -> "Section":
        """Return the same with its tables as HTML and its figures drawn."""
        tables = {
            name: table.rendered() if isinstance(table, Table) else table
            for name, table in self.tables.items()
        }
        figures = {
            name: figure.drawn(f"{anchor}-{name}", columns)
            for name, figure in self.figures.items()
        }
        return replace(self, tables=tables, figures=figures)

    def worded(
        self, anchor: str, template: str, wordings: Mapping[tuple[str, str], Wording]
    ) -> "Section":
        """Give it the words of the ``template``; ReportError unless items and wordings match."""
        items: Mapping[str, Mapping[str, Any]] = {
            "claim": {claim.name: claim for claim in self.claims},
            "figure": self.figures,
            "table": self.tables,
        }
        for (kind, name), wording in wordings.items():
            if name not in items[kind] and name not in self.unmeasured:
                names = ", ".join(items[kind])
                raise ReportError(
                    f"{wording.source}: there is no {kind} {name}; there are: {names}"
                )

        def with_words(kind: str) -> Iterator[tuple[str, Any]]:
            for name, item in items[kind].items():
                if (kind, name) not in wordings:
                    raise ReportError(
                        f"templates/{template} says nothing of the {kind} {name}"
                    )
                if hasattr(item, "wording"):
                    wordings[kind, name].check(f"{kind} {name}", item.numbers)
                    item = replace(item, wording=wordings[kind, name])
                yield name, item

        figures = {
            name: replace(figure, anchor=f"{anchor}-{name}")
            for name, figure in with_words("figure")
        }
        return replace(
            self,
            claims=[claim for _, claim in with_words("claim")],
            figures=figures,
            tables=dict(with_words("table")),
        )
