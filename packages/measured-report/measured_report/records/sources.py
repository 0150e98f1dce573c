"""Sources: which code of Newton is installed, where its version does not say: from a checkout or a wheel (PEP 610)."""

import hashlib
import json
import subprocess
from importlib import metadata
from pathlib import Path
from urllib.parse import unquote, urlparse

from measured_report import UsageError

SHORT_COMMIT = 7
EDITED = ".edited"
"""Behind a commit: a checkout of it differs."""


def source_of(package: str) -> str:
    """The part of a version that says which code is installed here; empty for a package from an index."""
    try:
        said = metadata.distribution(package).read_text("direct_url.json")
    except metadata.PackageNotFoundError:
        return ""
    found = json.loads(said) if said else {}
    if "vcs_info" in found:
        return f"g{found['vcs_info']['commit_id'][:SHORT_COMMIT]}"
    address = found.get("url", "")
    path = Path(unquote(urlparse(address).path))
    if "dir_info" in found:
        return checkout_source(path)
    if address and not address.startswith("file:"):
        return address_source(address)
    return wheel_source(path) if address else ""


def checkout_source(folder: Path) -> str:
    """The commit that a checkout of Newton is at, with ``.edited.`` and a digest of its code where that differs."""
    code = digest_of(sorted((folder / "newton").rglob("*.py")), folder)
    commit = git(folder, "rev-parse", f"--short={SHORT_COMMIT}", "HEAD")
    if not commit:
        return f"x{code}"
    edited = git(folder, "status", "--porcelain", "--", "newton")
    return f"g{commit[:SHORT_COMMIT]}{EDITED}.{code}" if edited else f"g{commit[:SHORT_COMMIT]}"


def wheel_source(path: Path) -> str:
    return f"w{digest_of([path], path.parent)}"


def address_source(address: str) -> str:
    """Of a wheel that is fetched: another one has another address."""
    return f"w{hashlib.sha256(address.encode()).hexdigest()[:SHORT_COMMIT]}"


def digest_of(paths: list[Path], root: Path) -> str:
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
