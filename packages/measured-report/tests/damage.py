"""List ways to damage a record or a trace, by name.

Every reader must detect each of them.
"""

import ctypes
import gzip
import json
import os
import re
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from functools import reduce
from operator import getitem
from pathlib import Path
from typing import Any

from measured_report.records.record import sealed

Change = Callable[[dict], Any]


GONE = object()


def _with(*path: str | int, value: Any = GONE) -> Change:
    """Change the field at ``path``, or remove it if no value is given."""

    def change(data: dict) -> None:
        *way, last = path
        inner: Any = reduce(getitem, way, data)
        if value is GONE:
            del inner[last]
        else:
            inner[last] = value

    return change


NO_NUMBERS = (
    "6.36",
    True,
    [],
    {},
    float("nan"),
    float("inf"),
    1e308,
    -1e308,
    10**400,
    -1.0,
    None,
)
NO_TEXTS = (
    None,
    3,
    1.5,
    True,
    [],
    {},
    "",
    "\x00",
    "a\ue000b",
    "x" * 5000,
    "\u202etext",
    "a\uffff",
    "two\nlines",
)
NO_TEXTS += ("\u3164", "\u2800", "a" + "\u0301" * 390)
NO_MAPPINGS = (None, 3, "text", [], [1])
NO_DATES = (
    "soon",
    "2026-01-02",
    "2026-01-02t03:04:05z",
    *(f"{year}-01-02T03:04:05+00:00" for year in ("0001", "1999", "2099", "9999")),
)
VERSIONS = (
    "evil @ file:///tmp/evil.whl",
    "1.4.0; python_version>'3'",
    "1.4.0 --index-url http://x",
    "../1.4.0",
    "1.4.0\n",
)
VERSIONS += ("", 3, None, "$(touch x)", "1.4.0 ")

FIELDS: dict[str, Change] = {
    **{f"slip {value!r:.20}": _with("rows", 0, "slip_mm", value=value) for value in NO_NUMBERS},
    **{f"case {value!r:.20}": _with("rows", 0, "case", value=value) for value in NO_TEXTS},
    **{f"dropped {value!r:.20}": _with("rows", 0, "dropped", value=value) for value in ([], {}, 1, "\x1b[2J")},
    **{f"row {value!r:.20}": _with("rows", 0, value=value) for value in (*NO_MAPPINGS, {}, {"case": None})},
    **{f"rows {value!r:.20}": _with("rows", value=value) for value in (None, 3, "text", {}, [], [[]])},
    **{f"unit {value!r:.20}": _with("units", "slip_mm", value=value) for value in ("m", "1", "", None, 3, "mm ", [])},
    **{f"units {value!r:.20}": _with("units", value=value) for value in (*NO_MAPPINGS, {})},
    "unit of no column": _with("units", "drift_mm_s", value="mm/s"),
    **{f"seconds {value!r:.20}": _with("measured", "seconds", value=value) for value in (*NO_NUMBERS, "soon")},
    **{f"date {value!r:.20}": _with("measured", "date", value=value) for value in (*NO_TEXTS, *NO_DATES)},
    "ended before it began": _with("measured", "started", value="2026-01-02T03:04:06+00:00"),
    **{f"commit {value!r:.20}": _with("measured", "commit", value=value) for value in (3, [], "\x00", "x" * 5000)},
    **{f"command {value!r:.20}": _with("measured", "command", value=value) for value in (None, 3, [], "\x07", "a\nb")},
    **{f"measured {value!r:.20}": _with("measured", value=value) for value in (*NO_MAPPINGS, {})},
    **{f"device {value!r:.20}": _with("machine", "device", value=value) for value in (None, 3, "tpu", [], "")},
    **{f"gpu {value!r:.20}": _with("machine", "gpu", value=value) for value in (3, True, [], {}, "\ue000", "x" * 5000)},
    **{f"cpu {value!r:.20}": _with("machine", "cpu", value=value) for value in (None, 3, [], "\x00")},
    **{f"key {name!r:.20}": _with("machine", name, value="a") for name in ("\u202edriver", "a\u200fb", "a b", "")},
    **{f"machine {value!r:.20}": _with("machine", value=value) for value in (*NO_MAPPINGS, {})},
    **{f"newton {value!r:.20}": _with("identity", "packages", "newton", value=value) for value in VERSIONS},
    **{f"package {name}": _with("identity", "packages", name, value="1.0") for name in ("evil", "pip", "", "newton ")},
    **{f"packages {value!r:.20}": _with("identity", "packages", value=value) for value in (*NO_MAPPINGS, {"a": {}})},
    **{f"code {value!r:.20}": _with("identity", "code", value=value) for value in (None, 3, "", "abc", "g" * 64, [])},
    **{f"profile {value!r:.20}": _with("identity", "profile", value=value) for value in (None, "slow", 3, [])},
    **{f"files {value!r:.20}": _with("identity", "files", value=value) for value in (*NO_MAPPINGS, {"a": 1}, {"": ""})},
    "file elsewhere": _with("identity", "files", value={"a/../../b.py": "0" * 64}),
    **{f"identity {value!r:.20}": _with("identity", value=value) for value in (*NO_MAPPINGS, {})},
    **{f"schema {value!r:.20}": _with("schema", value=value) for value in (None, 0, 2, "1", True, [], 10**400)},
    **{f"section {value!r:.20}": _with("section", value=value) for value in (*NO_TEXTS, "other", "../toy")},
    **{f"traces {value!r:.20}": _with("traces", value=value) for value in (3, "text", [], [1])},
    **{f"seal {value!r:.20}": _with("traces", "stiff", value=value) for value in (*NO_MAPPINGS, {})},
    **{f"digest {value!r:.20}": _with("traces", "stiff", "digest", value=value) for value in (None, 3, "", "0" * 64)},
    **{f"row count {value!r:.20}": _with("traces", "stiff", "row_count", value=value) for value in (None, 0, "2", 1.5)},
    "seal of no trace": _with("traces", "soft", value={"digest": "0" * 64, "row_count": 2}),
    "seal of a place": _with("traces", "../soft", value={"digest": "0" * 64, "row_count": 2}),
    "unknown field": _with("more", value=1),
    "unknown identity": _with("identity", "more", value=1),
    "column of no name": _with("rows", 0, "Slip mm", value="a"),
    "number without unit": _with("rows", 0, "drift_mm_s", value=1.0),
    "text in one row": _with("rows", 1, "dropped", value="no"),
    **{f"no {field}": _with(field) for field in ("schema", "section", "identity", "machine", "measured", "units")},
    **{f"no {field} of identity": _with("identity", field) for field in ("code", "config", "packages")},
    **{f"no {field} of measured": _with("measured", field) for field in ("date", "seconds", "command", "commit")},
    **{f"no {field} of machine": _with("machine", field) for field in ("device", "cpu", "gpu")},
}  # fmt: skip
"""Changes of a record's fields, by name."""

