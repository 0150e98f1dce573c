"""Dependencies: the code, files and packages that a section is derived and drawn by."""

import hashlib
from functools import cache
from importlib import metadata
from pathlib import Path
from platform import python_version

from measured_report.files.config import config
from measured_report.files.root import ROOT
from measured_report.parts import macros
from measured_report.records.code import files, roots_of

PACKAGES = ("numpy", "pandas", "matplotlib", "markupsafe")
"""What decides how numbers are computed and figures are drawn."""
FONT = "matplotlib/mpl-data/fonts/ttf/DejaVuSans.ttf"  # how wide its letters are decides where things stand
READ_BY_NAME = config().sources
"""What says what columns are, and nobody imports."""


def digest_of(*texts: str) -> str:
    """Digest texts, told apart."""
    return hashlib.sha256(repr(texts).encode()).hexdigest()


def code_digest(code: Path) -> str:
    """Digest a module, and all else of the project and of what is installed that decides what it makes."""
    return digest_of(installed(), *map(repr, sorted(files_of(code).items())))


def files_of(code: Path) -> dict[str, str]:
    """Digest, by name, a module, what it and this room import of the project, and the files that all these name."""
    root = next(folder for folder in code.parents if (folder / "report").is_dir())
    graph = files().graph(tuple(dict.fromkeys([*roots_of(root), *roots_of(ROOT)])))
    own = Path(__file__).resolve()
    closure = {file for start in (own, own.with_name("cache.py"), code) for file in graph.closure(str(start))}
    sources = {graph.name_of(file): graph.source(file) for file in closure}
    named = {name for source in sources.values() for name in source.assets} | set(READ_BY_NAME)
    found = {name: (ROOT / name).read_bytes() for name in named if (ROOT / name).is_file()}
    found[macros.FILE.name] = macros.FILE.read_bytes()
    digests = {name: hashlib.sha256(content).hexdigest() for name, content in found.items()}
    return digests | {name: source.digest for name, source in sources.items()}


@cache
def installed() -> str:
    """Digest what is installed, as far as it decides what is made."""
    font = Path(str(metadata.distribution("matplotlib").locate_file(FONT))).read_bytes()
    versions = [f"{name} {metadata.version(name)}" for name in PACKAGES]
    return digest_of(python_version(), *versions, hashlib.sha256(font).hexdigest())
