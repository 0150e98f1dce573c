"""Traces: long per-frame series that lie beside a record, as ``<section>.<case>.csv.gz``."""

import gzip
import re
import zlib
from collections.abc import Mapping
from pathlib import Path

import pandas as pd

from report.records.record import RecordError, atomic_file

FILE_NAME_PART = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*")


def trace_path(record: Path, case: str) -> Path:
    """Where the trace of ``case`` lies, beside the record at ``record``."""
    if not FILE_NAME_PART.fullmatch(case):
        raise RecordError(f"a trace needs a case name that can be part of a file name, not {case!r}")
    return record.with_name(f"{record.stem}.{case}.csv.gz")


def load_trace(path: Path) -> pd.DataFrame:
    try:
        return pd.read_csv(path)
    except FileNotFoundError:
        raise RecordError(f"there is no {path.name}") from None
    except (OSError, EOFError, ValueError, zlib.error) as error:
        raise RecordError(f"{path.name} is no whole trace: {' '.join(str(error).split())}") from None


def write_traces(record: Path, frames: Mapping[str, pd.DataFrame]) -> None:
    """Put each case's trace beside the record at ``record``; traces of cases that are no more are removed."""
    paths = {trace_path(record, case): frame for case, frame in frames.items()}
    for path, frame in paths.items():
        text = frame.to_csv(index=False, lineterminator="\n")
        with atomic_file(path) as temporary:
            # Without a time in the header the same numbers give the same bytes.
            temporary.write_bytes(gzip.compress(text.encode(), mtime=0))
    for path in traces_of(record):
        if path not in paths:
            path.unlink()


def traces_of(record: Path) -> list[Path]:
    """The traces that lie beside the record at ``record``."""
    return sorted(record.parent.glob(f"{record.stem}.*.csv.gz"))
