"""Read and write records: the measured rows of a section with their provenance.

A record is a JSON file with one line for each row, so that git can compare records line
by line. Each field is checked when it is read.
"""

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
from measured_report.files.config import report as current
from measured_report.files.errors import UNPRINTABLE
from measured_report.records.identity import MISSING, Digest, Identity, identity_of

SCHEMA = 1
BYTE_LIMIT = 32 << 20
CASE = re.compile(r"[A-Za-z0-9][A-Za-z0-9._-]*")
DIGITS = ".9g"  # enough digits to distinguish all numbers of single precision
Case = Annotated[str, Meta(pattern=rf"\A{CASE.pattern}\Z", max_length=200)]
Key = Annotated[str, Meta(pattern=r"\A[A-Za-z0-9_.+-]{1,200}\Z")]
NAME = r"\A[a-z][a-z0-9_]{0,79}\Z"  # of a column
Name = Annotated[str, Meta(pattern=NAME)]
LINE_LIMIT = 400  # characters
Line = Annotated[str, Meta(pattern=r"\A[^\n\t]+\Z", max_length=LINE_LIMIT)]
if TYPE_CHECKING:
    from typing import Any as Cell
    from typing import Any as Noted
else:
    Noted, Cell = Line | int | float | None, bool | int | float | str | None
Time = Annotated[
    str, Meta(pattern=r"\A20\d\d-\d\d-\d\dT\d\d:\d\d:\d\d(\.\d{6})?[+-]\d\d:\d\d\Z")
]
"""A time in the format that all supported versions of Python can parse.

A year before 2000 comes from a clock that was not set.
"""


@dataclass(frozen=True, order=True)
class Origin:
    """Describe the release and the processor with which a number was measured.

    Only numbers with the same origin can be compared.
    """

    release: str
    processor: str

    def __str__(self) -> str:
        return f"{current().settings.edition_name} {self.release} on {self.processor}"


class Seal(Struct, frozen=True, forbid_unknown_fields=True):
    """The digest of a trace's file, which shows whether the file was changed."""

    digest: Digest
    row_count: Annotated[int, Meta(ge=1, le=10_000_000)]


class Carried(Struct, frozen=True, forbid_unknown_fields=True):
    """Describe a change of code over which a record was carried."""

    code: Digest  # the digest of the old code, as in the identity before the change
    old: Line = renamed(name="from")  # the commit with the old code
    new: Line = renamed(name="to")  # the commit with the new code
    date: Time
    cells: Annotated[int, Meta(ge=1)]  # the number of compared cells

    def __str__(self) -> str:
        change = (
            f"The measured code changed from {self.old} to {self.new} on "
            f"{self.date[:10]}"
        )
        proof = (
            f"The quick profile was run again with both, and all {self.cells} cells "
            "are bit-identical"
        )
        return f"{change}. {proof}; the full profile was not run again."


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
"""The types of the fields that these tables must contain.

The tables can contain other fields, too.
"""


@dataclass(frozen=True)
class Record:
    """The rows of a section, with the machine, the date and the code that measured them."""

    section: Line
    identity: Identity
    machine: Mapping[Key, Noted]  # None if the machine lacks the part, such as a GPU
    measured: Mapping[Key, Noted]  # `date`, `commit`, `command` and `seconds`
    units: Mapping[Name, Line]
    rows: Annotated[Sequence[Mapping[Name, Cell]], Meta(min_length=1)]
    traces: Mapping[Case, Seal] = field(default_factory=dict)
    carried: tuple[Carried, ...] = ()  # oldest first
    deprecated: tuple[Line, ...] = ()
    """The warnings of features that a later release of a package removes."""

    @property
    def codes(self) -> frozenset[str]:
        """Return the digests of all versions of the code that measure the same rows."""
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
        """Return a description of the machine with its core count and its CPU."""
        count = self.machine.get("cores") or "an unknown number of"
        text = f"{self.machine_text}, {count} cores"
        if self.machine.get("device") == "cpu":
            return text
        return f"{text} of {self.machine.get('cpu')}"

    @property
    def machine_for_speed(self) -> tuple[str | None, ...]:
        """Return the properties that must be the same before times are compared.

        Hosts with the same kind of processor differ by a few percent, which the noise
        of a time includes.
        """
        return self.processor, self.machine.get("device")

    @cached_property
    def number_count(self) -> int:
        return sum(is_number(cell) for row in self.rows for cell in row.values())

    @property
    def card(self) -> str:
        """Return an identifier of the card or, without one, of the host that measured.

        Older records contain neither; then only the kind of processor is known.
        """
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
            f"case {case!r} of a trace cannot be part of a file name: use letters, "
            "digits, '.', '_' and '-'"
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
    """Write a record and its traces at ``path``.

    Args:
        traces: the seals and contents of the new traces by case; None keeps the traces
            that exist.
        replacing: the ``file_digest`` of the only file that may be replaced; None
            replaces any file.
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
                f"{short_path(path)} was changed by another command in the meantime, "
                "and was kept: run this command again"
            )
        write_files({path: content, **packed})
        for trace in (
            path.parent.glob(f"{path.stem}.*.csv.gz") if traces is not None else ()
        ):
            if trace not in packed:  # its case no longer exists
                trace.unlink()


def file_digest(path: Path) -> str:
    """Return the digest of a record's file, or an empty string if it is unreadable."""
    try:
        return sha256(read_file(path, BYTE_LIMIT)).hexdigest()
    except RecordError:
        return ""


