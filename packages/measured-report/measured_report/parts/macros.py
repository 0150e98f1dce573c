"""Compile ``pages/layout/parts.html.j2``: macros for the HTML of a section's parts."""

from functools import cache, partial
from pathlib import Path
from typing import Any

import jinja2

FILE = Path(__file__).parents[1] / "pages" / "layout" / "parts.html.j2"


environment = partial(
    jinja2.Environment,
    undefined=jinja2.StrictUndefined,
    autoescape=True,
    trim_blocks=True,
    lstrip_blocks=True,
)


@cache
def macros(file: Path = FILE) -> Any:
    """Return an object with the macros of a template as its methods."""
    loader = jinja2.FileSystemLoader(file.parent)
    return environment(loader=loader).get_template(file.name).module
