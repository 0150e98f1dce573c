"""Find the folder of the report."""

import sys
from pathlib import Path

_starts = (Path(sys.path[0] or ".").resolve(), Path.cwd())
_folders = (folder for start in _starts for folder in (start, *start.parents))
ROOT = next(
    (folder for folder in _folders if (folder / "report.toml").is_file()), Path.cwd()
)
"""The first folder with a ``report.toml`` above the program or the working directory.

Paths in records are relative to it.
"""
