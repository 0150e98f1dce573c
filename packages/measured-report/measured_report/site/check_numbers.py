"""Check of the numbers on a page, in sentences, tables and drawings: each is what its source says."""

import json
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache, cached_property
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

from measured_report.files.config import Report
from measured_report.findings.sections import file_of, outline_of
from measured_report.records.replicas import measurements_beside, read_replica
from measured_report.values.cells import evidence_of
from measured_report.values.evidence import Evidence, Repeated, repeats_of
from measured_report.values.format import (
    WRITES,
    format_code,
    format_short,
    label_of,
    number_pattern,
    read_number,
)
from measured_report.values.quantities import VALUES_FILE

SCRIPT = "page.js"  # the one script that pages run: the project's own, beside them
FETCHING = {
    "src",
    "srcset",
    "poster",
    "data",
    "xlink:href",
    "background",
    "action",
    "formaction",
    "ping",
    "manifest",
}
"""Attributes whose address a browser fetches or sends to, as it does every href but that of ``a``."""
ACTIVE = {
    "script",
    "iframe",
    "frame",
    "object",
    "embed",
    "applet",
    "base",
    "form",
    "portal",
    "set",
    "animate",
}
"""Elements that run, hold another page, or change where links lead."""
INLINE = (
    "a",
    "abbr",
    "b",
    "code",
    "em",
    "i",
    "span",
    "strong",
    "sub",
    "sup",
)  # none of which a browser closes itself
DOUBLED = re.compile(r"</data>&nbsp;(\S+)\s+\1(?!\w)")


@dataclass
class Element:
    tag: str
    attributes: dict[str, str]
    around: list[
        str
    ]  # tags of the elements that it is in; `tick` for one at an axis, where numbers are places
    text: str = ""  # its own; of a cell all in it but numbers and code

    @property
    def is_active(self) -> bool:
        """Tell whether it may run what is neither judged by its text nor a file of the site."""
        names = self.attributes.keys()
        if any(name.startswith("on") or name == "srcdoc" for name in names):
            return True
        if self.tag == "meta":
            return "refresh" in self.attributes.get("http-equiv", "").lower()
        if self.tag != "script" or not names:
            return self.tag in ACTIVE - {"script"}
        # A file's bytes are checked where they lie, so that it need only be one of the site.
        is_file = self.attributes.get("src", "").endswith(".js")
        return not is_file or not names <= {"src", "defer"} or bool(self.text.strip())


class PageReader(HTMLParser):
    """Reads a page or a drawing as a list of elements, and of what they lead to, fetch and run."""

    def __init__(self, html: str):
        super().__init__()
        self.elements: list[Element] = []
        self._open: list[Element] = []
        self.feed(html)
        self.ids: list[str] = []
        self.links: list[str] = []
        self.fetched: list[str] = []
        self.styles = "".join(element.text for element in self.of("style"))
        for element in self.elements:
            is_named = element.attributes.get("rel") in ("canonical", "alternate")
            for name, value in element.attributes.items():
                if name == "id":
                    self.ids.append(value)
                elif name == "style":
                    self.styles += value
                elif name == "href" and element.tag == "a":
                    self.links.append(value)
                elif name in FETCHING or (name == "href" and not is_named):
                    self.fetched.append(value)
        self.active = [element.tag for element in self.elements if element.is_active]
        scripts = self.of("script")
        self.inline = [script.text for script in scripts if not script.attributes]
        claims = [element.attributes for element in self.elements]
        self.claims = [claim for claim in claims if "data-claim" in claim]
        units = DOUBLED.findall(html)
        self.faults = [f"{unit} stands twice behind a number" for unit in units]
        for tag in INLINE:
            if len(self.of(tag)) != html.count(f"</{tag}>"):
                self.faults.append(f"<{tag}> is not closed")

    def of(self, tag: str) -> list[Element]:
        return [element for element in self.elements if element.tag == tag]

    def handle_starttag(
        self, tag: str, attrs: Sequence[tuple[str, str | None]]
    ) -> None:
        around = [
            "tick" if element.attributes.get("class") == "tick" else element.tag
            for element in self._open
        ]
        attributes = {name: value or "" for name, value in attrs}
        self._open.append(Element(tag, attributes, around))
        self.elements.append(self._open[-1])

    def handle_data(self, data: str) -> None:
        is_plain = {"data", "code"}.isdisjoint(element.tag for element in self._open)
        for element in self._open:
            if element is self._open[-1] or (element.tag == "td" and is_plain):
                element.text += data

    def handle_endtag(self, tag: str) -> None:
        while self._open and self._open.pop().tag != tag:
            pass


UNRESOLVED = (OSError, ValueError, LookupError, TypeError)
RELEASE = r" \d+(?:\.\w+)+(?:[+@-]\w+(?:\.\w+)*)*"


