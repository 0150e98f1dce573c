"""Cache: what was made before, in the user's own cache folder; what is damaged counts as not there."""

import os
import pickle
from contextlib import suppress
from dataclasses import dataclass
from hashlib import sha256
from pathlib import Path
from typing import Any


@dataclass(frozen=True)
class Cache:
    root: Path  # of the project that it is of

    @property
    def folder(self) -> Path:
        """Return where it lies; RuntimeError where there is no home."""
        told = Path(os.environ.get("XDG_CACHE_HOME", ""))  # which counts only as a whole path: others lie in a checkout
        name = f"{self.root.resolve().name}-{sha256(str(self.root.resolve()).encode()).hexdigest()[:12]}"
        return (told if told.is_absolute() else Path.home() / ".cache") / "measured-report" / name

    def get(self, name: str, key: Any) -> Any:
        """Return what is kept as ``name`` and was made from ``key``; None when there is nothing whole."""
        with suppress(Exception), (self.folder / name).open("rb") as file:  # it may name code that is no more
            return pickle.load(file) if pickle.load(file) == key else None
        return None

    def put(self, name: str, key: Any, value: Any) -> None:
        """Keep ``value``, made from ``key``; where nothing can be written it is not kept."""
        with suppress(OSError, RuntimeError):
            self.folder.mkdir(mode=0o700, parents=True, exist_ok=True)
            part = self.folder / f".{name}.{os.getpid()}"
            with part.open("wb") as file:
                pickle.dump(key, file, pickle.HIGHEST_PROTOCOL)
                pickle.dump(value, file, pickle.HIGHEST_PROTOCOL)
            os.replace(part, self.folder / name)
