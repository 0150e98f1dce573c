"""Read and write replicas: the records of a repeated measurement of an edition.

A replica is a compressed archive of records without traces, and of their checksums.
"""

import gzip
import io
import tarfile
import zlib
from collections.abc import Iterable, Mapping
from dataclasses import replace
from hashlib import sha256
from pathlib import Path

from measured_report.files.atomic import RecordError, read_file, short_path, sums
from measured_report.records.identity import package_changes
from measured_report.records.record import BYTE_LIMIT, Record, read_record, record_text

FOLDER = "replicas"  # beside the records of the edition that was measured again
SUMS = "SHA256SUMS"  # the file in a replica with the checksums of all others
# A chosen value: the smallest share of the record's numbers that a replica must have.
# Runs near the edge of stability may fail in a replica.
LEAST_SHARE = 0.9
Records = Mapping[str, Record]


def archive_of(records: Iterable[Record]) -> bytes:
    """Return an archive of records without traces; equal records give equal bytes."""
    files = {}
    for record in records:
        text = record_text(replace(record, traces={}))
        files[f"{record.section}.json"] = text.encode()
    files[SUMS] = _sums(files)
    content = io.BytesIO()
    with tarfile.open(
        fileobj=content, mode="w", format=tarfile.USTAR_FORMAT
    ) as archive:
        for name, file_content in sorted(files.items()):
            member = tarfile.TarInfo(name)
            member.size = len(file_content)
            archive.addfile(member, io.BytesIO(file_content))
    return gzip.compress(content.getvalue(), mtime=0)


def _sums(files: Mapping[str, bytes]) -> bytes:
    digests = {name: sha256(content).hexdigest() for name, content in files.items()}
    return sums(digests).encode()


def read_replica(path: Path) -> Records:
    """Return a replica's records by section; raise RecordError if it is damaged."""
    files = {}
    try:
        with gzip.open(io.BytesIO(read_file(path, BYTE_LIMIT))) as file:
            content = file.read(BYTE_LIMIT + 1)
        if len(content) > BYTE_LIMIT:
            raise RecordError(
                f"{short_path(path)} contains more than {BYTE_LIMIT >> 20} MiB"
            )
        start = 0
        # The headers are read here, because tarfile trusts a size beyond the archive's
        # end.
        while any(header := content[start : start + tarfile.BLOCKSIZE]):
            member = tarfile.TarInfo.frombuf(header, "utf-8", "strict")
            start += tarfile.BLOCKSIZE
            is_inside = 0 <= member.size <= len(content) - start
            if member.type != tarfile.REGTYPE or not is_inside:
                raise RecordError(
                    f"{short_path(path)} is not an archive of regular files"
                )
            files[member.name] = content[start : start + member.size]
            # Each file fills whole blocks, so its size is rounded up.
            start += -(-member.size // tarfile.BLOCKSIZE) * tarfile.BLOCKSIZE
    except (OSError, EOFError, ValueError, zlib.error, tarfile.TarError) as error:
        raise RecordError(
            f"{short_path(path)} is not a valid replica: {error}"
        ) from None
    if files.pop(SUMS, b"") != _sums(files) or not files:
        raise RecordError(f"{short_path(path)} was changed after it was sealed")
    return {
        Path(name).stem: read_record(file_content, path.parent / name)
        for name, file_content in sorted(files.items())
    }


def mismatch(tracked: Record, replica: Record) -> str:
    """Return why a record is not a replica of the tracked one, or an empty string."""
    old, new = tracked.identity, replica.identity
    if package_changes(old.packages, new.packages):
        return "other packages"
    is_alike = (old.config, old.profile) == (new.config, new.profile)
    if not is_alike or tracked.codes.isdisjoint(replica.codes):
        return "other code"
    if replica.number_count < LEAST_SHARE * tracked.number_count:
        return "too many of its numbers are missing"
    return ""
