"""The way of a number: from the page back to the rows that it was read from, their cases, and what measures them."""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from difflib import get_close_matches
from functools import cached_property
from typing import Any

from report import UsageError
from report.altered import Cell, World
from report.chapters import Chapter
from report.editions import Edition
from report.format import unit_label
from report.noise import NOISE, Floor, noise_floors
from report.page import Templates
from report.quantities import VALUES_FILE, Quantity, Value
from report.records.columns import is_number
from report.records.project import Project
from report.records.record import Record
from report.settings import from_shipped, is_setting
from report.site import undrawn

PLACE = re.compile(' id="([^"]+)"| data-src="([^"]+)"')
CELLS_MOVED = 60
"""Of a value that is read from more measured numbers than that, none is moved to see what noise does to it."""


@dataclass(frozen=True)
class Ways:
    """What is known of the numbers of all releases, as the pages of one of them show them."""

    project: Project
    editions: Mapping[str, Edition]
    templates: Templates

    def text(self, name: str) -> str:
        """The way of a value, ``section.name`` or the pointer that a page has for it; UsageError for an unknown one."""
        found = self._found(name)
        lines = [f"{name}: {_said(found)}", *self._of_value(found), *self._on_pages(found)]
        cells: dict[str, list[Cell]] = {}
        for pointer in sorted(_leaves(found), key=_place):
            cells.setdefault(Cell(pointer).file, []).append(Cell(pointer))
        for file, of_file in cells.items():
            lines += ["", *self._of_record(file, of_file)]
        return "\n".join(lines)

    def _found(self, name: str) -> Quantity:
        section, _, value = name.partition(".")
        chapter = self._chapters.get(section)
        if chapter and value in chapter.results.derived:
            return chapter.results.derived[value]
        pointer = name if name.startswith("newton-") else f"newton-{self.project.release}/{name}"
        known = self._values.get(pointer) or self._cell(pointer)
        if known:
            return known
        names = [f"{each}.{value}" for each, chapter in self._chapters.items() for value in chapter.results.derived]
        near = get_close_matches(name, names, n=4, cutoff=0.5) or names[:1]
        fault = f"VALUE={name} is no value of newton {self.project.release}" if name else "VALUE is missing"
        raise UsageError(f"{fault}; near it: {', '.join(near) or 'none'}; all are in site/data/{VALUES_FILE}")

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
        rows = {row[match[3]].source: row[match[3]] for row in self._records[match[1]].results.rows if match[3] in row}
        return rows.get(pointer)

    def _of_value(self, found: Quantity) -> Iterator[str]:
        if isinstance(found, Value):
            yield f"  is          {found.formula}"
            for pointer in found.sources:
                if pointer in self._values:
                    value = self._values[pointer]
                    yield f"  made of     {_name(value)}, {_said(value)}: {value.formula}"
        cells = [pointer for pointer in _leaves(found) if not is_setting(pointer)]
        yield f"  n           {len(cells)} measured numbers and traces"
        if isinstance(found, Value) and cells:
            yield f"  noise       {self._noise_of(found, cells)}"

    def _noise_of(self, found: Value, pointers: Sequence[str]) -> str:
        """How far the value goes when each number that it is read from moves by its noise, all taken together."""
        cells = [cell for cell in map(Cell, pointers) if not cell.is_trace and "/rows/" in cell.pointer]
        moves = {cell: self._noise(cell) for cell in cells}
        known = {cell: noise for cell, noise in moves.items() if noise is not None}
        if not known or len(known) > CELLS_MOVED or found.value is None:
            return f"not told: of {len(pointers)} measured numbers {len(known)} have one"
        moved = [self._moved(found, cell, noise) for cell, noise in known.items()]
        there = [abs(value - found.value) for value in moved if value is not None]
        rest = f"; of {len(pointers) - len(known)} numbers none was measured" if len(known) < len(pointers) else ""
        return f"{replace(found, value=sum(there))}, all together, when each moves by its own{rest}"

    def _moved(self, found: Value, cell: Cell, by: float) -> float | None:
        """The value where one number of a record is larger by its noise."""
        record = self._records[cell.file].results.record
        index, column = cell.place
        rows = [*record.rows]
        rows[index] = {**rows[index], column: rows[index][column] + by}
        release, section, name = _parts(found)
        world = World({name: edition.chapters for name, edition in self.editions.items()}, self.templates)
        return world.values(release, section, {cell.file: replace(record, rows=rows)})[name].value

    def _noise(self, cell: Cell) -> float | None:
        """How far apart runs of one case are in this number; of a time, how far frames of the run spread."""
        index, column = cell.place
        row = self._records[cell.file].results.record.rows[index]
        edges = row.get(f"{column}_p5"), row.get(f"{column}_p95")
        if all(map(is_number, edges)):
            return edges[1] - edges[0]
        floors = self._floors(cell.file)
        return floors[column].at(row[column]) if column in floors and is_number(row[column]) else None

    def _noise_said(self, cell: Cell, unit: str) -> str:
        noise = None if is_setting(cell.pointer) else self._noise(cell)
        if noise is None:
            return ""
        index, column = cell.place
        if f"{column}_p5" in self._records[cell.file].results.record.rows[index]:
            whence = "its frames, 5th to 95th percentile"
        else:
            runs = self._records[f"{cell.file.partition('/')[0]}/{NOISE}.json"].results.record.rows
            whence = f"section {NOISE}, n {len(runs)}"
        return f", noise {f'{noise:.2g} {unit}'.strip()} ({whence})"

    def _floors(self, file: str) -> Mapping[str, Floor]:
        noise = self._records.get(f"{file.partition('/')[0]}/{NOISE}.json")
        return noise_floors([noise.results.record]) if noise else {}

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
            yield f"  stale:      {'; '.join(chapter.state.notes)}"
        yield f"  again by    {project.rerun(record.section, record.machine['device'])}"

    def _of_row(self, record: Record, index: int, cells: Sequence[Cell]) -> Iterator[str]:
        row = record.rows[index]
        yield f"  row {index}, case {row['case']}"
        for cell in cells:
            column = cell.place[1]
            unit = unit_label(record.units[column])
            yield f"    {column} = {row[column]} {unit}".rstrip() + self._noise_said(cell, unit)
        yield f"    {_settings(row)}"
        yield f"    n: {_runs(row)}"


def _leaves(found: Quantity) -> list[str]:
    """Pointers to the numbers of records, and to traces, that a number comes from; its own where it is one of them."""
    return sorted(pointer for pointer in found.reads if VALUES_FILE not in pointer)


def _place(pointer: str) -> tuple[str, int, str]:
    cell = Cell(pointer)
    return (cell.file, *cell.place) if "/rows/" in pointer else (cell.file, -1, pointer)


def _parts(value: Value) -> tuple[str, str, str]:
    """Release, section and name of a value."""
    folder, _, pointer = value.source.partition("/")
    _, section, name = pointer.split("/", 2)
    return folder.removeprefix("newton-"), section, name


def _name(value: Value) -> str:
    return ".".join(_parts(value)[1:])


def _said(found: Quantity) -> str:
    """As the page prints it, and with all its digits."""
    return f"not there, for {found.reason}" if found.value is None else f"{found} ({found.value!r})"


def _settings(row: Mapping[str, Any]) -> str:
    """In which settings a row's case differs from the scene as shipped."""
    changed = ", ".join(f"{name} {value}" for name, value in from_shipped(row).items())
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
