"""The page: templates of Markdown, made into HTML; what one prints passes as a token, and is never Markdown."""

import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from traceback import extract_tb
from typing import Any

import jinja2
from markdown import Markdown
from markdown.extensions.toc import slugify
from markupsafe import Markup, escape

from measured_report.files.config import config
from measured_report.files.errors import ReportError
from measured_report.pages.passages import PassageTag
from measured_report.parts.citations import Mark, StatedTag, references
from measured_report.parts.macros import environment
from measured_report.parts.section import Figure
from measured_report.parts.words import (
    CLOSE,
    OPEN,
    Wording,
    WordTags,
    refuse_numbers,
    token,
    with_formulas,
)
from measured_report.records.identity import sources
from measured_report.values.results import ResultsError

LAYOUT = Path(__file__).resolve().parent / "layout"
"""Templates of HTML, and what else lies beside every page; a report's own may extend ``layout/NAME``."""
NUMBER = re.compile(f"{OPEN}([0-9]+){CLOSE}")
TOKEN = re.compile(f"(<p>)?{NUMBER.pattern}(?(1)</p>)")  # stands alone in its paragraph where it may be a block
LINK = re.compile(r'(?:(?<=\]\()|(?<= href="))#([\w-]+)(?=[)"])')  # in Markdown, a link that leads to an id
PARAGRAPH = re.compile(rf"<p(?: [^>]*)?>(?!{NUMBER.pattern}</p>)(?P<words>.+?)</p>", re.DOTALL)
PLAIN = re.compile(r"'(str|bool|int|float|None|NoneType)( object)?' has no attribute")
TOLD = re.compile("(there is no )?templates/")  # an error that says already where it is
OF_CLASS = re.compile(r"'measured_report[\w.]*\.(\w+) object'")
BLOCK = ("<figure", "<p", "<div", "</div")
TITLE, HEADING = re.compile(r"\A<h[12].*?</h[12]>\n?"), re.compile(r'<(h[2-6]) id="([^"]+)">(.*?)</\1>')
SELF = r'<\1 id="\2">\3 <a aria-hidden="true" class="anchor" href="#\2" tabindex="-1">#</a></\1>'
"""A heading with a link to itself: no stop of the keyboard, which the contents lead to as well."""


@dataclass(frozen=True)
class Prose:
    """Hold a rendered template of Markdown, its figures not yet drawn."""

    title: Markup
    body: str
    printed: list[Any]
    anchor: str
    headings: list[tuple[str, Markup]]

    @property
    def figures(self) -> list[Figure]:
        return [item for item in self.printed if isinstance(item, Figure)]

    @property
    def summary(self) -> Markup:
        """Return its first paragraph of words, which are not those of a figure."""
        return _put_back(next((each["words"] for each in PARAGRAPH.finditer(self.body)), ""), self.printed)

    @property
    def marks(self) -> list[str]:
        """List the anchors of links and citations, whose places the page fills."""
        return [item.anchor for item in self.printed if isinstance(item, Mark)]

    def html(self, replacements: Mapping[str, Any]) -> Markup:
        """Put in what it prints: as ``shown`` has them by their anchors its figures, and links and marks of sources."""
        anchored = Figure | Mark
        printed = [replacements.get(item.anchor, item) if isinstance(item, anchored) else item for item in self.printed]
        return _put_back(self.body, printed)


@dataclass(frozen=True)
class Text:
    """Hold one template of Markdown, parsed."""

    name: str
    template: jinja2.Template
    words: Mapping[tuple[str, str], Wording]

    def prose(self, anchor: str, names: Mapping[str, Any], level: int = 2) -> Prose:
        """Render it; its first line is its title, of that level, and ids of further headings begin with ``anchor``."""
        printed: list[Any] = []
        with _named(self.name):
            text = self.template.render({**names, "printed": printed})
        text = LINK.sub(lambda link: token(printed, Mark(f"#{link[1]}")), text)
        slugs = {"baselevel": level, "slugify": lambda title, by: f"{anchor}-{slugify(NUMBER.sub('', title), by)}"}
        markdown = Markdown(extensions=["toc", "fenced_code", "tables"], extension_configs={"toc": slugs})
        body = HEADING.sub(SELF, TITLE.sub("", markdown.convert(text)))
        body = body.replace("<pre>", '<pre tabindex="0">')  # what may be wider is scrolled with the keyboard too
        if len(markdown.toc_tokens) != 1 or not text.lstrip().startswith("# "):
            raise ReportError(f"templates/{self.name} must begin with its one title, a line with a single #")
        top = markdown.toc_tokens[0]
        headings = [(heading["id"], _put_back(heading["name"], printed)) for heading in top["children"]]
        return Prose(_put_back(top["name"], printed), body, printed, anchor, headings)


