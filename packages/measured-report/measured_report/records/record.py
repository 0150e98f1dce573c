"""Records: what one section measured, as one JSON file that git can compare line by line."""

import json
import re
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from datetime import datetime, timedelta
from pathlib import Path
from typing import Annotated, Any

from msgspec import Meta

from measured_report.files.atomic import RecordError, put_record, short_path
from measured_report.files.config import config
from measured_report.records.columns import COLUMN, column_of, columns_of, name_problem, problem_in, units_of
from measured_report.records.identity import Digest, Identity
from measured_report.records.provenance import MISSING

SCHEMA = 1
CASE = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*")
Text = Annotated[str, Meta(max_length=400)]
Case = Annotated[str, Meta(pattern=rf"\A{CASE.pattern}\Z", max_length=200)]


@dataclass(frozen=True, order=True)
class Origin:
    """What a number was measured with, as far as others must share it to be compared with it."""

    release: str
    """Version of the package whose releases are editions."""
    processor: str

    def __str__(self) -> str:
        return f"{config().edition_name} {self.release} on {self.processor}"


@dataclass(frozen=True)
class Seal:
    """What binds a trace to its record."""

    digest: Digest
    """SHA-256 of the file."""
    row_count: Annotated[int, Meta(ge=1, le=10_000_000)]


@dataclass(frozen=True)
class Record:
    """What one section measured, and where, when and by which code."""

    section: Text
    identity: Identity
    machine: Mapping[Text, Any]
    """``device`` (cuda or cpu), ``gpu``, ``driver``, ``cpu``, ``python``; None where there is none."""
    measured: Mapping[Text, Any]
    """``date``, ``commit``, ``command`` and ``seconds``."""
    units: Mapping[Text, Text]
    rows: Sequence[Mapping[Text, Any]]
    traces: Mapping[Case, Seal] | None = None
    """Seal of each trace by its case; None in a record from before traces were sealed."""

    @property
    def processor(self) -> str:
        """What the numbers were measured on."""
        device = "gpu" if self.machine.get("device") == "cuda" else "cpu"
        return self.machine.get(device) or device.upper()

    @property
    def machine_text(self) -> str:
        """The processor, and the driver that it runs with."""
        return self.processor + (f" (driver {self.machine['driver']})" if self.machine.get("driver") else "")

    @property
    def machine_in_full(self) -> str:
        """All that must be the same for two times to be compared."""
        cores = f"{self.machine_text}, {self.machine.get('cores') or 'an unknown number of'} cores"
        beside = f", {self.machine['sections_at_once']} sections at once" if "sections_at_once" in self.machine else ""
        return f"{cores}{beside}" if self.machine.get("device") == "cpu" else f"{cores} of {self.machine.get('cpu')}"

    @property
    def time_text(self) -> str:
        """When it was measured, to the minute."""
        return datetime.fromisoformat(self.measured["date"]).strftime("%Y-%m-%d %H:%M %Z")

    @property
    def span(self) -> tuple[datetime, datetime]:
        """From when to when it was measured."""
        ended = datetime.fromisoformat(self.measured.get("ended", self.measured["date"]))
        started = self.measured.get("started")
        return datetime.fromisoformat(started) if started else ended - timedelta(
            seconds=self.measured["seconds"]
        ), ended

    @property
    def origin(self) -> Origin:
        return Origin(self.identity.packages.get(config().package, MISSING), self.processor)

    @property
    def machine_for_speed(self) -> tuple[str | None, ...]:
        """What must be the same for two times to be compared."""
        return tuple(map(self.machine.get, ("device", "gpu", "driver", "cpu", "cores", "sections_at_once")))


DIGITS = ".9g"
"""Of a number: as many as tell any two of single precision apart, far below what any of these repeats to."""


def write_record(path: Path, record: Record, traces: Mapping[str, tuple[Seal, bytes]] | None = None) -> None:
    """Put ``record`` and its traces, by case, at ``path``: all of them whole, or none; None: those there stay."""
    if traces is not None:
        record = replace(record, traces={case: seal for case, (seal, _) in traces.items()})
    check_record(record, short_path(path))
    files = {f"{path.stem}.{case}.csv.gz": content for case, (_, content) in (traces or {}).items()}
    put_record(path, {**files, path.name: _text(record).encode()})


def _text(record: Record) -> str:
    rows = [
        {column: float(f"{value:{DIGITS}}") if isinstance(value, float) else value for column, value in row.items()}
        for row in record.rows
    ]
    data = {"schema": SCHEMA, **asdict(replace(record, rows=[]))}  # which would copy every cell
    del data["rows"]
    if record.traces is None:
        del data["traces"]
    head = json.dumps(data, indent=1, ensure_ascii=False, allow_nan=False)
    lines = [json.dumps(row, ensure_ascii=False, allow_nan=False, separators=(",", ":")) for row in rows]
    return head.removesuffix("\n}") + ',\n "rows": [\n  ' + ",\n  ".join(lines) + "\n ]\n}\n"


def check_record(record: Record, place: str) -> None:
    """RecordError, with the first thing that is wrong, when the rows of ``record`` can't be kept at ``place``."""
    if not record.rows:
        raise RecordError(f"{place} has no rows")
    known = filter(COLUMN.fullmatch, record.units)
    ranges = {name: (column_of(name).least, column_of(name).largest) for name in known}
    for index, row in enumerate(record.rows):
        case = row.get("case")
        if not case or not isinstance(case, str):
            raise RecordError(f"{place}: row {index} has no case")
        if problem := name_problem(case):
            raise RecordError(f"{place}: the case of row {index} {problem}")
        for column, value in row.items():
            # Nearly all are numbers that may be there, and every build reads every record.
            if type(value) in (float, int) and column in ranges and ranges[column][0] <= value <= ranges[column][1]:
                continue
            if problem := problem_in(row, column, record.units):
                raise RecordError(f"{place}: {column:.80} of {case!r:.80} {problem}")
    _check_columns(record, place)


def _check_columns(record: Record, place: str) -> None:
    """The units are those that the columns' names say, and a column holds one kind of thing."""
    expected = units_of(record.rows)
    for column in sorted({*expected, *record.units}):
        said, unit = record.units.get(column), expected.get(column)
        if said != unit:
            raise RecordError(f"{place}: the unit of {column} is given as {said}, and its name says {unit}")
    for column in columns_of(record.rows):
        if column not in record.units and len({type(row.get(column)) for row in record.rows} - {type(None)}) > 1:
            raise RecordError(f"{place}: {column} is text in one row and yes or no in another")
