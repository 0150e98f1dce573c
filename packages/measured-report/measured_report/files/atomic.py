"""Files: read only as what they should be, and written whole; folders are held by one process at a time."""

import fcntl
import os
import stat
import sys
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from pathlib import Path

from measured_report.files.errors import ReportError


class RecordError(ReportError):
    """Names a record or trace that can't be trusted, in one line, with its release and file."""


def short_path(path: Path) -> str:
    """Write the path of a record or a trace as messages have it: its edition's folder and its name."""
    return f"{path.parent.name}/{path.name}"


def read_own_file(path: Path, byte_limit: int) -> bytes:
    """Read the regular file at ``path``; RecordError for a link, a pipe or a device, and for too much."""
    place = short_path(path)
    try:
        about = path.lstat()
        if not stat.S_ISREG(about.st_mode):
            raise RecordError(f"{place} is no regular file")
        if about.st_size > byte_limit:
            raise RecordError(f"{place} has more than {byte_limit >> 20} MiB")
        return path.read_bytes()
    except FileNotFoundError:
        raise RecordError(f"there is no {place}") from None
    except OSError as error:
        raise RecordError(f"{place} can't be read: {error.strerror}") from None


@contextmanager
def locked(folder: Path, *, alone: bool = True) -> Iterator[None]:
    """Hold ``folder``, if it is there, alone or with others that only read; whoever has to wait for it says so."""
    if not folder.is_dir():
        yield
        return
    descriptor = os.open(folder, os.O_RDONLY)
    mode = fcntl.LOCK_EX if alone else fcntl.LOCK_SH
    try:
        try:
            fcntl.flock(descriptor, mode | fcntl.LOCK_NB)
        except BlockingIOError:
            print(f"waiting for another process that is at work in {folder.name}/", file=sys.stderr, flush=True)
            fcntl.flock(descriptor, mode)
        yield
    finally:
        os.close(descriptor)


def put_record(record: Path, files: Mapping[str, bytes]) -> None:
    """Put a record and its traces, contents by file name, beside each other at ``record``, once all are written."""
    with ExitStack() as stack:
        for name, content in reversed([*files.items()]):  # the record, which is the last of them, is put in place last
            stack.enter_context(atomic_file(record.with_name(name))).write_bytes(content)


@contextmanager
def atomic_file(path: Path) -> Iterator[Path]:
    """Name a path to write to, which takes the place of ``path`` once the block has ended well."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{path.name}.part")
    temporary.unlink(missing_ok=True)  # of a process that was killed, or a link that leads elsewhere
    try:
        yield temporary
        with temporary.open("rb") as file:
            os.fsync(file.fileno())
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)
