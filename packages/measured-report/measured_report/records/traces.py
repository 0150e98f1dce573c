"""Traces: long per-frame series that lie beside a record, as ``<section>.<case>.csv.gz``, and are sealed by it."""

import csv
import gzip
import hashlib
import io
import re
import zlib
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from measured_report.files.atomic import RecordError, is_own_file, read_own_file, short_path
from measured_report.records.columns import PLAIN, cell_problem, column_of, number_problem
from measured_report.records.record import CASE, DIGITS, Record, Seal

if TYPE_CHECKING:  # it takes long to import, and whoever only asks what is fresh needs none of it
    import pandas as pd

HEAD = re.compile(r"[a-z][a-z0-9_-]{0,79}")
PACKED_BYTE_LIMIT, BYTE_LIMIT = 32 << 20, 64 << 20
CELL_LIMIT = 8_000_000
"""More would take gigabytes to look at; the longest trace that was kept has some tens of thousands."""
NO_NUMBER = re.compile(r"(?:^|,)[+-]?(?:nan|inf|infinity)(?:,|$)", re.IGNORECASE | re.MULTILINE)
"""What a number that is missing is never written as: its cell is empty."""


def trace_path(record: Path, case: str) -> Path:
    """Where the trace of ``case`` lies, beside the record at ``record``."""
    if not CASE.fullmatch(case):
        raise RecordError(f"a trace needs a case name that can be part of a file name, not {case!r}")
    return record.with_name(f"{record.stem}.{case}.csv.gz")


def traces_of(path: Path, record: Record) -> list[Path]:
    """The traces that belong to the record at ``path``; of one that doesn't say, those that lie beside it."""
    if record.traces is not None:
        return [trace_path(path, case) for case in record.traces]
    return sorted(trace for trace in path.parent.glob(f"{path.stem}.*.csv.gz") if is_own_file(trace))


def packed(record: Path, case: str, table: Mapping[str, Any]) -> tuple[Seal, bytes]:
    """A trace as it is kept beside ``record``, and its seal; a number that can't be kept is left empty."""
    import pandas as pd

    path = trace_path(record, case)
    frame = pd.DataFrame(table)
    for column in frame.select_dtypes("number"):
        frame[column] = frame[column].where([not number_problem(column, value) for value in frame[column].tolist()])
    # Without a time in the header the same numbers give the same bytes.
    content = gzip.compress(frame.to_csv(index=False, lineterminator="\n", float_format=f"%{DIGITS}").encode(), mtime=0)
    return Seal(hashlib.sha256(content).hexdigest(), len(_read(content, path))), content


def load_trace(path: Path, seal: Seal | None = None) -> "pd.DataFrame":
    """The trace at ``path``, or RecordError, one line with its release and file, when it is damaged in any way.

    Without a ``seal``, as for a record from before traces were sealed, it may be any whole trace.
    """
    frame = _read(sealed_content(path, seal), path)
    if seal and len(frame) != seal.row_count:
        raise RecordError(f"{short_path(path)} has {len(frame)} rows, and its record says {seal.row_count}")
    return frame


def sealed_content(path: Path, seal: Seal | None) -> bytes:
    """What the trace at ``path`` holds; RecordError unless it is the one that ``seal`` is of."""
    content = read_own_file(path, PACKED_BYTE_LIMIT)
    if seal and hashlib.sha256(content).hexdigest() != seal.digest:
        raise RecordError(f"{short_path(path)} is not the trace that was measured with {path.name.split('.')[0]}.json")
    return content


def _read(content: bytes, path: Path) -> "pd.DataFrame":
    import pandas as pd

    try:
        unpacking = zlib.decompressobj(wbits=31)
        unpacked = unpacking.decompress(content, BYTE_LIMIT)
        if not unpacking.eof or unpacking.unused_data:
            raise ValueError(f"it ends early, or holds more than {BYTE_LIMIT >> 20} MiB, or something behind its end")
        text = unpacked.decode("utf-8")
        _check_cells(csv.reader(io.StringIO(text), strict=True))
        if found := NO_NUMBER.search(text):
            raise ValueError(f"{found[0].strip(',')} is no number")
        # Before pandas 3, which Python 3.10 has, the last digits of numbers are others unless one asks for them.
        exact: dict[str, Any] = {} if int(pd.__version__.partition(".")[0]) > 2 else {"float_precision": "round_trip"}
        frame = pd.read_csv(io.StringIO(text), keep_default_na=False, na_values=[""], **exact)
        for column in frame:
            _check_column(column, frame[column])
    except (EOFError, ValueError, csv.Error, zlib.error) as error:
        raise RecordError(f"{short_path(path)} is no whole trace: {' '.join(str(error).split())}") from None
    return frame


def _check_cells(lines: Iterator[list[str]]) -> None:
    head, number = next(lines, []), 1
    if not head or not all(HEAD.fullmatch(column) for column in head) or len(set(head)) < len(head):
        raise ValueError("its first line does not name each of its columns once")
    for number, line in enumerate(lines, start=2):
        if len(line) != len(head):
            raise ValueError(f"line {number} has {len(line)} cells, not {len(head)}")
        if number * len(head) > CELL_LIMIT:
            raise ValueError(f"it has more than {CELL_LIMIT} cells")
    if number < 2:
        raise ValueError("it has no rows")


def _check_column(column: str, cells: "pd.Series") -> None:
    values = cells.dropna()
    if cells.dtype.kind in "iuf":
        problems = (number_problem(column, value) for value in (values.min(), values.max()) if len(values))
        if column == "time_s" and not cells.is_monotonic_increasing:
            raise ValueError("its time_s runs backwards")
    elif column_of(column).unit != PLAIN:
        raise ValueError(f"{column} is not all numbers")
    else:
        problems = (cell_problem(value) or _mixed(value) for value in values.unique() if isinstance(value, str))
    if problem := next(filter(None, problems), ""):
        raise ValueError(f"{column} {problem}")


def _mixed(text: str) -> str:
    try:
        float(text)
    except ValueError:
        return ""
    return "has both numbers and text"
