"""Check of a built site: what it shows is what was measured, and it needs nothing from elsewhere."""

import json
import re
from collections.abc import Mapping
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from urllib.parse import SplitResult, unquote, urlsplit

from report import ROOT
from report.format import format_code, format_number
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
FETCHING_STYLE = re.compile(r"@import|url\(\s*['\"]?(?!#|data:)", re.IGNORECASE)


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
        self.claims: list[dict[str, str]] = []
        self.styles = ""
        self._open: list[str] = []
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
        if tag == "data":
            self.numbers.append({**attributes, "text": "", "in": "code" if "code" in self._open else ""})
        if "data-claim" in attributes:
            self.claims.append(attributes)

    def handle_data(self, data):
        tag = self._open[-1] if self._open else ""
        if tag == "data":
            self.numbers[-1]["text"] += data
        if tag == "style":
            self.styles += data
        if tag == "script" and self.inline:
            self.inline[-1] += data
        elif tag == "script" and data.strip():
            self.scripts.append(tag)

    def handle_endtag(self, tag):
        while self._open and self._open.pop() != tag:
            pass


def check_site(site: Path) -> list[str]:
    """What is wrong with the site in folder ``site``, a line each; empty when nothing is."""
    problems = []
    pages = {path.resolve(): Reading(path.read_text(encoding="utf-8")) for path in sorted(site.rglob("*.html"))}
    for path, reading in pages.items():
        found = [*_check_self_contained(reading), *_check_links(reading, path, pages, site), *_check_claims(reading)]
        found += _check_numbers(reading, path.parent / "data")
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


def _check_self_contained(reading: Reading) -> list[str]:
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


def _check_numbers(reading: Reading, data: Path) -> list[str]:
    problems = []
    files: dict[str, Any] = {}
    for number in reading.numbers:
        name, _, pointer = number.get("data-src", "").partition("#")
        try:
            if name not in files:
                files[name] = json.loads((data / name).read_text(encoding="utf-8"))
            kept = _resolve(files[name], pointer)
            kept = kept["value"] if name.endswith(VALUES_FILE) else kept
        except (OSError, ValueError, LookupError, TypeError):
            problems.append(f"{number.get('data-src')} resolves to nothing")
            continue
        shown = json.loads(number["value"]) if number.get("value") else None
        write = format_code if number["in"] == "code" else format_number
        if shown != kept or number["text"] != write(kept):
            problems.append(f"{number['data-src']} is {kept}, but {number['text']} ({shown}) is shown")
    return problems


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