class Templates:
    """Find the templates of one project; a name that does not exist is an error."""

    def __init__(self, folder: Path):
        project, base = jinja2.FileSystemLoader(folder), jinja2.FileSystemLoader(LAYOUT)
        self._loader = jinja2.ChoiceLoader([project, base, jinja2.PrefixLoader({"layout": base})])
        self._layout = environment(loader=self._loader)
        self._prose = self._layout.overlay(finalize=_as_token)
        self.references = references(folder)
        self._layout.globals |= {"references": self.references, "config": config(), "sources": sources()}
        for extension in (WordTags, PassageTag, StatedTag):
            self._prose.add_extension(extension)
        self.text = cache(self._text)

    def _text(self, name: str) -> Text:
        with _named(name):
            source, path, _ = self._loader.get_source(self._prose, name)
            refuse_numbers(source := with_formulas(source))
            code = self._prose.compile(source, name, path)
        template = jinja2.Template.from_code(self._prose, code, self._prose.make_globals(None))

        def render(block: str, numbers: Mapping[str, Any]) -> Markup:
            printed: list[Any] = []
            with _named(name, template):
                text = "".join(template.blocks[block](template.new_context({**numbers, "printed": printed})))
            return _put_back(" ".join(text.split()), printed)

        tags: Any = self._prose
        words = {key: replace(wording, render=render) for key, wording in tags.wordings[name].items()}
        return Text(name, template, words)

    def layout(self, template: str, names: Mapping[str, Any]) -> str:
        with _named(template):
            return self._layout.get_template(template).render(names)


def stylesheet(root: Path) -> str:
    """Return the styles of pages: first those that drawings have as files, last the report's own."""
    paths = (LAYOUT / "theme.css", LAYOUT / "style.css", root / "static" / "style.css")
    return "\n".join(path.read_text(encoding="utf-8") for path in paths if path.is_file())


@contextmanager
def _named(template: str, code: jinja2.Template | None = None) -> Iterator[None]:
    """Say in errors which template it is; of a block, which is called by itself, where its ``code`` has the line."""
    try:
        yield
    except jinja2.TemplateNotFound as error:
        raise ReportError(f"there is no templates/{error.name}") from None
    except UnicodeDecodeError as error:
        raise ReportError(f"templates/{template}: {error}") from None
    except jinja2.TemplateSyntaxError as error:
        name = template if (error.name or "<")[0] in "/<" else error.name  # a path, or what looks for names in a tree
        raise ReportError(f"templates/{name}:{error.lineno}: {error.message}") from None
    except (jinja2.TemplateError, ReportError) as error:
        if TOLD.match(text := str(error)):
            raise
        # What is asked of a text or of nothing, as if it were a number, a record has otherwise than was thought.
        kind = ResultsError if isinstance(error, ResultsError) or PLAIN.match(text) else ReportError
        lines = [frame.lineno or 1 for frame in extract_tb(error.__traceback__) if frame.filename.endswith(template)]
        line = f":{code.get_corresponding_lineno(lines[-1]) if code else lines[-1]}" if lines else ""
        raise kind(f"templates/{template}{line}: " + OF_CLASS.sub(r"a \1", text)) from None


@jinja2.pass_context
def _as_token(context: jinja2.runtime.Context, value: Any) -> Markup:
    if isinstance(value, Markup) and OPEN in value:
        return value  # what a macro returns has passed here already
    if isinstance(value, int | float):
        raise ReportError(f"templates/{context.name} prints {value}, which says nothing of where it comes from")
    return token(context["printed"], value if isinstance(value, Figure) else escape(value))


def _put_back(text: str, printed: list[Any]) -> Markup:
    def html(token: re.Match[str]) -> str:
        content = escape(printed[int(token[2])])
        return f"<p>{content}</p>" if token[1] and not content.startswith(BLOCK) else content

    return Markup(TOKEN.sub(html, text))
