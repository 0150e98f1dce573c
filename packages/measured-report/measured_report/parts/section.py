"""A section as its module derives it from results: claims, figures, tables; their words are in its template."""

import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import TYPE_CHECKING, Any

from markupsafe import Markup

from measured_report.files.errors import ReportError, bug_of
from measured_report.parts.claim import Claim
from measured_report.parts.macros import Picture, macros
from measured_report.parts.words import Wording
from measured_report.records.columns import PLAIN, column_of, is_unit, unlike
from measured_report.values.format import ABSENT, unit_label
from measured_report.values.quantities import VALUES_FILE, Quantity
from measured_report.values.results import ResultsError, Series

if TYPE_CHECKING:  # these take long to import, and what is kept from before needs none of them
    import pandas as pd
    from matplotlib.figure import Figure as Drawing

Pictures = Sequence[Picture | Markup]  # a figure as drawn for broad screens and for narrow ones
UNDRAWN = "This cannot be drawn from what was measured"  # said in the place of a figure
FIGURE_SPACE, POINT_SPACE = "\u2007", "\u2008"  # as wide as a digit and as a point; the stylesheet puts them there
SOURCE = re.compile('<data value="[^"][^>]* data-src="([^"]*)"')  # finds the source of each number that there is


@dataclass(frozen=True)
class Table:
    """Show a table whose cells are Quantities, text, or yes and no; the index names the rows."""

    frame: "pd.DataFrame | Markup"  # HTML where it is kept
    numbers: Mapping[str, Any] = field(default_factory=dict)  # named by its caption
    wording: Wording | None = None

    def __html__(self) -> Markup:
        return macros().captioned_table(self)

    def rendered(self) -> "Table":
        """Return the same as HTML: one unit a column, numbers aligned at their points, a mark for what there is not."""
        if isinstance(self.frame, Markup):
            return self
        frame, columns = self.frame, [_Column(name, self.frame[name]) for name in self.frame]
        lines = zip(frame.index, frame.astype(object).to_numpy(), strict=True)
        rows = ((name, [column.cell(cell) for column, cell in zip(columns, line, strict=True)]) for name, line in lines)
        return replace(self, frame=macros().table(frame.index.name or "", columns, rows))


class _Column:
    def __init__(self, name: str, cells: "pd.Series"):
        numbers = [cell for cell in cells if isinstance(cell, Quantity)]
        units = {cell.unit for cell in numbers}
        if clash := unlike(sorted(units)):
            raise ResultsError(f"the column {name} of a table has {' and '.join(clash)}: give it one unit")
        self.name, self.has_numbers = name, bool(numbers)
        self.unit = units.pop() if len(units) == 1 else ""
        self.label = unit_label(self.unit or PLAIN)
        self.places = max(map(_place_count, numbers), default=0)  # the most digits behind a point

    def cell(self, value: Any) -> tuple["_Column", Any, str]:
        """Return the column, the text of a cell, and what fills it for its point to stand below the others."""
        if isinstance(value, Quantity):
            if not self.unit:
                return self, value, ""
            count = _place_count(value)
            missing = "" if "×" in value.written else (self.places - count) * FIGURE_SPACE
            return self, value.bare, missing if count or not missing else POINT_SPACE + missing
        if isinstance(value, bool):
            return self, "yes" if value else "no", ""
        is_missing = value is None or value != value or value == ""
        if isinstance(value, int | float) and not is_missing:
            raise ResultsError(f"the number {value} in a table says nothing of where it comes from")
        return self, ABSENT if is_missing else value, ""


def _place_count(number: Quantity) -> int:
    match = re.search(r"\.(\d*)$", number.written if number.source else "")
    return len(match[1]) if match else 0


