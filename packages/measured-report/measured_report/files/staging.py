"""Staging: a folder is made beside another, by one process at a time, and takes its place in one step."""

import ctypes
import errno
import filecmp
import hashlib
import os
import re
import secrets
import shutil
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from pathlib import Path

from measured_report.files.atomic import atomic_file, is_own_file, locked, remove

AT_FDCWD, RENAME_EXCHANGE = -100, 2  # from linux/fcntl.h and linux/fs.h


def staged(folder: Path) -> re.Pattern:
    """What matches the names of the folder's staging folders; others may begin alike, and are none."""
    return re.compile(rf"\.{re.escape(folder.name)}-[0-9a-f]{{8}}")


@contextmanager
def staging_folder(folder: Path) -> Iterator[Path]:
    """Name a staging folder for what is to take the place of ``folder``; whoever has it is alone with both.

    What is there afterwards is removed, as is what processes that were killed have left.
    """
    with locked(folder.parent):
        for left in folder.parent.iterdir():
            if staged(folder).fullmatch(left.name):
                remove(left)
        fresh = folder.with_name(f".{folder.name}-{secrets.token_hex(4)}")
        try:
            yield fresh
        finally:
            remove(fresh)


class Draft:
    """A folder that is being made to take the place of ``before``; files that are the same stay those that are there.

    ``there`` is what ``digests_below`` says of that one.
    """

    def __init__(self, folder: Path, before: Path, there: Mapping[str, str]):
        self.digests: dict[str, str] = {}
        """Of what it holds by now, by name below it."""
        self.folder, self._before, self._there = folder, before, there
        self._sources: dict[Path, str] = {}

    def write(self, name: str, content: str | bytes) -> None:
        """Put a file there; ``name`` may be below folders, which are made."""
        data = content.encode() if isinstance(content, str) else content
        if not self._stays(name, hashlib.sha256(data).hexdigest()):
            (self.folder / name).write_bytes(data)

    def copy(self, name: str, source: Path) -> None:
        """Put a copy of the file ``source`` there."""
        if source not in self._sources:
            self._sources[source] = hashlib.sha256(source.read_bytes()).hexdigest()
        if not self._stays(name, self._sources[source]):
            shutil.copyfile(source, self.folder / name)

    def _stays(self, name: str, digest: str) -> bool:
        """Whether what is to be put there is there now: it was put there already, or it was there before."""
        if self.digests.get(name) == digest:
            return True
        self.digests[name] = digest
        (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
        if self._there.get(name) == digest:
            with suppress(OSError):  # of a file system without such links, or of another one
                os.link(self._before / name, self.folder / name)
                return True
        return False


def digests_below(folder: Path) -> dict[str, str]:
    """Digests of the files below a folder, by their names there; links, and what else is no file, are passed over."""
    files = [path for place, _, names in os.walk(folder) for path in map(Path(place).joinpath, names)]
    own = filter(is_own_file, files)
    return {path.relative_to(folder).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest() for path in own}


def replace(folder: Path, fresh: Path) -> None:
    """Let ``fresh`` take the place of ``folder``; what was there is at ``fresh`` afterwards.

    A folder that can't be moved, as one that is mounted, gets the contents, its pages last.
    """
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
        if is_own_file(place) and filecmp.cmp(path, place, shallow=False):
            continue
        if place.is_dir() and not place.is_symlink():
            shutil.rmtree(place)
        with atomic_file(place) as part:
            shutil.copyfile(path, part)
    kept = {path.relative_to(fresh) for path in files}
    for path in sorted(folder.rglob("*"), reverse=True):
        if path.is_dir() and not path.is_symlink():
            with suppress(OSError):  # of one that is not empty
                path.rmdir()
        elif path.relative_to(folder) not in kept:
            path.unlink()
