"""A section as its module derives it from results: claims, figures, tables; their words are in its template."""

import re
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from measured_report.files.columns import PLAIN, unlike
from measured_report.files.errors import ReportError, bug_of
from measured_report.parts.claim import Claim
from measured_report.parts.macros import macros
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
SIZE = re.compile(r'viewBox="0 0 ([\d.]+) ([\d.]+)"')
"""The width and the height of a drawing in SVG."""


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
    root: str = ""  # the way from the page to the root of the site
    pictures: Sequence[str] = ()  # in SVG, for broad screens and for narrow ones
    fault: str = ""  # why there are none, though something of it exists

    @property
    def is_there(self) -> bool:
        return any(source.value is not None for source in self.sources)

    def drawn(self, anchor: str) -> "Figure":
        """Return the same drawn: of its series it keeps only whether they are there."""
        pictures: Sequence[str] = ()
        fault = ""
        if self.is_there:
            from measured_report.parts.figures import draw_svgs

            try:
                assert self.draw, "it is drawn already"
                pictures = draw_svgs(self.draw, name=anchor)
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

    def __html__(self) -> Markup:
        """Show it, with links to the data that it draws, if anything of it exists."""
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
        if self.fault:
            shown = macros().left_out(UNDRAWN, self.fault)
        else:
            assert self.wording, f"the figure {self.anchor} has no words yet"
            alt = self.wording("alt", self.numbers).striptags().replace("\xa0", " ")
            sizes = [
                match.groups() for match in map(SIZE.search, self.pictures) if match
            ]
            shown = macros().picture(self.anchor, *sizes, alt)
        return macros().figure(self, shown, links)


@dataclass(frozen=True)
class Section:
    """Hold all that a section's template can name, besides what all of them can."""

    tables: Mapping[str, Any] = field(
        default_factory=dict
    )  # tables, and other things that print themselves
    figures: Mapping[str, Figure] = field(default_factory=dict)
    claims: Sequence[Claim] = ()
    downloads: Mapping[str, str] = field(default_factory=dict)
    """Texts of files by name, which lie on the site below ``download/``."""
    unmeasured: Collection[
        str
    ] = ()  # names that only other records have, so that the words for them stay unsaid
    lost: Collection[
        tuple[str, str]
    ] = ()  # kinds and names that other editions derive, and this one does not

    def __post_init__(self) -> None:
        names = [claim.name for claim in self.claims]
        assert len(set(names)) == len(names), (
            f"two claims have one name: {', '.join(names)}"
        )

    @property
    def names(self) -> set[tuple[str, str]]:
        """Return the kind and the name of each of its claims, figures and tables."""
        claims = {("claim", claim.name) for claim in self.claims}
        figures = {("figure", name) for name in self.figures}
        return claims | figures | {("table", name) for name in self.tables}

    def drawn(self, anchor: str) -> "Section":
        """Return the same with its tables as HTML and its figures drawn."""
        tables = {
            name: table.rendered() if isinstance(table, Table) else table
            for name, table in self.tables.items()
        }
        figures = {
            name: figure.drawn(f"{anchor}-{name}")
            for name, figure in self.figures.items()
        }
        return replace(self, tables=tables, figures=figures)

    def worded(
        self,
        anchor: str,
        template: str,
        wordings: Mapping[tuple[str, str], Wording],
        root: str = "",
    ) -> "Section":
        """Give it the words of the ``template``; ReportError unless items and wordings match."""
        items: Mapping[str, Mapping[str, Any]] = {
            "claim": {claim.name: claim for claim in self.claims},
            "figure": {
                name: replace(figure, anchor=f"{anchor}-{name}", root=root)
                for name, figure in self.figures.items()
            },
            "table": self.tables,
        }
        for kind, name in wordings:
            is_known = name in self.unmeasured or (kind, name) in self.lost
            if name not in items[kind] and not is_known:
                names = ", ".join(items[kind])
                raise ReportError(
                    f"templates/{template}: there is no {kind} {name}; "
                    f"there are: {names}"
                )

        def with_words(kind: str) -> Iterator[tuple[str, Any]]:
            for name, item in items[kind].items():
                if (kind, name) not in wordings:
                    raise ReportError(
                        f"templates/{template} says nothing of the {kind} {name}"
                    )
                if hasattr(item, "wording"):
                    wording = wordings[kind, name]
                    for part in wording.parts:  # with other numbers another one is said
                        wording(part, item.numbers)
                    item = replace(item, wording=wording)
                yield name, item

        return replace(
            self,
            claims=[claim for _, claim in with_words("claim")],
            figures=dict(with_words("figure")),
            tables=dict(with_words("table")),
        )
