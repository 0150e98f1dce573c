"""Parse the templates of a report, for Markdown and for layouts, and render them."""

import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from functools import cache, partial
from pathlib import Path
from traceback import extract_tb
from typing import Any

import jinja2
from jinja2 import nodes
from jinja2.bccache import Bucket
from jinja2.ext import Extension
from jinja2.parser import Parser
from jinja2.runtime import Context
from markupsafe import Markup, escape

from measured_report.files.cache import Cache
from measured_report.files.config import report as current
from measured_report.files.errors import ReportError, bug_of
from measured_report.pages.passages import parse_passage
from measured_report.parts.citations import references, stated
from measured_report.parts.macros import environment
from measured_report.parts.prose import NUMBER, OPEN, Prose, put_back, token
from measured_report.parts.words import (
    PARTS,
    TYPED,
    Wording,
    parse_words,
    refuse_numbers,
    wordings_of,
)
from measured_report.records.identity import files_digest
from measured_report.values.results import ResultsError

GENERATOR = Path(__file__).resolve().parents[1]
LAYOUT = GENERATOR / "pages" / "layout"
"""The folder of the layouts, style sheets and script of all pages.

A layout of a report can extend ``layout/NAME``.
"""
TITLE = re.compile(r"\A<h[12].*?</h[12]>\n?")
HEADING = re.compile(r'<(h[2-6]) id="([^"]+)">(.*?)</\1>')
SELF = (
    r'<\1 id="\2">\3 '
    r'<a aria-hidden="true" class="anchor" href="#\2" tabindex="-1">#</a></\1>'
)
"""A heading with a link to itself, which the Tab key skips."""
PARSERS = {
    **dict.fromkeys(PARTS, parse_words),
    "passage": parse_passage,
}
Words = Mapping[tuple[str, str], Wording]


class Tags(Extension):
    """Add the tags for claims, figures, tables and passages to an environment."""

    tags = {*PARSERS}  # noqa: RUF012, because Jinja declares it as an attribute

    def preprocess(
        self, source: str, name: str | None, filename: str | None = None
    ) -> str:
        refuse_numbers(source)
        return source

    def parse(self, parser: Parser) -> list[nodes.Node]:
        return PARSERS[parser.stream.current.value](parser, self.environment)


class Compiled(jinja2.BytecodeCache):
    """Cache compiled templates until the code in pages/ or parts/ changes.

    Compiling all of them takes a second.
    """

    def __init__(self, kind: str):
        self.kind = kind
        self.cache = Cache(GENERATOR)
        self.made_by = files_digest([*GENERATOR.glob("pa*/*.py")], GENERATOR)

    def load_bytecode(self, bucket: Bucket) -> None:
        if content := self.cache.get(f"{self.kind}-{bucket.key}", self.made_by):
            bucket.bytecode_from_string(content)

    def dump_bytecode(self, bucket: Bucket) -> None:
        content = bucket.bytecode_to_string()
        self.cache.put(f"{self.kind}-{bucket.key}", self.made_by, content)


