"""The archive: all that was measured and derived, of every release, in one file with a text that explains it."""

import csv
import io
from collections.abc import Mapping, Sequence
from itertools import chain
from pathlib import Path
from typing import Any
from zipfile import ZIP_DEFLATED, ZIP_STORED, ZipFile, ZipInfo

from measured_report.files.config import config

ARCHIVE = "data.zip"
KINDS = {".json", ".csv", ".gz"}
FORMULA = (*"=+-@\t\r\n", *"＝＋－＠")  # as OWASP has it


def archived(data: Mapping[str, Path], readme: str) -> bytes:
    """Put the data of a site, by their names, into an archive; the same give the same bytes, as far as zlib does."""
    files = {name: path.read_bytes() for name, path in data.items() if path.suffix in KINDS}
    files["README.txt"] = readme.encode()
    content = io.BytesIO()
    with ZipFile(content, "w") as archive:
        for name in sorted(files):
            entry = ZipInfo(f"{config().name}-data/{name}")  # of 1980, as long as nobody says otherwise
            entry.create_system, entry.external_attr = 3, 0o644 << 16
            archive.writestr(entry, files[name], ZIP_STORED if name.endswith(".gz") else ZIP_DEFLATED, 1)
    return content.getvalue()


def rows_csv(rows: Sequence[Mapping[str, Any]]) -> bytes:
    """Write rows as a table; what a row lacks is empty."""
    columns = dict.fromkeys(chain.from_iterable(rows))
    text = io.StringIO()
    cells = ([_inert(row.get(column)) for column in columns] for row in rows)
    csv.writer(text, lineterminator="\n").writerows([list(columns), *cells])
    return text.getvalue().encode()


def _inert(cell: Any) -> Any:
    """Return a cell that no spreadsheet takes for a formula: text that could be one gets an apostrophe before it."""
    return f"'{cell}" if isinstance(cell, str) and cell.startswith(FORMULA) and not _is_number(cell) else cell


def _is_number(text: str) -> bool:
    try:
        float(text)
    except ValueError:
        return False
    return True
