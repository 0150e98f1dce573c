"""Reading: a record is known to be one, field by field, before anything else sees it."""

import json
from dataclasses import fields
from datetime import datetime
from pathlib import Path
from typing import Annotated, Any, Literal

import msgspec
from msgspec import Meta, Struct

from measured_report.files.atomic import RecordError, read_own_file, short_path
from measured_report.files.config import config
from measured_report.records.columns import UNPRINTABLE, name_problem
from measured_report.records.identity import Identity
from measured_report.records.record import SCHEMA, Record, Seal, Text, check_record
from measured_report.records.traces import sealed_content, trace_path

BYTE_LIMIT = 32 << 20


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
    started: Text = ""
    ended: Text = ""


def load_record(path: Path) -> Record:
    """Read the record at ``path``; RecordError, one line with its release and file, when it is damaged in any way.

    The traces that it seals are there and are the ones that were measured with it.
    """
    record = _checked(read_own_file(path, BYTE_LIMIT), path)
    for case, seal in (record.traces or {}).items():
        sealed_content(trace_path(path, case), seal)
    return record


def _checked(content: bytes, path: Path) -> Record:
    place = short_path(path)
    try:
        data = json.loads(content.decode("utf-8"), object_pairs_hook=_unique, parse_constant=_refuse)
        schema = data.pop("schema", None) if isinstance(data, dict) else SCHEMA
        if type(schema) is not int or schema != SCHEMA:
            raise RecordError(f"{place} has schema {schema!r:.40}, not {SCHEMA}")
        record = msgspec.convert(data, Record)
        seals = (data.get("traces") or {}).values()
        kinds = [(data, Record), (data["identity"], Identity), *((seal, Seal) for seal in seals)]
        known = [(part, {each.name for each in fields(kind)}) for part, kind in kinds]
        for part, names in [*known, (data["identity"]["packages"], {*config().packages})]:
            if others := part.keys() - names:
                raise ValueError(f"nothing here is called {min(others)!r:.80}")
        msgspec.convert(record.machine, _Machine)
        measured = msgspec.convert(record.measured, _Measured)
        for date in filter(None, (measured.date, measured.started, measured.ended)):
            if datetime.fromisoformat(date).tzinfo is None:
                raise ValueError(f"the date {date} has no time zone")
        _ = record.span  # which may begin before there are dates
    except (ValueError, OverflowError, RecursionError, msgspec.ValidationError) as error:
        # In one line, without characters that could do anything to whoever reads it.
        said = UNPRINTABLE.sub("?", " ".join(str(error).split())) or type(error).__name__
        raise RecordError(f"{place} is no whole record: {said:.300}") from None
    if record.section != path.stem:
        raise RecordError(f"{place} is a record of {record.section!r}")
    for name, value in [*record.machine.items(), *record.measured.items()]:
        if problem := name_problem(value):
            raise RecordError(f"{place}: {name} {problem}")
    check_record(record, place)
    return record


def _unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    """An object of JSON, in which each key stands once: of two, a reader would see either."""
    found = dict(pairs)
    if len(found) < len(pairs):
        keys = [key for key, _ in pairs]
        raise ValueError(f"{max(keys, key=keys.count)!r:.80} is there twice")
    return found


def _refuse(constant: str) -> None:
    raise ValueError(f"{constant} is no number")
