"""The site: every section that has results, checked first, then drawn, then put in place as a whole."""

import importlib.util
import json
import os
import shutil
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import ModuleType
from typing import Any

from report.format import format_time
from report.overview import overview
from report.page import Prose, Templates
from report.parts import PlacedFigure, Section
from report.project import Project
from report.quantities import VALUES_FILE
from report.results import Results, ResultsError
from report.status import State, machine_name
from report.traces import traces_of


@dataclass(frozen=True)
class Chapter:
    """A section that is shown."""

    state: State
    results: Results
    section: Section
    names: Mapping[str, Any]
    """What its template can name, and the summary through ``sections``."""
    prose: Prose

    @property
    def name(self) -> str:
        return self.state.section

    @property
    def machine(self) -> str:
        return machine_name(self.results.record)


@dataclass(frozen=True)
class Report:
    """What the site shows, checked and ready to be drawn."""

    project: Project
    chapters: Sequence[Chapter]
    left_out: Sequence[State]
    """Sections whose results are missing, damaged, or too old for the words that are now said of them."""
    summary: Prose


def assemble(project: Project, states: Sequence[State]) -> Report:
    """Derive all that is shown and render every template, but draw nothing yet."""
    templates = Templates(project.templates)
    shown = [(state, _load_module(project, state.section)) for state in states if state.record]
    left_out = [state for state in states if not state.record]
    chapters: dict[str, Chapter] = {}
    for state, module in sorted(shown, key=lambda pair: pair[1].order):
        others = {name: chapter.results for name, chapter in chapters.items()}
        results = Results(state.record, project.record_path(state.section), others)
        try:
            section = module.derive(results)
            names = _names(results, section)
            prose = templates.prose(f"sections/{state.section}.md.j2", state.section, names)
        except ResultsError as error:
            if state.name == "fresh":
                raise
            left_out.append(replace(state, record=None, notes=(str(error),)))
        else:
            chapters[state.section] = Chapter(state, results, section, names, prose)
    sections = {name: chapter.names for name, chapter in chapters.items()}
    figure = overview({name: chapter.results for name, chapter in chapters.items()})
    placed = PlacedFigure("summary-overview", figure) if figure else None
    summary = templates.prose("summary.md.j2", "summary", {"sections": sections, "overview": placed})
    return Report(project, list(chapters.values()), left_out, summary)


def build(report: Report) -> None:
    """Write the site; until it is whole, the one that was there stays."""
    project = report.project
    fresh = project.root / f".site-{os.getpid()}"
    try:
        _write(fresh, report)
        _replace(project.site, fresh)
    finally:
        shutil.rmtree(fresh, ignore_errors=True)


def _names(results: Results, section: Section) -> dict[str, Any]:
    name = results.record.section
    claims = {claim.name: claim.html(name) for claim in section.claims}
    figures = {key: PlacedFigure(f"{name}-{key}", figure) for key, figure in section.figures.items()}
    return {
        "row": results.row,
        "rows": results.rows,
        "value": results.derived,
        "claim": _finder(name, "claim", claims),
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


def _load_module(project: Project, section: str) -> ModuleType:
    path = project.root / "report" / "sections" / f"{section}.py"
    spec = importlib.util.spec_from_file_location(f"report.sections.{section}", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _write(folder: Path, report: Report) -> None:
    project, chapters = report.project, report.chapters
    data = folder / "data" / project.results.name
    data.mkdir(parents=True)
    (folder / ".gitkeep").touch()
    html = Templates(project.templates).layout("base.html.j2", {"report": report, "format_time": format_time})
    (folder / "index.html").write_text(html, encoding="utf-8")
    shutil.copyfile(project.root / "assets" / "style.css", folder / "style.css")
    for chapter in chapters:
        for path in (chapter.results.path, *traces_of(chapter.results.path)):
            shutil.copyfile(path, data / path.name)
        for download in chapter.section.downloads:
            path = folder / "download" / download.name
            path.parent.mkdir(exist_ok=True)
            path.write_text(download.text, encoding="utf-8")
    values = {
        chapter.name: {name: value.entry for name, value in chapter.results.derived.items()} for chapter in chapters
    }
    text = json.dumps(values, indent=1, ensure_ascii=False, allow_nan=False)
    (folder / "data" / VALUES_FILE).write_text(text + "\n", encoding="utf-8")


def _replace(site: Path, fresh: Path) -> None:
    old = fresh.with_name(f"{fresh.name}-old")
    if site.exists():
        os.rename(site, old)
    os.rename(fresh, site)
    shutil.rmtree(old, ignore_errors=True)
