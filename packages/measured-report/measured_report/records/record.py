"""Records: what one section measured, as one JSON file that git can compare line by line, and each field is checked."""

import json
import re
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from datetime import datetime, timedelta, timezone
from functools import cached_property, partial
from hashlib import sha256
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from msgspec import Meta, Struct, convert, to_builtins
from msgspec import field as renamed

from measured_report.files.atomic import (
    RecordError,
    locked,
    read_file,
    short_path,
    write_files,
)
from measured_report.files.columns import is_number, text_problem
from measured_report.files.config import Report
from measured_report.files.config import report as current
from measured_report.files.errors import UNPRINTABLE
from measured_report.records.identity import MISSING, Digest, Identity, identity_of

SCHEMA = 1
BYTE_LIMIT = 32 << 20
CASE = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*")
DIGITS = ".9g"  # as many digits as tell any two numbers of single precision apart
Case = Annotated[str, Meta(pattern=rf"\A{CASE.pattern}\Z", max_length=200)]
Key = Annotated[str, Meta(pattern=r"\A[A-Za-z0-9_.+-]{1,200}\Z")]
NAME = r"\A[a-z][a-z0-9_]{0,79}\Z"  # of a column
Name = Annotated[str, Meta(pattern=NAME)]
Line = Annotated[str, Meta(pattern=r"\A[^\n\t]+\Z", max_length=400)]
if TYPE_CHECKING:
    from typing import Any as Cell
    from typing import Any as Noted
else:
    Noted, Cell = Line | int | float | None, bool | int | float | str | None
Time = Annotated[
    str, Meta(pattern=r"\A20\d\d-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d{6})?[+-]\d\d:\d\d\Z")
]
"""As every Python reads it, in a year of a clock that goes."""


@dataclass(frozen=True, order=True)
class Origin:
    """Say what a number was measured with, as far as others must share it to be compared with it."""

    release: str
    processor: str

    def __str__(self) -> str:
        return f"{current().settings.edition_name} {self.release} on {self.processor}"


class Seal(Struct, frozen=True, forbid_unknown_fields=True):
    digest: Digest
    row_count: Annotated[int, Meta(ge=1, le=10_000_000)]


class Carried(Struct, frozen=True, forbid_unknown_fields=True):
    """Describes a change of code over which a record was carried."""

    code: Digest  # of the identity that the record had before
    old: Line = renamed(
        name="from"
    )  # the commit with that code, as the next with the code of the identity after it
    new: Line = renamed(name="to")
    date: Time
    cells: Annotated[int, Meta(ge=1)]  # so many were compared

    def __str__(self) -> str:
        change = (
            f"from the code of {self.old} to that of {self.new} on {self.date[:10]}"
        )
        same = f"{self.cells} cells, same bits in the quick profile"
        return f"{change}: {same}; the full profile was not run again"


REQUIRED: Mapping[str, Mapping[str, Any]] = {
    "machine": {
        "device": Literal["cuda", "cpu"],
        "gpu": Line | None,
        "driver": Line | None,
        "cpu": Line,
        "python": Line,
    },
    "measured": {
        "date": Time,
        "commit": Line | None,
        "command": Line,
        "seconds": Annotated[float, Meta(ge=0.0, le=1e8)],
    },
}
"""The types of fields that a record has besides any others; so has each row a case."""


