"""Prose: rendered Markdown, in which each thing that is printed is still a token.

So nothing that is printed is ever taken for Markdown, and figures, links and the numbers of
citations are put in once all pages are known.
"""

import re
import secrets
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup, escape

from measured_report.parts.section import Figure

# The token has a part that nobody can know before, so that no text of a record can be one.
OPEN, CLOSE = f"\ue000{secrets.token_hex(16)}n", "\ue001"
NUMBER = re.compile(f"{OPEN}([0-9]+){CLOSE}")
TOKEN = re.compile(f"(<p>)?{NUMBER.pattern}(?(1)</p>)")
"""Alone in its paragraph it may be a block."""
PARAGRAPH = re.compile(
    rf"<p(?: [^>]*)?>(?!{NUMBER.pattern}</p>)(?P<words>.+?)</p>", re.DOTALL
)
BLOCK = ("<figure", "<p", "<div", "</div")


@dataclass(frozen=True)
class Mark:
    """Hold the place of a link to a part, ``#id``, or of a citation, ``source name``."""

    anchor: str

    def __html__(self) -> str:
        return self.anchor if self.anchor.startswith("#") else ""


@dataclass(frozen=True)
class Prose:
    """Hold a rendered template of Markdown, its figures not yet in it."""

    title: Markup
    body: str
    printed: list[Any]  # by the numbers of the tokens in the body
    anchor: str
    headings: list[tuple[str, Markup]]  # id and text of each below the title

    @property
    def figures(self) -> list[Figure]:
        return [item for item in self.printed if isinstance(item, Figure)]

    @property
    def summary(self) -> Markup:
        """Return its first paragraph of words, which are not those of a figure."""
        paragraph = PARAGRAPH.search(self.body)
        return put_back(paragraph["words"] if paragraph else "", self.printed)

    @property
    def marks(self) -> list[str]:
        """List the anchors of links and citations, whose places the page fills."""
        return [item.anchor for item in self.printed if isinstance(item, Mark)]

    def html(self, shown: Mapping[str, Any]) -> Markup:
        """Put in all that it prints, figures and marks as ``shown`` has them by anchor."""
        printed = [
            shown.get(item.anchor, item) if isinstance(item, Figure | Mark) else item
            for item in self.printed
        ]
        return put_back(self.body, printed)


def token(printed: list[Any], item: Any) -> Markup:
    """Return the token that stands for a thing until Markdown has been rendered."""
    printed.append(item)
    return Markup(f"{OPEN}{len(printed) - 1}{CLOSE}")


def put_back(text: str, printed: list[Any]) -> Markup:
    """Put what is printed in the place of its tokens."""

    def html(token: re.Match[str]) -> str:
        content = escape(printed[int(token[2])])
        is_words = token[1] and not content.startswith(BLOCK)
        return f"<p>{content}</p>" if is_words else content

    return Markup(TOKEN.sub(html, text))
