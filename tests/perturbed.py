"""Perturb results to test how sections react to other numbers."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, fields, replace
from functools import lru_cache
from importlib import import_module
from inspect import signature
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from conftest import contents, undrawn
from current_columns import column_of

from measured_report.files.config import report
from measured_report.findings.chapters import Chapters
from measured_report.findings.editions import Edition
from measured_report.findings.sections import derive_section
from measured_report.pages.prose import Templates
from measured_report.parts.claim import Claim
from measured_report.parts.section import Section
from measured_report.records.record import Record
from measured_report.records.traces import load_trace
from measured_report.values.evidence import Evidence, repeats_of
from measured_report.values.quantities import Pointer
from measured_report.values.results import Results, Series

if TYPE_CHECKING:
    import pandas as pd

FACTORS = {
    "×0": 0.0,
    "×1000": 1000.0,
    "×−1": -1.0,
    "×0.001": 0.001,
    "×2": 2.0,
    "×½": 0.5,
}
"""Changes of a number."""
load_trace_once = lru_cache(maxsize=None)(load_trace)


def perturbed(value: Any, change: str) -> Any:
    return None if value is None else FACTORS[change] * value


def perturbed_record(record: Record, pointer: Pointer, change: str) -> Record:
    """Return the record with one number changed."""
    index, column = pointer.cell
    rows = list(record.rows)
    rows[index] = {**rows[index], column: perturbed(rows[index][column], change)}
    return replace(record, rows=rows)


@dataclass(frozen=True)
class PerturbedResults(Results):
    """Holds results in which a trace may be changed. Traces are read once."""

    traces: Mapping[str, str] = field(default_factory=dict)
    """Change of each trace, by its pointer."""

    def loaded(self, *place: Any) -> "pd.DataFrame":
        return load_trace_once(*place)

    def trace(self, case: str) -> Series:
        series = super().trace(case)
        change = self.traces.get(series.source)
        if change and series.value is not None:
            names = set(series.value.select_dtypes("number")) - {"time_s"}
            scaled = {
                name: FACTORS[change] * series.value[name]
                for name in names
                if not column_of(name).is_setting
            }
            return replace(series, value=series.value.assign(**scaled))
        return series


@dataclass(frozen=True)
class Perturbation:
    """Derives sections again from perturbed results, in memory, among the tracked
    chapters of all releases.
    """

    releases: Mapping[str, Chapters]
    templates: Templates
    pages: Mapping[str, str] = field(default_factory=dict)
    """Words of a release."""

    def of(
        self, release: str, name: str, pointers: Iterable[Pointer], change: str
    ) -> Section:
        """Derive a section with the same change in some numbers and traces."""
        tracked = (
            chapter.results
            for chapters in self.releases.values()
            for chapter in chapters.values()
        )
        whole = {results.source: results.record for results in tracked}
        records: dict[str, Record] = {}
        traces = {}
        for pointer in pointers:
            if "#" not in pointer.text:
                traces[pointer.text] = change
            else:
                record = records.get(pointer.file) or whole[pointer.file]
                records[pointer.file] = perturbed_record(record, pointer, change)
        return self.section(release, name, records, traces)

    def section(
        self,
        release: str,
        name: str,
        records: Mapping[str, Record],
        traces: Mapping[str, str] = MappingProxyType({}),
    ) -> Section:
        """Derive a section or the claims of a text from these records, by their file
        below ``data/``, and from changed traces. Sections on which this one depends are
        not derived again unless their records changed.
        """
        releases = {each: dict(chapters) for each, chapters in self.releases.items()}
        for each, chapters in releases.items():
            for section, chapter in chapters.items():
                if chapter.results.source in records and (each, section) != (
                    release,
                    name,
                ):
                    results = self._results(each, section, records, traces)
                    derive_section(results, self.releases)
                    chapters[section] = replace(chapter, results=results)
        if (
            name not in releases[release]
        ):  # the claims of a page's text have no record of their own
            derive = import_module(f"{report().settings.text_modules}.{name}").derive
            return (
                derive(releases, release)
                if len(signature(derive).parameters) > 1
                else derive(releases[release])
            )
        own = self._results(release, name, records, traces)
        releases[release][name] = replace(releases[release][name], results=own)
        others = {other: releases[release][other].results for other in own.others}
        return derive_section(replace(own, others=others), releases)

    def worded(self, section: Section, name: str) -> Section:
        """Return the section with all of its words."""
        template = f"sections/{name}.md.j2"
        return section.worded(name, template, self.templates.words(template))

    def says_before(self, release: str, section: str, claim: Claim) -> bool:
        """Return whether an earlier release gives the same answer, with the same
        numbers in the same words.
        """
        earlier = [
            self.releases[name]
            for name in list(self.pages)[: list(self.pages).index(release)]
        ]
        claims = [
            each
            for chapters in earlier
            if section in chapters
            for each in chapters[section].section.claims
        ]
        return (claim.name, claim.outcome.answer) in [
            (each.name, each.outcome.answer) for each in claims
        ]

    def _results(
        self,
        release: str,
        name: str,
        records: Mapping[str, Record],
        traces: Mapping[str, str],
    ) -> PerturbedResults:
        """Return the perturbed results of a section before any value is derived."""
        tracked = self.releases[release][name].results
        record = records.get(tracked.source, tracked.record)
        noise = records.get(
            f"{tracked.path.parent.name}/{report().settings.noise_section}.json"
        )
        repeats = (
            repeats_of(noise.rows, tracked.columns)
            if noise
            else tracked.evidence.repeats
        )
        evidence = (
            tracked.evidence
            if record is tracked.record and not noise
            else Evidence(repeats=repeats)
        )
        changed = {
            "record": record,
            "derived": {},
            "evidence": evidence,
            "traces": traces,
        }
        return PerturbedResults(
            **{each.name: getattr(tracked, each.name) for each in fields(tracked)}
            | changed
        )


def of_editions(
    editions: Mapping[str, Edition], templates: Templates, told: Iterable[str]
) -> Perturbation:
    """Return the perturbation of some editions, with the words of the releases that are
    rendered.
    """
    there = {release: contents(editions, templates, release) for release in told}
    pages = {
        release: "".join(undrawn(content.parts) for content in found)
        for release, found in there.items()
    }
    return Perturbation(
        {release: edition.chapters for release, edition in editions.items()},
        templates,
        pages,
    )