@dataclass(frozen=True)
class Record:
    """Keeps what one section measured, and where, when and by which code."""

    section: Line
    identity: Identity
    machine: Mapping[Key, Noted]  # None where there is none
    measured: Mapping[Key, Noted]  # `date`, `commit`, `command` and `seconds`
    units: Mapping[Name, Line]
    rows: Annotated[Sequence[Mapping[Name, Cell]], Meta(min_length=1)]
    traces: Mapping[Case, Seal] = field(default_factory=dict)
    carried: tuple[Carried, ...] = ()  # oldest first

    @property
    def codes(self) -> frozenset[str]:
        """Return digests of the codes that are known to measure the same."""
        return frozenset(
            {self.identity.code, *(carried.code for carried in self.carried)}
        )

    @property
    def processor(self) -> str:
        kind = "cpu" if self.machine.get("device") == "cpu" else "gpu"
        return self.machine.get(kind) or "an unknown processor"

    @property
    def machine_text(self) -> str:
        driver = self.machine.get("driver")
        return f"{self.processor} (driver {driver})" if driver else self.processor

    @property
    def machine_in_full(self) -> str:
        """Name all that must be the same for two times to be compared."""
        count = self.machine.get("cores") or "an unknown number of"
        text = f"{self.machine_text}, {count} cores"
        if self.machine.get("device") == "cpu":
            return text
        return f"{text} of {self.machine.get('cpu')}"

    @property
    def machine_for_speed(self) -> tuple[str | None, ...]:
        """Return what two machines must share for their times to be compared.

        Hosts with the same kind of processor differ by a few percent, which the noise of
        a time includes.
        """
        return self.processor, self.machine.get("device")

    @cached_property
    def number_count(self) -> int:
        return sum(is_number(cell) for row in self.rows for cell in row.values())

    @property
    def card(self) -> str:
        """Name the one card, or else the host, that it was measured on, as far as its record tells."""
        return str(
            self.machine.get("gpu_uuid") or (self.machine.get("host"), self.processor)
        )

    @property
    def time(self) -> datetime:
        return datetime.fromisoformat(self.measured["date"])

    @property
    def time_text(self) -> str:
        return self.time.strftime("%Y-%m-%d %H:%M %Z")

    @property
    def origin(self) -> Origin:
        return Origin(
            next(iter(self.identity.packages.values()), MISSING), self.processor
        )


def trace_path(record: Path, case: str) -> Path:
    if not CASE.fullmatch(str(case)):
        raise RecordError(
            f"a trace needs a case name that can be part of a file name, not {case!r}"
        )
    return record.with_name(f"{record.stem}.{case}.csv.gz")


def traces_of(path: Path, record: Record) -> list[Path]:
    return [trace_path(path, case) for case in record.traces]


def write_record(
    path: Path,
    record: Record,
    traces: Mapping[str, tuple[Seal, bytes]] | None = None,
    replacing: str | None = None,
) -> None:
    """Write a record and its traces, by case, at ``path``; None: the traces there stay.

    ``replacing`` is the digest of the file that may be replaced, as ``file_digest`` gives it; None: any file.
    """
    if traces is not None:
        record = replace(
            record, traces={case: seal for case, (seal, _) in traces.items()}
        )
    try:
        content = record_text(record).encode()
    except (TypeError, ValueError) as error:
        raise RecordError(f"{short_path(path)} cannot be written: {error}") from None
    read_record(content, path)
    packed = {
        trace_path(path, case): content for case, (_, content) in (traces or {}).items()
    }
    path.parent.mkdir(parents=True, exist_ok=True)
    with locked(path.parent.parent):
        if replacing not in (None, file_digest(path)):
            raise RecordError(
                f"{short_path(path)} was written by another command meanwhile: nothing was changed"
            )
        write_files({path: content, **packed})
        for trace in (
            path.parent.glob(f"{path.stem}.*.csv.gz") if traces is not None else ()
        ):
            if trace not in packed:  # of a case that is gone
                trace.unlink()


def file_digest(path: Path) -> str:
    """Return the digest of a record's file; empty if there is none that can be read."""
    try:
        return sha256(read_file(path, BYTE_LIMIT)).hexdigest()
    except RecordError:
        return ""


@dataclass(frozen=True)
class Basis:
    """Holds the code, and the record that is to be replaced, as they were before a section was measured."""

    section: str
    path: Path  # of the record
    identify: Callable[[], Identity]
    identity: Identity
    replacing: str  # digest of the record's file; empty if there was none

    def write(
        self, record: Record, traces: Mapping[str, tuple[Seal, bytes]] | None = None
    ) -> None:
        """Write a record; raise RecordError if the code or the record changed meanwhile."""
        if self.identify() != self.identity:
            raise RecordError(
                f"the code of {self.section} changed meanwhile: nothing was written"
            )
        write_record(self.path, record, traces, self.replacing)


def basis_of(
    section: str,
    path: Path,
    profile: str,
    root: Path,
    packages: Mapping[str, str] | None = None,
) -> Basis:
    """Return the basis of a measurement, whose modules may be imported after this."""
    identify = partial(identity_of, section, profile, root, packages)
    return Basis(section, path, identify, identify(), file_digest(path))


