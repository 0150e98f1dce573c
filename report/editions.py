"""Editions: every section of a release that has results is derived and put into words; nothing is drawn yet."""

import inspect
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from importlib import import_module
from pathlib import Path
from traceback import extract_tb
from types import ModuleType
from typing import Any

from report import ReportError
from report.chapters import Chapter, Chapters, Releases
from report.claims import HOLDS
from report.clips import Clips, clips_of
from report.noise import NOISE, noise_floors
from report.packed import replayed_runs
from report.page import Prose, Templates, Text
from report.pages import DEFAULT, FRONT, PAGES, REPLAY, Page, page_named
from report.pairs import refuse_contradictions
from report.parts import Making, Section
from report.records.files import RecordError, place_of
from report.records.project import Project
from report.records.status import State, states_of
from report.results import Results, ResultsError
from report.story.found import Found
from report.story.front import cards_of, front_of
from report.story.story import story_of

RETOLD = {"front": front_of, "story": story_of}
"""By template: what retells the findings of the sections in claims of its own."""


class LostError(ReportError):
    """A record from which nothing of its section can be derived; the message is one line."""


@dataclass(frozen=True)
class Edition:
    """What the results of one release make."""

    project: Project
    chapters: Chapters
    left_out: Sequence[State]
    """Sections whose results are missing, damaged, or too old for the words that are now said of them."""

    @property
    def pages(self) -> dict[Page, list[Chapter]]:
        """Its pages with what each shows; one that would show nothing is not there."""
        chapters = self.chapters.values()
        shown = {page: [chapter for chapter in chapters if chapter.page == page] for page in PAGES}
        return {page: found for page, found in shown.items() if found or page == FRONT}

    @cached_property
    def clips(self) -> Clips | None:
        """Its clips; None when there are none that can be shown."""
        return clips_of(self.project)

    @cached_property
    def replay(self) -> dict[str, Any] | None:
        """The runs of its replay; None where they are not kept."""
        return replayed_runs(self.chapters)

    def unmeasured(self, page: Page) -> list[State]:
        """The sections of a page, or of all for the front page, that have not been measured."""
        missing = [state for state in self.left_out if state.kind == "missing"]
        return [state for state in missing if page in (FRONT, _page(_module(state.section)))]

    def texts(self, page: Page, templates: Templates, names: Mapping[str, Any]) -> list[Prose]:
        """The words of a page besides those of its sections; ``names`` are what they can name, and the sections."""
        return [self._text(templates.text(template), names) for template in page.texts]

    def _text(self, text: Text, names: Mapping[str, Any]) -> Prose:
        anchor = text.name.rpartition("/")[2].partition(".")[0]
        section = RETOLD[anchor](self.chapters) if anchor in RETOLD else Section()
        if not section.claims:  # where the shake test was not measured there is nothing to tell
            section = replace(section, unmeasured=[word for _, word in text.words])
        section = section.worded(anchor, text.name, text.words, Making("report/story/", "make page"))
        found = Found(self.chapters)
        sections = {name: chapter.section for name, chapter in self.chapters.items()}
        known = {
            "release": self.project.release,
            "sections": {name: chapter.names for name, chapter in self.chapters.items()},
            "is_told": bool(section.claims),
            "does_slip": found.does_slip,
            "overview": "overview" in section.figures,
            "cards": cards_of(self.chapters),
            "clips": self.clips,
            "replay": REPLAY if self.replay else "",
            "value": found.value,
            "cell": found.cell,
            "claim": _finder(anchor, "claim", {claim.name: found.marked(claim, anchor) for claim in section.claims}),
            "holds": _asker({**sections, anchor: section}, anchor),
            "table": _finder(anchor, "table", section.tables),
            "figure": _finder(anchor, "figure", section.figures),
        }
        return text.prose(anchor, {**known, **names})


def editions_of(project: Project, templates: Templates, among: Sequence[str] | None = None) -> dict[str, Edition]:
    """What the results of every release make, oldest first; ``among``: of these alone."""
    shown = project.releases if among is None else among
    derived = {release: derive_edition(project.of(release), templates) for release in shown}
    releases = {release: edition.chapters for release, edition in derived.items()}
    return {release: _compared(edition, releases, templates) for release, edition in derived.items()}


def derive_edition(project: Project, templates: Templates) -> Edition:
    """What the results of one release make by themselves: a section that compares releases has its results alone."""
    states = states_of(project)
    left_out = [state for state in states if not state.record]
    modules = [(state, _module(state.section)) for state in states if state.record]
    floors = noise_floors(state.record for state, _ in modules if state.section == NOISE)
    found: dict[str, Chapter] = {}
    for state, module in sorted(modules, key=lambda pair: pair[1].order):
        others = {name: chapter.results for name, chapter in found.items()}
        results = Results(state.record, project.record_path(state.section), others, floors=floors)
        try:
            if _compares(module):
                chapter = Chapter(state, results, Section(), {}, None, _page(module), compares=True)
            else:
                chapter = _chapter(project, state, results, derive_section(results, {}), templates, found)
        except Exception as error:
            left_out.append(_left_out(project, state, error))
        else:
            found[state.section] = chapter
    return Edition(project, found, left_out)


