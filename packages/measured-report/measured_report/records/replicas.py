"""Replicas: what measuring an edition again gave, records without their traces, in one file that seals them."""

import gzip
import io
import math
import tarfile
import zlib
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from hashlib import sha256
from pathlib import Path

from measured_report.files.atomic import RecordError, read_file, short_path, sums
from measured_report.records.columns import column_of, is_cost
from measured_report.records.record import BYTE_LIMIT, Record, read_record, record_text

FOLDER = "replicas"  # beside the records of the edition that was measured again
SUMS = "SHA256SUMS"  # the file in it that seals all others
WHOLE = 0.9  # chosen: so large a share of the numbers is there again; runs at an edge may be lost
COPIED, NEAR = 0.9, 1e-6  # chosen: so large a share of a copy's numbers is so near; two measurements agree in up to 0.6
FAR, FAR_SHARE = 5.0, 0.05  # chosen: what is far outside is by more than so many ranges and such a share of a number
Records = Mapping[str, Record]
Key = tuple[str, str]


def archive_of(records: Iterable[Record]) -> bytes:
    """Pack records without their traces; the same records are the same bytes."""
    files = {f"{record.section}.json": record_text(replace(record, traces={})).encode() for record in records}
    content = io.BytesIO()
    with tarfile.open(fileobj=content, mode="w", format=tarfile.USTAR_FORMAT) as archive:
        for name, text in sorted({**files, SUMS: _sums(files)}.items()):
            about = tarfile.TarInfo(name)
            about.size = len(text)
            archive.addfile(about, io.BytesIO(text))
    return gzip.compress(content.getvalue(), mtime=0)


def _sums(files: Mapping[str, bytes]) -> bytes:
    return sums({name: sha256(text).hexdigest() for name, text in files.items()}).encode()


def read_replica(path: Path) -> Records:
    """Read a replica; RecordError, one line, when it is damaged in any way."""
    files = {}
    try:
        with gzip.open(io.BytesIO(read_file(path, BYTE_LIMIT))) as file:
            content = file.read(BYTE_LIMIT + 1)
        if len(content) > BYTE_LIMIT:
            raise RecordError(f"{short_path(path)} holds more than {BYTE_LIMIT >> 20} MiB")
        start = 0
        while any(header := content[start : start + tarfile.BLOCKSIZE]):
            # Header by header: a reader of archives believes what goes before one, as a sparse file's size.
            member = tarfile.TarInfo.frombuf(header, "utf-8", "strict")
            start += tarfile.BLOCKSIZE
            if member.type != tarfile.REGTYPE or not 0 <= member.size <= len(content) - start:
                raise RecordError(f"{short_path(path)} is no archive of plain files")
            files[member.name] = content[start : start + member.size]
            start += -(-member.size // tarfile.BLOCKSIZE) * tarfile.BLOCKSIZE
        if files.pop(SUMS, b"") != _sums(files) or not files:
            raise RecordError(f"{short_path(path)} is not as it was sealed")
    except (OSError, EOFError, ValueError, zlib.error, tarfile.TarError) as error:
        raise RecordError(f"{short_path(path)} is no whole replica: {error}") from None
    return {Path(name).stem: read_record(text, path.parent / name) for name, text in sorted(files.items())}


def measurements_beside(path: Path, read: Callable[[Path], Records]) -> list[Record]:
    """Return the record at ``path``, and those of the replicas beside it, as ``read``, that measured the same."""
    tracked = read_record(read_file(path, BYTE_LIMIT), path)
    replicas = (read(file).get(path.stem) for file in sorted((path.parent / FOLDER).glob("*.tgz")))
    alike = [record for record in replicas if record and not mismatch(tracked, record)]
    return [*filter(None, believed([tracked, *alike]))]


def mismatch(tracked: Record, replica: Record) -> str:
    """Say what keeps a record from being a replica of the tracked one; empty where nothing does."""
    if tracked.identity.packages != replica.identity.packages:
        return "other packages"
    sides = [(identity.config, identity.profile) for identity in (tracked.identity, replica.identity)]
    if sides[0] != sides[1] or tracked.codes.isdisjoint(replica.codes):
        return "other code"
    return "" if replica.number_count >= WHOLE * tracked.number_count else "not all of it could be measured there"


def is_copy(a: Record, b: Record) -> bool:
    """Tell whether two records are of one measurement: of one moment, or more alike than two of them ever are."""
    is_alike = a.measured["seconds"] == b.measured["seconds"] and list(a.rows) == list(b.rows)
    if a.started == b.started and (is_alike or a.card.casefold() == b.card.casefold()):
        return True
    mine, theirs = dict(_numbers(a)), dict(_numbers(b))
    repeats = "cpu" in (a.machine["device"], b.machine["device"])  # to the last bit, but for costs
    keys = [key for key in mine.keys() & theirs.keys() if is_cost(key[1]) or not repeats]
    same = [math.isclose(mine[key], theirs[key], rel_tol=NEAR) for key in keys]
    return bool(same) and sum(same) >= COPIED * len(same)


def believed(measured: Sequence[Record | None]) -> list[Record | None]:
    """Return the measurements of a section, what is tracked first, without replicas that are far from the others."""
    return [*measured[:1], *(record if record and not is_far(record, measured) else None for record in measured[1:])]


def is_far(record: Record, measured: Sequence[Record | None]) -> bool:
    """Tell whether most numbers of a column are far outside what two other measurements or more say."""
    sides = [dict(_numbers(other)) for other in measured if other and other is not record]
    is_outside: dict[str, list[bool]] = {}
    for key, cell in dict(_numbers(record)).items():  # of rows of one case the last
        numbers = [side[key] for side in sides if key in side]
        if len(numbers) > 1 and not is_cost(key[1]):
            low, high = min(numbers), max(numbers)
            reach = FAR * (high - low) + FAR_SHARE * max(abs(low), abs(high))
            is_outside.setdefault(key[1], []).append(not low - reach <= cell <= high + reach)
    return any(sum(column) > len(column) / 2 for column in is_outside.values())


def _numbers(record: Record) -> Iterator[tuple[Key, float]]:
    """Yield what was measured, by case and column."""
    for row in record.rows:
        for name, cell in row.items():
            if isinstance(cell, float) and cell and not column_of(name).is_exact:
                yield (row["case"], name), cell
