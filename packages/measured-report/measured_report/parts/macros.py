"""Macros: the HTML of what a section prints, ``pages/layout/parts.html.j2``."""

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
    """Compile the macros of a template, which are the names of what is returned."""
    loader = jinja2.FileSystemLoader(file.parent)
    return environment(loader=loader).get_template(file.name).module
