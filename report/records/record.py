"""Records: what one section measured, as one JSON file that git can compare line by line."""

import json
import math
import os
import re
from collections.abc import Mapping, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass
from datetime import datetime
from pathlib import Path
from typing import Any, TypeGuard

from report import ROOT, ReportError
from report.records.identity import MISSING, Identity

SCHEMA = 1

UNITS = {
    "mm_per_cycle": "mm/cycle",
    "kg_m3": "kg/m³",
    "ms_per_s": "ms/s",
    "mrad_s": "mrad/s",
    "mm_s": "mm/s",
    "n_m": "N/m",
    "per_s": "1/s",
    "m_s2": "m/s²",
    "bytes_per_world": "B",
    "bytes": "B",
    "mm": "mm",
    "m": "m",
    "n": "N",
    "s": "s",
    "ms": "ms",
    "hz": "Hz",
    "kg": "kg",
    "count": "1",
}
"""Unit by the end of a column's name; the longest end that fits counts."""

PERCENTILE = re.compile(r"_p[0-9]+$")
COLUMN = re.compile(r"[a-z][a-z0-9_]*")
REASON = "_reason"


class RecordError(ReportError):
    """A record that can't be trusted; the message is one line."""


@dataclass(frozen=True, order=True)
class Origin:
    """What a number was measured with, as far as others must share it to be compared with it."""

    release: str
    """Newton release."""
    processor: str

    def __str__(self) -> str:
        return f"Newton {self.release} on {self.processor}"


@dataclass(frozen=True)
class Record:
    """What one section measured, and where, when and by which code."""

    section: str
    identity: Identity
    machine: Mapping[str, Any]
    """``device`` (cuda or cpu), ``gpu``, ``driver``, ``cpu``, ``python``; None where there is none."""
    measured: Mapping[str, Any]
    """``date``, ``commit``, ``command`` and ``seconds``."""
    units: Mapping[str, str]
    rows: Sequence[Mapping[str, Any]]

    @property
    def processor(self) -> str:
        """What the numbers were measured on."""
        device = "gpu" if self.machine.get("device") == "cuda" else "cpu"
        return self.machine.get(device) or device.upper()

    @property
    def machine_text(self) -> str:
        """The processor, and the driver that it runs with."""
        driver = self.machine.get("driver")
        return self.processor + (f" (driver {driver})" if driver else "")

    @property
    def time_text(self) -> str:
        """When it was measured, to the minute."""
        return datetime.fromisoformat(self.measured["date"]).strftime("%Y-%m-%d %H:%M %Z")

    @property
    def origin(self) -> Origin:
        return Origin(self.identity.packages.get("newton", MISSING), self.processor)

    @property
    def machine_for_speed(self) -> tuple[str | None, ...]:
        """What must be the same for two times to be compared."""
        return tuple(self.machine.get(part) for part in ("device", "gpu", "driver", "cpu", "cores"))


def unit_of(column: str) -> str:
    """The unit that a column's name says; ``1`` when it says none."""
    words = PERCENTILE.sub("", column).split("_")
    ends = ("_".join(words[start:]) for start in range(len(words)))
    return next((UNITS[end] for end in ends if end in UNITS), "1")


def units_of(rows: Sequence[Mapping[str, Any]]) -> dict[str, str]:
    """Units of the columns that hold numbers, missing ones included."""
    columns = {column: None for row in rows for column, value in row.items() if _is_number(value)}
    columns |= {column.removesuffix(REASON): None for row in rows for column in row if column.endswith(REASON)}
    return {column: unit_of(column) for column in columns}


def results_folder(release: str, profile: str, root: Path = ROOT) -> Path:
    """Where the records of a Newton release lie; only those of the full profile are tracked."""
    results = root / "results"
    return (results if profile == "full" else results / profile) / f"newton-{release}"


def record_path(section: str, release: str, profile: str, root: Path = ROOT) -> Path:
    return results_folder(release, profile, root) / f"{section}.json"


def load_record(path: Path) -> Record:
    """The record at ``path``, or RecordError when it is damaged in any way."""
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        schema = data.pop("schema")
        record = Record(**{**data, "identity": Identity(**data["identity"])})
    except OSError as error:
        raise RecordError(f"{path.name}: {error.strerror}") from None
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise RecordError(f"{path.name} is no whole record: {_line(error)}") from None
    if schema != SCHEMA:
        raise RecordError(f"{path.name} has schema {schema!r}, not {SCHEMA}")
    if record.section != path.stem:
        raise RecordError(f"{path.name} is a record of {record.section!r}")
    check_record(record, path.name)
    return record


def write_record(path: Path, record: Record) -> None:
    """Put ``record`` at ``path``: whole, or not at all."""
    check_record(record, path.name)
    data = {"schema": SCHEMA, **asdict(record)}
    rows = data.pop("rows")
    try:
        head = json.dumps(data, indent=1, ensure_ascii=False, allow_nan=False)
        lines = [json.dumps(row, ensure_ascii=False, allow_nan=False) for row in rows]
    except (TypeError, ValueError) as error:
        raise RecordError(f"{path.name}: {_line(error)}") from None
    text = head.removesuffix("\n}") + ',\n "rows": [\n  ' + ",\n  ".join(lines) + "\n ]\n}\n"
    with atomic_file(path) as temporary:
        temporary.write_text(text, encoding="utf-8")


@contextmanager
def atomic_file(path: Path):
    """A path to write to, which takes the place of ``path`` once the block has ended well."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        yield temporary
        with temporary.open("rb") as file:
            os.fsync(file.fileno())
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


def check_record(record: Record, name: str) -> None:
    """RecordError, with the first thing that is wrong, when ``record`` can't be kept as file ``name``."""
    parts = (record.machine, record.measured, record.units, *record.rows)
    if not record.rows or not all(isinstance(part, Mapping) for part in parts):
        raise RecordError(f"{name} lacks rows, or holds something else in the place of one")
    _check_measured(record, name)
    for index, row in enumerate(record.rows):
        if not isinstance(row.get("case"), str):
            raise RecordError(f"{name}: row {index} has no case")
        for column, value in row.items():
            problem = _problem(record, row, column, value)
            if problem:
                raise RecordError(f"{name}: {column} of {row['case']} {problem}")


def _check_measured(record: Record, name: str) -> None:
    try:
        datetime.fromisoformat(record.measured["date"])
        float(record.measured["seconds"])
    except (KeyError, TypeError, ValueError) as error:
        raise RecordError(f"{name} does not say when it was measured: {_line(error)}") from None


def _problem(record: Record, row: Mapping[str, Any], column: str, value: Any) -> str:
    if not COLUMN.fullmatch(column):
        return "is no column name (lower-case words joined by _)"
    if not isinstance(value, bool | int | float | str | None):
        return f"is a {type(value).__name__}, not a plain number or text"
    if _is_number(value) and not math.isfinite(value):
        return f"is {value}; a number that does not exist is null, with its {column}{REASON}"
    if _is_number(value) and column not in record.units:
        return "has no unit"
    if value is None and column in record.units and not row.get(column + REASON):
        return f"is null without a {column}{REASON}"
    return ""


def _is_number(value: Any) -> TypeGuard[int | float]:
    return isinstance(value, int | float) and not isinstance(value, bool)


def _line(error: Exception) -> str:
    return " ".join(str(error).split()) or type(error).__name__
