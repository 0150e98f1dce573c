"""Provenance of packages: which version of each is installed, and of which code where the version does not say.

Code comes from an index, a commit, a checkout or a wheel, as PEP 610 notes it.
"""

import hashlib
import json
import subprocess
from collections.abc import Mapping, Sequence
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
    """Version of each package that is installed here; of the first with its code, where that is not an index's."""
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
    """Which packages are of another version than before, each with both."""
    versions = {name: (before.get(name), after.get(name)) for name in names or config().packages}
    return [f"{name} {old} → {new}" for name, (old, new) in versions.items() if old != new]


def _source() -> str:
    """The part of a version that says which code is installed here; empty for a package from an index."""
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
    """The commit that a checkout of the package is at, with ``.edited.`` and the digest of its code if that differs."""
    module, code = config().package.replace("-", "_"), code_in(folder)
    commit = git(folder, "rev-parse", "HEAD")[:SHORT_COMMIT]
    if not commit:
        return f"x{code}"
    return (
        f"g{commit}{EDITED}.{code}"
        if git(folder, "status", "--porcelain", "--", module, f"src/{module}")
        else f"g{commit}"
    )


def code_in(folder: Path) -> str:
    """The digest of the package's code in a checkout."""
    module = config().package.replace("-", "_")
    return _digest(sorted([*(folder / module).rglob("*.py"), *(folder / "src" / module).rglob("*.py")]), folder)


def wheel_source(path: Path) -> str:
    return f"w{_digest([path], path.parent)}"


def _digest(paths: list[Path], root: Path) -> str:
    """Seven digits for the files, by their names below ``root`` and what they hold."""
    digest = hashlib.sha256()
    for path in paths:
        if path.is_file():
            digest.update(f"{path.relative_to(root).as_posix()}\0".encode() + path.read_bytes() + b"\0")
    return digest.hexdigest()[:SHORT_COMMIT]


def git(folder: Path, *command: str) -> str:
    """What git says in a folder; nothing where it has nothing to say, as outside of a repository."""
    try:
        done = subprocess.run(["git", "-C", folder, *command], capture_output=True, text=True, check=False)
    except FileNotFoundError:
        raise UsageError("git is not installed, and a checkout takes it") from None
    return done.stdout.strip() if done.returncode == 0 else ""
