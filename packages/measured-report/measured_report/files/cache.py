"""Cache: what was made before, in the user's own cache folder; what is damaged counts as not there."""

import os
import pickle
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from typing import Any


class _Writing(pickle.Pickler):
    """Can be told ``persistent_id``, which the plain one of Python 3.13 cannot."""


class _Reading(pickle.Unpickler):
    """Can be told ``persistent_load``."""


@dataclass(frozen=True)
class Cache:
    """Keeps what was made of the project at ``root``."""

    root: Path

    @property
    def folder(self) -> Path:
        """Return where it lies; RuntimeError where there is no home."""
        told = Path(os.environ.get("XDG_CACHE_HOME", ""))  # which counts only as a whole path: others lie in a checkout
        place = str(self.root.resolve())
        name = f"{self.root.resolve().name}-{sha256(place.encode()).hexdigest()[:12]}"
        return (told if told.is_absolute() else Path.home() / ".cache") / "measured-report" / name

    def get(self, name: str, key: Any, find: Callable[[Any], Any] | None = None) -> Any:
        """Return what is kept as ``name`` and was made from ``key``; None when there is nothing whole.

        ``find`` finds what ``put`` was told to name.
        """
        with suppress(Exception), (self.folder / name).open("rb") as file:  # it may name code that is no more
            reading = _Reading(file)
            if find:
                reading.persistent_load = find  # type: ignore[method-assign]
            return reading.load() if reading.load() == key else None
        return None

    def put(self, name: str, key: Any, value: Any, name_of: Callable[[Any], Any] | None = None) -> None:
        """Keep ``value``, made from ``key``; where nothing can be written it is not kept.

        ``name_of`` gives the name of a part of it that is not to be kept with it; None for what is.
        """
        with suppress(OSError, RuntimeError):
            self.folder.mkdir(mode=0o700, parents=True, exist_ok=True)
            part = self.folder / f".{name}.{os.getpid()}"
            with part.open("wb") as file:
                writing = _Writing(file, pickle.HIGHEST_PROTOCOL)
                if name_of:
                    writing.persistent_id = name_of  # type: ignore[method-assign]
                writing.dump(key)
                writing.dump(value)
            os.replace(part, self.folder / name)
