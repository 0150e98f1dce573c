"""Reading: a record is known to be one, field by field, before anything else sees it."""

import hashlib
import json
from datetime import datetime
from functools import cache as once
from pathlib import Path
from typing import Annotated, Any, Literal

import msgspec
from msgspec import Meta, Struct

from measured_report.files.cache import Cache
from measured_report.files.files import RecordError, place_of, read_own_file
from measured_report.records.columns import UNPRINTABLE, text_problem
from measured_report.records.identity import Identity
from measured_report.records.record import SCHEMA, Record, Seal, check_record
from measured_report.records.traces import CASE, check_seals

BYTE_LIMIT = 32 << 20

Digest = Annotated[str, Meta(pattern=r"\A[0-9a-f]{64}\Z")]
FileName = Annotated[str, Meta(pattern=r"\A[A-Za-z0-9_][A-Za-z0-9_./-]*\Z", max_length=200)]
Version = Annotated[str, Meta(pattern=r"\A(missing|[0-9]+(\.[0-9]+)*[a-z0-9.]*(\+[a-z0-9.]+)?)\Z", max_length=64)]
Package = Literal["newton", "warp-lang", "mujoco-warp", "mujoco"]
Text = Annotated[str, Meta(max_length=400)]
Case = Annotated[str, Meta(pattern=rf"\A{CASE.pattern}\Z", max_length=200)]
Cell = bool | int | float | str | None


class _Identity(Struct, forbid_unknown_fields=True):
    code: Digest
    config: Digest
    packages: dict[Package, Version]
    profile: Literal["full", "quick"] = "full"
    files: dict[FileName, Digest] = {}


class _Machine(Struct):
    """What else was noted of a machine may be there as well."""

    device: Literal["cuda", "cpu"]
    gpu: Text | None
    driver: Text | None
    cpu: Text
    python: Text
    cores: Text | None = None
    system: Text | None = None


class _Measured(Struct):
    date: Text
    commit: Text | None
    command: Text
    seconds: Annotated[float, Meta(ge=0.0, le=1e8)]


class _Seal(Struct, forbid_unknown_fields=True):
    digest: Digest
    row_count: Annotated[int, Meta(ge=1, le=10_000_000)]


class _Record(Struct, forbid_unknown_fields=True):
    schema: int
    section: Text
    identity: _Identity
    machine: dict[Text, Text | int | float | bool | None]
    measured: dict[Text, Text | int | float | bool | None]
    units: dict[Text, Text]
    rows: list[dict[Text, Cell]]
    traces: dict[Case, _Seal] | None = None


def load_record(path: Path, cache: Cache | None = None) -> Record:
    """The record at ``path``, or RecordError, one line with its release and file, when it is damaged in any way.

    The traces that it seals are there and are the ones that were measured with it. A record from before traces were
    sealed says nothing of them, and is read without.

    Args:
        path: Where it lies.
        cache: Has records that were found whole before: one that holds the same is not checked again.
    """
    content = read_own_file(path, BYTE_LIMIT)
    entry, made_from = f"record.{'.'.join(path.parts[-3:])}", (_own_code(), hashlib.sha256(content).digest())
    record: Record | None = cache.get(entry, made_from) if cache else None
    if not record:
        record = _checked(content, path)
        if cache:
            cache.put(entry, made_from, record)
    check_seals(path, record)
    return record


@once
def _own_code() -> bytes:
    """What decides what is found whole, and how it is read."""
    names = ("reading.py", "record.py", "columns.py", "identity.py")
    return hashlib.sha256(b"".join(Path(__file__).with_name(name).read_bytes() for name in names)).digest()


def _checked(content: bytes, path: Path) -> Record:
    place = place_of(path)
    try:
        data = json.loads(content.decode("utf-8"), object_pairs_hook=_unique, parse_constant=_refuse)
        schema = data.get("schema") if isinstance(data, dict) else None
        if schema is not None and schema != SCHEMA:
            raise RecordError(f"{place} has schema {schema!r:.40}, not {SCHEMA}")
        known = msgspec.convert(data, _Record)
        msgspec.convert(known.machine, _Machine)
        date = msgspec.convert(known.measured, _Measured).date
        if datetime.fromisoformat(date).tzinfo is None:
            raise ValueError(f"the date {date} has no time zone")
    except (ValueError, RecursionError, msgspec.ValidationError) as error:
        raise RecordError(f"{place} is no whole record: {_line(error)}") from None
    if known.section != path.stem:
        raise RecordError(f"{place} is a record of {known.section!r}")
    for name, text in [*known.machine.items(), *known.measured.items()]:
        problem = text_problem(text) if isinstance(text, str) else ""
        if problem:
            raise RecordError(f"{place}: {name} {problem}")
    seals = known.traces
    record = Record(
        section=known.section,
        identity=Identity(**{name: getattr(known.identity, name) for name in _Identity.__struct_fields__}),
        machine=known.machine,
        measured=known.measured,
        units=known.units,
        rows=known.rows,
        traces=None if seals is None else {case: Seal(seal.digest, seal.row_count) for case, seal in seals.items()},
    )
    check_record(record, place)
    return record


def _unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """An object of JSON, in which each key stands once: of two, a reader would see either."""
    found = dict(pairs)
    if len(found) < len(pairs):
        keys = [key for key, _ in pairs]
        raise ValueError(f"{next(key for key in keys if keys.count(key) > 1)!r:.80} is there twice")
    return found


def _refuse(constant: str) -> None:
    raise ValueError(f"{constant} is no number")


def _line(error: Exception) -> str:
    """An error in one line, without characters that could do anything to whoever reads it."""
    text = UNPRINTABLE.sub("?", " ".join(str(error).split()))
    return f"{text:.300}" or type(error).__name__