def record_text(record: Record) -> str:
    data = {"schema": SCHEMA, **to_builtins(replace(record, rows=[]))}
    del data["rows"]  # to_builtins would copy every cell
    if not record.carried:
        del data["carried"]
    head = json.dumps(data, indent=1, ensure_ascii=False, allow_nan=False)
    write = partial(
        json.dumps, ensure_ascii=False, allow_nan=False, separators=(",", ":")
    )
    lines = []
    for row in record.rows:
        cells = row.items()
        lines.append(write({name: _rounded(cell) for name, cell in cells}))
    rows = ",\n  ".join(lines)
    return sealed(head.removesuffix("\n}") + f',\n "rows": [\n  {rows}\n ]')


def _rounded(cell: Any) -> Any:
    return float(f"{cell:{DIGITS}}") if isinstance(cell, float) else cell


def sealed(text: str) -> str:
    """Return the text of a record, so far without its last brace, with its seal.

    The seal shows a change by hand, unless somebody seals the text anew.
    """
    return f'{text},\n "seal": "{sha256(text.encode()).hexdigest()}"\n}}\n'


def load_record(path: Path, report: Report | None = None) -> Record:
    """Read the record at ``path``; raise RecordError if it or a trace that it seals is damaged in any way."""
    record = read_record(read_file(path, BYTE_LIMIT), path, report)
    for case, seal in record.traces.items():
        trace = trace_path(path, case)
        if sha256(read_file(trace, BYTE_LIMIT)).hexdigest() != seal.digest:
            raise RecordError(
                f"{short_path(trace)} is not the trace that was measured with {path.name}"
            )
    return record


def read_record(content: bytes, path: Path, report: Report | None = None) -> Record:
    """Return the record that a file holds; raise RecordError unless each field is as it should be."""
    report = report or current()
    try:
        text = content.decode("utf-8")
        data = json.loads(text, object_pairs_hook=_plain, parse_constant=_refuse)
        if not isinstance(data, dict):
            raise ValueError("it is no object")
        schema = data.pop("schema", None)
        if type(schema) is not int or schema != SCHEMA:
            raise ValueError(f"it has schema {schema!r:.40}, not {SCHEMA}")
        if data.pop("seal", None) is None:
            raise ValueError("it has no seal")
        if text != sealed(text[: text.rfind(',\n "seal": ')]):
            raise ValueError("it is not as it was sealed")
        record = convert(data, Record)
        for table, types in REQUIRED.items():
            for name, kind in types.items():
                convert(data[table].get(name, ...), kind)
        convert([row.get("case") for row in record.rows], list[Line])
        identity = data["identity"]
        _refuse_others(data, Record.__match_args__)
        _refuse_others(identity, Identity.__match_args__)
        _refuse_others(identity["packages"], report.settings.packages)
        date = record.measured["date"]
        texts = [record.measured.get(name) or date for name in ("started", "ended")]
        times = map(datetime.fromisoformat, convert([*texts, date], list[Time]))
        began, ended, written = times
        tomorrow = datetime.now(timezone.utc) + timedelta(days=1)
        if began > ended or max(ended, written) > tomorrow:
            raise ValueError("it ended before it began, or will on a day to come")
        if record.section != path.stem:
            raise ValueError(f"it is one of {record.section!r}")
        report.columns.refuse_mixed(record.rows, record.units)
    except (ValueError, OverflowError, RecursionError) as error:
        # In one line, without characters that could do anything to whoever reads it.
        message = UNPRINTABLE.sub("?", " ".join(str(error).split()))
        raise RecordError(
            f"{short_path(path)} is no whole record: {message or type(error).__name__:.300}"
        ) from None
    return record


def _refuse_others(table: Mapping[str, Any], names: Collection[str]) -> None:
    if unknown := table.keys() - set(names):
        raise ValueError(f"nothing here is called {min(unknown)!r:.80}")


def _plain(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """Return an object of JSON, in which each key stands once: of two, a reader would see either."""
    fields = dict(pairs)
    if len(fields) < len(pairs):
        keys = [key for key, _ in pairs]
        raise ValueError(f"{max(keys, key=keys.count)!r:.80} is there twice")
    for key, value in pairs:
        if isinstance(value, str) and (problem := text_problem(value)):
            raise ValueError(f"{key!r:.80} {problem}")
    return fields


def _refuse(constant: str) -> None:
    raise ValueError(f"{constant} is no number")
