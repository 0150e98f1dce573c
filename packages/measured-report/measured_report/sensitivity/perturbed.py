"""Altered records: what a section would say if something else had been measured."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Any

import pandas as pd

from measured_report.deriving.chapters import Chapters
from measured_report.deriving.editions import derive_section, editions_of
from measured_report.editions.project import Project, own_release
from measured_report.pages.page import Templates
from measured_report.parts.parts import Section
from measured_report.records.columns import REASON, column_of
from measured_report.records.record import Record
from measured_report.records.traces import load_trace
from measured_report.values.noise import NOISE, noise_floors
from measured_report.values.results import Results, Series

MUTATIONS = ("×0", "×−1", "×1000", "×0.001", "missing")
FACTORS = {"×0": 0.0, "×−1": -1.0, "×1000": 1000.0, "×0.001": 0.001}
LACK = "left out on purpose"

load_trace_once = lru_cache(maxsize=64)(load_trace)


@dataclass(frozen=True)
class Cell:
    """A number of a record, or a whole trace, by its pointer below ``data/``."""

    pointer: str

    @property
    def file(self) -> str:
        return self.pointer.partition("#")[0]

    @property
    def place(self) -> tuple[int, str]:
        """Row and column."""
        _, _, index, column = self.pointer.partition("#")[2].split("/")
        return int(index), column

    @property
    def is_trace(self) -> bool:
        return "#" not in self.pointer


def mutated(value: Any, mutation: str) -> Any:
    return None if mutation == "missing" or value is None else FACTORS[mutation] * value


def with_cell(record: Record, cell: Cell, mutation: str) -> Record:
    """The record with one number mutated; a missing one says why."""
    if "/rows/" not in cell.pointer:  # how long the measurement took, which a record never lacks
        seconds = record.measured["seconds"] * FACTORS.get(mutation, 0.0)
        return replace(record, measured={**record.measured, "seconds": seconds})
    index, column = cell.place
    rows = list(record.rows)
    reason = {column + REASON: LACK} if mutation == "missing" else {}
    rows[index] = {**reason, **rows[index], column: mutated(rows[index][column], mutation)}
    return replace(record, rows=rows)


@dataclass(frozen=True)
class AlteredResults(Results):
    """Results of which a trace may be mutated; traces are read once."""

    traces: Mapping[str, str] = field(default_factory=dict)
    """Mutation by the pointer of the trace."""

    def trace(self, case: str) -> Series:
        series = super().trace(case)
        mutation = self.traces.get(series.source, "")
        if mutation == "missing":
            return Series(None, series.source, LACK)
        if mutation and series.value is not None:
            return replace(series, value=_scaled(series.value, FACTORS[mutation]))
        return series


def _scaled(frame: pd.DataFrame, factor: float) -> pd.DataFrame:
    columns = [name for name in frame.select_dtypes("number") if name != "time_s" and not column_of(name).is_setting]
    return frame.assign(**{column: factor * frame[column] for column in columns})


@dataclass(frozen=True)
class World:
    """The chapters of all releases, in which records are replaced and sections derived again, in memory."""

    releases: Mapping[str, Chapters]
    templates: Templates

    def section(self, release: str, name: str, records: Mapping[str, Record], traces: Mapping[str, str]) -> Section:
        """A section as these records, by their file below ``data/``, and mutated traces make it.

        Sections between an altered one and this one stay as they are.
        """
        releases = {
            each: {
                section: replace(chapter, results=self._results(each, section, records, traces))
                if chapter.results.source in records and (each, section) != (release, name)
                else chapter
                for section, chapter in chapters.items()
            }
            for each, chapters in self.releases.items()
        }
        results = self._bare(release, name, records, traces)
        releases[release][name] = replace(releases[release][name], results=results)
        others = {other: releases[release][other].results for other in results.others}
        section = derive_section(replace(results, others=others), releases)
        text = self.templates.text(f"sections/{name}.md.j2")
        return section.worded(name, text.name, text.words)

    def _bare(
        self, release: str, name: str, records: Mapping[str, Record], traces: Mapping[str, str]
    ) -> AlteredResults:
        kept = self.releases[release][name].results
        record = records.get(kept.source, kept.record)
        noise = records.get(f"{kept.path.parent.name}/{NOISE}.json")
        floors = noise_floors([noise]) if noise else kept.floors
        return AlteredResults(record, kept.path, kept.others, {}, floors, kept.label, traces)

    def _results(self, release: str, name: str, records: Mapping[str, Record], traces: Mapping[str, str]) -> Results:
        results = self._bare(release, name, records, traces)
        derive_section(results, self.releases)
        return results

    def mutated(self, release: str, name: str, cells: Iterable[Cell], mutation: str) -> Section:
        """A section with the same done to some numbers and traces."""
        records: dict[str, Record] = {}
        for cell in cells:
            if not cell.is_trace:
                record = records.get(cell.file) or self._record(cell.file)
                records[cell.file] = with_cell(record, cell, mutation)
        return self.section(release, name, records, {cell.pointer: mutation for cell in cells if cell.is_trace})

    def _record(self, file: str) -> Record:
        for chapters in self.releases.values():
            for chapter in chapters.values():
                if chapter.results.source == file:
                    return chapter.results.record
        raise KeyError(file)


def tracked_world() -> World:
    """What is tracked, before anything is altered."""
    project = Project(own_release())
    templates = Templates(project.templates)
    editions = editions_of(project, templates)
    return World({release: edition.chapters for release, edition in editions.items()}, templates)
