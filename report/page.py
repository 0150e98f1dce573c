"""The page: templates of Markdown with values in it, made into HTML."""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from jinja2 import (
    Environment,
    FileSystemLoader,
    StrictUndefined,
    TemplateError,
    TemplateNotFound,
    pass_context,
)
from jinja2.runtime import Context
from markdown import Markdown
from markdown.extensions.toc import slugify
from markupsafe import Markup, escape

from report import ReportError
from report.parts import PlacedFigure

# What a template prints passes Markdown as a token between two private characters and is put back afterwards,
# so that no value, case name or table is ever taken for Markdown. Alone in its paragraph it may be a block.
OPEN, CLOSE = "\ue000", "\ue001"
TOKEN = re.compile(f"(<p>)?{OPEN}([0-9]+){CLOSE}(?(1)</p>)")
BLOCK = ("<figure", "<p")
TITLE = re.compile(r"\s*<h2[^>]*>.*?</h2>", re.DOTALL)


@dataclass(frozen=True)
class Prose:
    """A rendered template of Markdown, its figures not yet drawn."""

    title: Markup
    body: str
    printed: list[Any]

    @property
    def figures(self) -> list[PlacedFigure]:
        return [thing for thing in self.printed if isinstance(thing, PlacedFigure)]

    def html(self, drawn: Mapping[str, Markup]) -> Markup:
        """The text below the title, with its figures, which are drawn already, by their names."""
        printed = [drawn[thing.name] if isinstance(thing, PlacedFigure) else thing for thing in self.printed]
        return _put_back(self.body, printed)


class Templates:
    """The templates of one project; a name that does not exist is an error."""

    def __init__(self, folder: Path):
        self._layout = Environment(
            loader=FileSystemLoader(folder),
            undefined=StrictUndefined,
            autoescape=True,
            trim_blocks=True,
            lstrip_blocks=True,
        )
        self._prose = self._layout.overlay(finalize=_as_token)

    def prose(self, template: str, anchor: str, names: Mapping[str, Any]) -> Prose:
        """Render Markdown whose first line is its title; ids of further headings begin with ``anchor``."""
        printed: list[Any] = []
        text = self._render(self._prose, template, {**names, "printed": printed})
        headings = {
            "baselevel": 2,
            "slugify": lambda title, separator: f"{anchor}-{slugify(title, separator)}",
        }
        markdown = Markdown(extensions=["toc", "fenced_code"], extension_configs={"toc": headings})
        html = markdown.convert(text)
        if len(markdown.toc_tokens) != 1 or not TITLE.match(html):
            raise ReportError(f"templates/{template} must begin with its one title, a line with a single #")
        title = _put_back(markdown.toc_tokens[0]["name"], printed)
        return Prose(title, TITLE.sub("", html, count=1), printed)

    def layout(self, template: str, names: Mapping[str, Any]) -> str:
        return self._render(self._layout, template, names)

    def _render(self, environment: Environment, template: str, names: Mapping[str, Any]) -> str:
        try:
            return environment.get_template(template).render(names)
        except TemplateNotFound as error:
            raise ReportError(f"there is no templates/{error.message}") from None
        except TemplateError as error:
            raise ReportError(f"templates/{template}: {error.message}") from None


@pass_context
def _as_token(context: Context, value: Any) -> Markup:
    if isinstance(value, Markup) and OPEN in value:
        return value  # what a macro returns has passed here already
    if isinstance(value, int | float):
        raise ReportError(f"templates/{context.name} prints {value}, which says nothing of where it comes from")
    printed = context["printed"]
    printed.append(value if isinstance(value, PlacedFigure) else escape(value))
    return Markup(f"{OPEN}{len(printed) - 1}{CLOSE}")


def _put_back(text: str, printed: list[Any]) -> Markup:
    def html(token: re.Match) -> str:
        content = escape(printed[int(token[2])])
        return f"<p>{content}</p>" if token[1] and not content.startswith(BLOCK) else content

    return Markup(TOKEN.sub(html, text))
