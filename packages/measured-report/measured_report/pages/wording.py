"""Words: what an edition's sections and pages say, as their templates have it."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from functools import cache, partial
from typing import Any

from markupsafe import Markup

from measured_report.editions.project import Project
from measured_report.editions.status import Kind, State
from measured_report.files.errors import ReportError
from measured_report.files.settings import Page
from measured_report.findings.chapters import Chapter, Releases
from measured_report.findings.editions import Edition, editions_of
from measured_report.findings.sections import outline_of
from measured_report.pages.passages import passages
from measured_report.pages.prose import Templates
from measured_report.parts.claim import HOLDS, Claim
from measured_report.parts.macros import macros
from measured_report.parts.prose import Prose
from measured_report.parts.section import Section
from measured_report.records.identity import sections as sections_of
from measured_report.values.results import ResultsError

Sections = Mapping[str, Section]
Names = Mapping[str, Any]


def worded_editions(project: Project, templates: Templates) -> dict[str, Edition]:
    """Derive what the results of every release make, drawn, and put it into words."""
    editions = editions_of(project, draws=True)
    give_words(editions, templates)
    releases = {release: dict(each.chapters) for release, each in editions.items()}
    for edition in editions.values():
        edition.update(partial(_say, edition, releases, templates))
    return editions


def give_words(editions: Mapping[str, Edition], templates: Templates) -> None:
    """Give claims, figures and tables their words, which are not yet said.

    What only other editions derive of a section is lost in this one.
    """
    derived: dict[str, set[tuple[str, str]]] = {}
    for edition in editions.values():
        for name, chapter in edition.chapters.items():
            derived.setdefault(name, set()).update(chapter.section.names)

    def worded(edition: Edition, chapter: Chapter) -> Chapter:
        template = template_of(chapter.name)
        words = templates.words(template)
        section = chapter.section
        lost = derived[chapter.name].intersection(words).difference(section.names)
        section = replace(section, lost=lost)
        section = section.worded(chapter.name, template, words, edition.root)
        return replace(chapter, section=section)

    for edition in editions.values():
        edition.update(partial(worded, edition))


def template_of(section: str) -> str:
    return f"sections/{section}.md.j2"


def sentences_of(project: Project) -> Callable[[str, Claim], str]:
    """Return what says a claim of a section; templates are parsed when one is said."""
    templates = cache(lambda: Templates(project.templates, project.report))

    def say(section: str, claim: Claim) -> str:
        template = template_of(section)
        if ("claim", claim.name) not in (words := templates().words(template)):
            raise ReportError(
                f"templates/{template} says nothing of the claim {claim.name}"
            )
        return replace(claim, wording=words["claim", claim.name]).text

    return say


def _say(
    edition: Edition, releases: Releases, templates: Templates, chapter: Chapter
) -> Chapter:
    """Say a section, which may rest on claims of all sections, or of all releases."""
    name, results = chapter.name, chapter.results
    tables = {
        key: table.of(releases) if hasattr(table, "of") else table
        for key, table in chapter.section.tables.items()
    }
    section = replace(chapter.section, tables=tables)
    others = {key: other.section for key, other in edition.chapters.items()}
    names = {
        "release": results.record.origin.release,
        "row": results.row,
        "rows": results.rows,
        "value": results.derived,
        **_names_of(edition, name, section, {**others, name: section}),
    }
    prose = templates.prose(template_of(name), name, names)
    return replace(chapter, section=section, names=names, prose=prose)


def texts_of(
    edition: Edition,
    page: Page,
    releases: Releases,
    templates: Templates,
    names: Names,
) -> list[Prose]:
    """Say a page's own texts; one that can't be said is said as if nothing was measured."""
    files = {file.rpartition("/")[2].partition(".")[0]: file for file in page.texts}
    for anchor, file in files.items():
        story = edition.story(anchor, releases)
        edition.stories[anchor] = _worded(edition, anchor, file, story, templates)

    def say(edition: Edition, anchor: str, level: int) -> Prose:
        stories = {name: edition.stories[name] for name in files}
        told = {**_text_names(edition, anchor, stories), **names}
        return templates.prose(files[anchor], anchor, told, level)

    texts: list[Prose] = []
    for anchor, file in files.items():
        level = 2 if texts else 1
        try:
            prose = say(edition, anchor, level)
        except ReportError as error:
            if not (edition.left_out or isinstance(error, ResultsError)):
                raise
            if all(state.section != anchor for state in edition.left_out):
                state = State(anchor, Kind.NOT_SHOWN, notes=(str(error),))
                edition.left_out.append(state)
            untold = _worded(edition, anchor, file, Section(), templates)
            stories = {**edition.stories, anchor: untold}
            prose = say(replace(edition, chapters={}, stories=stories), anchor, level)
        texts.append(prose)
    return texts


def _text_names(edition: Edition, anchor: str, stories: Sections) -> Names:
    """Return what a text can name: its own story, sections, and what plugins have."""
    story = stories[anchor]
    chapters = edition.chapters
    # A text that tells nothing of its own is no stand-in for the section of its name.
    sections = {
        name: section
        for name, section in stories.items()
        if section.claims or section.unmeasured
    }
    sections |= {name: chapter.section for name, chapter in chapters.items()}
    # What was not measured says nothing.
    kinds = ("claim", "table", "figure", "download")
    nothing = dict.fromkeys(kinds, lambda thing: Markup(""))
    unmeasured = dict.fromkeys(sections_of(edition.project.root), nothing)
    measured = {name: each.names for name, each in chapters.items()}
    return {
        "release": edition.project.release,
        "measured": list(chapters),
        "sections": unmeasured | measured,
        **_names_of(edition, anchor, story, sections),
        **edition.plugins.names(story),
    }


def _worded(
    edition: Edition, anchor: str, template: str, section: Section, templates: Templates
) -> Section:
    """Give what a text tells its words; where nothing was measured it tells nothing."""
    words = templates.words(template)
    if not section.claims:
        section = replace(section, unmeasured=[name for _, name in words])
    return section.worded(anchor, template, words, edition.root)


def _names_of(
    edition: Edition, anchor: str, section: Section, sections: Sections
) -> Names:
    """Return what finds the parts of a section, and says what rests on claims of others."""
    # Words that only another record has are said as nothing.
    nothing = dict.fromkeys(section.unmeasured, Markup(""))
    claims = {claim.name: claim.html(anchor) for claim in section.claims}
    downloads = {name: macros().download(name) for name in section.downloads}
    parts: Mapping[str, Mapping[str, Any]] = {
        "claim": {**nothing, **claims},
        "table": {**nothing, **section.tables},
        "figure": {**nothing, **section.figures},
        "download": downloads,
    }

    def find(name: str, claim: str) -> Claim | None:
        if name not in sections:
            outline_of(name)  # refuses a name that no section has
            return None
        claims = {item.name: item for item in sections[name].claims}
        is_lost = ("claim", claim) in sections[name].lost
        is_unsaid = is_lost or claim in sections[name].unmeasured
        if claim not in claims and not is_unsaid:
            present = ", ".join(claims) or "none"
            raise ReportError(f"{name} has no claim {claim!r}; it has: {present}")
        return claims.get(claim)

    def holds(query: str) -> bool:
        name, _, claim = query.rpartition(".")
        needed = find(name or anchor, claim)
        return needed is not None and needed.outcome == HOLDS

    def find_part(kind: str, name: str) -> Any:
        if (kind, name) in section.lost:
            reason = "it cannot be derived from what was measured"
            again = edition.project.rerun(anchor)
            what = f"The {kind} {name} is left out here"
            return macros().left_out(what, f"{reason}; {again} measures it")
        if name not in parts[kind]:
            present = ", ".join(parts[kind]) or "none"
            raise ReportError(f"{anchor} has no {kind} {name!r}; it has: {present}")
        return parts[kind][name]

    finders = {kind: partial(find_part, kind) for kind in parts}
    return {"holds": holds, "passage": passages(find), **finders}
