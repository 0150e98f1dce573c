"""Contain one module or folder for each measured section; other folders are shared."""

import sys
from pathlib import Path

# Find the packages of this repository in its own folders, whether they are installed or
# not, so that a host without network can run them.
sys.path[:0] = map(
    str, sorted((Path(__file__).resolve().parent.parent / "packages").glob("*"))
)
