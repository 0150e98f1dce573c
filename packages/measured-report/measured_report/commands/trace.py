"""Print the origin of a number: its pages, rows and cases, and how to repeat it."""

import re
from collections.abc import Iterable, Iterator, Mapping
from itertools import groupby
from typing import Any

from measured_report.changes.query import Query
from measured_report.commands.options import (
    SHARED,
    Arguments,
    refuse_unmeasured,
    shared,
)
from measured_report.commands.status import print_left_out
from measured_report.editions.project import Project
from measured_report.files.atomic import files_in, read_text
from measured_report.files.errors import UsageError, suggestion
from measured_report.findings.chapters import Chapter
from measured_report.findings.editions import Edition, editions_of
from measured_report.values.format import unit_label
from measured_report.values.quantities import (
    VALUES_FILE,
    Pointer,
    Quantity,
    Value,
    local,
)
from measured_report.values.results import Row

OPTIONS = {
    "value": {**SHARED["value"], "required": True},
    **shared("edition", "profile"),
}

PLACES = re.compile(' id="([^"]+)"| data-src="([^"]+)"')


def run(project: Project, arguments: Arguments) -> int:
    """Print the origin, and return 1 if a record cannot be read or shown."""
    refuse_unmeasured(project, arguments.release.spec)
    editions = editions_of(project)
    is_damaged = print_left_out(editions)
    print(provenance(project, editions, arguments.value))
    return int(is_damaged)


def provenance(project: Project, editions: Mapping[str, Edition], name: str) -> str:
    """Return lines about the origin of a number.

    The name is ``section.name``, ``section.case.column`` or a pointer of a page.
    """
    chapters = editions[project.release].chapters
    chapters_by_file = {
        chapter.results.source: chapter
        for edition in editions.values()
        for chapter in edition.chapters.values()
    }
    values = {
        value.source: value
        for chapter in chapters_by_file.values()
        for value in chapter.results.derived.values()
    }
    query = Query(name)
    folder = project.results.name
    pointer = name if "/" in name.partition("#")[0] else f"{folder}/{name}"
    quantity: Any = values.get(pointer) or _cell(chapters_by_file, pointer)
    quantity = quantity or query.quantity(chapters)
    if not isinstance(quantity, Quantity) or not quantity.source:
        hint = suggestion(name, query.names(chapters))
        raise UsageError(
            f"{name} is not a value of {folder}{hint}: use a name in "
            f"site/data/{VALUES_FILE}, or SECTION.CASE.COLUMN for a number of a row"
        )
    lines = [f"{name}: {_text(quantity)}"]
    if isinstance(quantity, Value):
        lines.append(f"  formula     {quantity.formula}")
        for source in filter(values.__contains__, quantity.sources):
            value = values[source]
            value_name = ".".join(source.split("/")[2:])
            lines.append(f"  from value  {value_name}, {_text(value)}: {value.formula}")
    for page in _pages(project, quantity.source) or ["no page"]:
        lines.append(f"  printed on  {page}")
    for section, chapter in chapters.items():
        for claim in chapter.section.claims:
            if quantity.source in claim.outcome.reads:
                answer = claim.outcome.answer
                lines.append(f"  decides     {section}.{claim.name}: {answer}")
    pointers = sorted(read for read in quantity.reads if VALUES_FILE not in read)
    for file, file_pointers in groupby(pointers, lambda text: Pointer(text).file):
        # The record of a trace has the name of the trace without its case.
        record_file = re.sub(r"\.[^/]*\.csv\.gz$", ".json", file)
        owner = chapters_by_file.get(record_file)
        if owner is None:
            lines += [
                "",
                f"from {file}, whose section cannot be derived: see make status",
            ]
            continue
        cell_lines = _lines_of_record(project, owner, chapters_by_file, file_pointers)
        lines += ["", f"from {file}", *cell_lines]
    return "\n".join(lines)


def _pages(project: Project, source: str) -> list[str]:
    """Return the pages that print a number, each with the anchor before the number."""
    own = project.of(project.own_release or project.release).results.name
    site = project.site if project.is_own else project.site / project.results.name
    places: dict[str, None] = {}
    for path in files_in(site, "*.html"):
        anchor = ""
        for match in PLACES.finditer(read_text(path)):
            anchor = match[1] or anchor
            if match[2] == local(source, own):
                places[f"{path.name}#{anchor}"] = None
    return [*places]


def _cell(chapters_by_file: Mapping[str, Chapter], text: str) -> Quantity | None:
    """Return the number of the cell that a pointer names."""
    pointer = Pointer(text)
    if not pointer.cell or pointer.file not in chapters_by_file:
        return None
    index, column = pointer.cell
    return Row(chapters_by_file[pointer.file].results, index)[column]


def _lines_of_record(
    project: Project,
    chapter: Chapter,
    chapters_by_file: Mapping[str, Chapter],
    pointers: Iterable[str],
) -> Iterator[str]:
    """Yield lines about cells of a record and about its measurement."""
    record = chapter.results.record
    columns = chapter.results.columns
    for pointer in pointers:
        if not (cell := Pointer(pointer).cell):
            continue
        index, column = cell
        row = record.rows[index]
        changed = columns.changes_text(row)
        exception = f", except {changed}" if changed else ""
        changes = (
            f" ({columns.settings.baseline}{exception})" if columns.parameters else ""
        )
        number = _cell(chapters_by_file, pointer)
        text = _text(number) if number else row[column]
        yield f"  row {index}, case {row['case']}{changes}: {column} = {text}"
    commit = record.measured["commit"]
    circumstances = (
        record.machine_text,
        record.time_text,
        f"{columns.settings.edition} {record.origin.release}",
        *([f"commit {commit}"] if commit else []),
    )
    yield f"  measured on {', '.join(circumstances)}"
    yield from (f"  carried     {carried}" for carried in record.carried)
    if chapter.state.notes:
        yield f"  stale:      {chapter.state.words}"
    edition = project.of(record.origin.release)
    yield f"  repeat with {edition.rerun(record.section, record.machine['device'])}"


def _text(number: Quantity) -> str:
    if number.value is None:
        return f"missing: {number.reason}"
    noise = "unknown"
    if number.noise is not None:
        noise = f"{number.noise:.2g} {unit_label(number.unit)}".rstrip()
    return f"{number} ({number.value!r}), noise {noise}"
