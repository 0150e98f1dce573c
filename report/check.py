"""Check of a built site: what it shows is what was measured, and it needs nothing from elsewhere."""

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from urllib.parse import SplitResult, unquote, urlsplit

from report import ROOT
from report.format import format_code, format_number, spellings, whole
from report.names import name_of
from report.noise import NOISE, Floor, cell_noise, floors_of
from report.quantities import VALUES_FILE
from report.replay import script

SCRIPT = "page.js"
"""The one script that pages run: the project's own, beside them."""

FETCHING = {"src", "srcset", "poster", "data", "xlink:href", "background", "action", "formaction", "ping", "manifest"}
"""Attributes whose address a browser fetches or sends to, as it does every href but that of ``a``."""
ACTIVE = {"script", "iframe", "frame", "object", "embed", "applet", "base", "form", "portal"}
"""Elements that run, hold another page, or change where links lead."""
SCHEMES = {"", "http", "https", "mailto"}
"""What a link may begin with: a page may lead anywhere, but nothing that it leads to may run in it."""
BLANK = re.compile("[\x00-\x20\x7f-\x9f]")
OUTCOMES = {"holds", "fails", "unknown"}
PICTURES = {"svg", "img", "video", "canvas"}
"""What says in words what it shows."""
TYPED = re.compile(
    r"kd = 2√ke|2/kd = 2·dt|dt² ke \+ 2 dt kd > 4|clamped to 2 dt|damping ratio 1\b|^[12]\. |RK4|link7|1/s"
    r"|[\d\u202f]+ worlds?|\d+ runs(?: in \d+ sections)?|Newton \d+\.\d+\.\d+"
)
"""Numbers in drawings and in their words that are names and formulas."""
FETCHING_STYLE = re.compile(r"@import|url\(\s*['\"]?(?!#|data:)", re.IGNORECASE)


@dataclass
class Drawn:
    """A text of a drawing, or what it says to whoever can't see it."""

    text: str
    sources: list[str]
    """Pointers to its numbers."""
    is_drawn: bool = True
    """Whether it may have little room."""
    is_tick: bool = False
    """Whether it stands at an axis, where numbers are places and not measurements."""


@dataclass
class Data:
    """What a page's numbers point into."""

    folder: Path
    _files: dict[str, Any] = field(default_factory=dict)

    def file(self, name: str) -> Any:
        if name not in self._files:
            self._files[name] = json.loads((self.folder / name).read_text(encoding="utf-8"))
        return self._files[name]

    def number(self, source: str) -> tuple[float | int | None, float | None]:
        """A number and its noise; an error where the pointer leads to none."""
        name, _, pointer = source.partition("#")
        kept = _resolve(self.file(name), pointer)
        if name.endswith(VALUES_FILE):
            return kept["value"], kept["noise"]
        place, _, column = pointer.rpartition("/")
        is_cell = pointer.startswith("/rows/")
        return kept, cell_noise(column, _resolve(self.file(name), place), self._floors(name)) if is_cell else None

    def _floors(self, name: str) -> Mapping[str, Floor]:
        noise = f"{name.rpartition('/')[0]}/{NOISE}.json"
        if not (self.folder / noise).is_file():
            return {}
        if noise not in self._floors_of:
            self._floors_of[noise] = floors_of(self.file(noise)["rows"], self.file(noise)["units"])
        return self._floors_of[noise]

    _floors_of: dict[str, Mapping[str, Floor]] = field(default_factory=dict)

    @cached_property
    def names(self) -> re.Pattern:
        """What cases with a number in their names are called, in whole and in parts."""
        files = self.folder.glob("newton-*/*.json")
        records = [self.file(str(path.relative_to(self.folder))) for path in files if path.name != VALUES_FILE]
        whole = {name_of(row["case"]) for record in records for row in record["rows"] if "case" in row}
        names = {part for name in whole for part in (name, *name.split(", ")) if re.search(r"\d", part)}
        longest_first = sorted(names, key=len, reverse=True)
        return re.compile(rf"(?<![\w.])(?:{'|'.join(map(re.escape, longest_first))})(?![\w.]*\d)")


class Reading(HTMLParser):
    """What a page holds, as far as it is checked."""

    def __init__(self, html: str):
        super().__init__()
        self.ids: list[str] = []
        self.links: list[str] = []
        self.fetched: list[str] = []
        self.scripts: list[str] = []
        self.inline: list[str] = []
        self.numbers: list[dict[str, str]] = []
        self.drawn: list[Drawn] = []
        self.claims: list[dict[str, str]] = []
        self.styles = ""
        self._open: list[str] = []
        self._ticks: list[bool] = []
        self.feed(html)

    def handle_starttag(self, tag, attrs):
        attributes = {name: value or "" for name, value in attrs}
        self._open.append(tag)
        is_own = tag == "script" and attributes == {"src": SCRIPT}
        is_inline = tag == "script" and not attributes  # judged by what it holds
        self.inline += [""] if is_inline else []
        is_active = tag in ACTIVE and not is_own and not is_inline
        if is_active or any(name.startswith("on") or name == "srcdoc" for name in attributes):
            self.scripts.append(tag)
        if tag == "meta" and "refresh" in attributes.get("http-equiv", "").lower():
            self.scripts.append(tag)
        if tag == "script" and not is_inline:
            self.fetched.append(attributes.get("src", ""))
        if "id" in attributes:
            self.ids.append(attributes["id"])
        if "href" in attributes:
            (self.links if tag == "a" else self.fetched).append(attributes["href"])
        self.fetched += [value for name, value in attributes.items() if name in FETCHING]
        self.styles += attributes.get("style", "")
        if tag == "g":
            self._ticks.append(attributes.get("class") == "tick")
        if tag == "text":
            self.drawn.append(Drawn("", attributes.get("data-src", "").split(), is_tick=any(self._ticks)))
        if tag in PICTURES and "aria-label" in attributes:
            sources = attributes.get("data-src", "").split()
            self.drawn.append(Drawn(attributes["aria-label"], sources, is_drawn=False))
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


