"""A cache of what was made before: a folder of the project that may be deleted at any time.

An entry is believed when it is whole; when it is not, or is no file at all, it counts as not there.
"""

import glob
import hashlib
import io
import os
import pickle
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from measured_report.files.atomic import read_own_file

FOLDER = ".cache"
BYTE_LIMIT = 256 << 20
DIGEST_SIZE = hashlib.sha256().digest_size


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
            if hashlib.sha256(content[DIGEST_SIZE:]).digest() == content[:DIGEST_SIZE]:
                reading = _Reading(io.BytesIO(content[DIGEST_SIZE:]))
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
        try:
            place.parent.mkdir(exist_ok=True)
            part.write_bytes(hashlib.sha256(content).digest() + content)
            os.replace(part, place)
        except OSError:
            with suppress(OSError):
                part.unlink(missing_ok=True)

    def remove(self, start: str) -> None:
        """Remove what is kept as a name that begins so."""
        self._remove(f"{glob.escape(start)}*")

    def sweep(self) -> None:
        """Remove what processes that were killed have left; one that is just being written is then not kept."""
        self._remove("*.part")

    def _remove(self, pattern: str) -> None:
        for entry in (self.root / FOLDER).glob(pattern):
            with suppress(OSError):
                entry.unlink()