@dataclass(frozen=True)
class Basis:
    """The state of the code and of the record before a section is measured.

    A new record is written only if neither of them changed during the measurement.
    """

    section: str
    path: Path  # of the record
    identify: Callable[[], Identity]  # returns the identity of the current code
    identity: Identity
    replacing: str  # digest of the record's file; empty if it did not exist

    def write(
        self, record: Record, traces: Mapping[str, tuple[Seal, bytes]] | None = None
    ) -> None:
        """Write a record; raise RecordError if the code or the old record changed."""
        if self.identify() != self.identity:
            raise RecordError(
                f"the code of {self.section} changed in the meantime, so its record "
                "was not written: run this command again"
            )
        write_record(self.path, record, traces, self.replacing)


def basis_of(
    section: str,
    path: Path,
    profile: str,
    root: Path,
    packages: Mapping[str, str] | None = None,
) -> Basis:
    """Return the basis of a measurement; call this before its modules are imported."""
    identify = partial(identity_of, section, profile, root, packages)
    return Basis(section, path, identify, identify(), file_digest(path))


def record_text(record: Record) -> str:
    # The rows are written below, because to_builtins would copy every cell.
    data = {"schema": SCHEMA, **to_builtins(replace(record, rows=[]))}
    del data["rows"]
    for name in ("carried", "deprecated"):
        if not data[name]:
            del data[name]
    head = json.dumps(data, indent=1, ensure_ascii=False, allow_nan=False)
    write = partial(
        json.dumps, ensure_ascii=False, allow_nan=False, separators=(",", ":")
    )
    lines = []
    for row in record.rows:
        lines.append(write({name: _rounded(cell) for name, cell in row.items()}))
    rows = ",\n  ".join(lines)
    return sealed(head.removesuffix("\n}") + f',\n "rows": [\n  {rows}\n ]')


def _rounded(cell: Any) -> Any:
    return float(f"{cell:{DIGITS}}") if isinstance(cell, float) else cell


def sealed(text: str) -> str:
    """Return the text of a record with its seal and its last brace added.

    The seal reveals changes by hand, but it does not prevent forgery: anyone can
    compute a new one.
    """
    return f'{text},\n "seal": "{sha256(text.encode()).hexdigest()}"\n}}\n'


def load_record(path: Path) -> Record:
    """Read the record at ``path``; raise RecordError if it or a trace is damaged."""
    record = read_record(read_file(path, BYTE_LIMIT), path)
    for case, seal in record.traces.items():
        trace = trace_path(path, case)
        if sha256(read_file(trace, BYTE_LIMIT)).hexdigest() != seal.digest:
            raise RecordError(
                f"{short_path(trace)} is not the trace that was measured with "
                f"{path.name}"
            )
    return record


def read_record(content: bytes, path: Path) -> Record:
    """Return the record in the content of a file.

    Raise RecordError if any field is invalid.
    """
    report = current()
    try:
        text = content.decode("utf-8")
        data = json.loads(text, object_pairs_hook=_plain, parse_constant=_refuse)
        if not isinstance(data, dict):
            raise ValueError("it is not a JSON object")
        schema = data.pop("schema", None)
        if type(schema) is not int or schema != SCHEMA:
            raise ValueError(f"it has schema {schema!r:.40}, not {SCHEMA}")
        if data.pop("seal", None) is None:
            raise ValueError("it has no seal")
        if text != sealed(text[: text.rfind(',\n "seal": ')]):
            raise ValueError("it was changed after it was sealed")
        record = convert(data, Record)
        for table, types in REQUIRED.items():
            for name, kind in types.items():
                convert(data[table].get(name, ...), kind)
        convert([row.get("case") for row in record.rows], list[Line])
        identity = data["identity"]
        _refuse_unknown(data, Record.__match_args__)
        _refuse_unknown(identity, Identity.__match_args__)
        _refuse_unknown(identity["packages"], report.settings.packages)
        date = record.measured["date"]
        texts = [record.measured.get(name) or date for name in ("started", "ended")]
        times = map(datetime.fromisoformat, convert([*texts, date], list[Time]))
        started, ended, written = times
        tomorrow = datetime.now(timezone.utc) + timedelta(days=1)
        if started > ended or max(ended, written) > tomorrow:
            raise ValueError("its end is before its start or in the future")
        if record.section != path.stem:
            raise ValueError(f"it belongs to section {record.section!r}")
        report.columns.refuse_mixed(record.rows, record.units)
    except (ValueError, OverflowError, RecursionError) as error:
        # One line, without characters that could control the terminal of the reader.
        message = UNPRINTABLE.sub("?", " ".join(str(error).split()))
        raise RecordError(
            f"{short_path(path)} is not a valid record: "
            f"{message or type(error).__name__:.300}"
        ) from None
    return record


def _refuse_unknown(table: Mapping[str, Any], names: Collection[str]) -> None:
    if unknown := table.keys() - set(names):
        raise ValueError(f"{min(unknown)!r:.80} is not a known key")


def _plain(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """Return a JSON object as a dictionary; raise ValueError for a repeated key.

    Programs differ in which of two values they read.
    """
    fields = dict(pairs)
    if len(fields) < len(pairs):
        keys = [key for key, _ in pairs]
        raise ValueError(f"it contains the key {max(keys, key=keys.count)!r:.80} twice")
    for key, value in pairs:
        if isinstance(value, str) and (problem := text_problem(value)):
            raise ValueError(f"{key!r:.80} {problem}")
    return fields


def _refuse(constant: str) -> None:
    raise ValueError(f"{constant} is not a finite number")