@dataclass(frozen=True)
class Figure:
    """Show a figure, which is drawn only after everything else has been checked."""

    draw: "Callable[[], Drawing] | None"  # None where it is kept as it was drawn
    sources: Sequence[Quantity | Series]  # all that it draws; when none of it exists the page says why in its place
    numbers: Mapping[str, Any] = field(default_factory=dict)  # named by its caption and its alternative text
    wording: Wording | None = None
    anchor: str = ""
    pictures: Pictures | None = None  # None where it is not kept, and still to be drawn

    @property
    def is_there(self) -> bool:
        return any(source.value is not None for source in self.sources)

    def rendered(self, pictures: Pictures | None) -> "Figure":
        """Return the same as it is kept once it is drawn: of its series no more than whether they are there."""
        sources = [
            replace(source, value=None if source.value is None else ()) if isinstance(source, Series) else source
            for source in self.sources
        ]
        return replace(self, draw=None, sources=sources, pictures=pictures)

    def drawn(self) -> Pictures:
        """Draw it; where what it takes is not all there, that is said in its place, once."""
        from measured_report.parts.figures import draw_svgs

        assert self.draw, f"the figure {self.anchor} is drawn already"
        try:
            return draw_svgs(self._checked, name=self.anchor)
        except Exception as error:
            if all(source.value is not None for source in self.sources):
                raise ReportError(f"the figure {self.anchor} can't be drawn: {bug_of(error)}") from None
            return macros().left_out(UNDRAWN, " ".join(str(error).split())), Markup("")

    def _checked(self) -> "Drawing":
        """Draw it; ReportError for what is no drawing, or an axis in another unit of a kind than what is drawn."""
        from matplotlib.figure import Figure as Drawing

        assert self.draw
        if not isinstance(drawing := self.draw(), Drawing):
            kind = f"{type(drawing).__module__}.{type(drawing).__name__}"
            raise ReportError(f"it draws a {kind}, and not a new_figure()")
        assert any(axes.has_data() for axes in drawing.axes), "it draws nothing"
        units = {source.unit for source in self.sources if isinstance(source, Quantity)}
        tables = (source.value for source in self.sources if isinstance(source, Series))
        units |= {column_of(column).unit for table in tables if table is not None for column in table}
        labels = [label for axes in drawing.axes for label in (axes.get_xlabel(), axes.get_ylabel()) if label]
        matches = {label: re.search(r"\[([^\[\]]+)\]$", label) for label in labels}  # the unit at its end
        unsaid = sorted(units - {match[1] for match in matches.values() if match}) if PLAIN not in units else []
        for label, match in matches.items():
            if match and " " not in match[1] and not is_unit(match[1]):
                raise ReportError(f"its axis {label!r} has a unit that is not known; units in report.toml adds it")
            if match and match[1] not in units and (clash := [unit for unit in units if unlike([unit, match[1]])]):
                raise ReportError(f"its axis {label!r} has another unit than what it draws, {clash[0]}")
            if not match and unsaid:
                raise ReportError(f"its axis {label!r} has no unit, and no axis has {unsaid[0]}, which it draws")
        return drawing

    def html(self, pictures: Pictures | None, address: str = "", root: str = "") -> Markup:
        """Show the figure, where anything of it exists; drawings that are files are at ``address``."""
        if not (pointers := [source.source for source in self.sources if source.value is not None]):
            reasons = [source.reason for source in self.sources] or ["there is nothing to draw"]
            return macros().left_out("A figure is left out here", reasons[0])
        files: dict[str, None] = {}
        for file in (source.partition("#")[0] for source in pointers):
            is_record = file.endswith(".json") and not file.endswith(VALUES_FILE)  # its rows are there as CSV as well
            files |= dict.fromkeys([file, *([file.removesuffix("json") + "csv"] if is_record else [])])
        names = [file.rpartition("/")[2] for file in files]
        # The same file of several releases is told apart by its folder.
        links = [(file, name if names.count(name) == 1 else file) for file, name in zip(files, names, strict=True)]
        return macros().figure(self, self._spoken(pictures, address), links, f"{root}data/")

    def _spoken(self, pictures: Pictures | None, address: str) -> Markup:
        assert self.wording, f"the figure {self.anchor} has no words yet"
        assert pictures, f"the figure {self.anchor} is not drawn yet"
        drawn = [picture for picture in pictures if isinstance(picture, Picture)]
        if not drawn:  # what is said in its place
            return Markup("").join(picture for picture in pictures if not isinstance(picture, Picture))
        text = self.wording("alt", self.numbers)
        alt, sources = Markup(re.sub("<[^>]*>", "", text)).unescape().replace("\xa0", " "), SOURCE.findall(text)
        if address:
            return macros().picture(address, *(picture.size for picture in drawn), alt, sources)
        return Markup("").join(macros().drawing(picture, alt, sources) for picture in drawn)


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

    tables: Mapping[str, Any] = field(default_factory=dict)  # tables, and other things that print themselves
    figures: Mapping[str, Figure] = field(default_factory=dict)
    claims: Sequence[Claim] = ()
    downloads: Sequence[Download] = ()
    unmeasured: Collection[str] = ()  # names that only other records have, so that the words for them stay unsaid

    def __post_init__(self) -> None:
        names = [claim.name for claim in self.claims]
        assert len(set(names)) == len(names), f"two claims have one name: {', '.join(names)}"
        for name, item in (*self.tables.items(), *self.figures.items()):
            assert hasattr(item, "__html__") or hasattr(item, "draw"), f"{name} is no Table(frame), or Figure(draw, …)"

    def worded(self, anchor: str, template: str, wordings: Mapping[tuple[str, str], Wording]) -> "Section":
        """Give it the words of the ``template``; ReportError unless items and wordings match."""
        items = {"claim": {claim.name: claim for claim in self.claims}, "figure": self.figures, "table": self.tables}
        for (kind, name), wording in wordings.items():
            if name not in items[kind] and name not in self.unmeasured:
                raise ReportError(f"{wording.source}: there is no {kind} {name}; there are: {', '.join(items[kind])}")

        def fill(kind: str, name: str, item: Any) -> Any:
            if (kind, name) not in wordings:
                raise ReportError(f"templates/{template} says nothing of the {kind} {name}")
            if not hasattr(item, "wording"):
                return item
            wordings[kind, name].refuse_unknown(f"{kind} {name}", item.numbers)
            for part in wordings[kind, name].blocks:  # those as well that are not said now: with other numbers they are
                wordings[kind, name](part, item.numbers)
            anchors = {"anchor": f"{anchor}-{name}"} if kind == "figure" else {}
            return replace(item, wording=wordings[kind, name], **anchors)

        worded = {kind: {name: fill(kind, name, item) for name, item in group.items()} for kind, group in items.items()}
        return replace(self, claims=list(worded["claim"].values()), figures=worded["figure"], tables=worded["table"])
