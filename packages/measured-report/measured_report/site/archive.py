"""The archive: all that was measured and derived, of every release, in one file with a text that explains it."""

import csv
import io
import json
from collections.abc import Iterator, Mapping, Sequence
from hashlib import sha256
from itertools import chain
from typing import Any
from zipfile import ZIP_DEFLATED, ZIP_STORED, ZipFile, ZipInfo
from zlib import ZLIB_RUNTIME_VERSION

from measured_report.deriving.editions import Edition
from measured_report.files.cache import Cache
from measured_report.files.config import config
from measured_report.pages.prose import Templates
from measured_report.records.columns import REASON, column_of
from measured_report.records.traces import traces_of
from measured_report.values.quantities import VALUES_FILE

ARCHIVE = "data.zip"
FIGURES = "figures.csv"
FORMULA = (*"=+-@\t\r\n", *"＝＋－＠")  # as OWASP has it


def archived(
    editions: Mapping[str, Edition], tables: Mapping[str, bytes], templates: Templates, cache: Cache | None
) -> bytes:
    """Put all releases, and ``tables``, the rows of each record by its file, into an archive.

    The same give the same bytes, as far as zlib is the same; what was packed before is not packed again.
    """
    files = dict(_data_files(editions, tables))
    head = ("release", "figure", "drawn by", "source", "value", "unit")
    files[FIGURES] = _csv(head, (row for edition in editions.values() for row in _drawn(edition)))
    names = {"editions": editions, "columns": _columns(editions), "figures": FIGURES, "values": VALUES_FILE}
    files["README.txt"] = templates.layout("archive.txt.j2", names).encode()
    made_from = config().name, ZLIB_RUNTIME_VERSION, [(name, sha256(files[name]).hexdigest()) for name in sorted(files)]
    kept = cache and cache.get(ARCHIVE, made_from)
    if not kept:
        kept = _packed(files)
        if cache:
            cache.put(ARCHIVE, made_from, kept)
    return kept


def _packed(files: Mapping[str, bytes]) -> bytes:
    content = io.BytesIO()
    with ZipFile(content, "w") as archive:
        for name in sorted(files):
            entry = ZipInfo(f"{config().name}-data/{name}")  # of 1980, as long as nobody says otherwise
            entry.create_system, entry.external_attr = 3, 0o644 << 16
            archive.writestr(entry, files[name], ZIP_STORED if name.endswith(".gz") else ZIP_DEFLATED, 1)
    return content.getvalue()


def _data_files(editions: Mapping[str, Edition], tables: Mapping[str, bytes]) -> Iterator[tuple[str, bytes]]:
    """Records, as they are kept and as tables, with their traces, and values by release."""
    for edition in editions.values():
        for chapter in edition.chapters.values():
            path = chapter.results.path
            for file in (path, *traces_of(path, chapter.results.record)):
                yield f"{path.parent.name}/{file.name}", file.read_bytes()
            yield f"{path.parent.name}/{path.stem}.csv", tables[chapter.results.source]
        yield f"{edition.project.results.name}/{VALUES_FILE}", edition.values_text.encode()


def _drawn(edition: Edition) -> Iterator[tuple[str, ...]]:
    """What each figure of the sections draws: a number with its value, or a trace by its file."""
    for chapter in edition.chapters.values():
        for figure in chapter.section.figures.values():
            for source in figure.sources:
                value = getattr(source, "value", None)
                number = json.dumps(value) if isinstance(value, int | float) else ""
                place = (edition.project.release, figure.anchor, figure.drawn_by, source.source)
                yield (*place, number, getattr(source, "unit", ""))


def _columns(editions: Mapping[str, Edition]) -> list[dict[str, Any]]:
    """All columns of the records; text, and yes and no, have no unit."""
    sections: dict[str, set[str]] = {}
    units: dict[str, str] = {}
    for record in (chapter.results.record for edition in editions.values() for chapter in edition.chapters.values()):
        units |= record.units
        for column in {name for name in set().union(*record.rows) if not name.endswith(REASON)}:
            sections.setdefault(column, set()).add(record.section)
    return [
        {
            "name": name,
            "unit": units.get(name),
            "sections": ", ".join(sorted(found)),
            "is_setting": column_of(name).is_setting,
        }
        for name, found in sorted(sections.items())
    ]


def rows_csv(rows: Sequence[Mapping[str, Any]]) -> bytes:
    """Write rows as a table; what a row lacks is empty."""
    columns = tuple(dict.fromkeys(chain.from_iterable(rows)))
    return _csv(columns, (tuple(map(row.get, columns)) for row in rows))


def _csv(head: tuple[str, ...], rows: Iterator[tuple]) -> bytes:
    text = io.StringIO()
    inert = ([_inert(cell) if isinstance(cell, str) else cell for cell in row] for row in rows)
    csv.writer(text, lineterminator="\n").writerows([head, *inert])
    return text.getvalue().encode()


def _inert(cell: str) -> str:
    """A cell that no spreadsheet takes for a formula: text that could be one has an apostrophe before it."""
    return f"'{cell}" if cell.startswith(FORMULA) and not _is_number(cell) else cell


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
