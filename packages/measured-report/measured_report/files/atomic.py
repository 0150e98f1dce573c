"""Files: read only as what they should be, and written whole, together and by one process at a time."""

import errno
import fcntl
import json
import os
import shutil
import stat
import sys
import tempfile
from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

from measured_report.files.errors import ReportError

WHOLE, NEW, ASIDE = ".whole", ".new", ".damaged"
"""How the folders of files end that wait to be put in place, that are still being written, and that are refused."""


class RecordError(ReportError):
    """A record or trace that can't be trusted; the message is one line that names its release and file."""


def short_path(path: Path) -> str:
    """The path of a record or a trace as messages have it: its edition's folder and its name."""
    return f"{path.parent.name}/{path.name}"


def is_own_file(path: Path) -> bool:
    """Whether a regular file lies at ``path``: no link, pipe or device."""
    with suppress(OSError):
        return stat.S_ISREG(path.lstat().st_mode)
    return False


def read_own_file(path: Path, byte_limit: int) -> bytes:
    """What the regular file at ``path`` holds; RecordError for a link, a pipe or a device, and for too much."""
    place = short_path(path)
    try:
        # A pipe that nobody writes to would keep us waiting.
        descriptor = os.open(path, os.O_RDONLY | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC)
        with os.fdopen(descriptor, "rb") as file:
            if not stat.S_ISREG(os.fstat(file.fileno()).st_mode):
                raise RecordError(f"{place} is no regular file")
            content = file.read(byte_limit + 1)
    except FileNotFoundError:
        raise RecordError(f"there is no {place}") from None
    except OSError as error:
        is_link = error.errno == errno.ELOOP
        reason = "is a link, not a file of its own" if is_link else f"can't be read: {error.strerror}"
        raise RecordError(f"{place} {reason}") from None
    if len(content) > byte_limit:
        raise RecordError(f"{place} has more than {byte_limit >> 20} MiB")
    return content


@contextmanager
def locked(folder: Path, *, alone: bool = True) -> Iterator[None]:
    """Hold ``folder`` alone, or with others that only read; whoever has to wait for it says so."""
    try:
        descriptor = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_CLOEXEC)
    except FileNotFoundError:
        yield
        return
    mode = fcntl.LOCK_EX if alone else fcntl.LOCK_SH
    try:
        try:
            fcntl.flock(descriptor, mode | fcntl.LOCK_NB)
        except BlockingIOError:
            print(f"waiting for another process that is at work in {folder.name}/", file=sys.stderr, flush=True)
            fcntl.flock(descriptor, mode)
        except OSError:
            pass  # a file system without locks: one process at a time is then up to its users
        yield
    finally:
        os.close(descriptor)


def put_record(record: Path, files: Mapping[str, bytes]) -> None:
    """Put a record and its traces, contents by file name, beside each other at ``record``: all of them, or none.

    They are written to a folder aside, and its new name says that they are whole. From then on a process that is
    killed has lost nothing: ``recover`` does what is left to do.
    """
    folder = record.parent
    folder.mkdir(parents=True, exist_ok=True)
    with locked(folder.parent):
        new, whole = (folder / f".{record.stem}{ending}" for ending in (NEW, WHOLE))
        for left in (new, whole):  # of a process that was killed: this takes the place of both
            remove(left)
        new.mkdir()
        try:
            for name, content in files.items():
                with (new / name).open("wb") as file:
                    file.write(content)
                    file.flush()
                    os.fsync(file.fileno())
        except BaseException:
            shutil.rmtree(new, ignore_errors=True)
            raise
        os.rename(new, whole)
        _put_in_place(whole)


def sync_below(folder: Path) -> None:
    """Have a folder and all that is below it on the disk, whatever happens to the machine then."""
    for path in (*folder.rglob("*"), folder):
        sync(path)


def sync(path: Path) -> None:
    """Have a file, or the names in a folder, on the disk."""
    descriptor = os.open(path, os.O_RDONLY | os.O_CLOEXEC)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


@contextmanager
def atomic_file(path: Path) -> Iterator[Path]:
    """A path to write to, which takes the place of ``path`` once the block has ended well."""
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


def recover(results: Path, load: Callable[[Path], Any]) -> list[str]:
    """Finish what processes that were killed have begun to put in place below ``results``, and remove the rest.

    Only what ``load`` finds to be a whole record, with its own traces and nothing else beside it, is put in place: what
    is not is set aside, and said, a line each.
    """
    said = []
    for folder in sorted({path.parent for ending in (WHOLE, NEW) for path in results.glob(f"*/.*{ending}")}):
        with locked(results), suppress(OSError):  # a copy that can only be read stays as it is
            for unfinished in folder.glob(f".*{NEW}"):
                remove(unfinished)
            for whole in folder.glob(f".*{WHOLE}"):
                try:
                    _refuse_other(whole, load)
                except RecordError as error:
                    aside = whole.with_suffix(ASIDE)
                    remove(aside)
                    os.rename(whole, aside)
                    said.append(f"damaged: {error}; it was not put in place, and is at {folder.name}/{aside.name}")
                else:
                    _put_in_place(whole)
    return said


def _refuse_other(whole: Path, load: Callable[[Path], Any]) -> None:
    """RecordError unless this folder is a record that was measured, with the traces that it seals."""
    place = short_path(whole)
    if whole.is_symlink() or not whole.is_dir():
        raise RecordError(f"{place} is no folder of its own")
    record = whole / _record_name(whole)
    traces = {f"{record.stem}.{case}.csv.gz" for case in load(record).traces or {}}
    if strange := {path.name for path in whole.iterdir()} - {record.name, *traces}:
        raise RecordError(f"{place} has {min(strange)!r:.80} in it, which is none of it")


def _record_name(whole: Path) -> str:
    return f"{whole.name[1 : -len(WHOLE)]}.json"


def _put_in_place(whole: Path) -> None:
    folder, name = whole.parent, _record_name(whole)
    record = folder / name
    cases = json.loads((whole / name).read_bytes()).get("traces")
    for path in folder.glob(f"{record.stem}.*.csv.gz") if cases is not None else ():
        if path.name[len(record.stem) + 1 : -len(".csv.gz")] not in cases:  # that of a case that is no more
            path.unlink()
    for path in sorted(whole.iterdir(), key=lambda path: path.name == name):  # the record goes last
        part = folder / f".{name}{NEW}"
        part.unlink(missing_ok=True)
        try:
            os.link(path, part)
        except OSError:  # of a file system without such links
            shutil.copyfile(path, part)
        os.replace(part, folder / path.name)
    # What waits stays whole until all of it is in place, so that it can be judged again.
    new = whole.with_suffix(NEW)
    os.rename(whole, new)
    shutil.rmtree(new)


def remove(path: Path) -> None:
    """Remove whatever is there: a folder, a file, or a link, but not what it leads to."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path, ignore_errors=True)
    else:
        path.unlink(missing_ok=True)


def refuse_unwritable(results: Path) -> None:
    """ReportError when nothing could be kept below ``results``: better said before measuring than after."""
    try:
        results.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryFile(dir=results) as probe:
            probe.write(b" ")
    except OSError as error:
        raise ReportError(f"{results}: {error.strerror}; what is measured could not be kept there") from None
