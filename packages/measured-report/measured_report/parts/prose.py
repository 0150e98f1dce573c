"""Prose: rendered Markdown, in which each thing that is printed was a token until it was rendered.

So nothing that is printed is ever taken for Markdown.
"""

import re
import secrets
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup, escape

# The token has a part that nobody can know before, so that no text of a record can be one.
OPEN, CLOSE = f"\ue000{secrets.token_hex(16)}n", "\ue001"
NUMBER = re.compile(f"{OPEN}([0-9]+){CLOSE}")
TOKEN = re.compile(f"(<p>)?{NUMBER.pattern}(?(1)</p>)")
"""Alone in its paragraph it may be a block."""
PARAGRAPH = re.compile(r'<p(?: (?!class="left-out")[^>]*)?>(.+?)</p>', re.DOTALL)
BLOCK = ("<figure", "<p", "<div", "</div")


@dataclass(frozen=True)
class Prose:
    """Hold a rendered template of Markdown."""

    title: Markup
    body: Markup
    printed: list[Any]  # numbers, claims, figures and so on, in their order
    anchor: str
    headings: list[tuple[str, Markup]]  # id and text of each below the title

    @property
    def summary(self) -> Markup:
        """Return its first paragraph."""
        paragraph = PARAGRAPH.search(self.body)
        return Markup(paragraph[1] if paragraph else "")


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
