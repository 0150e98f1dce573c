"""Show where a number comes from: page, rows, case and command."""

import argparse
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import groupby
from typing import Any

from measured_report.changes.query import Query
from measured_report.commands.options import refuse_unmeasured, shared
from measured_report.editions.project import Project
from measured_report.files.config import config
from measured_report.files.errors import UsageError
from measured_report.files.suggestion import suggestion
from measured_report.pages.chapters import Chapter, Chapters
from measured_report.pages.editions import Edition, editions_of
from measured_report.pages.prose import Templates
from measured_report.records.columns import changed_parameters, is_setting
from measured_report.records.record import Record
from measured_report.site.pages import undrawn
from measured_report.values.format import unit_label
from measured_report.values.noise import NOISE
from measured_report.values.quantities import VALUES_FILE, Pointer, Quantity, Value

ANCHOR = re.compile(' id="([^"]+)"| data-src="([^"]+)"')

OPTIONS = shared("value", "edition", "profile")


def run(project: Project, arguments: argparse.Namespace) -> int:
    """Print the way of one value, from the page back to rows, cases and command."""
    if not arguments.value:
        rules = config().changes
        forms = f"{rules.example_value}, or a number of a row, VALUE={rules.headline}"
        raise UsageError(f"VALUE is missing: make trace VALUE={forms}")
    refuse_unmeasured(project, arguments.release.asked)
    templates = Templates(project.templates)
    print(Provenance(project, editions_of(project, templates), templates).text(arguments.value))
    return 0


