"""Read only regular files, replace files in one step, and lock folders."""

import fcntl
import os
import shutil
import stat
import sys
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from hashlib import sha256
from pathlib import Path

from measured_report.files.errors import UNPRINTABLE, ReportError


class RecordError(ReportError):
    """Signal a damaged record or trace; the message names its release and file."""


def short_path(path: Path) -> str:
    """Return the path of a record or trace for messages: its folder and its name."""
    return UNPRINTABLE.sub("?", "/".join(path.parts[-2:]))


def read_file(path: Path, byte_limit: int) -> bytes:
    """Return the content of a regular file.

    Raise RecordError for a link, a pipe, a device or a file that is too large.
    """
    name = short_path(path)
    try:
        info = path.lstat()
        if not stat.S_ISREG(info.st_mode):
            raise RecordError(f"{name} is not a regular file")
        if info.st_size > byte_limit:
            raise RecordError(f"{name} is larger than {byte_limit >> 20} MiB")
        return path.read_bytes()
    except FileNotFoundError:
        raise RecordError(f"{name} does not exist") from None
    except OSError as error:
        raise RecordError(f"{name} cannot be read: {error.strerror}") from None


def folder_fault(folder: Path) -> str:
    """Return the reason why a folder cannot be read.

    It is empty if the folder can be read or does not exist.
    """
    try:
        for path in folder.iterdir():
            path.lstat()
    except OSError as error:
        if os.path.lexists(folder) or not isinstance(error, FileNotFoundError):
            return f"{short_path(folder)} cannot be read: {error.strerror}"
    return ""


def files_in(folder: Path, pattern: str) -> list[Path]:
    """Return the matching files of a folder; none if it cannot be read.

    ``folder_fault`` returns the reason.
    """
    try:
        return sorted(folder.glob(pattern))
    except OSError:
        return []


def read_text(path: Path) -> str:
    """Return the text of a file of a report; raise ReportError if it cannot be read."""
    name = UNPRINTABLE.sub("?", path.name)
    try:
        # Opening a pipe would wait for somebody to write to it.
        if not stat.S_ISREG(path.stat().st_mode):
            raise ReportError(f"{name} is not a regular file")
        return path.read_text(encoding="utf-8-sig")
    except OSError as error:
        raise ReportError(f"{name} cannot be read: {error.strerror}") from None
    except UnicodeDecodeError as error:
        raise ReportError(f"{name} is not UTF-8 text: {error}") from None


def remove(path: Path) -> None:
    """Remove a file, a link, a pipe or a folder with its contents, if it exists."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path, ignore_errors=True)
    else:
        path.unlink(missing_ok=True)


@contextmanager
def locked(folder: Path, *, alone: bool = True) -> Iterator[None]:
    """Lock ``folder`` if it exists, exclusively or shared with other readers.

    Print a message if another process holds the lock.
    """
    if not folder.is_dir():
        yield
        return
    descriptor = os.open(folder, os.O_RDONLY)
    mode = fcntl.LOCK_EX if alone else fcntl.LOCK_SH
    try:
        try:
            fcntl.flock(descriptor, mode | fcntl.LOCK_NB)
        except BlockingIOError:
            message = f"waiting for another process that uses {folder.name}/"
            print(message, file=sys.stderr, flush=True)
            fcntl.flock(descriptor, mode)
        yield
    finally:
        os.close(descriptor)


def write_file(path: Path, content: str | bytes) -> None:
    """Write a file in one step: other readers see the old or the new content."""
    with atomic_file(path) as temporary:
        temporary.write_bytes(content.encode() if isinstance(content, str) else content)


def write_files(contents: Mapping[Path, bytes]) -> None:
    """Write several files, each in one step.

    The first file is replaced last, so it can name the others: if it exists, they exist
    too. No file is replaced before all are on the disk.
    """
    with ExitStack() as stack:
        for path, content in contents.items():
            with stack.enter_context(atomic_file(path)).open("wb") as file:
                file.write(content)
                file.flush()
                os.fsync(file.fileno())


@contextmanager
def atomic_file(path: Path) -> Iterator[Path]:
    """Yield a path to write to, which replaces ``path`` if the block succeeds."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{path.name}.part")
    # A killed process may have left this file. It may also be a link to another place.
    remove(temporary)
    try:
        yield temporary
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


@contextmanager
def staging_folder(folder: Path) -> Iterator[Path]:
    """Yield a folder in which a replacement of ``folder`` can be built.

    The folder is removed at the end.
    """
    with locked(folder.parent):
        fresh = folder.with_name(f".{folder.name}-new")
        remove(fresh)
        try:
            yield fresh
        finally:
            remove(fresh)


def sums(digests: Mapping[str, str]) -> str:
    """Return the digests of files by name, in the format of ``sha256sum --check``."""
    return "".join(f"{digest}  {name}\n" for name, digest in sorted(digests.items()))


def digests_below(folder: Path) -> dict[str, str]:
    """Return the digest of each file in a folder and its subfolders, by relative name.

    Links and other entries that are not files have an empty digest.
    """
    digests = {}
    # A link to a folder counts as a file, because its target may lie elsewhere.
    for path in (
        path for path in folder.rglob("*") if path.is_symlink() or not path.is_dir()
    ):
        is_file = stat.S_ISREG(path.lstat().st_mode)
        digests[path.relative_to(folder).as_posix()] = (
            sha256(path.read_bytes()).hexdigest() if is_file else ""
        )
    return digests


def put_in_place(folder: Path, fresh: Path) -> None:
    """Replace ``folder``, or the folder that it links to, with ``fresh``."""
    folder = folder.resolve()
    before = fresh.with_name(f"{fresh.name}-before")
    remove(before)
    if folder.exists():
        os.rename(folder, before)
    os.rename(fresh, folder)
    remove(before)
