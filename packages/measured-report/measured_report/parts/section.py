"""Define a section with its claims, figures and tables, as ``derive`` returns it.

Their wordings are in the template of the section.
"""

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from measured_report.files.columns import PLAIN
from measured_report.files.errors import ReportError, bug_of
from measured_report.files.units import TYPED, unlike
from measured_report.parts.claim import Claim
from measured_report.parts.macros import macros
from measured_report.parts.words import Wording
from measured_report.values.format import ABSENT, unit_label
from measured_report.values.quantities import VALUES_FILE, Quantity
from measured_report.values.results import ResultsError, Series

# These imports are slow, and sections from the cache do not need them.
if TYPE_CHECKING:
    import pandas as pd
    from matplotlib.figure import Figure as Drawing

UNDRAWN = (
    "This figure cannot be drawn from the measured data"  # shown instead of a figure
)
FIGURE_SPACE, POINT_SPACE = "\u2007", "\u2008"
"""Spaces as wide as a digit and a point, with which the style sheet aligns numbers."""
SIZE = re.compile(r'viewBox="0 0 ([\d.]+) ([\d.]+)"')
"""The width and the height of a drawing in SVG."""


@dataclass(frozen=True)
class Table:
    """A table whose cells are quantities, texts or booleans.

    The index of its frame contains the names of the rows.
    """

    frame: "pd.DataFrame | Markup"  # HTML if it is already rendered
    numbers: Mapping[str, Any] = field(default_factory=dict)  # for its caption
    wording: Wording | None = None
    missing: Sequence[str] = ()  # why cells are missing that no record has

    def __html__(self) -> Markup:
        return macros().captioned_table(self)

    def rendered(self) -> "Table":
        """Return the table as HTML, with one unit and aligned points in each column."""
        if isinstance(self.frame, Markup):
            return self
        index = self.frame.index
        columns = [_column(name, self.frame[name]) for name in self.frame]
        cells = zip(*(column["cells"] for column in columns), strict=True)
        rows = zip(index, cells if columns else [()] * len(index), strict=True)
        html = macros().table(index.name or "", columns, rows)
        cells = self.frame.to_numpy().flat
        return replace(self, frame=html, missing=unrecorded(cells))


def _column(name: str, values: "pd.Series") -> dict[str, Any]:
    """Return the name and unit of a column, and the text and padding of its cells."""
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
        # Only NaN differs from itself.
        if value is None or value != value or value == "":
            return ABSENT, ""
        if isinstance(value, int | float):
            raise ResultsError(
                f"the number {value} in a table does not have a source: use a Quantity"
            )
        if not isinstance(value, Markup) and (typed := TYPED.search(str(value))):
            raise ResultsError(
                f"{typed[0]!r} in a table does not have a source: use a Quantity"
            )
        return value, ""

    return {
        "name": name,
        "label": unit_label(unit or PLAIN),
        "has_numbers": bool(numbers),
        "cells": [cell(value) for value in values.astype(object)],
    }


def _place_count(number: Quantity) -> int:
    """Return the count of printed decimals; 0 for a number without a source."""
    match = re.search(r"\.(\d*)$", number.written if number.source else "")
    return len(match[1]) if match else 0


def unrecorded(sources: Iterable[Any]) -> list[str]:
    """Return why numbers and traces are missing that no record has.

    A number that was lost in the measurement has a pointer to its record.
    """
    return [
        source.reason
        for source in sources
        if isinstance(source, Series | Quantity)
        and source.value is None
        and (isinstance(source, Series) or not source.source)
    ]


