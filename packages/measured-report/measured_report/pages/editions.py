"""Editions in words: what an edition's records come to, as its pages say it; nothing is drawn yet."""

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import cache, cached_property, partial
from typing import Any

from markupsafe import Markup

from measured_report.editions.project import Project
from measured_report.editions.status import NOT_SHOWN, State
from measured_report.files.config import Page, config
from measured_report.files.errors import ReportError
from measured_report.findings.cache import DerivedCache
from measured_report.findings.chapters import Chapter, Chapters, Releases, before
from measured_report.findings.editions import Edition, editions_of
from measured_report.findings.sections import file_of, outline_of
from measured_report.pages.passages import teller
from measured_report.pages.plugins import Plugins, plugins
from measured_report.pages.prose import Prose, Templates, Text
from measured_report.parts.claim import HOLDS, Claim
from measured_report.parts.section import Section
from measured_report.values.results import ResultsError


@dataclass(frozen=True)
class WordedChapter(Chapter):
    names: Mapping[str, Any]  # what its template can name, and other templates through `sections`
    prose: Prose

    @property
    def code(self) -> Iterator[tuple[str, int]]:
        """Yield the file and the line of what measures it and of what derives it."""
        for package, function in (("experiments", "measure"), ("report.sections", "derive")):
            if file := file_of(package, self.name):
                lines = file.read_text(encoding="utf-8").splitlines()
                numbers = (number for number, line in enumerate(lines, 1) if line.startswith(f"def {function}("))
                inside = file.parts[-2:] if file.name == "__init__.py" else file.parts[-1:]
                yield "/".join([*package.split("."), *inside]), next(numbers, 1)


@dataclass(frozen=True)
class WordedEdition(Edition):
    chapters: Mapping[str, WordedChapter]
    root: str = ""  # the way from its pages to the root of the site

    @cached_property
    def pages(self) -> dict[Page, list[WordedChapter]]:
        """Return its pages with what each shows; one that would show nothing is not there."""
        chapters = sorted(self.chapters.values(), key=lambda chapter: not outline_of(chapter.name).first)
        by_page = {page: [chapter for chapter in chapters if chapter.page == page] for page in config().pages}
        return {page: members for page, members in by_page.items() if members or page == config().front}

    @property
    def folder(self) -> str:
        """Tell where its pages lie below the site."""
        return f"{self.project.results.name}/" if self.root else ""

    def address(self, page: Page) -> str:
        """Tell where the same page of it lies below the site, or its front where it has no such page."""
        return self.folder + (page if page in self.pages else config().front).file

    @property
    def measured_on(self) -> str:
        """Return the day on which the last of its sections was measured; empty where none was."""
        return max((each.results.record.measured["date"][:10] for each in self.chapters.values()), default="")

    @cached_property
    def plugins(self) -> Plugins:
        return plugins().Plugins(self)

    def unmeasured(self, page: Page) -> list[State]:
        """Return the sections of a page, or of all for the front page, that have not been measured."""
        missing = (state for state in self.left_out if state.kind == "missing")
        return [state for state in missing if page in (config().front, outline_of(state.section).page)]

    def texts(self, page: Page, templates: Templates, releases: Releases, names: Mapping[str, Any]) -> list[Prose]:
        """Put a page's own texts into words; what can't be said is said as if nothing had been measured."""
        texts = {text.name.rpartition("/")[2].partition(".")[0]: text for text in map(templates.text, page.texts)}
        stories = {anchor: _worded(anchor, text, self.story(anchor, releases)) for anchor, text in texts.items()}
        prose: list[Prose] = []
        for anchor, text in texts.items():
            level = 2 if prose else 1  # the first has the title of the page
            try:
                prose.append(self._prose(level, anchor, text, stories, names))
            except ReportError as error:
                is_lacking = any(state.kind in ("damaged", NOT_SHOWN) for state in self.left_out)
                if not (is_lacking or isinstance(error, ResultsError)):
                    raise
                if all(state.section != anchor for state in self.left_out):
                    self.left_out.append(State(anchor, NOT_SHOWN, notes=(str(error),)))
                bare = {**stories, anchor: _worded(anchor, text, Section())}
                prose.append(replace(self, chapters={})._prose(level, anchor, text, bare, names))
        return prose

    def _prose(
        self, level: int, anchor: str, text: Text, stories: Mapping[str, Section], names: Mapping[str, Any]
    ) -> Prose:
        section, sections = stories[anchor], {name: chapter.section for name, chapter in self.chapters.items()}
        # A text that tells nothing of its own is no stand-in for the section of its name.
        story_sections = {name: story for name, story in stories.items() if story.claims or story.unmeasured}
        claims = {claim.name: claim.html(anchor) for claim in section.claims}
        sections_said = _Names({name: chapter.names for name, chapter in self.chapters.items()})
        text_names = {
            "release": self.project.release,
            "sections": sections_said,
            "claim": _finder(anchor, "claim", claims),
        }
        text_names |= _names_for(anchor, section, {**story_sections, **sections})
        return text.prose(anchor, {**text_names, **self.plugins.names(section), **names}, level)


