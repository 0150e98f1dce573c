"""Plugins: what a report shows besides sections and pages, where ``report.toml`` names a module with the same names."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any


class Plugins:
    """Show what one edition has besides."""

    picture = ""  # address of the picture that others show with a link to its pages, seen from them; empty: none

    def __init__(self, edition: Any):  # an Edition, whose module reads this one
        self.edition = edition

    def names(self, section: Any) -> Mapping[str, Any]:
        """Return what texts of pages can name; ``section`` is what the report's ``story`` derived for this one."""
        return {}

    @property
    def left_out(self) -> Sequence[Any]:
        """Say what of it can't be shown, since it is damaged."""
        return ()

    @property
    def data(self) -> Sequence[Path]:
        """Name further files for the site to have beside the edition's records."""
        return ()

    @property
    def files(self) -> Mapping[str, Path | bytes]:
        """Return further files of the site, by their names below it; editions may have the same."""
        return {}

    def pages(self, templates: Any) -> Mapping[str, str]:
        """Return further pages, as HTML by their file, to lie beside the edition's own."""
        return {}


def scripts() -> Sequence[str]:
    """Return the texts of the scripts that a page may have in it; ``page.js`` lies beside the pages."""
    return ()
