"""Cache: what was made before, in the user's own cache folder; what is damaged counts as not there."""

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
    """Tell whether nobody else may write in a folder, and say where somebody may: what is read there is executed."""
    info = folder.stat()
    if not (is_ours := info.st_uid == os.geteuid() and not info.st_mode & 0o022):
        print(
            f"nothing is kept in {folder.name}/ of the cache: others may write there",
            file=sys.stderr,
        )
    return is_ours


@dataclass(frozen=True)
class Cache:
    root: Path  # of the project that it is of

    @property
    def folder(self) -> Path:
        """Return where it lies; RuntimeError where there is no home."""
        base = Path(
            os.environ.get("XDG_CACHE_HOME", "")
        )  # which counts only as a whole path: others lie in a checkout
        name = f"{self.root.resolve().name}-{sha256(str(self.root.resolve()).encode()).hexdigest()[:12]}"
        return (
            (base if base.is_absolute() else Path.home() / ".cache")
            / "measured-report"
            / name
        )

    def get(self, name: str, key: Any) -> Any:
        """Return what is kept as ``name`` and was made from ``key``; None when there is nothing whole."""
        with (
            suppress(Exception),
            (self.folder / name).open("rb") as file,
        ):  # it may name code that is no more
            if not _is_ours(self.folder):
                return None
            is_current = (
                pickle.load(file) == key
            )  # the key stands before the value, which may be large
            return pickle.load(file) if is_current else None
        return None

    def put(self, name: str, key: Any, value: Any) -> None:
        """Keep ``value``, made from ``key``; where nothing can be written it is not kept."""
        with suppress(OSError, RuntimeError):
            self.folder.mkdir(mode=0o700, parents=True, exist_ok=True)
            if not _is_ours(self.folder):
                return
            temporary = self.folder / f".{name}.{os.getpid()}"
            with temporary.open("wb") as file:
                pickle.dump(key, file, pickle.HIGHEST_PROTOCOL)
                pickle.dump(value, file, pickle.HIGHEST_PROTOCOL)
            os.replace(temporary, self.folder / name)
