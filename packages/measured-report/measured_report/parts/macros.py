"""Macros: the HTML of what a section prints, ``pages/layout/parts.html.j2``."""

from functools import cache, partial
from pathlib import Path
from typing import Any

import jinja2
from jinja2.utils import missing

from measured_report.values.results import ResultsError

FILE = Path(__file__).parents[1] / "pages" / "layout" / "parts.html.j2"


class Undefined(jinja2.StrictUndefined):
    """Raise ResultsError for an attribute of a text or of nothing, as of a number.

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
