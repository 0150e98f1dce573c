"""Read and write traces: per-frame tables beside a record.

Their files are named ``<section>.<case>.csv.gz``. The record contains their digests.
"""

import csv
import gzip
import io
import math
import re
import zlib
from collections.abc import Iterable, Mapping, Sequence
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, Any

from measured_report.files.atomic import RecordError, read_file, short_path
from measured_report.files.columns import PLAIN, Schema, is_number, plain, text_problem
from measured_report.files.config import report as current
from measured_report.records.record import BYTE_LIMIT, DIGITS, Seal, trace_path

# Importing pandas is slow, and only readers of traces need it.
if TYPE_CHECKING:
    import pandas as pd

HEAD = re.compile(r"[a-z][a-z0-9_-]{0,79}")
UNPACKED_LIMIT = 64 << 20
COLUMN_LIMIT = 1_000  # checking a trace of 100,000 columns took 47 s
# Checking more would need gigabytes of memory; existing traces have some 10,000 cells.
CELL_LIMIT = 8_000_000


def packed(
    record: Path, case: str, table: Mapping[str, Any], schema: Schema | None = None
) -> tuple[Seal, bytes]:
    """Return the content of a trace file beside ``record``, with its seal.

    This does not need pandas.
    """
    schema = schema or current().columns
    columns = {}
    for name, cells in table.items():
        column = str(name)
        columns[column] = [
            _written(plain(cell, name), column, schema) for cell in cells
        ]
    text = io.StringIO()
    try:
        if len({*map(len, columns.values())}) > 1:
            raise ValueError("its columns have different lengths")
        lines = list(zip(*columns.values(), strict=True))
        csv.writer(text, lineterminator="\n").writerows([[*columns], *lines])
        _check(text.getvalue(), schema)
    except ValueError as error:
        raise RecordError(
            f"{short_path(trace_path(record, case))} is not a valid trace: {error}"
        ) from None
    # Without a time in its header, the file of a trace is always the same.
    content = gzip.compress(text.getvalue().encode(), mtime=0)
    return Seal(sha256(content).hexdigest(), len(lines)), content


def _written(cell: Any, column: str, schema: Schema) -> Any:
    """Return a cell in the form in which its file stores it.

    A number outside the range of its column becomes None.
    """
    is_checked = is_number(cell) and HEAD.fullmatch(column)
    if is_checked and schema.number_problem(column, cell):
        return None
    return f"{cell:{DIGITS}}" if isinstance(cell, float) else cell


def load_trace(path: Path) -> "pd.DataFrame":
    """Read the trace at ``path``; raise RecordError if it is damaged in any way."""
    import pandas as pd

    content = read_file(path, BYTE_LIMIT)
    try:
        unpacking = zlib.decompressobj(wbits=31)
        text = unpacking.decompress(content, UNPACKED_LIMIT)
        if not unpacking.eof or unpacking.unused_data:
            raise ValueError(
                f"it is truncated, is larger than {UNPACKED_LIMIT >> 20} MiB, or "
                "has extra data at the end"
            )
        _check(text.decode("utf-8"), current().columns)
        # Versions of pandas before 3, which Python 3.10 uses, round the last digits
        # unless this option is set.
        is_new = int(pd.__version__.partition(".")[0]) > 2
        exact: dict[str, Any] = {} if is_new else {"float_precision": "round_trip"}
        return pd.read_csv(
            io.BytesIO(text),
            index_col=False,
            keep_default_na=False,
            na_values=[""],
            **exact,
        )
    except (ValueError, csv.Error, zlib.error) as error:
        message = " ".join(str(error).split())
        raise RecordError(
            f"{short_path(path)} is not a valid trace: {message:.300}"
        ) from None


def _check(text: str, schema: Schema) -> None:
    """Raise ValueError unless a text is a valid trace.

    Its columns must have equal lengths and contain either numbers or text.
    """
    lines = csv.reader(io.StringIO(text), strict=True)
    head = next(lines, [])
    if len(head) > COLUMN_LIMIT:
        raise ValueError(f"it has more than {COLUMN_LIMIT} columns")
    if len(set(head)) < len(head):
        raise ValueError("its header contains a column twice")
    rows: list[Sequence[str]] = []
    for number, line in enumerate(lines, start=2):
        if len(line) != len(head):
            raise ValueError(
                f"line {number} has {len(line)} cells instead of {len(head)}"
            )
        if number * len(head) > CELL_LIMIT:
            raise ValueError(f"it has more than {CELL_LIMIT} cells")
        rows.append(line)
    if not rows:
        raise ValueError("it has no rows")
    for column, cells in zip(head, zip(*rows, strict=True), strict=True):
        if problem := _column_problem(column, cells, schema):
            raise ValueError(f"{column!r:.80} {problem}")


def _column_problem(column: str, cells: Iterable[str], schema: Schema) -> str:
    """Return the problem with a column, or an empty string."""
    if not HEAD.fullmatch(column):
        return "is not a valid column name"
    filled = [cell for cell in cells if cell]
    try:
        numbers = list(map(float, filled))
    except ValueError:
        return _text_problem(filled, schema[column].unit)
    if not all(map(math.isfinite, numbers)):
        return "contains values that are not finite"
    if column == "time_s" and numbers != sorted(numbers):
        return "is not in ascending order"
    ends = (min(numbers), max(numbers)) if numbers else ()
    problems = (schema.number_problem(column, end) for end in ends)
    return next(filter(None, problems), "")


def _text_problem(texts: Sequence[str], unit: str) -> str:
    if unit != PLAIN:
        return "contains values that are not numbers"
    for text in dict.fromkeys(texts):
        if problem := text_problem(text):
            return problem
        try:
            float(text)
        except ValueError:
            continue
        return "contains both numbers and text"
    return ""