def _compared(edition: Edition, releases: Releases, templates: Templates) -> Edition:
    """The same with the sections that compare releases."""
    chapters, left_out = dict(edition.chapters), list(edition.left_out)
    for name, chapter in edition.chapters.items():
        if chapter.compares:
            results = replace(chapter.results, derived={})  # what is derived here is of this page alone
            try:
                section = derive_section(results, releases)
                made = _chapter(edition.project, chapter.state, results, section, templates, edition.chapters)
                chapters[name] = replace(made, compares=True)
            except Exception as error:
                left_out.append(_left_out(edition.project, chapter.state, error))
                del chapters[name]
    refuse_contradictions(edition.project.templates, {name: chapter.section for name, chapter in chapters.items()})
    return Edition(edition.project, chapters, left_out)


def derive_section(results: Results, releases: Releases) -> Section:
    """What a section makes of its results, its words not yet said; one that compares releases has them as well."""
    module = _module(results.record.section)
    try:
        return module.derive(results, releases) if _compares(module) else module.derive(results)
    except ReportError:
        raise
    except (ArithmeticError, AttributeError, LookupError, StopIteration, TypeError, ValueError) as error:
        what = f"{type(error).__name__}: {' '.join(str(error).split())}, {_line_of(error)}"
        raise LostError(f"its record lacks what the section is about ({what})") from error


def _chapter(
    project: Project, state: State, results: Results, section: Section, templates: Templates, before: Chapters
) -> Chapter:
    name = state.section
    module = _module(name)
    text = templates.text(f"sections/{name}.md.j2")
    source = f"report/sections/{name}/" if hasattr(module, "__path__") else f"report/sections/{name}.py"
    section = section.worded(name, text.name, text.words, Making(source, project.rerun(name)))
    names = _names(results, section, before)
    return Chapter(state, results, section, names, text.prose(name, names), _page(module))


def _module(section: str) -> ModuleType:
    return import_module(f"report.sections.{section}")


def _page(module: ModuleType) -> Page:
    return page_named(getattr(module, "page", DEFAULT), module.__name__)


def _compares(module: ModuleType) -> bool:
    """Whether a section compares releases: its ``derive`` then takes them as a second argument."""
    return len(inspect.signature(module.derive).parameters) > 1


def _left_out(project: Project, state: State, error: Exception) -> State:
    """A section that can't be shown, for the rest of the page stands without it.

    A record of older code may lack anything. One that is fresh should not: then it is damaged, or its section is wrong.
    A fault of the template, which is not the record's, stops the build.
    """
    if state.kind == "fresh" and project.is_own and not isinstance(error, RecordError | ResultsError | LostError):
        raise error
    words = str(error) if isinstance(error, ReportError) else f"{type(error).__name__}: {error}"
    kind = "damaged" if state.kind == "fresh" or isinstance(error, RecordError) else state.kind
    place = "" if isinstance(error, RecordError) else f"{place_of(project.record_path(state.section))}: "
    return replace(state, kind=kind, record=None, notes=(place + " ".join(words.split()),))


def _line_of(error: Exception) -> str:
    """Where an error was raised, for whoever has to mend it."""
    where = extract_tb(error.__traceback__)[-1]
    return f"{Path(where.filename).name}:{where.lineno}"


def _names(results: Results, section: Section, before: Chapters) -> dict[str, Any]:
    name = results.record.section
    claims = {claim.name: claim.html(name) for claim in section.claims}
    return {
        "release": results.record.identity.packages["newton"],
        "row": results.row,
        "rows": results.rows,
        "value": results.derived,
        "claim": _finder(name, "claim", claims),
        "holds": _asker({**{chapter: found.section for chapter, found in before.items()}, name: section}, name),
        "table": _finder(name, "table", section.tables),
        "figure": _finder(name, "figure", section.figures),
        "download": _finder(name, "download", {download.name: download for download in section.downloads}),
    }


def _asker(sections: Mapping[str, Section], own: str = "") -> Callable[[str], bool]:
    """Says of ``claim``, in the section ``own``, or of ``section.claim`` whether it holds; what was not measured does
    not."""

    def holds(name: str) -> bool:
        section, _, claim = name.rpartition(".")
        section = section or own
        if section not in sections:
            return False
        claims = {each.name: each.outcome == HOLDS for each in sections[section].claims}
        if claim not in claims and claim not in sections[section].unmeasured:
            raise ReportError(f"{section} has no claim {claim!r}; it has: {', '.join(claims) or 'none'}")
        return claims.get(claim, False)

    return holds


def _finder(section: str, kind: str, things: Mapping[str, Any]) -> Callable[[str], Any]:
    def find(name: str) -> Any:
        if name not in things:
            raise ReportError(f"{section} has no {kind} {name!r}; it has: {', '.join(things) or 'none'}")
        return things[name]

    return find
