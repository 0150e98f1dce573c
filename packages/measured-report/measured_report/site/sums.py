"""Sums: a site says of each of its files what is in it, and what is taken from it is compared with that."""

import hashlib
from collections.abc import Mapping
from pathlib import Path

SUMS = "SHA256SUMS"
"""The file that names all others with their digests, as ``sha256sum --check`` reads it."""


def sums_text(digests: Mapping[str, str]) -> str:
    """Write the digests of files by their names below the site."""
    return "".join(f"{digest}  {name}\n" for name, digest in sorted(digests.items()))


def check_sums(site: Path) -> list[str]:
    """Say in what a site is not what its build made, a line each: every file, no other one, and no link."""
    if not (site / SUMS).is_file():
        return [f"there is no {SUMS}"]
    paths = [path for path in sorted(site.rglob("*")) if path.is_symlink() or not path.is_dir()]
    there = {path.relative_to(site).as_posix(): path for path in paths if path != site / SUMS}
    lines = (line.partition("  ") for line in (site / SUMS).read_text(encoding="utf-8").splitlines())
    told = {name: digest for digest, _, name in lines}
    problems = [f"there is no {name}" for name in told if name not in there]
    problems += [f"{name} is not of the build" for name in there if name not in told]
    for name, path in there.items():
        if path.is_symlink():
            problems.append(f"{name} is a link")
        elif name in told and hashlib.sha256(path.read_bytes()).hexdigest() != told[name]:
            problems.append(f"{name} was changed")
    return problems
