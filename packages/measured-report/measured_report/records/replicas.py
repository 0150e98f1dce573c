"""Replicas: what measuring an edition again gave, records without their traces, in one file that seals them."""

import gzip
import io
import tarfile
import zlib
from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace
from hashlib import sha256
from pathlib import Path

from measured_report.files.atomic import RecordError, read_file, short_path, sums
from measured_report.records.record import BYTE_LIMIT, Record, read_record, record_text

FOLDER = "replicas"  # beside the records of the edition that was measured again
SUMS = "SHA256SUMS"  # the file in it that seals all others
WHOLE = 0.9  # chosen: so large a share of the numbers is there again; runs at an edge may be lost
Records = Mapping[str, Record]


def archive_of(records: Iterable[Record]) -> bytes:
    """Pack records without their traces; the same records are the same bytes."""
    files = {
        f"{record.section}.json": record_text(replace(record, traces={})).encode()
        for record in records
    }
    content = io.BytesIO()
    with tarfile.open(
        fileobj=content, mode="w", format=tarfile.USTAR_FORMAT
    ) as archive:
        for name, text in sorted({**files, SUMS: _sums(files)}.items()):
            about = tarfile.TarInfo(name)
            about.size = len(text)
            archive.addfile(about, io.BytesIO(text))
    return gzip.compress(content.getvalue(), mtime=0)


def _sums(files: Mapping[str, bytes]) -> bytes:
    return sums(
        {name: sha256(text).hexdigest() for name, text in files.items()}
    ).encode()


def read_replica(path: Path) -> Records:
    """Read a replica; RecordError, one line, when it is damaged in any way."""
    files = {}
    try:
        with gzip.open(io.BytesIO(read_file(path, BYTE_LIMIT))) as file:
            content = file.read(BYTE_LIMIT + 1)
        if len(content) > BYTE_LIMIT:
            raise RecordError(
                f"{short_path(path)} holds more than {BYTE_LIMIT >> 20} MiB"
            )
        start = 0
        while any(header := content[start : start + tarfile.BLOCKSIZE]):
            # Header by header: a reader of archives believes what goes before one, as a sparse file's size.
            member = tarfile.TarInfo.frombuf(header, "utf-8", "strict")
            start += tarfile.BLOCKSIZE
            if (
                member.type != tarfile.REGTYPE
                or not 0 <= member.size <= len(content) - start
            ):
                raise RecordError(f"{short_path(path)} is no archive of plain files")
            files[member.name] = content[start : start + member.size]
            start += -(-member.size // tarfile.BLOCKSIZE) * tarfile.BLOCKSIZE
        if files.pop(SUMS, b"") != _sums(files) or not files:
            raise RecordError(f"{short_path(path)} is not as it was sealed")
    except (OSError, EOFError, ValueError, zlib.error, tarfile.TarError) as error:
        raise RecordError(f"{short_path(path)} is no whole replica: {error}") from None
    return {
        Path(name).stem: read_record(text, path.parent / name)
        for name, text in sorted(files.items())
    }


def measurements_beside(path: Path, read: Callable[[Path], Records]) -> list[Record]:
    """Return the record at ``path``, and those of the replicas beside it, as ``read``, that measured the same."""
    tracked = read_record(read_file(path, BYTE_LIMIT), path)
    replicas = (
        read(file).get(path.stem)
        for file in sorted((path.parent / FOLDER).glob("*.tgz"))
    )
    alike = [record for record in replicas if record and not mismatch(tracked, record)]
    return [tracked, *alike]


def mismatch(tracked: Record, replica: Record) -> str:
    """Say what keeps a record from being a replica of the tracked one; empty where nothing does."""
    if tracked.identity.packages != replica.identity.packages:
        return "other packages"
    sides = [
        (identity.config, identity.profile)
        for identity in (tracked.identity, replica.identity)
    ]
    if sides[0] != sides[1] or tracked.codes.isdisjoint(replica.codes):
        return "other code"
    return (
        ""
        if replica.number_count >= WHOLE * tracked.number_count
        else "not all of it could be measured there"
    )
