"""Compile ``pages/layout/parts.html.j2``: macros for the HTML of a section's parts."""

from functools import cache, partial
from pathlib import Path
from typing import Any

import jinja2
from jinja2.utils import missing

from measured_report.values.results import ResultsError

FILE = Path(__file__).parents[1] / "pages" / "layout" / "parts.html.j2"


class Undefined(jinja2.StrictUndefined):
    """Raise an error if a template uses an undefined name.

    It is a ResultsError if the name is an attribute of None, a text or a number,
    because then a record contains one of them instead of a quantity. Other names are
    mistakes in the template.
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
    """Return an object with the macros of a template as its methods."""
    loader = jinja2.FileSystemLoader(file.parent)
    return environment(loader=loader).get_template(file.name).module
