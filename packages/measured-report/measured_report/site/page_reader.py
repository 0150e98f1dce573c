"""A reader of a built site's pages, as far as they are checked."""

from dataclasses import dataclass
from html.parser import HTMLParser

SCRIPT = "page.js"
"""The one script that pages run: the project's own, beside them."""

FETCHING = {"src", "srcset", "poster", "data", "xlink:href", "background", "action", "formaction", "ping", "manifest"}
"""Attributes whose address a browser fetches or sends to, as it does every href but that of ``a``."""
ACTIVE = {"script", "iframe", "frame", "object", "embed", "applet", "base", "form", "portal", "set", "animate"}
"""Elements that run, hold another page, or change where links lead."""
PICTURES = {"svg", "img", "video", "canvas"}
"""Elements that say in words what they show."""


@dataclass
class Drawn:
    """Holds a text of a drawing, or what it says to whoever can't see it, with pointers to its numbers."""

    text: str
    sources: list[str]
    is_drawn: bool = True
    """Set where there may be little room."""
    is_tick: bool = False
    """Set at an axis, where numbers are places and not measurements."""


class PageReader(HTMLParser):
    """Read the HTML of a page."""

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
        is_file = (
            tag == "script" and attributes.get("src", "").endswith(".js") and attributes.keys() <= {"src", "defer"}
        )
        is_active = tag in ACTIVE and not is_inline and not is_file
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
        if tag == "td":
            self.cells.append("")
        if tag == "g":
            self._ticks.append(attributes.get("class") == "tick")
        sources = attributes.get("data-src", "").split()
        if tag == "text":
            self.drawn.append(Drawn("", sources, is_tick=any(self._ticks)))
        said = attributes.get("aria-label") or attributes.get("alt")
        if tag in PICTURES and said:
            self.drawn.append(Drawn(said, sources, is_drawn=False))
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
