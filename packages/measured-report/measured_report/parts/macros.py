"""Macros: the HTML of what a section prints, ``pages/layout/parts.html.j2``."""

from functools import cache
from pathlib import Path
from typing import Any

import jinja2

FILE = Path(__file__).parents[1] / "pages" / "layout" / "parts.html.j2"


@cache
def macros() -> Any:
    """Compile the macros, which are the names of what is returned."""
    loader = jinja2.FileSystemLoader(FILE.parent)
    environment = jinja2.Environment(
        loader=loader, undefined=jinja2.StrictUndefined, autoescape=True, trim_blocks=True, lstrip_blocks=True
    )
    return environment.get_template(FILE.name).module
