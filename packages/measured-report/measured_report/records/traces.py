"""Traces: long per-frame series that lie beside a record, as ``<section>.<case>.csv.gz``, and are sealed by it."""

import csv
import gzip
import io
import re
import zlib
from collections.abc import Iterator, Mapping
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, Any

from measured_report.files.atomic import RecordError, read_own_file, short_path
from measured_report.records.columns import PLAIN, column_of, number_problem, text_problem
from measured_report.records.record import BYTE_LIMIT, DIGITS, Seal, trace_path

if TYPE_CHECKING:  # it takes long to import, and whoever only asks what is fresh needs none of it
    import pandas as pd

HEAD = re.compile(r"[a-z][a-z0-9_-]{0,79}")
UNPACKED_LIMIT = 64 << 20
CELL_LIMIT = 8_000_000
"""More would take gigabytes to look at; the longest trace that was kept has some tens of thousands."""
NO_NUMBER = re.compile(r"[+-]?(?:nan|inf|infinity)", re.IGNORECASE)


def packed(record: Path, case: str, table: Mapping[str, Any]) -> tuple[Seal, bytes]:
    """Pack a trace as it is kept beside ``record``, with its seal; a number that can't be kept is left empty."""
    import pandas as pd

    frame = pd.DataFrame(table)
    for column in frame.select_dtypes("number"):
        frame[column] = frame[column].where([not number_problem(column, value) for value in frame[column].tolist()])
    # Without a time in the header the same numbers give the same bytes.
    content = gzip.compress(frame.to_csv(index=False, lineterminator="\n", float_format=f"%{DIGITS}").encode(), mtime=0)
    return Seal(sha256(content).hexdigest(), len(_read(content, trace_path(record, case)))), content


def load_trace(path: Path) -> "pd.DataFrame":
    """Read the trace at ``path``; RecordError, one line with its release and file, when it is damaged in any way."""
    return _read(read_own_file(path, BYTE_LIMIT), path)


def _read(content: bytes, path: Path) -> "pd.DataFrame":
    import pandas as pd

    try:
        unpacking = zlib.decompressobj(wbits=31)
        text = unpacking.decompress(content, UNPACKED_LIMIT)
        if not unpacking.eof or unpacking.unused_data:
            raise ValueError(
                f"it ends early, or holds more than {UNPACKED_LIMIT >> 20} MiB, or something behind its end"
            )
        _check_cells(csv.reader(io.StringIO(text.decode("utf-8")), strict=True))
        # Before pandas 3, which Python 3.10 has, the last digits of numbers are others unless one asks for them.
        exact: dict[str, Any] = {} if int(pd.__version__.partition(".")[0]) > 2 else {"float_precision": "round_trip"}
        frame = pd.read_csv(io.BytesIO(text), index_col=False, keep_default_na=False, na_values=[""], **exact)
        for column in frame:
            if problem := _problem(column, frame[column].dropna()):
                raise ValueError(f"{column!r:.80} {problem}")
    except (ValueError, csv.Error, zlib.error) as error:
        raise RecordError(f"{short_path(path)} is no whole trace: {' '.join(str(error).split()):.300}") from None
    return frame


def _check_cells(lines: Iterator[list[str]]) -> None:
    """Raise ValueError unless each line has a cell for each column, and a missing number is an empty cell."""
    head, number = next(lines, []), 1
    if len(set(head)) < len(head):
        raise ValueError("its first line names a column twice")
    for number, line in enumerate(lines, start=2):
        if len(line) != len(head):
            raise ValueError(f"line {number} has {len(line)} cells, not {len(head)}")
        if number * len(head) > CELL_LIMIT:
            raise ValueError(f"it has more than {CELL_LIMIT} cells")
        if found := next(filter(NO_NUMBER.fullmatch, line), ""):
            raise ValueError(f"{found} is no number")
    if number < 2:
        raise ValueError("it has no rows")


def _problem(column: str, cells: "pd.Series") -> str:
    """Say what is wrong with a column of a trace; empty when nothing is."""
    if not HEAD.fullmatch(column):
        return "is no column name"
    if cells.empty:
        return ""
    if cells.dtype.kind in "iuf":
        if column == "time_s" and not cells.is_monotonic_increasing:
            return "runs backwards"
        return next(filter(None, (number_problem(column, end) for end in (cells.min(), cells.max()))), "")
    if column_of(column).unit != PLAIN:
        return "is not all numbers"
    texts = [text for text in cells.unique() if isinstance(text, str)]
    return next(filter(None, (text_problem(text) or _mixed(text) for text in texts)), "")


def _mixed(text: str) -> str:
    try:
        float(text)
    except ValueError:
        return ""
    return "has both numbers and text"
