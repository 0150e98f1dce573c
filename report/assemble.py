"""Assembling: every section of a release that has results is derived and put into words; nothing is drawn yet."""

import inspect
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path
from types import ModuleType
from typing import Any

from report import ReportError
from report.claims import HOLDS
from report.overview import overview
from report.page import Prose, Templates
from report.parts import PlacedFigure, Section
from report.project import Project
from report.quantities import VALUES_FILE
from report.results import Results, ResultsError
from report.status import State, states_of


@dataclass(frozen=True)
class Derived:
    """What a section makes of its record."""

    state: State
    results: Results
    section: Section

    @property
    def name(self) -> str:
        return self.state.section

    @property
    def values(self) -> dict[str, dict]:
        """What the site's values file says of it."""
        return {name: value.entry for name, value in self.results.derived.items()}


Sections = Mapping[str, Derived]
"""The sections of one release by name, in the order of the page."""


@dataclass(frozen=True)
class Derivation:
    """What the results of one release make."""

    sections: Sections
    left_out: Sequence[State]
    """Sections whose results are missing, damaged, or too old to be derived from."""
    values_file: str
    """Where the derived values lie below the site's ``data/``."""


@dataclass(frozen=True)
class Chapter(Derived):
    """A section that is shown."""

    names: Mapping[str, Any]
    """What its template can name, and the summary through ``sections``."""
    prose: Prose


@dataclass(frozen=True)
class Report:
    """What one release's page shows, checked and ready to be drawn."""

    project: Project
    chapters: Sequence[Chapter]
    left_out: Sequence[State]
    """Sections whose results are missing, damaged, or too old for the words that are now said of them."""
    summary: Prose
    values_file: str
    """Where the derived values lie below the site's ``data/``."""

    @property
    def shown(self) -> list[str]:
        return [chapter.name for chapter in self.chapters]


def assemble(project: Project, derivations: Mapping[str, Derivation]) -> Report:
    """Render every template of one release's report.

    Args:
        project: The report.
        derivations: What the results of every release make, by release, oldest first.
    """
    own = derivations[project.release]
    releases = {name: derivation.sections for name, derivation in derivations.items()}
    left_out = list(own.left_out)
    templates = Templates(project.templates)
    chapters: dict[str, Chapter] = {}
    for name, derived in own.sections.items():
        results, section = derived.results, derived.section
        try:
            module = _module(project, name)
            if _compares(module):
                results = replace(results, derived={})  # what is derived here is of this page alone
                section = module.derive(results, releases)
            names = _names(results, section)
            prose = templates.prose(f"sections/{name}.md.j2", name, names)
        except Exception as error:
            left_out.append(_left_out(project, derived.state, error))
        else:
            chapters[name] = Chapter(derived.state, results, section, names, prose)
    return Report(
        project=project,
        chapters=list(chapters.values()),
        left_out=left_out,
        summary=_summary(templates, chapters),
        values_file=own.values_file,
    )


def derive_releases(project: Project) -> dict[str, Derivation]:
    """What the results of every release make, oldest first."""
    return {name: derive_release(project.of(name), values_file_of(name)) for name in project.releases}


def derive_release(project: Project, values_file: str) -> Derivation:
    """What the results of one release make.

    A section that compares releases is derived only for the page that it stands on; here it has its results alone.
    """
    states = states_of(project)
    left_out = [state for state in states if not state.record]
    modules = [(state, _module(project, state.section)) for state in states if state.record]
    found: dict[str, Derived] = {}
    for state, module in sorted(modules, key=lambda pair: pair[1].order):
        others = {name: derived.results for name, derived in found.items()}
        results = Results(state.record, project.record_path(state.section), others, values_file=values_file)
        try:
            section = Section() if _compares(module) else module.derive(results)
        except Exception as error:
            left_out.append(_left_out(project, state, error))
        else:
            found[state.section] = Derived(state, results, section)
    return Derivation(found, left_out, values_file)


def values_file_of(release: str) -> str:
    """Where the values that are derived from a release lie, on the page of another one."""
    return f"newton-{release}/{VALUES_FILE}"


def _compares(module: ModuleType) -> bool:
    """Whether a section compares releases: its ``derive`` then takes them as a second argument."""
    return len(inspect.signature(module.derive).parameters) > 1


def _left_out(project: Project, state: State, error: Exception) -> State:
    """A section that can't be shown: a record of older code or of another release may lack anything."""
    if state.kind == "fresh" and project.is_own:
        raise error
    words = str(error) if isinstance(error, ReportError) else f"{type(error).__name__}: {error}"
    return replace(state, record=None, notes=(" ".join(words.split()),))


def _summary(templates: Templates, chapters: Mapping[str, Chapter]) -> Prose:
    sections = {name: chapter.names for name, chapter in chapters.items()}
    figure = overview({name: chapter.results for name, chapter in chapters.items()})
    placed = PlacedFigure("summary-overview", figure) if figure else None
    return templates.prose("summary.md.j2", "summary", {"sections": sections, "overview": placed})


def _names(results: Results, section: Section) -> dict[str, Any]:
    name = results.record.section
    claims = {claim.name: claim.html(name) for claim in section.claims}
    figures = {key: PlacedFigure(f"{name}-{key}", figure) for key, figure in section.figures.items()}
    return {
        "release": results.record.identity.packages["newton"],
        "row": results.row,
        "rows": results.rows,
        "value": results.derived,
        "claim": _finder(name, "claim", claims),
        "holds": _finder(name, "claim", {claim.name: claim.outcome == HOLDS for claim in section.claims}),
        "table": _finder(name, "table", section.tables),
        "figure": _finder(name, "figure", figures),
        "download": _finder(name, "download", {download.name: download for download in section.downloads}),
    }


def _finder(section: str, kind: str, things: Mapping[str, Any]) -> Callable[[str], Any]:
    def find(name: str) -> Any:
        if name not in things:
            raise ResultsError(f"{section} has no {kind} {name!r}; it has: {', '.join(things) or 'none'}")
        return things[name]

    return find


def _module(project: Project, section: str) -> ModuleType:
    path = project.root / "report" / "sections" / f"{section}.py"
    return _run_module(path, path.read_text(encoding="utf-8"))


@cache  # by the text itself: one module derives every release
def _run_module(path: Path, text: str) -> ModuleType:
    module = ModuleType(f"report.sections.{path.stem}")
    exec(compile(text, path, "exec"), vars(module))
    return module
