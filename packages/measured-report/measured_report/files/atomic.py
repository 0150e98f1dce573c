"""Files: each is read only if it is a regular file, and written whole. Folders are held by one process at a time."""

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
    """Names a record or trace that can't be trusted, in one line, with its release and file."""


def short_path(path: Path) -> str:
    """Write the path of a record or a trace as messages have it: its edition's folder and its name."""
    return UNPRINTABLE.sub("?", "/".join(path.parts[-2:]))


def read_file(path: Path, byte_limit: int) -> bytes:
    """Return the content of a regular file; RecordError for a link, a pipe or a device, and if it is too large."""
    name = short_path(path)
    try:
        info = path.lstat()
        if not stat.S_ISREG(info.st_mode):
            raise RecordError(f"{name} is no regular file")
        if info.st_size > byte_limit:
            raise RecordError(f"{name} has more than {byte_limit >> 20} MiB")
        return path.read_bytes()
    except FileNotFoundError:
        raise RecordError(f"there is no {name}") from None
    except OSError as error:
        raise RecordError(f"{name} can't be read: {error.strerror}") from None


def folder_fault(folder: Path) -> str:
    """Say why a folder cannot be read; empty if it can, or is not there."""
    try:
        if os.path.lexists(folder):
            for path in folder.iterdir():
                path.lstat()
    except OSError as error:
        return f"{short_path(folder)} can't be read: {error.strerror}"
    return ""


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
            text = f"waiting for another process that is at work in {folder.name}/"
            print(text, file=sys.stderr, flush=True)
            fcntl.flock(descriptor, mode)
        yield
    finally:
        os.close(descriptor)


def write_file(path: Path, content: str | bytes) -> None:
    """Write a file whole: whoever reads it meanwhile finds the former content."""
    with atomic_file(path) as temporary:
        temporary.write_bytes(content.encode() if isinstance(content, str) else content)


def write_files(contents: Mapping[Path, bytes]) -> None:
    """Write several files, each whole. The first is replaced last, and none unless all are on the disk."""
    with ExitStack() as stack:
        for path, content in contents.items():
            with stack.enter_context(atomic_file(path)).open("wb") as file:
                file.write(content)
                file.flush()
                os.fsync(file.fileno())


@contextmanager
def atomic_file(path: Path) -> Iterator[Path]:
    """Name a path to write to, which takes the place of ``path`` once the block has ended well."""
    path.parent.mkdir(parents=True, exist_ok=True)
    temporary = path.with_name(f".{path.name}.part")
    temporary.unlink(
        missing_ok=True
    )  # of a process that was killed, or a link that leads elsewhere
    try:
        yield temporary
        os.replace(temporary, path)
    finally:
        temporary.unlink(missing_ok=True)


@contextmanager
def staging_folder(folder: Path) -> Iterator[Path]:
    """Name a staging folder for what is to take the place of ``folder``; what is left there is removed."""
    with locked(folder.parent):
        fresh = folder.with_name(f".{folder.name}-new")
        shutil.rmtree(fresh, ignore_errors=True)
        try:
            yield fresh
        finally:
            shutil.rmtree(fresh, ignore_errors=True)


def sums(digests: Mapping[str, str]) -> str:
    """Write the digests of files, by name, as ``sha256sum --check`` reads them."""
    return "".join(f"{digest}  {name}\n" for name, digest in sorted(digests.items()))


def digests_below(folder: Path) -> dict[str, str]:
    """Digest the files below a folder, by their names there; a link, and what else is no file, has none."""
    digests = {}
    for path in (
        path for path in folder.rglob("*") if path.is_symlink() or not path.is_dir()
    ):
        is_file = stat.S_ISREG(path.lstat().st_mode)
        digests[path.relative_to(folder).as_posix()] = (
            sha256(path.read_bytes()).hexdigest() if is_file else ""
        )
    return digests


def put_in_place(folder: Path, fresh: Path) -> None:
    """Let ``fresh`` take the place of ``folder``, or of what that leads to; what was there is removed."""
    folder = folder.resolve()
    before = fresh.with_name(f"{fresh.name}-before")
    shutil.rmtree(before, ignore_errors=True)
    if folder.exists():
        os.rename(folder, before)
    os.rename(fresh, folder)
    shutil.rmtree(before, ignore_errors=True)
