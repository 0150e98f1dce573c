"""Root: the report's folder."""

import sys
from pathlib import Path


def _root() -> Path:
    """Find the folder: the first with a ``report.toml`` above the program, or else above where it was started."""
    starts = [Path(sys.path[0] or ".").resolve(), Path.cwd()]
    folders = (folder for start in starts for folder in (start, *start.parents))
    return next((folder for folder in folders if (folder / "report.toml").is_file()), Path.cwd())


ROOT = _root()
"""Every path in a record is relative to it."""
