"""A cache of what was made before: a folder of the project that may be deleted at any time.

An entry is believed when it is whole and was written with this user's key, which lies outside of the project. One from
elsewhere is not even read, so that it can neither run anything nor put a number on a page; like what is damaged, or no
file at all, it counts as not there.
"""

import glob
import hmac
import io
import os
import pickle
import secrets
import stat
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any

from measured_report.files.atomic import read_own_file

FOLDER = ".cache"
BYTE_LIMIT = 256 << 20
MARK_SIZE = KEY_SIZE = sha256().digest_size


class _Writing(pickle.Pickler):
    """Can be told ``persistent_id``, which the plain one of Python 3.13 cannot."""


class _Reading(pickle.Unpickler):
    """Can be told ``persistent_load``."""


@dataclass(frozen=True)
class Cache:
    """The cache of the project at ``root``."""

    root: Path

    def get(self, name: str, key: Any, find: Callable[[Any], Any] | None = None) -> Any:
        """What is kept as ``name`` and was made from ``key``; None when there is nothing whole.

        ``find`` finds what ``put`` was told to name.
        """
        with suppress(Exception):  # what was whole once may name code that is no more
            content = memoryview(read_own_file(self.root / FOLDER / name, BYTE_LIMIT))
            if hmac.compare_digest(_mark(name, content[MARK_SIZE:]), content[:MARK_SIZE]):
                reading = _Reading(io.BytesIO(content[MARK_SIZE:]))
                if find:
                    reading.persistent_load = find  # type: ignore[method-assign]
                return reading.load() if reading.load() == key else None
        return None

    def put(self, name: str, key: Any, value: Any, name_of: Callable[[Any], Any] | None = None) -> None:
        """Keep ``value``, made from ``key``, whole or not at all; where nothing can be written it is not kept.

        ``name_of`` gives the name of a part of it that is not to be kept with it; None for what is.
        """
        buffer = io.BytesIO()
        writing = _Writing(buffer, pickle.HIGHEST_PROTOCOL)
        if name_of:
            writing.persistent_id = name_of  # type: ignore[method-assign]
        writing.dump(key)
        writing.dump(value)
        content = buffer.getvalue()
        place = self.root / FOLDER / name
        # Always of this name, so that no more than one is ever left. Two that write it at once damage it at worst.
        part = place.with_name(f"{name}.part")
        with suppress(OSError):
            place.parent.mkdir(mode=0o700, exist_ok=True)
            if place.parent.is_symlink():  # what it leads to is somebody's
                return
            place.parent.chmod(0o700)  # of an older one
            part.unlink(missing_ok=True)
            try:
                with part.open("xb") as file:
                    file.write(_mark(name, content) + content)
                os.replace(part, place)
            finally:
                part.unlink(missing_ok=True)

    def remove(self, start: str) -> None:
        """Remove what is kept as a name that begins so."""
        self._remove(f"{glob.escape(start)}*")

    def sweep(self) -> None:
        """Remove what processes that were killed have left; one that is just being written is then not kept."""
        self._remove("*.part")

    def _remove(self, pattern: str) -> None:
        folder = self.root / FOLDER
        for entry in () if folder.is_symlink() else folder.glob(pattern):
            with suppress(OSError):
                entry.unlink()


def _mark(name: str, content: bytes | memoryview) -> bytes:
    """What only who has the key can put before an entry of this name."""
    mark = hmac.new(_key(), f"{name}\0".encode(), sha256)
    mark.update(content)
    return mark.digest()


@cache
def _key() -> bytes:
    """This user's key, made where there is none; one for this process alone where none can be kept unseen."""
    with suppress(OSError, RuntimeError):  # where there is no home
        told = Path(os.environ.get("XDG_CACHE_HOME", ""))  # which counts only as a whole path: others lie in a checkout
        folder = (told if told.is_absolute() else Path.home() / ".cache") / "measured-report"
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        place, part = folder / "key", folder / f"key.{secrets.token_hex(4)}"
        if not place.exists():
            try:
                descriptor = os.open(part, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
                with os.fdopen(descriptor, "wb") as file:
                    file.write(secrets.token_bytes(KEY_SIZE))
                with suppress(FileExistsError):  # another process was faster
                    os.link(part, place)
            finally:
                part.unlink(missing_ok=True)
        found = place.lstat()
        is_mine = stat.S_ISREG(found.st_mode) and found.st_uid == os.geteuid() and not found.st_mode & 0o077
        if is_mine and found.st_size == KEY_SIZE:
            return place.read_bytes()
    return secrets.token_bytes(KEY_SIZE)
