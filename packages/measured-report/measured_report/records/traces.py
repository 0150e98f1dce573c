"""Traces: long per-frame series that lie beside a record, as ``<section>.<case>.csv.gz``, and are sealed by it."""

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

if TYPE_CHECKING:  # it takes long to import, and only who reads traces needs it
    import pandas as pd

HEAD = re.compile(r"[a-z][a-z0-9_-]{0,79}")
UNPACKED_LIMIT = 64 << 20
COLUMN_LIMIT = 1_000
CELL_LIMIT = 8_000_000  # more would take gigabytes to look at; traces that were kept have some tens of thousands


def packed(
    record: Path, case: str, table: Mapping[str, Any], schema: Schema | None = None
) -> tuple[Seal, bytes]:
    """Return a trace as it is kept beside ``record``, with its seal; pandas is not needed."""
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
            raise ValueError("its columns are not of one length")
        lines = list(zip(*columns.values(), strict=True))
        csv.writer(text, lineterminator="\n").writerows([[*columns], *lines])
        _check(text.getvalue(), schema)
    except ValueError as error:
        raise RecordError(
            f"{short_path(trace_path(record, case))} is no whole trace: {error}"
        ) from None
    # With no time in its header, the same trace gives the same bytes.
    content = gzip.compress(text.getvalue().encode(), mtime=0)
    return Seal(sha256(content).hexdigest(), len(lines)), content


def _written(cell: Any, column: str, schema: Schema) -> Any:
    """Return a cell as its file has it, None for a number that no record may hold."""
    is_checked = is_number(cell) and HEAD.fullmatch(column)
    if is_checked and schema.number_problem(column, cell):
        return None
    return f"{cell:{DIGITS}}" if isinstance(cell, float) else cell


def load_trace(path: Path, schema: Schema | None = None) -> "pd.DataFrame":
    """Read the trace at ``path``; raise RecordError if it is damaged in any way."""
    import pandas as pd

    content = read_file(path, BYTE_LIMIT)
    try:
        unpacking = zlib.decompressobj(wbits=31)
        text = unpacking.decompress(content, UNPACKED_LIMIT)
        if not unpacking.eof or unpacking.unused_data:
            raise ValueError(
                f"it ends early, holds more than {UNPACKED_LIMIT >> 20} MiB, or has a rest"
            )
        _check(text.decode("utf-8"), schema or current().columns)
        # Before pandas 3, which Python 3.10 has, the last digits of numbers are others unless one asks for them.
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
            f"{short_path(path)} is no whole trace: {message:.300}"
        ) from None


def _check(text: str, schema: Schema) -> None:
    """Raise ValueError unless a text is a trace: columns of one length, each of numbers or of texts."""
    lines = csv.reader(io.StringIO(text), strict=True)
    head = next(lines, [])
    if len(head) > COLUMN_LIMIT:
        raise ValueError(f"it has more than {COLUMN_LIMIT} columns")
    if len(set(head)) < len(head):
        raise ValueError("its first line names a column twice")
    rows: list[Sequence[str]] = []
    for number, line in enumerate(lines, start=2):
        if len(line) != len(head):
            raise ValueError(f"line {number} has {len(line)} cells, not {len(head)}")
        if number * len(head) > CELL_LIMIT:
            raise ValueError(f"it has more than {CELL_LIMIT} cells")
        rows.append(line)
    if not rows:
        raise ValueError("it has no rows")
    for column, cells in zip(head, zip(*rows, strict=True), strict=True):
        if problem := _column_problem(column, cells, schema):
            raise ValueError(f"{column!r:.80} {problem}")


def _column_problem(column: str, cells: Iterable[str], schema: Schema) -> str:
    """Say what is wrong with a column; empty if nothing is."""
    if not HEAD.fullmatch(column):
        return "is no column name"
    filled = [cell for cell in cells if cell]
    try:
        numbers = list(map(float, filled))
    except ValueError:
        return _text_problem(filled, schema[column].unit)
    if not all(map(math.isfinite, numbers)):
        return "has what is no number"
    if column == "time_s" and numbers != sorted(numbers):
        return "runs backwards"
    ends = (min(numbers), max(numbers)) if numbers else ()
    problems = (schema.number_problem(column, end) for end in ends)
    return next(filter(None, problems), "")


def _text_problem(texts: Sequence[str], unit: str) -> str:
    if unit != PLAIN:
        return "is not all numbers"
    for text in dict.fromkeys(texts):
        if problem := text_problem(text):
            return problem
        try:
            float(text)
        except ValueError:
            continue
        return "has both numbers and text"
    return ""
