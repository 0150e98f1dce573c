"""Macros: the HTML of what a section prints, ``pages/layout/parts.html.j2``; and a drawing as they show it."""

from collections.abc import Sequence
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

import jinja2
from markupsafe import Markup

from measured_report.files.config import config

FILE = Path(__file__).parents[1] / "pages" / "layout" / "parts.html.j2"


@cache
def macros() -> Any:
    """Compile the macros, which are the names of what is returned."""
    loader = jinja2.FileSystemLoader(FILE.parent)
    environment = jinja2.Environment(
        loader=loader, undefined=jinja2.StrictUndefined, autoescape=True, trim_blocks=True, lstrip_blocks=True
    )
    environment.globals["repository"] = lambda: config().repository
    return environment.get_template(FILE.name).module


class Picture(NamedTuple):
    """Hold a drawing in SVG, of which the element itself is left out."""

    kind: str
    """``broad`` or ``narrow``: the screens that it is for."""
    view: str
    """The box that it shows, as an SVG element has it."""
    content: Markup

    def __html__(self) -> Markup:
        return self.html("", ())

    def html(self, alt: str, sources: Sequence[str]) -> Markup:
        """Show it on a page, with what it says to whoever can't see it and where the numbers in that are from."""
        return macros().drawing(self, alt, sources)

    @property
    def file(self) -> str:
        """Return it as a file: an image has the scheme of the page that it is on, and nothing else of it."""
        return macros().drawing_file(self)

    @property
    def size(self) -> list[int]:
        """Return width and height, as far as their proportion goes."""
        return [round(float(side)) for side in self.view.split()[2:]]
