"""Check of the numbers on a page, in sentences, tables and drawings: each is what its source says."""

import json
import re
from dataclasses import dataclass
from functools import cache, cached_property
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

from measured_report.files.config import config
from measured_report.findings.sections import labels_of
from measured_report.records.columns import number_of
from measured_report.records.replicas import measurements_beside, read_replica
from measured_report.values.evidence import Evidence, Repeated, evidence_of, repeats_of
from measured_report.values.format import (
    format_code,
    format_least,
    format_most,
    format_number,
    format_short,
    label_of,
    read_number,
    whole,
)
from measured_report.values.quantities import LEAST, MOST, VALUES_FILE

SCRIPT = "page.js"  # the one script that pages run: the project's own, beside them
FETCHING = {"src", "srcset", "poster", "data", "xlink:href", "background", "action", "formaction", "ping", "manifest"}
"""Attributes whose address a browser fetches or sends to, as it does every href but that of ``a``."""
ACTIVE = {"script", "iframe", "frame", "object", "embed", "applet", "base", "form", "portal", "set", "animate"}
"""Elements that run, hold another page, or change where links lead."""
PICTURES = {"svg", "img", "video", "canvas"}


@dataclass
class Drawn:
    """Holds a text of a drawing, or what it says to whoever can't see it, with pointers to its numbers."""

    text: str
    sources: list[str]
    is_tick: bool = False  # set at an axis, where numbers are places and not measurements


class PageReader(HTMLParser):
    def __init__(self, html: str):
        super().__init__()
        self.ids: list[str] = []
        self.links: list[str] = []
        self.fetched: list[str] = []
        self.scripts: list[str] = []
        self.inline: list[str] = []
        self.numbers: list[dict[str, str]] = []
        self.drawn: list[Drawn] = []
        self.cells: list[str] = []
        self.claims: list[dict[str, str]] = []
        self.styles = ""
        self._open: list[str] = []
        self._ticks: list[bool] = []
        self.feed(html)

    def handle_starttag(self, tag, attrs):
        attributes = {name: value or "" for name, value in attrs}
        self._open.append(tag)
        is_inline = tag == "script" and not attributes  # judged by what it holds
        self.inline += [""] if is_inline else []
        # A file's bytes are checked where they lie, so that it need only be one of the site.
        address = attributes.get("src", "")
        is_file = tag == "script" and address.endswith(".js") and attributes.keys() <= {"src", "defer"}
        is_active = tag in ACTIVE and not is_inline and not is_file
        leads_on = tag == "meta" and "refresh" in attributes.get("http-equiv", "").lower()
        if is_active or leads_on or any(name.startswith("on") or name == "srcdoc" for name in attributes):
            self.scripts.append(tag)
        if "id" in attributes:
            self.ids.append(attributes["id"])
        if "href" in attributes:
            (self.links if tag == "a" else self.fetched).append(attributes["href"])
        self.fetched += [value for name, value in attributes.items() if name in FETCHING]
        self.styles += attributes.get("style", "")
        if tag == "td":
            self.cells.append("")
        if tag == "g":
            self._ticks.append(attributes.get("class") == "tick")
        sources = attributes.get("data-src", "").split()
        if tag == "text":
            self.drawn.append(Drawn("", sources, is_tick=any(self._ticks)))
        said = attributes.get("aria-label") or attributes.get("alt")
        if tag in PICTURES and said:
            self.drawn.append(Drawn(said, sources))
        if tag == "data":
            self.numbers.append({**attributes, "text": "", "in": "code" if "code" in self._open else ""})
        if "data-claim" in attributes:
            self.claims.append(attributes)

    def handle_data(self, data):
        tag = self._open[-1] if self._open else ""
        if tag == "data":
            self.numbers[-1]["text"] += data
        if tag == "text":
            self.drawn[-1].text += data
        if "td" in self._open and not {"data", "code"} & set(self._open):
            self.cells[-1] += data
        if tag == "style":
            self.styles += data
        if tag == "script" and self.inline:
            self.inline[-1] += data
        elif tag == "script" and data.strip():
            self.scripts.append(tag)

    def handle_endtag(self, tag):
        if tag == "g" and self._ticks:
            self._ticks.pop()
        while self._open and self._open.pop() != tag:
            pass


WRITES = {"": format_number, MOST: format_most, LEAST: format_least}  # by how a page says that a number is written
RELEASE = r" \d+(?:\.\w+)+(?:[+@-]\w+(?:\.\w+)*)*"


