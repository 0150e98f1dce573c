"""Macros: the HTML of what a section prints, ``pages/layout/parts.html.j2``; and a drawing as they show it."""

from functools import cache, partial
from pathlib import Path
from typing import Any, NamedTuple

import jinja2
from markupsafe import Markup

FILE = Path(__file__).parents[1] / "pages" / "layout" / "parts.html.j2"
RULES: dict[str, Any] = {"autoescape": True, "trim_blocks": True, "lstrip_blocks": True}
environment = partial(jinja2.Environment, undefined=jinja2.StrictUndefined, **RULES)


@cache
def macros(file: Path = FILE) -> Any:
    """Compile the macros of a template, which are the names of what is returned."""
    return environment(loader=jinja2.FileSystemLoader(file.parent)).get_template(file.name).module


class Picture(NamedTuple):
    """Hold a drawing in SVG, of which the element itself is left out."""

    kind: str  # `broad` or `narrow`: the screens that it is for
    view: str  # the box that it shows, as an SVG element has it
    content: Markup

    @property
    def size(self) -> list[int]:
        """Return width and height, as far as their proportion goes."""
        return [round(float(side)) for side in self.view.split()[2:]]