@dataclass(frozen=True)
class Provenance:
    """Provenance of the numbers of all editions, as the pages of one of them show them."""

    project: Project
    editions: Mapping[str, Edition]
    templates: Templates

    def text(self, name: str) -> str:
        """Return the provenance of a value, ``section.name``, or a number of a row, ``section.case.column``, in lines.

        The pointer that a page has for either will do; UsageError for an unknown one.
        """
        found = self._found(name)
        lines = [f"{name}: {_said(found)}", *self._of_value(found), *self._on_pages(found)]
        cells = sorted(map(Pointer, _leaves(found)), key=lambda cell: (cell.file, *(cell.cell or (-1, cell.text))))
        for file, of_file in groupby(cells, key=lambda cell: cell.file):
            lines += ["", *self._of_record(file, list(of_file))]
        return "\n".join(lines)

    def _found(self, name: str) -> Quantity:
        release, package, query = self.project.release, config().package, Query(name)
        found = query.quantity(self._chapters)
        if isinstance(found, Quantity) and found.source:
            return found
        pointer = name if name.startswith(f"{package}-") else f"{package}-{release}/{name}"
        if known := self._values.get(pointer) or self._cell(pointer):
            return known
        fault = f"{query.given} is no value of {package} {release}{suggestion(name, query.names(self._chapters))}"
        rows = f"numbers of rows named as {config().changes.headline}"
        raise UsageError(f"{fault}; all values are in site/data/{VALUES_FILE}, {rows}")

    @property
    def _chapters(self) -> Chapters:
        return self.editions[self.project.release].chapters

    @cached_property
    def _records(self) -> Mapping[str, Chapter]:
        """Chapters by the file of their record."""
        chapters = (chapter for edition in self.editions.values() for chapter in edition.chapters.values())
        return {chapter.results.source: chapter for chapter in chapters}

    @cached_property
    def _values(self) -> Mapping[str, Value]:
        return {value.source: value for chapter in self._records.values() for value in chapter.results.derived.values()}

    def _cell(self, pointer: str) -> Quantity | None:
        """Return the number of a record that a pointer leads to."""
        file, cell = Pointer(pointer).file, Pointer(pointer).cell
        if not cell or file not in self._records:
            return None
        found = (row[cell[1]] for row in self._records[file].results.rows if cell[1] in row)
        return next((each for each in found if isinstance(each, Quantity) and each.source == pointer), None)

    def _of_value(self, found: Quantity) -> Iterator[str]:
        if isinstance(found, Value):
            yield f"  is          {found.formula}"
            for value in (self._values[pointer] for pointer in found.sources if pointer in self._values):
                name = ".".join(value.source.split("/", 3)[2:])
                yield f"  made of     {name}, {_said(value)}: {value.formula}"
        cells = [pointer for pointer in _leaves(found) if not is_setting(pointer)]
        yield f"  n           {len(cells)} measured numbers and traces"
        if cells:
            whence = ", by that of what it is made of" if isinstance(found, Value) else ""
            known = "not known" if found.noise is None else _in_unit(found.noise, found.unit)
            yield f"  noise       {known}{whence}"

    def _noise_of(self, cell: Pointer, index: int, column: str) -> str:
        """Say the noise of a number of a record, and whence it is known, if it is."""
        found = self._cell(cell.text)
        if not (found and found.noise):
            return ""
        whence = "its frames"
        if f"{column}_p5" not in self._records[cell.file].results.record.rows[index]:
            runs = self._records[f"{cell.file.partition('/')[0]}/{NOISE}.json"].results.record.rows
            whence = f"section {NOISE}, n {len(runs)}"
        return f", noise {_in_unit(found.noise, found.unit)} ({whence})"

    def _on_pages(self, found: Quantity) -> Iterator[str]:
        """Say where the pages print a number, and which claims it decides."""
        release = self.project.release
        places: dict[str, None] = {}
        for (file, anchor), html in undrawn(self.editions, self.templates, release).items():
            for match in ANCHOR.finditer(html):
                anchor = match[1] or anchor
                if match[2] == found.source:
                    places[f"{file}#{anchor}"] = None
        yield from (f"  printed at  {place}" for place in places)
        if not places:
            yield f"  printed     nowhere on the pages of {config().package} {release}"
        for section, chapter in self._chapters.items():
            claims = (claim for claim in chapter.section.claims if found.source in claim.outcome.reads)
            yield from (f"  decides     {section}.{claim.name}: {claim.outcome.said}" for claim in claims)

    def _of_record(self, file: str, cells: Sequence[Pointer]) -> Iterator[str]:
        """Describe the rows and traces of a file that a number comes from, and what measured them."""
        yield f"from {file}"
        chapter = self._records.get(file) or self._records[re.sub(r"\.[^/]*\.csv\.gz$", ".json", file)]
        record = chapter.results.record
        places = [(*cell.cell, cell) for cell in cells if cell.cell]
        for index, of_row in groupby(places, key=lambda place: place[0]):
            yield from self._of_row(record, index, of_row)
        if any(cell.is_trace for cell in cells):
            case = file.removeprefix(chapter.results.source.removesuffix("json")).removesuffix(".csv.gz")
            seal = (record.traces or {}).get(case)
            yield f"  the trace of case {case}" + (f", all {seal.row_count} frames" if seal else "")
            rows = [row for row in record.rows if row["case"] == case]
            yield f"    {_settings(rows[0])}" if rows else "    no row says its settings"
        if any(cell.text.endswith("/seconds") for cell in cells):
            yield f"  how long the measurement took, {record.measured['seconds']} s"
        release, commit = record.origin.release, record.measured["commit"]
        measured = f"{record.machine_text}, {record.time_text}, {config().package} {release}"
        yield f"  measured on {measured}{f', commit {commit}' if commit else ''}"
        if chapter.state.notes:
            yield f"  stale:      {chapter.state.words}"
        yield f"  again by    {self.project.of(release).rerun(record.section, record.machine['device'])}"

    def _of_row(self, record: Record, index: int, cells: Iterable[tuple[int, str, Pointer]]) -> Iterator[str]:
        row = record.rows[index]
        yield f"  row {index}, case {row['case']}"
        for _, column, cell in cells:
            number = f"    {column} = {row[column]} {unit_label(record.units[column])}".rstrip()
            yield number + self._noise_of(cell, index, column)
        yield f"    {_settings(row)}"
        count = next((row[name] for name in ("run_count", "repeat_count") if row.get(name)), 1)
        frames = f" of {row['frame_count']} frames" if row.get("frame_count") else ""
        yield f"    n: {count} run{'' if count == 1 else 's'}{frames}"


def _leaves(found: Quantity) -> list[str]:
    """Return pointers to the numbers of records and traces that a number comes from; its own where it is one."""
    return sorted(pointer for pointer in found.reads if VALUES_FILE not in pointer)


def _said(found: Quantity) -> str:
    """Write a number as the page prints it, and with all its digits."""
    return f"not there, for {found.reason}" if found.value is None else f"{found} ({found.value!r})"


def _in_unit(noise: float, unit: str) -> str:
    return f"{noise:.2g} {unit_label(unit)}".rstrip()


def _settings(row: Mapping[str, Any]) -> str:
    """Say in which settings a row's case differs from the baseline."""
    changed = ", ".join(f"{name} {value}" for name, value in changed_parameters(row).items())
    return f"{config().baseline}, but for {changed}" if changed else config().baseline