@dataclass(frozen=True)
class Figure:
    """A figure, which is drawn after its section is derived."""

    draw: "Callable[[], Drawing] | None"  # None if it is already drawn
    sources: Sequence[Quantity | Series]
    """All data that it draws; if they are all missing, the page prints the reason."""
    numbers: Mapping[str, Any] = field(default_factory=dict)
    """Numbers for its caption and its alternative text."""
    wording: Wording | None = None
    anchor: str = ""
    root: str = ""  # the relative path from the page to the root of the site
    pictures: Sequence[str] = ()  # SVG for broad and for narrow screens
    fault: str = ""  # why it could not be drawn although some of its sources exist

    def __post_init__(self) -> None:
        assert all(isinstance(part, Quantity | Series) for part in self.sources), (
            "a source of a figure is not a quantity or a trace: leave out .number"
        )

    @property
    def is_there(self) -> bool:
        return any(source.value is not None for source in self.sources)

    def drawn(self, anchor: str) -> "Figure":
        """Return the figure as SVG, and without the numbers of its series.

        Raise ReportError if it cannot be drawn although all of its sources exist.
        """
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
                        f"the figure {anchor} cannot be drawn: {bug}"
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
        """Return the HTML with links to the data, or the reason why it is left out."""
        pointers = [
            source.source for source in self.sources if source.value is not None
        ]
        if not pointers:
            reasons = [source.reason for source in self.sources]
            reason = reasons[0] if reasons else "there is nothing to draw"
            return macros().left_out("A figure is left out here", reason)
        files: dict[str, None] = {}
        for file in (pointer.partition("#")[0] for pointer in pointers):
            files[file] = None
            if file.endswith(".json") and not file.endswith(VALUES_FILE):
                # The same rows as a table.
                files[file.removesuffix("json") + "csv.gz"] = None
        names = [file.rpartition("/")[2] for file in files]
        # Files of several releases have the same name, so their folder is added.
        links = [
            (file, name if names.count(name) == 1 else file)
            for file, name in zip(files, names, strict=True)
        ]
        if self.fault:
            content = macros().left_out(UNDRAWN, self.fault)
        else:
            assert self.wording, f"the figure {self.anchor} does not have a wording yet"
            alt = self.wording["alt"](self.numbers).striptags().replace("\xa0", " ")
            sizes = [
                match.groups() for match in map(SIZE.search, self.pictures) if match
            ]
            content = macros().picture(self.anchor, *sizes, alt)
        return macros().figure(self, content, links)


@dataclass(frozen=True)
class Section:
    """The tables, figures, claims and downloads for the template of a section."""

    tables: Mapping[str, Any] = field(default_factory=dict)
    """Tables, and other objects with a method ``__html__``."""
    figures: Mapping[str, Figure] = field(default_factory=dict)
    claims: Sequence[Claim] = ()
    downloads: Mapping[str, str] = field(default_factory=dict)
    """Contents of files by name; the site has them in its folder ``download/``."""
    unmeasured: Collection[str] = ()
    """Names of parts whose numbers are not in this record; they are not printed."""
    lost: Collection[tuple[str, str]] = ()
    """Kinds and names that only other editions derive."""

    def __post_init__(self) -> None:
        names = [claim.name for claim in self.claims]
        assert len(set(names)) == len(names), (
            f"two claims have the same name: {', '.join(names)}"
        )
        assert all(isinstance(part, Figure) for part in dict(self.figures).values()), (
            "figures contains something other than a Figure: use Figure(draw, sources)"
        )

    @property
    def names(self) -> set[tuple[str, str]]:
        """Return the kind and the name of each claim, figure and table.

        Claims that share a wording also count under the name of their wording.
        """
        claims = {
            ("claim", name)
            for claim in self.claims
            for name in (claim.name, claim.wording_name)
        }
        figures = {("figure", name) for name in self.figures}
        return claims | figures | {("table", name) for name in self.tables}

    def drawn(self, anchor: str) -> "Section":
        """Return the section with its tables as HTML and its figures as SVG."""
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
        """Return the section with the wordings of ``template``.

        Raise ReportError if a wording does not belong to any part of the section, or if
        a part does not have a wording.
        """
        parts: Mapping[str, Mapping[str, Any]] = {
            "claim": {claim.name: claim for claim in self.claims},
            "figure": {
                name: replace(figure, anchor=f"{anchor}-{name}", root=root)
                for name, figure in self.figures.items()
            },
            "table": self.tables,
        }
        for kind, name in wordings:
            is_known = name in self.unmeasured or (kind, name) in self.lost
            if (kind, name) not in self.names and not is_known:
                names = ", ".join(parts[kind]) or "none"
                raise ReportError(
                    f"templates/{template}: the section does not have a {kind} {name}: "
                    f"derive it or use one of {names}"
                )

        def with_wordings(kind: str) -> Iterator[tuple[str, Any]]:
            for name, part in parts[kind].items():
                wording_name = getattr(part, "wording_name", name)
                if (kind, wording_name) not in wordings:
                    raise ReportError(
                        f"templates/{template} does not contain the {kind} "
                        f"{wording_name}: add {{% {kind} {wording_name} %}}"
                    )
                if hasattr(part, "wording"):
                    wording = wordings[kind, wording_name]
                    # Render all texts now, because other numbers may select another
                    # text.
                    for text in wording.values():
                        text(part.numbers)
                    part = replace(part, wording=wording)
                yield name, part

        return replace(
            self,
            claims=[claim for _, claim in with_wordings("claim")],
            figures=dict(with_wordings("figure")),
            tables=dict(with_wordings("table")),
        )
