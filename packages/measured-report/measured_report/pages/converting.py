"""Converting: texts of Markdown made into HTML.

What a template prints passes as a token between two private characters, so that none of it is taken for Markdown.
"""

import re
import secrets
from typing import Any
from xml.etree.ElementTree import Element, SubElement

from markdown import Markdown
from markdown.extensions.toc import slugify
from markdown.treeprocessors import Treeprocessor
from markupsafe import Markup

from measured_report.files.errors import ReportError

# The token has a part that nobody can know before, so that no text of a record can be one.
OPEN, CLOSE = f"\ue000{secrets.token_hex(16)}n", "\ue001"
BLANK = "\ue002"
"""Stands for ``OPEN`` in what was converted."""
NUMBER = re.compile(f"{OPEN}([0-9]+){CLOSE}")
AFTER_TOC = 1  # the lower the later
ANCHOR = {"class": "anchor", "tabindex": "-1", "aria-hidden": "true"}
"""A link of a heading to itself: no stop of the keyboard, which the contents lead to as well."""


def token(printed: list[Any], thing: Any) -> Markup:
    """Return what stands in a text for a thing that is printed, which is kept for the time after Markdown."""
    printed.append(thing)
    return Markup(f"{OPEN}{len(printed) - 1}{CLOSE}")


class Headings(Treeprocessor):
    """Take the title off a text, and let every other heading link to itself."""

    def run(self, root: Element) -> None:
        if len(root) and root[0].tag in ("h1", "h2"):
            root.remove(root[0])
        for heading in (each for each in root.iter() if "id" in each.attrib):
            if len(heading):
                heading[-1].tail = f"{heading[-1].tail or ''} "
            else:
                heading.text = f"{heading.text} "
            SubElement(heading, "a", {**ANCHOR, "href": f"#{heading.get('id')}"}).text = "#"


def converted(text: str, place: str, anchor: str, level: int) -> tuple[str, str, list[tuple[str, str]]]:
    """Make title and body of a text of the template ``place``, with id and text of each heading right below the title.

    Each token begins with a ``BLANK``. The title is of that level, and the ids of headings begin with ``anchor``.
    """
    headings = {
        "baselevel": level,
        "slugify": lambda title, separator: "-".join([anchor, slugify(NUMBER.sub(r"\1", title), separator)]),
    }
    markdown = Markdown(extensions=["toc", "fenced_code"], extension_configs={"toc": headings})
    markdown.treeprocessors.register(Headings(), "headings", AFTER_TOC)
    body = markdown.convert(text).replace(OPEN, BLANK)
    if len(markdown.toc_tokens) != 1 or not text.lstrip().startswith("# "):
        raise ReportError(f"templates/{place} must begin with its one title, a line with a single #")
    top = markdown.toc_tokens[0]
    inner = [(heading["id"], heading["name"].replace(OPEN, BLANK)) for heading in top["children"]]
    # What may be wider than the page is scrolled with the keyboard too.
    return top["name"].replace(OPEN, BLANK), body.replace("<pre>", '<pre tabindex="0">'), inner
