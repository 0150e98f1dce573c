"""Publishing: a checked copy of the site, put in place in one step.

``dir:PATH`` makes PATH a symbolic link. The builds lie beside it, in ``.<name>.versions/<digest>/``, and
publishing replaces the link, so a reader gets the old build or the new one and never half of each. The build
before stays, for those who are reading it.
"""

import hashlib
import os
import shutil
from pathlib import Path

from report import ReportError, UsageError
from report.check import check_site

SCHEME = "dir:"
QUICK = '<meta name="profile" content="quick">'
"""What marks a page of small grids and short runs."""


def publish(site: Path, target: str) -> Path:
    """Put a checked copy of ``site`` at ``target`` and return where it lies."""
    path = _target_path(target)
    versions = path.with_name(f".{path.name}.versions")
    _refuse_foreign(path, versions)
    if not (site / "index.html").is_file():
        raise UsageError(f"{site.name}/ holds no report; make report builds it")
    if QUICK in (site / "index.html").read_text(encoding="utf-8"):
        raise UsageError(f"{site.name}/ holds a quick look, not the report; make report builds that")
    copy = versions / f"new-{os.getpid()}"
    try:
        shutil.copytree(site, copy)
        problems = check_site(copy)
        if problems:
            raise ReportError(f"not published, problems found: {len(problems)}; the first: {problems[0]}")
        version = versions / _digest(copy)
        if not version.exists():
            os.rename(copy, version)
    finally:
        shutil.rmtree(copy, ignore_errors=True)
        if not any(versions.iterdir()):
            versions.rmdir()
    before = path.resolve() if path.is_symlink() else None
    _switch(path, version)
    for old in versions.iterdir():
        if old.resolve() not in (version.resolve(), before):
            shutil.rmtree(old)
    return path


def _target_path(target: str) -> Path:
    place = target.removeprefix(SCHEME)
    if place == target or not place:
        raise UsageError(f"TARGET={target!r} is no place to publish to; use TARGET=dir:PATH")
    path = Path(os.path.abspath(Path(place).expanduser()))
    if not path.name or not path.parent.is_dir():
        raise UsageError(f"TARGET={target}: there is no folder {path.parent}")
    return path


def _refuse_foreign(path: Path, versions: Path) -> None:
    """Only what is not there, is empty, or was published here before may be replaced."""
    if path.is_symlink():
        if path.resolve().parent != versions.resolve():
            raise UsageError(f"{path} is a link to something else; it was left alone")
    elif path.exists() and (not path.is_dir() or any(path.iterdir())):
        raise UsageError(f"{path} holds something that was not published here; it was left alone")


def _switch(path: Path, version: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        path.rmdir()
    link = version.with_name(f"link-{os.getpid()}")
    # Relative to where the link ends up, so that the folder above can move.
    link.symlink_to(Path(version.parent.name) / version.name)
    os.replace(link, path)


def _digest(folder: Path) -> str:
    digest = hashlib.sha256()
    for path in sorted(folder.rglob("*")):
        if path.is_file():
            content = path.read_bytes()
            digest.update(f"{path.relative_to(folder).as_posix()}\0{len(content)}\0".encode() + content)
    return digest.hexdigest()[:16]