TEXTS: dict[str, Callable[[str], str | bytes]] = {
    "nothing": lambda text: "",
    "blank": lambda text: " \n",
    "list": lambda text: "[]",
    "null": lambda text: "null",
    "number": lambda text: "3",
    "text": lambda text: '"record"',
    "half": lambda text: text[: len(text) // 2],
    "without its end": lambda text: text[:-40],
    "twice": lambda text: text + text,
    "comma": lambda text: text.replace("]", ",]"),
    "1e999": lambda text: text.replace("6.3617", "1e999"),
    "a key twice": lambda text: text.replace(
        '"slip_mm":6.3617', '"slip_mm":6.3617,"slip_mm":0.1'
    ),
    "a section twice": lambda text: text.replace(
        '"section"', '"section": "toy", "section"', 1
    ),
    "units twice": lambda text: text.replace('"units"', '"units": {}, "units"', 1),
    "another script": lambda text: text.encode("utf-16"),
    "latin": lambda text: text.replace("toy", "t\xf6y").encode("latin-1"),
    "bytes": lambda text: bytes(range(256)) * 40,
    "zeros": lambda text: bytes(len(text)),
    "deep": lambda text: "[" * 100_000,
    "conflict": lambda text: text.replace(
        '"rows"', '<<<<<<< HEAD\n"rows"\n=======\n>>>>>>> other\n"rows"'
    ),
}
"""Changes of a record's text, by name."""


def _packed(text: str) -> bytes:
    return gzip.compress(text.encode())


TRACES: dict[str, Callable[[bytes], bytes]] = {
    "nothing": lambda content: b"",
    "half": lambda content: content[: len(content) // 2],
    "without its end": lambda content: content[:-4],
    "head": lambda content: content[:10],
    "not packed": gzip.decompress,
    "twice": lambda content: content * 2,
    "something behind": lambda content: content + b"more",
    "one bit": lambda content: content[:-5] + bytes([content[-5] ^ 1]) + content[-4:],
    "header alone": lambda content: _packed("time_s,x_mm\n"),
    "empty": lambda content: _packed(""),
    "column missing": lambda content: _packed("time_s,x_mm\n0\n1\n"),
    "column more": lambda content: _packed("time_s,x_mm\n0,1,2\n"),
    "column twice": lambda content: _packed("time_s,time_s\n0,1\n"),
    "many columns": lambda content: _packed(
        ",".join(f"c{n}" for n in range(2000)) + "\n" + "0," * 1999 + "0\n"
    ),
    "no columns": lambda content: _packed("0.0,0.0\n1.0,0.3\n"),
    "text": lambda content: _packed("time_s,x_mm\n0,a\n1,0.3\n"),
    "not a number": lambda content: _packed("time_s,x_mm\n0,nan\n1,0.3\n"),
    "infinite": lambda content: _packed("time_s,x_mm\n0,inf\n1,0.3\n"),
    "huge": lambda content: _packed("time_s,x_mm\n0,1e300\n1,0.3\n"),
    "backwards": lambda content: _packed("time_s,x_mm\n1,0\n0,0.3\n"),
    "negative time": lambda content: _packed("time_s,x_mm\n-1,0\n0,0.3\n"),
    "script": lambda content: _packed("time_s,x_mm\n0,<script>\n"),
    "private": lambda content: _packed("time_s,name\n0,\ue000\n"),
    "bytes": lambda content: gzip.compress(bytes(range(256))),
    "open quote": lambda content: _packed('time_s,x_mm\n0,"1\n'),
}
"""Changes of a trace's content, by name.

The seal of its record detects each of them, and so does the trace itself.
"""


PLACES: Mapping[str, Callable[[Path], object]] = {
    "a link to a password file": lambda path: path.symlink_to("/etc/passwd"),
    "a link to itself": lambda path: path.symlink_to(path.name),
    "a pipe": os.mkfifo,
    "a folder": Path.mkdir,
    "a terabyte": lambda path: (path.touch(), os.truncate(path, 1 << 40)),
}
"""Objects that may replace a record or a trace, by name."""


def unsealed(text: str) -> str:
    """Return the text of a record without its seal."""
    return re.sub(',\n "seal": "[0-9a-f]{64}"', "", text)


def resealed(text: str) -> str:
    """Return the text of a record, sealed again if it ends with a seal."""
    whole = text.rstrip()
    return sealed(whole.removesuffix("}")) if whole.endswith("}") else text


def damage(path: Path, name: str) -> None:
    """Damage the record or trace at ``path`` in the way ``name``; a record is sealed
    again.
    """
    kind, _, way = name.partition(": ")
    if kind == "field":
        data = json.loads(unsealed(path.read_text(encoding="utf-8")))
        FIELDS[way](data)
        path.write_text(resealed(json.dumps(data)), encoding="utf-8")
    elif kind == "text":
        changed = TEXTS[way](unsealed(path.read_text(encoding="utf-8")))
        if isinstance(changed, str):
            changed = resealed(changed).encode()
        path.write_bytes(changed)
    elif kind == "trace":
        path.write_bytes(TRACES[way](path.read_bytes()))
    else:
        path.unlink()
        PLACES[way](path)


def _named(**kinds: Mapping[str, Any]) -> list[str]:
    return [f"{kind}: {way}" for kind, ways in kinds.items() for way in ways]


RECORD_WAYS = _named(field=FIELDS, text=TEXTS, place=PLACES)
TRACE_WAYS = _named(trace=TRACES, place=PLACES)


class _Header(ctypes.Structure):
    _fields_ = (("version", ctypes.c_uint32), ("process", ctypes.c_int))


class _Sets(ctypes.Structure):
    _fields_ = tuple(
        (name, ctypes.c_uint32) for name in ("effective", "permitted", "inheritable")
    )


@contextmanager
def as_a_plain_user() -> Iterator[None]:
    """Remove root's right to read files whose mode forbids it; other users do not have
    this right.
    """
    libc = ctypes.CDLL(None)
    header = _Header(0x20080522, 0)  # from linux/capability.h: its third version
    sets = (_Sets * 2)()
    libc.capget(ctypes.byref(header), sets)
    before = sets[0].effective
    sets[0].effective &= ~0b110  # CAP_DAC_OVERRIDE and CAP_DAC_READ_SEARCH
    libc.capset(ctypes.byref(header), sets)
    try:
        yield
    finally:
        sets[0].effective = before
        libc.capset(ctypes.byref(header), sets)
