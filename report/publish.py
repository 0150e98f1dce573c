"""Publishing: a checked copy of the site, put in place in one step.

``dir:PATH`` makes PATH a symbolic link. The builds lie beside it, in ``.<name>.versions/<digest>/``, and
publishing replaces the link, so a reader gets the old build or the new one and never half of each. The build
before stays, for those who are reading it.
"""

import os
import shutil
from contextlib import suppress
from pathlib import Path

from report import ReportError, UsageError
from report.check import check_site
from report.records.identity import files_digest

SCHEME = "dir:"
QUICK = '<meta name="profile" content="quick">'
"""What marks a page of small grids and short runs."""


def publish(site: Path, target: str) -> Path:
    """Put a checked copy of ``site`` at ``target`` and return where it lies; what can't be put there leaves nothing."""
    try:
        path = _target_path(target)
        versions = path.with_name(f".{path.name}.versions")
        _refuse_foreign(path, versions)
        if not (site / "index.html").is_file():
            raise UsageError(f"{site.name}/ holds no report; make report builds it")
        if QUICK in (site / "index.html").read_text(encoding="utf-8"):
            raise UsageError(f"{site.name}/ holds a quick look, not the report; make report builds that")
        _put(site, path, versions)
    except OSError as error:
        raise UsageError(f"TARGET={target}: {_reason(error)}") from None
    return path


def _put(site: Path, path: Path, versions: Path) -> None:
    before = path.resolve() if path.is_symlink() else None
    copy = unused = versions / f"new-{os.getpid()}"
    try:
        shutil.copytree(site, copy)
        problems = check_site(copy)
        if problems:
            raise ReportError(f"not published, problems found: {len(problems)}; the first: {problems[0]}")
        version = versions / files_digest(copy.rglob("*"), copy)[:16]
        if not version.exists():
            unused = copy.rename(version)
        _switch(path, version)
        unused = copy
    finally:
        shutil.rmtree(unused, ignore_errors=True)
        with suppress(OSError):  # there and empty only when nothing was ever published here
            versions.rmdir()
    for old in versions.iterdir():
        if old.resolve() not in (version.resolve(), before):
            shutil.rmtree(old, ignore_errors=True)


def _target_path(target: str) -> Path:
    place = target.removeprefix(SCHEME)
    if place == target or not place:
        raise UsageError(f"TARGET={target!r} is no place to publish to; use TARGET=dir:PATH")
    # Path.expanduser would raise for a user that does not exist.
    path = Path(os.path.abspath(os.path.expanduser(place)))  # noqa: PTH111
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
    try:
        os.replace(link, path)
    finally:
        link.unlink(missing_ok=True)


def _reason(error: OSError) -> str:
    # Of a folder all that could not be copied is said at once: source, target and reason of each file.
    return error.args[0][0][2] if isinstance(error, shutil.Error) else error.strerror
