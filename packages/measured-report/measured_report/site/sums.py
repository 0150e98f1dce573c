"""Sums: a site says of each of its files what is in it, and what is taken from it is compared with that."""

import hashlib
import os
import re
from collections.abc import Iterator, Mapping
from pathlib import Path

from measured_report.files.atomic import read_own_file
from measured_report.files.cache import Cache
from measured_report.files.errors import ReportError

SUMS = "SHA256SUMS"
"""The file that names all others with their digests, as ``sha256sum --check`` reads it."""
LINE = re.compile(r"([0-9a-f]{64})  (\S.*)")
BYTE_LIMIT = 1 << 30


def sums_text(digests: Mapping[str, str]) -> str:
    """Write the digests of files by their names below the site."""
    return "".join(f"{digest}  {name}\n" for name, digest in sorted(digests.items()))


def copy_whole(site: Path, copy: Path) -> None:
    """Copy a site; ReportError, one line, unless it is what its build made: every file, no other one, and no link."""
    content = read_own_file(site / SUMS, BYTE_LIMIT)
    lines = [LINE.fullmatch(line) for line in content.decode(errors="replace").splitlines()]
    digests = {found[2]: found[1] for found in lines if found}
    there = set(_files(site))
    damaged = [] if all(lines) else [f"{SUMS} is damaged"]
    missing = [f"there is no {name}" for name in sorted(digests.keys() - there)]
    strange = [f"{name} is not of the build" for name in sorted(there - digests.keys() - {SUMS})]
    built = Cache(site.parent).get(SUMS, SUMS)  # None where the site was built elsewhere
    other = (
        [f"{SUMS} is not that of the last build"] if built not in (None, hashlib.sha256(content).hexdigest()) else []
    )
    for problem in (*damaged, *missing, *strange, *other):
        raise ReportError(f"not published: {site.name}/: {problem}; make report builds it again")
    for name, digest in {**digests, SUMS: hashlib.sha256(content).hexdigest()}.items():
        content = read_own_file(site / name, BYTE_LIMIT)
        if hashlib.sha256(content).hexdigest() != digest:
            raise ReportError(f"not published: {site.name}/{name} was changed; make report builds it again")
        place = copy / name
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_bytes(content)


def _files(site: Path) -> Iterator[str]:
    """Names of all that lies below a site and is no folder; ReportError for a folder elsewhere that a link leads to."""
    for place, folders, files in os.walk(site):
        for name in folders:
            if Path(place, name).is_symlink():
                raise ReportError(f"not published: {site.name}/{Path(place, name).relative_to(site)} is a link")
        yield from (Path(place, name).relative_to(site).as_posix() for name in files)
