"""Cache results in the user's cache folder; a damaged entry counts as missing."""

import os
import pickle
import sys
from contextlib import suppress
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any


@cache
def _is_ours(folder: Path) -> bool:
    """Return whether only this user may write to a folder, and print a message if not.

    The files in it are pickles, which can execute code when they are read.
    """
    info = folder.stat()
    if not (is_ours := info.st_uid == os.geteuid() and not info.st_mode & 0o022):
        print(
            f"{folder.name}/ in the cache is not used, because other users can write "
            "to it: remove it",
            file=sys.stderr,
        )
    return is_ours


@dataclass(frozen=True)
class Cache:
    """Store the results of one project by name, each with the key it was made from."""

    root: Path  # the folder of the project

    @property
    def folder(self) -> Path:
        """Return the cache's folder; raise RuntimeError if there is no home folder."""
        root = self.root.resolve()
        digest = sha256(os.fsencode(root)).hexdigest()[:12]
        base = Path(os.environ.get("XDG_CACHE_HOME", ""))
        # A relative path is ignored, because it would lead into a checkout.
        if not base.is_absolute():
            base = Path.home() / ".cache"
        return base / "measured-report" / f"{root.name}-{digest}"

    def get(self, name: str, key: Any) -> Any:
        """Return the entry ``name``, or None if it was not made from ``key``."""
        # Any error can occur, because the pickle may name code that no longer exists.
        with suppress(Exception):
            path = self.folder / name
            # Opening a pipe would wait for somebody to write to it.
            if path.is_file() and _is_ours(self.folder):
                with path.open("rb") as file:
                    # The key comes first, because the value may be large.
                    is_current = pickle.load(file) == key
                    return pickle.load(file) if is_current else None
        return None

    def put(self, name: str, key: Any, value: Any) -> None:
        """Store ``value``, made from ``key``; do nothing if the cache is not writable.

        It is also not stored if other users can write to the cache.
        """
        with suppress(OSError, RuntimeError):
            self.folder.mkdir(mode=0o700, parents=True, exist_ok=True)
            if not _is_ours(self.folder):
                return
            temporary = self.folder / f".{name}.{os.getpid()}"
            with temporary.open("wb") as file:
                pickle.dump(key, file, pickle.HIGHEST_PROTOCOL)
                pickle.dump(value, file, pickle.HIGHEST_PROTOCOL)
            os.replace(temporary, self.folder / name)
