"""Traces: long per-frame series that lie beside a record, as ``<section>.<case>.csv.gz``, and are sealed by it."""

import csv
import gzip
import io
import re
import zlib
from collections.abc import Collection, Iterator, Mapping, Sequence
from contextlib import suppress
from hashlib import sha256
from operator import gt
from pathlib import Path
from typing import TYPE_CHECKING, Any

from measured_report.files.atomic import RecordError, read_file, short_path
from measured_report.files.columns import PLAIN, Schema, is_number, plain, text_problem
from measured_report.files.config import report as current
from measured_report.records.record import BYTE_LIMIT, DIGITS, Seal, trace_path

if (
    TYPE_CHECKING
):  # it takes long to import, and whoever only asks what is fresh needs none of it
    import pandas as pd

HEAD = re.compile(r"[a-z][a-z0-9_-]{0,79}")
UNPACKED_LIMIT = 64 << 20
COLUMN_LIMIT = 1_000
CELL_LIMIT = 8_000_000  # more would take gigabytes to look at; traces that were kept have some tens of thousands
NO_NUMBER = re.compile(r"[+-]?(?:nan|inf|infinity)", re.IGNORECASE)


def packed(
    record: Path, case: str, table: Mapping[str, Any], schema: Schema | None = None
) -> tuple[Seal, bytes]:
    """Pack a trace as it is kept beside ``record``, with its seal, without pandas, which is not there."""
    schema = schema or current().columns
    text, columns = (
        io.StringIO(),
        {
            str(name): [plain(cell, name) for cell in cells]
            for name, cells in table.items()
        },
    )
    try:
        for name, cells in columns.items():
            cells[:] = [
                None if is_number(cell) and schema.number_problem(name, cell) else cell
                for cell in cells
            ]
            texts = dict.fromkeys(cell for cell in cells if isinstance(cell, str))
            _check_column(name, list(filter(is_number, cells)), texts, schema)
        if len({*map(len, columns.values())}) > 1:
            raise ValueError("its columns are not of one length")
        lines = list(zip(*columns.values(), strict=True))
        _check_cells(
            iter([[*columns], *([str(cell) for cell in line] for line in lines)])
        )
    except ValueError as error:
        raise RecordError(
            f"{short_path(trace_path(record, case))} is no whole trace: {error}"
        ) from None
    write = csv.writer(text, lineterminator="\n").writerow
    for line in ([*columns], *lines):
        write(
            [f"{cell:{DIGITS}}" if isinstance(cell, float) else cell for cell in line]
        )
    content = gzip.compress(
        text.getvalue().encode(), mtime=0
    )  # with no time in its header: the same gives the same
    return Seal(sha256(content).hexdigest(), len(lines)), content


def load_trace(path: Path, schema: Schema | None = None) -> "pd.DataFrame":
    """Read the trace at ``path``; RecordError, one line with its release and file, when it is damaged in any way."""
    import pandas as pd

    content = read_file(path, BYTE_LIMIT)
    try:
        unpacking = zlib.decompressobj(wbits=31)
        text = unpacking.decompress(content, UNPACKED_LIMIT)
        if not unpacking.eof or unpacking.unused_data:
            raise ValueError(
                f"it ends early, holds more than {UNPACKED_LIMIT >> 20} MiB, or has a rest"
            )
        _check_cells(csv.reader(io.StringIO(text.decode("utf-8")), strict=True))
        # Before pandas 3, which Python 3.10 has, the last digits of numbers are others unless one asks for them.
        exact: dict[str, Any] = (
            {}
            if int(pd.__version__.partition(".")[0]) > 2
            else {"float_precision": "round_trip"}
        )
        frame = pd.read_csv(
            io.BytesIO(text),
            index_col=False,
            keep_default_na=False,
            na_values=[""],
            **exact,
        )
        for column in frame:
            cells = frame[column].dropna()
            is_numeric = cells.dtype.kind in "iuf"
            numbers, texts = (
                cells.tolist() if is_numeric else [],
                [] if is_numeric else cells.unique(),
            )
            _check_column(
                column,
                numbers,
                [text for text in texts if isinstance(text, str)],
                schema or current().columns,
            )
    except (ValueError, csv.Error, zlib.error) as error:
        raise RecordError(
            f"{short_path(path)} is no whole trace: {' '.join(str(error).split()):.300}"
        ) from None
    return frame


def _check_cells(lines: Iterator[list[str]]) -> None:
    head, number = next(lines, []), 1
    if len(head) > COLUMN_LIMIT:
        raise ValueError(f"it has more than {COLUMN_LIMIT} columns")
    if len(set(head)) < len(head):
        raise ValueError("its first line names a column twice")
    for number, line in enumerate(lines, start=2):
        if len(line) != len(head):
            raise ValueError(f"line {number} has {len(line)} cells, not {len(head)}")
        if number * len(head) > CELL_LIMIT:
            raise ValueError(f"it has more than {CELL_LIMIT} cells")
        if cell := next(filter(NO_NUMBER.fullmatch, line), ""):
            raise ValueError(f"{cell} is no number")
    if number < 2:
        raise ValueError("it has no rows")


def _check_column(
    column: str, numbers: Sequence[float], texts: Collection[str], schema: Schema
) -> None:
    if not HEAD.fullmatch(column):
        raise ValueError(f"{column!r:.80} is no column name")
    problems = (
        ["runs backwards"]
        if column == "time_s" and any(map(gt, numbers, numbers[1:]))
        else []
    )
    problems += (
        ["is not all numbers"]
        if texts and (numbers or schema[column].unit != PLAIN)
        else []
    )
    problems += [
        problem
        for text in texts
        if (problem := text_problem(text) or _number_problem(text))
    ]
    problems += [
        schema.number_problem(column, end(numbers)) for end in (min, max) if numbers
    ]
    if problem := next(filter(None, problems), ""):
        raise ValueError(f"{column!r:.80} {problem}")


def _number_problem(text: str) -> str:
    with suppress(ValueError):
        float(text)
        return "has both numbers and text"
    return ""
