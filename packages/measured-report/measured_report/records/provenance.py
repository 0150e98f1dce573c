"""Provenance of packages: the version of each that is installed, and its code where the version does not say.

Code comes from an index, a commit, a checkout or a wheel, as PEP 610 notes it.
"""

import hashlib
import json
import os
import subprocess
from collections.abc import Iterable, Mapping, Sequence
from importlib import metadata
from pathlib import Path
from urllib.parse import unquote, urlparse

from measured_report.files.config import config
from measured_report.files.errors import UsageError
from measured_report.records.code import files

SHORT_COMMIT = 7
EDITED = ".edited"
"""Behind a commit: a checkout of it differs."""
MISSING = "missing"


def package_versions() -> dict[str, str]:
    """Return the version of each package here; of the first with its code, where that is not an index's."""
    found = files().versions
    if not found:
        for package in config().packages:
            try:
                found[package] = metadata.version(package)
            except metadata.PackageNotFoundError:
                found[package] = MISSING
        if found[config().package] != MISSING and (source := _source()):
            found[config().package] += f"+{source}"
    return dict(found)


def package_changes(before: Mapping[str, str], after: Mapping[str, str], names: Sequence[str] = ()) -> list[str]:
    """Say which packages are of another version than before, each with both."""
    versions = {name: (before.get(name), after.get(name)) for name in names or config().packages}
    return [f"{name} {old} → {new}" for name, (old, new) in versions.items() if old != new]


def _source() -> str:
    """Return the part of a version that names the code installed here; empty for a package from an index."""
    found = json.loads(metadata.distribution(config().package).read_text("direct_url.json") or "{}")
    if "vcs_info" in found:
        return f"g{found['vcs_info']['commit_id'][:SHORT_COMMIT]}"
    address = found.get("url", "")
    path = Path(unquote(urlparse(address).path))
    if "dir_info" in found:
        return checkout_source(path)
    if address.startswith("file:"):
        return wheel_source(path)
    return ""


def checkout_source(folder: Path) -> str:
    """Name the commit that a checkout is at, with ``.edited.`` and the digest of its code if that differs."""
    module, code = config().package.replace("-", "_"), code_in(folder)
    commit = git(folder, "rev-parse", "HEAD")[:SHORT_COMMIT]
    if not commit:
        return f"x{code}"
    is_edited = git(folder, "status", "--porcelain", "--", module, f"src/{module}")
    return f"g{commit}{EDITED}.{code}" if is_edited else f"g{commit}"


def code_in(folder: Path) -> str:
    """Digest the package's code in a checkout."""
    module = config().package.replace("-", "_")
    paths = [path for place in (folder, folder / "src") for path in (place / module).rglob("*.py")]
    return files_digest(paths, folder)[:SHORT_COMMIT]


def wheel_source(path: Path) -> str:
    return f"w{files_digest([path], path.parent)[:SHORT_COMMIT]}"


def files_digest(paths: Iterable[Path], root: Path) -> str:
    """Digest files, by their names below ``root`` and what they hold; folders are passed over."""
    digest = hashlib.sha256()
    for path in sorted(paths):
        if path.is_file():
            content = path.read_bytes()
            digest.update(os.fsencode(f"{path.relative_to(root).as_posix()}\0{len(content)}\0") + content)
    return digest.hexdigest()


def git(folder: Path, *command: str) -> str:
    """Return what git says in a folder; nothing where it has nothing to say, as outside of a repository."""
    try:
        done = subprocess.run(["git", "-C", folder, *command], capture_output=True, text=True, check=False)
    except FileNotFoundError:
        raise UsageError("git is not installed, and a checkout takes it") from None
    return done.stdout.strip() if done.returncode == 0 else ""
