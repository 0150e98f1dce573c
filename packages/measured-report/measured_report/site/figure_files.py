"""Figures as files: drawings that a page fetches on the way to them, in the colours that its reader has chosen."""

import re
from functools import cache

from markupsafe import Markup

from measured_report.pages.prose import LAYOUT
from measured_report.parts.section import Figure, Pictures

FOLDER = "figures"
THEME = re.compile(r"^:root \{.*?^\}|^svg .*?$", re.DOTALL | re.MULTILINE)
"""What a drawing takes from the stylesheet: the page's colours and font, and what holds of drawings alone."""
OPENING = re.compile(r'<svg class="\w+" viewBox="([^"]*)" role="img">')
NAMESPACES = 'xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink"'


def figure_files(figure: Figure, pictures: Pictures) -> dict[str, str]:
    """Return its drawings by the names of their files."""
    address = address_of(figure)
    names = f"{address}.svg", f"{address}-narrow.svg"
    return dict(zip(names, map(svg_file, pictures), strict=True))


def address_of(figure: Figure) -> str:
    """Return where its drawings lie beside the page, but for how their names end."""
    return f"{FOLDER}/{figure.anchor}"


def svg_file(picture: Markup) -> str:
    """A drawing that stands alone: an image has the scheme of the page that it is on, and nothing else of it."""
    opening = f'<svg {NAMESPACES} viewBox="\\1">\n<style>{_theme()}</style>'
    return f"{OPENING.sub(opening, str(picture), count=1)}\n"


@cache
def _theme() -> str:
    return "\n".join(THEME.findall((LAYOUT / "style.css").read_text(encoding="utf-8")))