def _worded(anchor: str, text: Text, section: Section) -> Section:
    """Give what a text tells its words; where what it is about was not measured there is nothing to tell."""
    if not section.claims:
        section = replace(section, unmeasured=[name for _, name in text.words])
    return section.worded(anchor, text.name, text.words)


class _Names(dict[str, Mapping[str, Any]]):
    """Hold what each section's words can name; of one that was not measured there is nothing to say."""

    def __missing__(self, name: str) -> Mapping[str, Any]:
        outline_of(name)  # for a name that no section has
        return dict.fromkeys(("claim", "table", "figure", "download"), lambda thing: Markup(""))


def worded_editions(project: Project, templates: Templates, derived: DerivedCache) -> dict[str, WordedEdition]:
    """Derive what the results of every release make, oldest first, and put it into words."""
    editions = {release: give_words(edition, templates) for release, edition in editions_of(project, derived).items()}
    releases = {release: edition.chapters for release, edition in editions.items()}
    say = partial(_say, releases=releases, templates=templates)
    roots = {release: "" if release == project.release else "../" for release in editions}
    worded = {release: WordedEdition(**vars(edition), root=roots[release]) for release, edition in editions.items()}
    return {release: edition.with_chapters(say) for release, edition in worded.items()}


def give_words(edition: Edition, templates: Templates) -> Edition:
    """Give the claims, figures and tables of an edition their words, which are not yet said."""

    def worded(state: State, chapters: Chapters) -> Chapter:
        chapter, text = chapters[state.section], templates.text(f"sections/{state.section}.md.j2")
        return replace(chapter, section=chapter.section.worded(chapter.name, text.name, text.words))

    return edition.with_chapters(worded)


def sentences_of(project: Project) -> Callable[[str, Claim], str]:
    """Return what says a claim of a section; no template is parsed before one is to be said."""
    templates = cache(lambda: Templates(project.templates))

    def say(section: str, claim: Claim) -> str:
        text = templates().text(f"sections/{section}.md.j2")
        alone = Section(claims=[claim], unmeasured=[name for _, name in text.words])
        return alone.worded(section, text.name, text.words).claims[0].text

    return say


def _say(state: State, chapters: Chapters, releases: Releases, templates: Templates) -> WordedChapter:
    """Put a section into words, which may rest on claims of others; its tables may show what other releases say."""
    chapter, name = chapters[state.section], state.section
    # Its passages may rest on what stands before it; what compares releases sees all.
    chapters_before = chapters if chapter.compares else before(name, chapters)
    text, tables = templates.text(f"sections/{chapter.name}.md.j2"), chapter.section.tables
    tables = {key: table.of(releases) if hasattr(table, "of") else table for key, table in tables.items()}
    section = replace(chapter.section, tables=tables)
    sections = {name: section, **{key: earlier.section for key, earlier in chapters_before.items()}}
    claims = dict.fromkeys(section.unmeasured, Markup("")) | {claim.name: claim.html(name) for claim in section.claims}
    downloads = {download.name: download for download in section.downloads}
    finders = {"claim": _finder(name, "claim", claims), "download": _finder(name, "download", downloads)}
    names = {"release": chapter.results.record.origin.release, "row": chapter.results.row, **finders}
    names |= {"rows": chapter.results.rows, "value": chapter.results.derived, **_names_for(name, section, sections)}
    return WordedChapter(**{**vars(chapter), "section": section}, names=names, prose=text.prose(name, names))


def _names_for(section_name: str, section: Section, sections: Mapping[str, Section]) -> dict[str, Callable[..., Any]]:
    """Find tables and figures of a section for its words, say its passages, and which claims hold."""

    def find(name: str, claim: str) -> Claim | None:
        if name not in sections:
            outline_of(name)  # for a name that no section has
            return None
        claims = {item.name: item for item in sections[name].claims}
        if claim not in claims and claim not in sections[name].unmeasured:
            raise ReportError(f"{name} has no claim {claim!r}; it has: {', '.join(claims) or 'none'}")
        return claims.get(claim)

    def holds(query: str) -> bool:
        name, _, claim = query.rpartition(".")
        needed = find(name or section_name, claim)
        return needed is not None and needed.outcome == HOLDS

    drawn = {"table": section.tables, "figure": section.figures}
    finders = {kind: _finder(section_name, kind, parts) for kind, parts in drawn.items()}
    return {"holds": holds, "passage": teller(find), **finders}


def _finder(section: str, kind: str, parts: Mapping[str, Any]) -> Callable[[str], Any]:
    def find(name: str) -> Any:
        if name not in parts:
            raise ReportError(f"{section} has no {kind} {name!r}; it has: {', '.join(parts) or 'none'}")
        return parts[name]

    return find
