"""Data of a site: tables of what was measured, and all that was measured and derived in one file."""

import csv
import io
from collections.abc import Mapping, Sequence
from itertools import chain
from pathlib import Path
from typing import Any
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

from measured_report.files.config import config

FORMULA = (*"=+-@\t\r\n", *"＝＋－＠")  # as OWASP has it


def archived(folder: Path, names: Sequence[str], readme: str) -> bytes:
    """Put files of a folder into an archive; the same give the same bytes, as far as zlib does."""
    content = io.BytesIO()
    with ZipFile(content, "w") as archive:
        for name in (*sorted(names), "README.txt"):
            data = (folder / name).read_bytes() if name in names else readme
            entry = ZipInfo(f"{config().name}-data/{name}")  # of 1980, as long as nobody says otherwise
            archive.writestr(entry, data, ZIP_DEFLATED, 1)
    return content.getvalue()


def rows_csv(rows: Sequence[Mapping[str, Any]]) -> str:
    """Write rows as a table; what a row lacks is empty."""
    text = io.StringIO()
    table = csv.DictWriter(text, dict.fromkeys(chain.from_iterable(rows)), lineterminator="\n")
    table.writeheader()
    table.writerows({column: _inert(cell) for column, cell in row.items()} for row in rows)
    return text.getvalue()


def _inert(cell: Any) -> Any:
    """Return a cell that no spreadsheet takes for a formula: text that could be one gets an apostrophe before it."""
    return f"'{cell}" if isinstance(cell, str) and cell.startswith(FORMULA) else cell
