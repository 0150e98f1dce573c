"""Render the texts of an edition's sections and pages from their templates."""

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
    """Return all editions of a project with drawn figures and rendered texts."""
    editions = editions_of(project, draws=True)
    give_words(editions, templates)
    releases = {
        release: dict(edition.chapters) for release, edition in editions.items()
    }
    for edition in editions.values():
        edition.update(partial(_rendered, edition, releases, templates))
    return editions


def give_words(editions: Mapping[str, Edition], templates: Templates) -> None:
    """Give the claims, figures and tables of all editions their wordings.

    Parts that only other editions derive are listed in ``Section.lost``.
    """
    derived: dict[str, set[tuple[str, str]]] = {}
    for edition in editions.values():
        for name, chapter in edition.chapters.items():
            derived.setdefault(name, set()).update(chapter.section.names)

    def worded(edition: Edition, chapter: Chapter) -> Chapter:
        template = template_of(chapter.name)
        words = templates.words(template)
        section = chapter.section
        lost_names = derived[chapter.name].intersection(words).difference(section.names)
        section = replace(section, lost=lost_names)
        section = section.worded(chapter.name, template, words, edition.root)
        return replace(chapter, section=section)

    for edition in editions.values():
        edition.update(partial(worded, edition))


def template_of(section: str) -> str:
    return f"sections/{section}.md.j2"


def sentences_of(project: Project) -> Callable[[str, Claim], str]:
    """Return a function that puts a claim of a section into words.

    The templates are parsed when it is called first.
    """
    templates = cache(lambda: Templates(project.templates))

    def sentence(section: str, claim: Claim) -> str:
        template = template_of(section)
        name = claim.wording_name
        if ("claim", name) not in (words := templates().words(template)):
            raise ReportError(
                f"templates/{template} does not contain the claim {name}: add "
                f"{{% claim {name} %}}"
            )
        return replace(claim, wording=words["claim", name]).text

    return sentence


def _rendered(
    edition: Edition, releases: Releases, templates: Templates, chapter: Chapter
) -> Chapter:
    """Return a chapter with its text.

    The text can depend on claims of all sections, and its tables on all releases.
    """
    name, results = chapter.name, chapter.results
    tables = {
        key: table.of(releases) if hasattr(table, "of") else table
        for key, table in chapter.section.tables.items()
    }
    section = replace(chapter.section, tables=tables)
    sections = {key: member.section for key, member in edition.chapters.items()}
    names = {
        "release": results.record.origin.release,
        "row": results.row,
        "rows": results.rows,
        "value": results.derived,
        **_names_of(edition, name, section, {**sections, name: section}),
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
    """Return the texts of a page that do not belong to a section.

    If a text cannot be rendered because results are missing or damaged, it is rendered
    as if no section had been measured.
    """
    files = {file.rpartition("/")[2].partition(".")[0]: file for file in page.texts}
    for anchor, file in files.items():
        story = edition.story(anchor, releases)
        edition.stories[anchor] = _worded(edition, anchor, file, story, templates)

    def render(edition: Edition, anchor: str, level: int) -> Prose:
        stories = {name: edition.stories[name] for name in files}
        text_names = {**_text_names(edition, anchor, stories), **names}
        return templates.prose(files[anchor], anchor, text_names, level)

    texts: list[Prose] = []
    for anchor, file in files.items():
        level = 2 if texts else 1
        try:
            prose = render(edition, anchor, level)
        except ReportError as error:
            if not (edition.left_out or isinstance(error, ResultsError)):
                raise
            if all(state.section != anchor for state in edition.left_out):
                state = State(anchor, Kind.NOT_SHOWN, notes=(str(error),))
                edition.left_out.append(state)
            empty = _worded(edition, anchor, file, Section(), templates)
            stories = {**edition.stories, anchor: empty}
            unmeasured = replace(edition, chapters={}, stories=stories)
            prose = render(unmeasured, anchor, level)
        texts.append(prose)
    return texts


def _text_names(edition: Edition, anchor: str, stories: Sections) -> Names:
    """Return the names for the template of a text: its story, sections and plugins."""
    story = stories[anchor]
    chapters = edition.chapters
    # A story without claims must not hide the section with the same name.
    sections = {
        name: section
        for name, section in stories.items()
        if section.claims or section.unmeasured
    }
    sections |= {name: chapter.section for name, chapter in chapters.items()}
    # The parts of a section that was not measured are empty.
    kinds = ("claim", "table", "figure", "download")
    empty_parts = dict.fromkeys(kinds, lambda name: Markup(""))
    unmeasured = dict.fromkeys(sections_of(edition.project.root), empty_parts)
    measured = {name: chapter.names for name, chapter in chapters.items()}
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
    """Return the section of a text with its wordings; all are empty without claims."""
    words = templates.words(template)
    if not section.claims:
        section = replace(section, unmeasured=[name for _, name in words])
    return section.worded(anchor, template, words, edition.root)


def _names_of(
    edition: Edition, anchor: str, section: Section, sections: Sections
) -> Names:
    """Return the functions that a template calls to print parts and passages."""
    # Parts whose numbers are missing from this edition's record are empty.
    empty = dict.fromkeys(section.unmeasured, Markup(""))
    # Claims that share a wording follow each other.
    claims: dict[str, Markup] = {}
    for claim in section.claims:
        before = claims.get(claim.wording_name, Markup(""))
        claims[claim.wording_name] = before + claim.html(anchor) + " "
    downloads = {name: macros().download(name) for name in section.downloads}
    parts: Mapping[str, Mapping[str, Any]] = {
        "claim": {**empty, **claims},
        "table": {**empty, **section.tables},
        "figure": {**empty, **section.figures},
        "download": downloads,
    }

    def find(name: str, claim: str) -> Claim | None:
        if name not in sections:
            outline_of(name)  # raises an error if there is no such section
            return None
        claims_by_name = {item.name: item for item in sections[name].claims}
        is_lost = ("claim", claim) in sections[name].lost
        is_expected = is_lost or claim in sections[name].unmeasured
        if claim not in claims_by_name and not is_expected:
            present = ", ".join(claims_by_name) or "none"
            raise ReportError(
                f"section {name} does not have a claim {claim!r}: use one of its "
                f"claims ({present})"
            )
        return claims_by_name.get(claim)

    def holds(query: str) -> bool:
        name, _, claim = query.rpartition(".")
        needed = find(name or anchor, claim)
        return needed is not None and needed.outcome == HOLDS

    def find_part(kind: str, name: str) -> Any:
        if (kind, name) in section.lost:
            reason = "it cannot be derived from the record of this edition"
            command = edition.project.rerun(anchor)
            title = f"The {kind} {name} is left out here"
            return macros().left_out(
                title, f"{reason}. Run {command} to measure it again"
            )
        if name not in parts[kind]:
            present = ", ".join(parts[kind]) or "none"
            raise ReportError(
                f"{anchor} does not have a {kind} {name!r}: use one of {present}"
            )
        return parts[kind][name]

    finders = {kind: partial(find_part, kind) for kind in parts}
    return {"holds": holds, "passage": passages(find), **finders}
