"""Converting: texts of Markdown made into HTML.

What a template prints passes as a token between two private characters, so that none of it is taken for Markdown.
"""

import re
import secrets
from dataclasses import dataclass
from typing import Any

from markdown import Markdown
from markdown.extensions.toc import slugify
from markupsafe import Markup

from measured_report.files.errors import ReportError

# The token has a part that nobody can know before, so that no text of a record can be one.
OPEN, CLOSE = f"\ue000{secrets.token_hex(16)}n", "\ue001"
BLANK = "\ue002"
"""Stands for ``OPEN`` in what was converted."""
NUMBER = re.compile(f"{OPEN}([0-9]+){CLOSE}")
TITLE = re.compile(r"\s*<(h[12])[^>]*>.*?</\1>", re.DOTALL)
HEADING = re.compile(r'(<(h[2-6]) id="([^"]+)">.*?)(?=</\2>)', re.DOTALL)
# It can be clicked, and is no stop on the way through the page with a keyboard: the contents lead there as well.
ANCHOR = r'\1 <a class="anchor" href="#\3" tabindex="-1" aria-hidden="true">#</a>'


def token(printed: list[Any], thing: Any) -> Markup:
    """Return what stands in a text for a thing that is printed, which is kept for the time after Markdown."""
    printed.append(thing)
    return Markup(f"{OPEN}{len(printed) - 1}{CLOSE}")


@dataclass(frozen=True)
class Converted:
    """What Markdown makes of a text."""

    title: str
    body: str
    headings: list[tuple[str, str]]
    """Id and text of each heading right below the title."""


def converted(text: str, place: str, anchor: str, level: int) -> Converted:
    """Make HTML of a text of the template ``place``, with a ``BLANK`` at the beginning of each token.

    Its title is of that level, and the ids of further headings begin with ``anchor``.
    """
    headings = {
        "baselevel": level,
        "slugify": lambda title, separator: "-".join([anchor, slugify(NUMBER.sub(r"\1", title), separator)]),
    }
    markdown = Markdown(extensions=["toc", "fenced_code"], extension_configs={"toc": headings})
    html = markdown.convert(text).replace(OPEN, BLANK)
    if len(markdown.toc_tokens) != 1 or not TITLE.match(html):
        raise ReportError(f"templates/{place} must begin with its one title, a line with a single #")
    top = markdown.toc_tokens[0]
    # What may be wider than the page is scrolled with the keyboard too.
    body = HEADING.sub(ANCHOR, TITLE.sub("", html, count=1)).replace("<pre>", '<pre tabindex="0">')
    inner = [(heading["id"], heading["name"].replace(OPEN, BLANK)) for heading in top["children"]]
    return Converted(top["name"].replace(OPEN, BLANK), body, inner)
