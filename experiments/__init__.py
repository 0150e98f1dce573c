"""What is measured: a module, or a folder, for each section, and what these share in folders."""

import sys
from pathlib import Path

# The packages of this repository are found where they lie, installed or not: a host without network needs no more.
sys.path[:0] = map(
    str, sorted((Path(__file__).resolve().parent.parent / "packages").glob("*"))
)