class Data:
    """Read the data that a page's numbers point into."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.file, self._evidence, self._repeats = cache(self._read), cache(self._evidence_of), cache(self._repeats_in)
        self._replica = cache(read_replica)  # which is of all sections

    def _read(self, name: str) -> Any:
        return json.loads((self.folder / name).read_text(encoding="utf-8"))

    def number(self, source: str) -> tuple[float | int | None, float | None]:
        """Return a number and its noise; an error where the pointer leads to none."""
        name, _, pointer = source.partition("#")
        kept = _resolve(self.file(name), pointer)
        if name.endswith(VALUES_FILE):
            return kept["value"], kept["noise"]
        if not pointer.startswith("/rows/"):
            return kept, None
        place, _, column = pointer.rpartition("/")
        row = _resolve(self.file(name), place)
        kept = number_of(column, row)
        known = self._evidence(name).estimate(column, row)
        return kept, known.written_noise if known else None

    def _evidence_of(self, name: str) -> Evidence:
        return evidence_of(measurements_beside(self.folder / name, self._replica), self._repeats(Path(name).parent))

    def _repeats_in(self, folder: Path) -> Repeated:
        noise = folder / f"{config().noise_section}.json"
        return repeats_of(self.file(str(noise))["rows"]) if (self.folder / noise).is_file() else {}

    @cached_property
    def typed(self) -> re.Pattern:
        """Match numbers in drawings and in their words that are names and formulas."""
        edition = [re.escape(config().edition_name) + RELEASE] if config().edition_name else []
        return re.compile("|".join([*config().formulas, *edition]) or "(?!)")

    @cached_property
    def names(self) -> re.Pattern:
        """Match what has a number in it and is none: labels of cases, whole and in parts, and the texts of records."""
        names: set[str] = set()
        for path in self.folder.glob("*/*.json"):
            if path.name != VALUES_FILE:
                rows, labels = self.file(str(path.relative_to(self.folder)))["rows"], labels_of(path.stem)
                names |= {" ".join(cell.split()) for row in rows for cell in row.values() if isinstance(cell, str)}
                for label in (label_of(row["case"], labels) for row in rows if "case" in row):
                    names |= {label, *label.split(", ")}
        longest_first = sorted((name for name in names if re.search(r"\d", name)), key=len, reverse=True)
        return re.compile(rf"(?<![\w.])(?:{'|'.join(map(re.escape, longest_first))})(?![\w.]*\d)")


def check_numbers(page: PageReader, data: Data) -> list[str]:
    """Say what is wrong with the numbers of a page, a line each."""
    problems = [*_check_written(page, data), *_check_drawn(page, data)]
    for cell in (cell for cell in page.cells if re.search(r"\d", cell)):
        if number := re.search(r"\d\S*", _unnamed(cell, data)):
            problems.append(f"the number {number[0]} leads nowhere in the cell: {cell.strip()}")
    return problems


def _check_written(page: PageReader, data: Data) -> list[str]:
    problems = []
    for number in page.numbers:
        source = number.get("data-src", "")
        try:
            kept, noise = data.number(source)
            is_code, how = number["in"] == "code", number.get("data-as", "")
            text = format_code(kept) if is_code else WRITES[how](kept, noise=noise)
        except (OSError, ValueError, LookupError, TypeError):
            problems.append(f"{number.get('data-src')} resolves to nothing")
            continue
        shown = json.loads(number["value"]) if number.get("value") else None
        if shown != kept or number["text"] != text:
            problems.append(f"{source} is {kept}, but {number['text']} ({shown}) is shown")
        elif kept and noise and (said := read_number(text)) is not None and abs(float(said) - kept) > noise:
            problems.append(f"{source} is {kept} within {noise}, and rounded to {text}")
    return problems


def _check_drawn(page: PageReader, data: Data) -> list[str]:
    problems = []
    for drawn in page.drawn:
        rest = drawn.text
        for source in drawn.sources:
            try:
                value, noise = data.number(source)
                texts = [write(value, noise=noise) for write in WRITES.values()]
                texts += [] if value is None or value < 0 else [format_short(value)]
            except (OSError, ValueError, LookupError, TypeError):
                problems.append(f"{source} resolves to nothing")
                continue
            found = [whole(text) for text in texts if whole(text).search(rest)]
            if not found:
                problems.append(f"{source} is {value}, which is not said by: {drawn.text}")
            else:
                rest = found[0].sub("", rest, count=1)
        if not drawn.is_tick and re.search(r"\d", rest) and (number := re.search(r"\d\S*", _unnamed(rest, data))):
            problems.append(f"the number {number[0]} leads nowhere in: {drawn.text}")
    return problems


def _unnamed(text: str, data: Data) -> str:
    return data.names.sub("", data.typed.sub("", text))


def _resolve(data: Any, pointer: str) -> Any:
    for part in pointer.removeprefix("/").split("/"):
        data = data[int(part)] if isinstance(data, list) else data[part]
    return data
