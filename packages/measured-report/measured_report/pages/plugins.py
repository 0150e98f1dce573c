"""Define the plugins of a report that does not add any content.

``report.toml`` can name a module with the same names, which adds content to the pages
and files to the site.
"""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any


class Plugins:
    """Provide the further content of one edition."""

    picture = ""
    """The address, relative to the site, of the preview picture that other sites show
    with a link to a page; empty if there is none.
    """

    def __init__(self, edition: Any):
        # An Edition; its module imports this one, so the type cannot be imported here.
        self.edition = edition

    def names(self, section: Any) -> Mapping[str, Any]:
        """Return further names for the template of a page.

        ``section`` is the section that the report derived for this template.
        """
        return {}

    @property
    def left_out(self) -> Sequence[Any]:
        """Return the states of content that cannot be shown because it is damaged."""
        return ()

    @property
    def data(self) -> Sequence[Path]:
        """Return further files for the folder of the edition's records on the site."""
        return ()

    @property
    def files(self) -> Mapping[str, Path | bytes]:
        """Return further files of the site by name; several editions can share one."""
        return {}

    def pages(self, templates: Any) -> Mapping[str, str]:
        """Return the HTML of further pages of the edition by file name."""
        return {}


def scripts() -> Sequence[str]:
    """Return the texts of the scripts that pages can run in addition to ``page.js``."""
    return ()
