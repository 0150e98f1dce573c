"""The way of a number: from the page back to the rows that it was read from, their cases, and what measures them."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from measured_report import UsageError
from measured_report.changes.question import Question
from measured_report.deriving.chapters import Chapter
from measured_report.deriving.editions import Edition
from measured_report.editions.project import Project
from measured_report.files.suggestion import suggestion
from measured_report.pages.page import Templates
from measured_report.records.columns import changed_parameters, is_setting
from measured_report.records.record import Record
from measured_report.sensitivity.perturbed import Cell
from measured_report.site.site import undrawn
from measured_report.values.format import unit_label
from measured_report.values.noise import NOISE
from measured_report.values.quantities import VALUES_FILE, Quantity, Value

PLACE = re.compile(' id="([^"]+)"| data-src="([^"]+)"')


@dataclass(frozen=True)
class Ways:
    """What is known of the numbers of all releases, as the pages of one of them show them."""

    project: Project
    editions: Mapping[str, Edition]
    templates: Templates

    def text(self, name: str) -> str:
        """The way of a value, ``section.name``, of a number of a row, ``section.case.column``, or of the pointer that a
        page has for either; UsageError for an unknown one."""
        found = self._found(name)
        lines = [f"{name}: {_said(found)}", *self._of_value(found), *self._on_pages(found)]
        cells: dict[str, list[Cell]] = {}
        for pointer in sorted(_leaves(found), key=_place):
            cells.setdefault(Cell(pointer).file, []).append(Cell(pointer))
        for file, of_file in cells.items():
            lines += ["", *self._of_record(file, of_file)]
        return "\n".join(lines)

    def _found(self, name: str) -> Quantity:
        pointer = name if name.startswith("newton-") else f"newton-{self.project.release}/{name}"
        known = self._named(name) or self._values.get(pointer) or self._cell(pointer)
        if known:
            return known
        hint = suggestion(name, Question(name, is_claim=False).names(self._chapters))
        fault = f"VALUE={name} is no value of newton {self.project.release}{hint}"
        where = f"values are in site/data/{VALUES_FILE}, numbers of rows named as reproduction.as-shipped.slip_mm"
        raise UsageError(f"{fault}; all {where}")

    def _named(self, name: str) -> Quantity | None:
        """A value, or a number of a row, by its name."""
        section, _, rest = name.partition(".")
        if section not in self._chapters:
            return None
        results = self._chapters[section].results
        if rest in results.derived:
            return results.derived[rest]
        case, _, column = rest.rpartition(".")
        row = results.row[case]
        return row[column] if column in row and isinstance(row[column], Quantity) else None

    @property
    def _chapters(self) -> Mapping[str, Chapter]:
        return self.editions[self.project.release].chapters

    @cached_property
    def _records(self) -> Mapping[str, Chapter]:
        """Chapters by the file of their record."""
        return {
            chapter.results.source: chapter
            for edition in self.editions.values()
            for chapter in edition.chapters.values()
        }

    @cached_property
    def _values(self) -> Mapping[str, Value]:
        return {value.source: value for chapter in self._records.values() for value in chapter.results.derived.values()}

    def _cell(self, pointer: str) -> Quantity | None:
        """A number of a record."""
        match = re.fullmatch(r"([^#]+)#/rows/(\d+)/(\w+)", pointer)
        if not match or match[1] not in self._records:
            return None
        cells = [row[match[3]] for row in self._records[match[1]].results.rows if match[3] in row]
        return next((cell for cell in cells if isinstance(cell, Quantity) and cell.source == pointer), None)

    def _of_value(self, found: Quantity) -> Iterator[str]:
        if isinstance(found, Value):
            yield f"  is          {found.formula}"
            for pointer in found.sources:
                if pointer in self._values:
                    value = self._values[pointer]
                    yield f"  made of     {_name(value)}, {_said(value)}: {value.formula}"
        cells = [pointer for pointer in _leaves(found) if not is_setting(pointer)]
        yield f"  n           {len(cells)} measured numbers and traces"
        if cells:
            whence = ", by that of what it is made of" if isinstance(found, Value) else ""
            known = "not known" if found.noise is None else _in_unit(found.noise, found.unit)
            yield f"  noise       {known}{whence}"

    def _noise_of(self, cell: Cell) -> str:
        """The noise of a number of a record, and whence it is known; empty where it is not."""
        found = self._cell(cell.pointer)
        if not (found and found.noise):
            return ""
        index, column = cell.place
        if f"{column}_p5" in self._records[cell.file].results.record.rows[index]:
            whence = "its frames"
        else:
            runs = self._records[f"{cell.file.partition('/')[0]}/{NOISE}.json"].results.record.rows
            whence = f"section {NOISE}, n {len(runs)}"
        return f", noise {_in_unit(found.noise, found.unit)} ({whence})"

    def _on_pages(self, found: Quantity) -> Iterator[str]:
        pages = undrawn(self.editions, self.templates, self.project.release)
        places = [
            f"{file}#{anchor}" for (file, part), html in pages.items() for anchor in _anchors(html, part, found.source)
        ]
        for place in dict.fromkeys(places):
            yield f"  printed at  {place}"
        if not places:
            yield f"  printed     nowhere on the pages of newton {self.project.release}"
        for section, chapter in self._chapters.items():
            for claim in chapter.section.claims:
                if found.source in claim.outcome.reads:
                    yield f"  decides     {section}.{claim.name}: {claim.outcome.said}"

    def _of_record(self, file: str, cells: Sequence[Cell]) -> Iterator[str]:
        yield f"from {file}"
        chapter = self._records.get(file) or self._records[re.sub(r"\.[^/]*\.csv\.gz$", ".json", file)]
        record = chapter.results.record
        for index in dict.fromkeys(cell.place[0] for cell in cells if not cell.is_trace and "/rows/" in cell.pointer):
            yield from self._of_row(record, index, [cell for cell in cells if cell.place[0] == index])
        if any(cell.is_trace for cell in cells):
            case = file.removeprefix(chapter.results.source.removesuffix("json")).removesuffix(".csv.gz")
            seal = (record.traces or {}).get(case)
            yield f"  the trace of case {case}" + (f", all {seal.row_count} frames" if seal else "")
            rows = [row for row in record.rows if row["case"] == case]
            yield f"    {_settings(rows[0])}" if rows else "    no row says its settings"
        if any(cell.pointer.endswith("/seconds") for cell in cells):
            yield f"  how long the measurement took, {record.measured['seconds']} s"
        project = self.project.of(record.origin.release)
        commit = f", commit {record.measured['commit']}" if record.measured["commit"] else ""
        yield f"  measured on {record.machine_text}, {record.time_text}, newton {record.origin.release}{commit}"
        if chapter.state.notes:
            yield f"  stale:      {chapter.state.words}"
        yield f"  again by    {project.rerun(record.section, record.machine['device'])}"

    def _of_row(self, record: Record, index: int, cells: Sequence[Cell]) -> Iterator[str]:
        row = record.rows[index]
        yield f"  row {index}, case {row['case']}"
        for cell in cells:
            column = cell.place[1]
            yield f"    {column} = {row[column]} {unit_label(record.units[column])}".rstrip() + self._noise_of(cell)
        yield f"    {_settings(row)}"
        yield f"    n: {_runs(row)}"


def _leaves(found: Quantity) -> list[str]:
    """Pointers to the numbers of records, and to traces, that a number comes from; its own where it is one of them."""
    return sorted(pointer for pointer in found.reads if VALUES_FILE not in pointer)


def _place(pointer: str) -> tuple[str, int, str]:
    cell = Cell(pointer)
    return (cell.file, *cell.place) if "/rows/" in pointer else (cell.file, -1, pointer)


def _name(value: Value) -> str:
    """Section and name."""
    return ".".join(value.source.split("/", 3)[2:])


def _said(found: Quantity) -> str:
    """As the page prints it, and with all its digits."""
    return f"not there, for {found.reason}" if found.value is None else f"{found} ({found.value!r})"


def _in_unit(noise: float, unit: str) -> str:
    return f"{noise:.2g} {unit_label(unit)}".rstrip()


def _settings(row: Mapping[str, Any]) -> str:
    """In which settings a row's case differs from the scene as shipped."""
    changed = ", ".join(f"{name} {value}" for name, value in changed_parameters(row).items())
    return f"the scene as shipped, but for {changed}" if changed else "the scene as shipped"


def _runs(row: Mapping[str, Any]) -> str:
    count = next((row[name] for name in ("run_count", "repeat_count") if row.get(name)), 1)
    frames = f" of {row['frame_count']} frames" if row.get("frame_count") else ""
    return f"{count} run{'' if count == 1 else 's'}{frames}"


def _anchors(html: str, part: str, source: str) -> Iterator[str]:
    """The ids below which the words of a part print a number."""
    anchor = part
    for match in PLACE.finditer(html):
        if match[1]:
            anchor = match[1]
        elif match[2] == source:
            yield anchor
