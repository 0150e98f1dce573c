"""Replicas: what measuring an edition again gave, records without their traces, in one file that seals them."""

import gzip
import io
import tarfile
import zlib
from collections.abc import Iterable, Mapping
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
    files = {}
    for record in records:
        whole = record_text(replace(record, traces={}))
        files[f"{record.section}.json"] = whole.encode()
    files[SUMS] = _sums(files)
    content = io.BytesIO()
    with tarfile.open(
        fileobj=content, mode="w", format=tarfile.USTAR_FORMAT
    ) as archive:
        for name, text in sorted(files.items()):
            member = tarfile.TarInfo(name)
            member.size = len(text)
            archive.addfile(member, io.BytesIO(text))
    return gzip.compress(content.getvalue(), mtime=0)


def _sums(files: Mapping[str, bytes]) -> bytes:
    digests = {name: sha256(text).hexdigest() for name, text in files.items()}
    return sums(digests).encode()


def read_replica(path: Path) -> Records:
    """Return the records in a replica; raise RecordError when it is damaged in any way."""
    files = {}
    try:
        with gzip.open(io.BytesIO(read_file(path, BYTE_LIMIT))) as file:
            content = file.read(BYTE_LIMIT + 1)
        if len(content) > BYTE_LIMIT:
            raise RecordError(
                f"{short_path(path)} holds more than {BYTE_LIMIT >> 20} MiB"
            )
        start = 0
        # A reader of archives would believe a header that makes files larger than they are.
        while any(header := content[start : start + tarfile.BLOCKSIZE]):
            member = tarfile.TarInfo.frombuf(header, "utf-8", "strict")
            start += tarfile.BLOCKSIZE
            is_inside = 0 <= member.size <= len(content) - start
            if member.type != tarfile.REGTYPE or not is_inside:
                raise RecordError(f"{short_path(path)} is no archive of plain files")
            files[member.name] = content[start : start + member.size]
            start += -(-member.size // tarfile.BLOCKSIZE) * tarfile.BLOCKSIZE
    except (OSError, EOFError, ValueError, zlib.error, tarfile.TarError) as error:
        raise RecordError(f"{short_path(path)} is no whole replica: {error}") from None
    if files.pop(SUMS, b"") != _sums(files) or not files:
        raise RecordError(f"{short_path(path)} is not as it was sealed")
    return {
        Path(name).stem: read_record(text, path.parent / name)
        for name, text in sorted(files.items())
    }


def mismatch(tracked: Record, replica: Record) -> str:
    """Say what keeps a record from being a replica of the tracked one; empty if nothing does."""
    old, new = tracked.identity, replica.identity
    if old.packages != new.packages:
        return "other packages"
    is_alike = (old.config, old.profile) == (new.config, new.profile)
    if not is_alike or tracked.codes.isdisjoint(replica.codes):
        return "other code"
    if replica.number_count < WHOLE * tracked.number_count:
        return "not all of it could be measured there"
    return ""
