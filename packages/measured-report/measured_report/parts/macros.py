"""Macros: the HTML of what a section prints, ``pages/layout/parts.html.j2``, and drawings."""

from functools import cache, partial
from pathlib import Path
from typing import Any, NamedTuple

import jinja2
from jinja2.utils import missing
from markupsafe import Markup

from measured_report.values.results import ResultsError

FILE = Path(__file__).parents[1] / "pages" / "layout" / "parts.html.j2"


class Undefined(jinja2.StrictUndefined):
    """Raise ResultsError for what is asked of a text or of nothing, as of a number.

    A record then has it otherwise than was thought; any other name is a mistake.
    """

    def __init__(
        self,
        hint: str | None = None,
        obj: Any = missing,
        name: str | None = None,
        exc: type[Exception] = jinja2.UndefinedError,
    ):
        is_plain = obj is None or isinstance(obj, str | int | float)
        super().__init__(hint, obj, name, ResultsError if is_plain else exc)  # type: ignore[arg-type]


environment = partial(
    jinja2.Environment,
    undefined=Undefined,
    autoescape=True,
    trim_blocks=True,
    lstrip_blocks=True,
)


@cache
def macros(file: Path = FILE) -> Any:
    """Compile the macros of a template, which are the names of what is returned."""
    loader = jinja2.FileSystemLoader(file.parent)
    return environment(loader=loader).get_template(file.name).module


class Picture(NamedTuple):
    """Hold a drawing in SVG, of which the element itself is left out."""

    kind: str  # `broad` or `narrow`: the screens that it is for
    view: str  # the box that it shows, as an SVG element has it
    content: Markup

    @property
    def size(self) -> list[int]:
        """Return width and height, as far as their proportion goes."""
        return [round(float(side)) for side in self.view.split()[2:]]
