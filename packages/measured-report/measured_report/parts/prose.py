"""Render Markdown with printed values that are never taken for Markdown.

A template first prints a token for each value. After Markdown is rendered, the tokens
are replaced by the values.
"""

import re
import secrets
from dataclasses import dataclass
from typing import Any

from markupsafe import Markup, escape

from measured_report.files.errors import ReportError
from measured_report.files.units import SYMBOL

# The token contains a random number, so that a text in a record cannot imitate it.
OPEN, CLOSE = f"\ue000{secrets.token_hex(16)}n", "\ue001"
NUMBER = re.compile(f"{OPEN}([0-9]+){CLOSE}")
TOKEN = re.compile(f"(<p>)?{NUMBER.pattern}(?(1)</p>)")
"""Matches a token, or a whole paragraph that consists of one token, because the token
may stand for a block.
"""
UNIT = rf"(?:(?!1)(?:{SYMBOL.pattern})|\w*seconds|percent)"
TYPED_UNIT = re.compile(
    rf"</data>(?:&nbsp;{UNIT}[\s\xa0]+({UNIT})|[\s\xa0]+(%|percent))(?![\w/])",
    re.VERBOSE,
)
"""Matches a unit after a number that prints its own, and a percent sign after a plain
number.
"""
PARAGRAPH = re.compile(r'<p(?: (?!class="left-out")[^>]*)?>(.+?)</p>', re.DOTALL)
BLOCK = ("<figure", "<p", "<div", "</div")


@dataclass(frozen=True)
class Prose:
    """A rendered template of Markdown."""

    title: Markup
    body: Markup
    printed: list[Any]  # the printed numbers, claims, figures and so on, in order
    anchor: str
    headings: list[tuple[str, Markup]]  # the id and the text of each heading

    @property
    def summary(self) -> Markup:
        """Return the content of the first paragraph, or an empty text."""
        paragraph = PARAGRAPH.search(self.body)
        return Markup(paragraph[1] if paragraph else "")


def token(printed: list[Any], value: Any) -> Markup:
    """Add a value to ``printed`` and return the token that stands for it."""
    printed.append(value)
    return Markup(f"{OPEN}{len(printed) - 1}{CLOSE}")


def put_back(text: str, printed: list[Any]) -> Markup:
    """Return a text in which the tokens are replaced by the printed values."""

    def html(token: re.Match[str]) -> str:
        content = escape(printed[int(token[2])])
        is_paragraph = token[1] and not content.startswith(BLOCK)
        return f"<p>{content}</p>" if is_paragraph else content

    page = TOKEN.sub(html, text)
    if unit := TYPED_UNIT.search(page):
        raise ReportError(
            f"the unit {unit[1] or unit[2]} is typed after a number, which is printed "
            "with its own unit: leave it out"
        )
    return Markup(page)