class Data:
    """Read the data that a page's numbers point into."""

    def __init__(self, folder: Path, report: Report):
        self.folder, self.report = folder, report
        self.file, self._evidence, self._repeats = (
            cache(self._read),
            cache(self._evidence_of),
            cache(self._repeats_in),
        )
        self._replica = cache(read_replica)  # which is of all sections

    def _read(self, name: str) -> Any:
        return json.loads((self.folder / name).read_text(encoding="utf-8"))

    def number(self, source: str) -> tuple[float | int | None, float | None]:
        """Return a number and its noise; an error where the pointer leads to none."""
        name, _, pointer = source.partition("#")
        cell = _resolve(self.file(name), pointer)
        if name.endswith(VALUES_FILE):
            return cell["value"], cell["noise"]
        if not pointer.startswith("/rows/"):
            return cell, None
        row_pointer, _, column = pointer.rpartition("/")
        row = _resolve(self.file(name), row_pointer)
        cell = self.report.columns.number_of(column, row)
        estimate = self._evidence(name).estimate(column, row, self.report.columns)
        return cell, estimate.written_noise if estimate else None

    def _evidence_of(self, name: str) -> Evidence:
        records = measurements_beside(self.folder / name, self._replica)
        return evidence_of(
            {name: records}, self._repeats(Path(name).parent), self.report.columns
        )[name]

    def _repeats_in(self, folder: Path) -> Repeated:
        noise = folder / f"{self.report.settings.noise_section}.json"
        if not (self.folder / noise).is_file():
            return {}
        return repeats_of(self.file(str(noise))["rows"], self.report.columns)

    @cached_property
    def typed(self) -> re.Pattern[str]:
        """Match numbers in drawings and in their words that are names and formulas."""
        settings = self.report.settings
        edition = (
            [re.escape(settings.edition_name) + RELEASE]
            if settings.edition_name
            else []
        )
        return re.compile("|".join([*settings.formulas, *edition]) or "(?!)")

    @cached_property
    def names(self) -> re.Pattern[str]:
        """Match what has a number in it and is none: labels of cases, whole and in parts, and the texts of records."""
        names: set[str] = set()
        for path in self.folder.glob("*/*.json"):
            if path.name != VALUES_FILE:
                rows = self.file(str(path.relative_to(self.folder)))["rows"]
                labels = (
                    outline_of(path.stem, self.report).labels
                    if file_of("report.sections", path.stem)
                    else {}
                )
                names |= {
                    " ".join(cell.split())
                    for row in rows
                    for cell in row.values()
                    if isinstance(cell, str)
                }
                for label in (
                    label_of(row["case"], labels) for row in rows if "case" in row
                ):
                    names |= {label, *label.split(", ")}
        longest_first = sorted(
            (name for name in names if re.search(r"\d", name)), key=len, reverse=True
        )
        return re.compile(
            rf"(?<![\w.])(?:{'|'.join(map(re.escape, longest_first))})(?![\w.]*\d)"
        )


def check_numbers(page: PageReader, data: Data) -> list[str]:
    """Say what is wrong with the numbers of a page, a line each."""
    cells = ((cell.text.strip(), _unnamed(cell.text, data)) for cell in page.of("td"))
    unnamed = [
        f"the number {number} leads nowhere in the cell: {text}"
        for text, number in cells
        if number
    ]
    return [*_check_written(page, data), *_check_drawn(page, data), *unnamed]


def _check_written(page: PageReader, data: Data) -> Iterator[str]:
    for element in page.of("data"):
        source, printed = element.attributes.get("data-src", ""), element.text
        try:
            value, noise = data.number(source)
            write = WRITES[element.attributes.get("data-as", "")]
            text = (
                format_code(value)
                if "code" in element.around
                else write(value, noise=noise)
            )
        except UNRESOLVED:
            yield f"{source} resolves to nothing"
            continue
        stated = json.loads(element.attributes.get("value") or "null")
        if stated != value or printed != text:
            yield f"{source} is {value}, but {printed} ({stated}) is shown"
        elif (
            value
            and noise
            and (rounded := read_number(text)) is not None
            and abs(float(rounded) - value) > noise
        ):
            yield f"{source} is {value} within {noise}, and rounded to {text}"


def _check_drawn(page: PageReader, data: Data) -> Iterator[str]:
    """Check the texts of drawings, and what pictures say to whoever can't see them."""
    for element in page.elements:
        label = element.attributes.get("aria-label") or element.attributes.get("alt")
        if element.tag != "text" and not (
            element.tag in ("svg", "img", "video", "canvas") and label
        ):
            continue
        remaining = text = element.text if element.tag == "text" else str(label)
        for source in element.attributes.get("data-src", "").split():
            try:
                value, noise = data.number(source)
                written = [write(value, noise=noise) for write in WRITES.values()]
                written += [] if value is None or value < 0 else [format_short(value)]
            except UNRESOLVED:
                yield f"{source} resolves to nothing"
                continue
            if pattern := next(
                (
                    form
                    for form in map(number_pattern, written)
                    if form.search(remaining)
                ),
                None,
            ):
                remaining = pattern.sub("", remaining, count=1)
            else:
                yield f"{source} is {value}, which is not said by: {text}"
        if not (element.tag == "text" and "tick" in element.around) and (
            number := _unnamed(remaining, data)
        ):
            yield f"the number {number} leads nowhere in: {text}"


def _unnamed(text: str, data: Data) -> str:
    """Return the first number in a text that is no part of a name or a formula; empty where there is none."""
    number = re.search(
        r"\d\S*",
        data.names.sub("", data.typed.sub("", text)) if re.search(r"\d", text) else "",
    )
    return number[0] if number else ""


def _resolve(data: Any, pointer: str) -> Any:
    for key in pointer.removeprefix("/").split("/"):
        data = data[int(key)] if isinstance(data, list) else data[key]
    return data
