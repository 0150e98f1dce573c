"""What a section module makes of its results; the words of it are in the section's template."""

import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import pandas as pd
from markupsafe import Markup
from matplotlib.figure import Figure as Drawing

from report import ReportError
from report.claims import Claim
from report.figures import draw_svg
from report.format import unit_label
from report.quantities import Quantity
from report.results import ResultsError, Series
from report.words import Wording

TAG = re.compile("<[^>]*>")


@dataclass(frozen=True)
class Table:
    """A table whose cells are Quantities, text, or yes and no; the index names the rows."""

    frame: pd.DataFrame
    numbers: Mapping[str, Any] = field(default_factory=dict)
    """What its caption can name."""
    wording: Wording | None = None

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
        ).format(_caption(self), corner, head, body)


@dataclass(frozen=True)
class Figure:
    """A figure, which is drawn only after everything else has been checked."""

    draw: Callable[[], Drawing]
    sources: Sequence[Quantity | Series]
    """What it draws; when none of it exists the page says why in place of the figure."""
    numbers: Mapping[str, Any] = field(default_factory=dict)
    """What its caption and its alternative text can name."""
    wording: Wording | None = None
    anchor: str = ""
    """Its id, unique on the page."""

    def drawn(self) -> Markup:
        there = [source.source for source in self.sources if source.value is not None]
        if not there:
            reasons = [source.reason for source in self.sources] or ["there is nothing to draw"]
            return Markup('<p class="left-out">A figure is left out here: {}.</p>').format(reasons[0])
        files = dict.fromkeys(source.partition("#")[0] for source in there)
        names = [file.rpartition("/")[2] for file in files]
        links = Markup(", ").join(
            # The same file of several releases is told apart by its folder.
            Markup('<a href="data/{}">{}</a>').format(file, name if names.count(name) == 1 else file)
            for file, name in zip(files, names, strict=True)
        )
        assert self.wording, f"the figure {self.anchor} has no words yet"
        alt = Markup(TAG.sub("", self.wording("alt", self.numbers))).unescape().replace("\xa0", " ")
        return Markup(
            '<figure id="{}"><div class="wide" tabindex="0">{}</div>'
            '<figcaption>{} <span class="source">Data: {}</span></figcaption></figure>'
        ).format(self.anchor, draw_svg(self.draw, name=self.anchor, alt=alt), _caption(self), links)


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
    """All that a section's template can name, besides what ``chapters`` gives to all of them."""

    tables: Mapping[str, Any] = field(default_factory=dict)
    """Tables, and other things that print themselves."""
    figures: Mapping[str, Figure] = field(default_factory=dict)
    claims: Sequence[Claim] = ()
    downloads: Sequence[Download] = ()
    unmeasured: Collection[str] = ()
    """What only other records have, so that the words for it stay unsaid."""

    def worded(self, anchor: str, place: str, words: Mapping[tuple[str, str], Wording]) -> "Section":
        """The same with the words of the template; ReportError unless each thing has its words, and they their thing.

        Args:
            anchor: How the ids of its figures begin.
            place: The template, to name in errors.
            words: What the template says, by kind and name.
        """
        claims = {claim.name: claim for claim in self.claims}
        things = {"claim": claims, "figure": self.figures, "table": self.tables}
        for (kind, name), wording in words.items():
            if name not in things[kind] and name not in self.unmeasured:
                raise ReportError(f"{wording.place}: there is no {kind} {name}; there are: {', '.join(things[kind])}")
        found: dict[str, dict[str, Any]] = {kind: {} for kind in things}
        for kind, named in things.items():
            for name, thing in named.items():
                if (kind, name) not in words:
                    raise ReportError(f"templates/{place} says nothing of the {kind} {name}")
                wording = words[kind, name]
                if hasattr(thing, "wording"):
                    wording.refuse_unknown(f"{kind} {name}", thing.numbers)
                    thing = replace(thing, wording=wording)
                    thing = thing.settled() if kind == "claim" else thing
                found[kind][name] = replace(thing, anchor=f"{anchor}-{name}") if kind == "figure" else thing
        return replace(self, claims=list(found["claim"].values()), figures=found["figure"], tables=found["table"])


def _caption(thing: Table | Figure) -> Markup:
    assert thing.wording, "a caption is printed before the template has given its words"
    return thing.wording("caption", thing.numbers)


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
