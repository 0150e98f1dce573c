"""Staging: a folder is made beside another, by one process at a time, and takes its place once it is whole."""

import hashlib
import os
import shutil
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from measured_report.files.atomic import locked


@contextmanager
def staging_folder(folder: Path) -> Iterator[Path]:
    """Name a staging folder for what is to take the place of ``folder``; whoever has it is alone with both.

    What is there afterwards is removed, as is what a process that was killed has left.
    """
    with locked(folder.parent):
        fresh = folder.with_name(f".{folder.name}-new")
        shutil.rmtree(fresh, ignore_errors=True)
        try:
            yield fresh
        finally:
            shutil.rmtree(fresh, ignore_errors=True)


class Draft:
    """Collect files in a folder that is being made, with their digests."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.digests: dict[str, str] = {}
        """Digests of what it holds by now, by name below it."""

    def write(self, name: str, content: str | bytes) -> None:
        """Put a file there; ``name`` may be below folders, which are made."""
        data = content.encode() if isinstance(content, str) else content
        self.digests[name] = hashlib.sha256(data).hexdigest()
        (self.folder / name).parent.mkdir(parents=True, exist_ok=True)
        (self.folder / name).write_bytes(data)

    def copy(self, name: str, source: Path) -> None:
        """Put a copy of the file ``source`` there."""
        self.write(name, source.read_bytes())


def digests_below(folder: Path) -> dict[str, str]:
    """Digest the files below a folder, by their names there; a link, and what else is no file, has none."""
    there = (path for path in folder.rglob("*") if path.is_symlink() or not path.is_dir())
    return {path.relative_to(folder).as_posix(): _digest(path) for path in there}


def _digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest() if stat.S_ISREG(path.lstat().st_mode) else ""


def replace(folder: Path, fresh: Path) -> None:
    """Let ``fresh`` take the place of ``folder``, or of what that leads to; what was there is removed."""
    folder, before = folder.resolve(), fresh.with_name(f"{fresh.name}-before")
    shutil.rmtree(before, ignore_errors=True)
    if folder.exists():
        os.rename(folder, before)
    os.rename(fresh, folder)
    shutil.rmtree(before, ignore_errors=True)