def check_site(site: Path) -> list[str]:
    """What is wrong with the site in folder ``site``, a line each; empty when nothing is."""
    problems = []
    pages = {path.resolve(): Reading(path.read_text(encoding="utf-8")) for path in sorted(site.rglob("*.html"))}
    data_of: dict[Path, Data] = {}
    for path, reading in pages.items():
        found = [*check_self_contained(reading), *_check_links(reading, path, pages, site), *_check_claims(reading)]
        data = data_of.setdefault(path.parent, Data(path.parent / "data"))
        found += [*_check_numbers(reading, data), *_check_drawn(reading, data)]
        problems += [f"{path.relative_to(site.resolve())}: {problem}" for problem in found]
    for folder in {path.parent for path in pages}:
        claims = [claim for path, reading in pages.items() if path.parent == folder for claim in reading.claims]
        if not claims:
            problems.append(f"{folder.relative_to(site.resolve()) / 'index.html'}: there is no claim on any page")
    for path in sorted(site.rglob("*.js")):
        if path.name != SCRIPT or path.read_bytes() != (ROOT / "assets" / SCRIPT).read_bytes():
            problems.append(f"{path.relative_to(site)} is not the project's script")
    for path in sorted(site.rglob("*.css")):
        if FETCHING_STYLE.search(path.read_text(encoding="utf-8")):
            problems.append(f"{path.relative_to(site)} fetches something")
    if not (site / "index.html").is_file():
        problems.append("there is no index.html")
    return problems


def check_self_contained(reading: Reading) -> list[str]:
    """What a page runs or fetches that is not the project's, a line each."""
    problems = [f"<{tag}> runs a script" for tag in reading.scripts]
    problems += ["a script runs that is not the project's own" for text in reading.inline if text != script()]
    problems += [f"{address} is fetched from elsewhere" for address in reading.fetched if _is_elsewhere(address)]
    return problems + (["a style fetches something"] if FETCHING_STYLE.search(reading.styles) else [])


def _check_links(reading: Reading, page: Path, pages: Mapping[Path, Reading], site: Path) -> list[str]:
    problems = [f"the id {name} is not unique" for name in sorted(set(reading.ids)) if reading.ids.count(name) > 1]
    for address in reading.links + reading.fetched:
        parts = _parts(address)
        if address in reading.links and parts.scheme not in SCHEMES:
            problems.append(f"{address} is no address that a page may lead to")
        if parts.scheme or parts.netloc:
            continue
        target = (page.parent / unquote(parts.path)).resolve() if parts.path else page
        if parts.path.startswith("/") or not target.is_relative_to(site.resolve()):
            problems.append(f"{address} leaves the site")
        elif not target.exists() or (
            target in pages and parts.fragment and unquote(parts.fragment) not in pages[target].ids
        ):
            problems.append(f"{address} leads nowhere")
    return problems


def _check_claims(reading: Reading) -> list[str]:
    return [
        f"the claim {claim['data-claim']} has no outcome"
        for claim in reading.claims
        if claim.get("data-outcome") not in OUTCOMES
    ]


def _check_numbers(reading: Reading, data: Data) -> list[str]:
    problems = []
    for number in reading.numbers:
        source = number.get("data-src", "")
        try:
            kept, noise = data.number(source)
        except (OSError, ValueError, LookupError, TypeError):
            problems.append(f"{number.get('data-src')} resolves to nothing")
            continue
        shown = json.loads(number["value"]) if number.get("value") else None
        text = format_code(kept) if number["in"] == "code" else format_number(kept, noise=noise)
        if shown != kept or number["text"] != text:
            problems.append(f"{source} is {kept}, but {number['text']} ({shown}) is shown")
    return problems


def _check_drawn(reading: Reading, data: Data) -> list[str]:
    """Every number of a drawing, and of its words, is what its source says; what has none is a name or a tick."""
    problems = []
    for drawn in reading.drawn:
        rest = drawn.text
        for source in drawn.sources:
            try:
                texts = spellings(*data.number(source))[: None if drawn.is_drawn else 1]
            except (OSError, ValueError, LookupError, TypeError):
                problems.append(f"{source} resolves to nothing")
                continue
            found = [whole(text) for text in texts if whole(text).search(rest)]
            if not found:
                problems.append(f"{source} is {data.number(source)[0]}, which is not said by: {drawn.text}")
            else:
                rest = found[0].sub("", rest, count=1)
        if not drawn.is_tick and re.search(r"\d", rest) and (number := re.search(r"\d\S*", _unnamed(rest, data))):
            problems.append(f"the number {number[0]} leads nowhere in: {drawn.text}")
    return problems


def _unnamed(text: str, data: Data) -> str:
    """What is left of a text without names and formulas."""
    return data.names.sub("", TYPED.sub("", text))


def _resolve(data: Any, pointer: str) -> Any:
    for part in pointer.removeprefix("/").split("/"):
        data = data[int(part)] if isinstance(data, list) else data[part]
    return data


def _is_elsewhere(address: str) -> bool:
    parts = _parts(address)
    is_image = parts.scheme == "data" and parts.path.startswith((",", "image/", "font/"))
    return bool(parts.netloc or (parts.scheme and not is_image))


def _parts(address: str) -> SplitResult:
    """An address as browsers read it, which pass over blanks and control characters, and take \\ for /."""
    try:
        return urlsplit(BLANK.sub("", address).replace("\\", "/"))
    except ValueError:
        return SplitResult("unreadable", "", "", "", "")
