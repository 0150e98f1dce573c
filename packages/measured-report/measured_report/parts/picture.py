"""A drawing as a page or a file shows it."""

from collections.abc import Sequence
from dataclasses import dataclass

from markupsafe import Markup

from measured_report.parts.macros import macros


@dataclass(frozen=True)
class Picture:
    """A drawing in SVG, of which the element itself is left out."""

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
    def size(self) -> tuple[int, int]:
        """Return width and height, as far as their proportion goes."""
        _, _, width, height = map(float, self.view.split())
        return round(width), round(height)