class Templates:
    """Load and render a project's templates; raise ReportError for invalid ones."""

    def __init__(self, folder: Path):
        report = current()
        own, base = map(jinja2.FileSystemLoader, (folder, LAYOUT))
        layouts = jinja2.PrefixLoader({"layout": base})
        self._layout = environment(
            loader=jinja2.ChoiceLoader([own, base, layouts]),
            bytecode_cache=Compiled("layout"),
        )
        self._prose = self._layout.overlay(
            finalize=_as_token, extensions=[Tags], bytecode_cache=Compiled("prose")
        )
        self.references = references(folder)
        self._layout.globals |= {
            "references": self.references,
            "config": report.settings,
            "sources": report.sources,
            "stated": partial(stated, self.references),
        }
        self.words = cache(self._words)

    def prose(
        self, name: str, anchor: str, names: Mapping[str, Any], level: int = 2
    ) -> Prose:
        """Render a template of Markdown, whose first line is its title.

        The title becomes a heading of ``level``. The ids of other headings begin with
        ``anchor``.
        """
        # This import is slow, and many commands do not render Markdown.
        from markdown import Markdown
        from markdown.extensions.toc import slugify

        printed: list[Any] = []
        with _named(name):
            template = self._prose.get_template(name)
            text = template.render({**names, "printed": printed})

        def id_of(title: str, separator: str) -> str:
            return f"{anchor}-{slugify(NUMBER.sub('', title), separator)}"

        markdown = Markdown(
            extensions=["toc", "fenced_code", "tables"],
            extension_configs={"toc": {"baselevel": level, "slugify": id_of}},
        )
        body = HEADING.sub(SELF, TITLE.sub("", markdown.convert(text)))
        # A block may be wider than the page; the focus allows scrolling by keyboard.
        body = body.replace("<pre>", '<pre tabindex="0">')
        if len(markdown.toc_tokens) != 1 or not text.lstrip().startswith("# "):
            raise ReportError(
                f"templates/{name} does not begin with its title or has two titles: "
                "begin exactly one line with a single #"
            )
        top = markdown.toc_tokens[0]
        with _named(name):
            headings = [
                (heading["id"], put_back(heading["name"], printed))
                for heading in top["children"]
            ]
            title = put_back(top["name"], printed)
            return Prose(title, put_back(body, printed), printed, anchor, headings)

    def layout(self, template: str, names: Mapping[str, Any]) -> str:
        with _named(template):
            return self._layout.get_template(template).render(names)

    def _words(self, name: str) -> Words:
        """Return the wordings in a template by kind and name."""
        with _named(name):
            template = self._prose.get_template(name)

        def render(block: str, numbers: Mapping[str, Any]) -> Markup:
            printed: list[Any] = []
            context = template.new_context({**numbers, "printed": printed})
            with _named(name, template):
                text = "".join(template.blocks[block](context))
                return put_back(" ".join(text.split()), printed)

        return wordings_of(template.blocks, render)


def stylesheet(root: Path) -> str:
    """Return the style sheet of the pages; the styles of the report come last."""
    own = root / "static" / "style.css"
    paths = (LAYOUT / "theme.css", LAYOUT / "style.css", own)
    return "\n".join(
        path.read_text(encoding="utf-8") for path in paths if path.is_file()
    )


@contextmanager
def _named(name: str, code: jinja2.Template | None = None) -> Iterator[None]:
    """Add the template and the line to the message of an error.

    ``code`` is the template of a block that is rendered by itself.
    """
    kind: type[ReportError] = ReportError
    try:
        yield
        return
    except jinja2.TemplateNotFound as error:
        message = f"templates/{error.name} does not exist: create it"
    except (OSError, UnicodeEncodeError):
        raise  # a file or a path, which the command names
    except UnicodeDecodeError as error:
        message = f"templates/{name}: {error}"
    except jinja2.TemplateSyntaxError as error:
        # Jinja's name can also be an absolute path or <unknown>.
        place = name if (error.name or "<")[0] in "/<" else error.name
        message = f"templates/{place}:{error.lineno}: {error.message}"
    except Exception as error:
        if hasattr(error, "place"):
            raise
        kind = ResultsError if isinstance(error, ResultsError) else ReportError
        frames = extract_tb(error.__traceback__)
        lines = [frame.lineno or 1 for frame in frames if frame.filename.endswith(name)]
        line = lines[-1] if lines else None
        if line and code:
            line = code.get_corresponding_lineno(line)
        is_known = isinstance(error, jinja2.TemplateError | ReportError)
        reason = str(error) if is_known else bug_of(error)
        message = f"templates/{name}{f':{line}' if line else ''}: {reason}"
    error_with_place = kind(message)
    # This attribute marks the error, so that an outer template does not add its name.
    vars(error_with_place)["place"] = name
    raise error_with_place


@jinja2.pass_context
def _as_token(context: Context, value: Any) -> Markup:
    """Return the token for a printed value; raise ReportError for a plain number."""
    if isinstance(value, Markup) and OPEN in value:
        return value  # the result of a macro, which already contains tokens
    if isinstance(value, int | float):
        raise ReportError(
            f"it prints {value}, which does not have a source: use a Quantity"
        )
    if not hasattr(value, "__html__") and (typed := TYPED.search(str(value))):
        raise ReportError(
            f"it prints {typed[0]!r}, which does not have a source: use a Quantity"
        )
    html = value.__html__() if hasattr(value, "__html__") else escape(value)
    return token(context["printed"], html)
