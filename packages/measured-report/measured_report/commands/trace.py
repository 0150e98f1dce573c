"""Show where a number comes from: page, rows, case and command."""

import re
from collections.abc import Iterator, Mapping, Sequence
from itertools import groupby

from measured_report.changes.query import Query
from measured_report.commands.options import (
    SHARED,
    Arguments,
    refuse_unmeasured,
    shared,
)
from measured_report.editions.project import Project
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

OPTIONS = {
    "value": {**SHARED["value"], "required": True},
    **shared("edition", "profile"),
}


def run(project: Project, arguments: Arguments) -> int:
    refuse_unmeasured(project, arguments.release.asked)
    print(provenance(project, editions_of(project), arguments.value))
    return 0


def provenance(project: Project, editions: Mapping[str, Edition], name: str) -> str:
    """Return the provenance of ``section.name``, ``section.case.column``, or a page's pointer to either, in lines."""
    chapters = editions[project.release].chapters
    records = {
        owner.results.source: owner
        for edition in editions.values()
        for owner in edition.chapters.values()
    }
    values = {
        value.source: value
        for chapter in records.values()
        for value in chapter.results.derived.values()
    }
    query = Query(name)
    package = project.report.settings.edition
    pointer = (
        name
        if name.startswith(f"{package}-")
        else f"{package}-{project.release}/{name}"
    )
    answers = (
        query.quantity(chapters),
        values.get(pointer),
        _cell(records, Pointer(pointer)),
    )
    quantity = next(
        (
            answer
            for answer in answers
            if isinstance(answer, Quantity) and answer.source
        ),
        None,
    )
    if quantity is None:
        fault = f"{name} is no value of {package} {project.release}{suggestion(name, query.names(chapters))}"
        hint = f"all values are in site/data/{VALUES_FILE}, a number of a row is SECTION.CASE.COLUMN"
        raise UsageError(f"{fault}; {hint}")
    lines = [f"{name}: {_text(quantity)}"]
    if isinstance(quantity, Value):
        lines.append(f"  is          {quantity.formula}")
        for value in (
            values[pointer] for pointer in quantity.sources if pointer in values
        ):
            lines.append(
                f"  made of     {'.'.join(value.source.split('/')[2:])}, {_text(value)}: {value.formula}"
            )
    lines += [
        f"  printed at  {anchor}"
        for anchor in dict.fromkeys(_printed(project, quantity.source)) or ["no page"]
    ]
    for section, chapter in chapters.items():
        claims = (
            claim
            for claim in chapter.section.claims
            if quantity.source in claim.outcome.reads
        )
        lines += [
            f"  decides     {section}.{claim.name}: {claim.outcome.answer}"
            for claim in claims
        ]
    cells = [
        Pointer(pointer)
        for pointer in sorted(quantity.reads)
        if VALUES_FILE not in pointer
    ]
    for file, cells_of_file in groupby(cells, key=lambda cell: cell.file):
        chapter = (
            records.get(file) or records[re.sub(r"\.[^/]*\.csv\.gz$", ".json", file)]
        )
        lines += [
            "",
            f"from {file}",
            *_of_record(project, chapter, list(cells_of_file)),
        ]
    return "\n".join(lines)


def _printed(project: Project, source: str) -> Iterator[str]:
    own = project.of(project.own_release or project.release).results.name
    for path in sorted(
        (project.site if project.is_own else project.site / project.results.name).glob(
            "*.html"
        )
    ):
        anchor = ""
        for match in re.finditer(
            ' id="([^"]+)"| data-src="([^"]+)"', path.read_text(encoding="utf-8")
        ):
            anchor = match[1] or anchor
            if match[2] and local(source, own) in match[2].split():
                yield f"{path.name}#{anchor}"


def _cell(records: Mapping[str, Chapter], pointer: Pointer) -> Quantity | None:
    if not pointer.cell or pointer.file not in records:
        return None
    cells = (
        row[pointer.cell[1]]
        for row in records[pointer.file].results.rows
        if pointer.cell[1] in row
    )
    return next(
        (
            cell
            for cell in cells
            if isinstance(cell, Quantity) and cell.source == pointer.text
        ),
        None,
    )


def _of_record(
    project: Project, chapter: Chapter, cells: Sequence[Pointer]
) -> Iterator[str]:
    record = chapter.results.record
    columns = chapter.results.columns
    for index, column, cell in sorted(
        (*pointer.cell, pointer) for pointer in cells if pointer.cell
    ):
        row = record.rows[index]
        parameters = columns.changed_parameters(row).items()
        changed = ", ".join(f"{name} {value}" for name, value in parameters)
        but = f", but for {changed}" if changed else ""
        changes = f" ({columns.settings.baseline}{but})" if columns.parameters else ""
        number = _cell({chapter.results.source: chapter}, cell)
        yield f"  row {index}, case {row['case']}{changes}: {column} = {_text(number) if number else row[column]}"
    release = record.origin.release
    commit = record.measured["commit"]
    measured = f"{record.machine_text}, {record.time_text}, {columns.settings.edition} {release}"
    yield f"  measured on {measured}{f', commit {commit}' if commit else ''}"
    yield from (f"  carried     {pointer}" for pointer in record.carried)
    if chapter.state.notes:
        yield f"  stale:      {chapter.state.words}"
    yield f"  again by    {project.of(release).rerun(record.section, record.machine['device'])}"


def _text(number: Quantity) -> str:
    if number.value is None:
        return f"not there, for {number.reason}"
    noise = (
        "not known"
        if number.noise is None
        else f"{number.noise:.2g} {unit_label(number.unit)}".rstrip()
    )
    return f"{number} ({number.value!r}), noise {noise}"
