"""Placing: a folder is made aside, by one process at a time, and takes the place of another in one step."""

import ctypes
import errno
import filecmp
import os
import secrets
import shutil
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path

from report.records.files import is_own_file, locked

AT_FDCWD, RENAME_EXCHANGE = -100, 2
"""From linux/fcntl.h and linux/fs.h."""


@contextmanager
def aside(folder: Path) -> Iterator[Path]:
    """A name beside ``folder`` for what is to take its place: whoever has it is alone with ``folder``.

    What is there afterwards is removed, as is what processes that were killed have left.
    """
    with locked(folder.parent):
        beginning = f".{folder.name}-"
        for left in folder.parent.glob(f"{beginning}*"):
            remove(left)
        fresh = folder.with_name(f"{beginning}{secrets.token_hex(4)}")
        try:
            yield fresh
        finally:
            remove(fresh)


def replace(folder: Path, fresh: Path) -> None:
    """Let ``fresh`` take the place of ``folder``; what was there is at ``fresh`` afterwards.

    Files that are the same stay those that were there. A folder that can't be moved, as one that is mounted, gets the
    contents, its pages last.
    """
    for path in fresh.rglob("*"):
        there = folder / path.relative_to(fresh)
        if path.is_file() and _is_same(path, there):
            part = path.with_name(f".{path.name}.part")
            with suppress(OSError):  # of a file system without such links, or of another one
                os.link(there, part)
                os.replace(part, path)
    if not folder.exists():
        os.rename(fresh, folder)
    elif not _exchange(folder, fresh):
        _move_into(folder, fresh)


def _exchange(one: Path, other: Path) -> bool:
    """Whether two folders have changed places, between which there is no moment without one."""
    renameat2 = getattr(ctypes.CDLL(None, use_errno=True), "renameat2", None)
    if not renameat2 or one.is_symlink():
        return False
    if renameat2(AT_FDCWD, os.fsencode(one), AT_FDCWD, os.fsencode(other), RENAME_EXCHANGE) == 0:
        return True
    number = ctypes.get_errno()
    if number in (errno.EBUSY, errno.EXDEV, errno.EINVAL, errno.ENOSYS):
        return False
    raise OSError(number, os.strerror(number), str(one))


def _move_into(folder: Path, fresh: Path) -> None:
    """The contents of ``fresh`` into ``folder``, and what else is there out of it."""
    files = sorted((path for path in fresh.rglob("*") if path.is_file()), key=lambda path: path.suffix == ".html")
    for path in files:
        place = folder / path.relative_to(fresh)
        if _is_same(path, place):
            continue
        if place.is_dir() and not place.is_symlink():
            shutil.rmtree(place)
        place.parent.mkdir(parents=True, exist_ok=True)
        part = place.with_name(f".{place.name}.part")
        shutil.copyfile(path, part)
        os.replace(part, place)
    kept = {path.relative_to(fresh) for path in files}
    for path in sorted(folder.rglob("*"), reverse=True):
        if path.is_dir() and not path.is_symlink():
            if not any(path.iterdir()):
                path.rmdir()
        elif path.relative_to(folder) not in kept:
            path.unlink()


def _is_same(one: Path, other: Path) -> bool:
    return is_own_file(other) and filecmp.cmp(one, other, shallow=False)


def remove(path: Path) -> None:
    """Remove whatever is there: a folder, a file, or a link, but not what it leads to."""
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path, ignore_errors=True)
    else:
        path.unlink(missing_ok=True)
