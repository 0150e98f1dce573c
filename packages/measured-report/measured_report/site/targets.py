"""Targets: where a checked copy of the site can be published, and how it gets there as a whole."""

import hashlib
import os
import re
import secrets
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path

from measured_report.files.atomic import locked, remove, sync, sync_below
from measured_report.files.errors import UsageError
from measured_report.files.staging import replace, staged
from measured_report.records.identity import files_digest

ATTRIBUTES = "* -text -filter -ident -working-tree-encoding\n"
"""For git: whoever checks the branch out gets its bytes, whatever else is set there."""
MARK = ".published"  # a file of every copy that is published: only what has it is replaced
VERSION = re.compile(r"[0-9a-f]{16}")
UNFINISHED = re.compile(r"(new|link)-[0-9a-f]+")
BRANCH = "gh-pages"
OTHER_REPOSITORY = {f"GIT_{what}" for what in ("DIR", "WORK_TREE", "INDEX_FILE", "OBJECT_DIRECTORY", "COMMON_DIR")}
OTHER_REPOSITORY |= {"GIT_ALTERNATE_OBJECT_DIRECTORIES", "GIT_NAMESPACE", "GIT_SHALLOW_FILE", "GIT_DEFAULT_HASH"}
"""Settings of the environment that would lead to another repository: a hook, or another git, sets them."""
SUBJECT = "The report, as make publish made it"


def to_folder(copy: Path, place: str, site: Path) -> str:
    """Publish to a folder of this machine: a link to one of the versions, in ``.<name>.versions/<digest>/`` beside it.

    Publishing replaces the link. The version before stays, for those who are reading it.
    """
    # Path.expanduser would raise for a user that does not exist.
    path = Path(os.path.abspath(os.path.expanduser(place)))  # noqa: PTH111
    if not path.name or not path.parent.is_dir():
        raise UsageError(f"TARGET=dir:{place}: there is no folder to put it into")
    _refuse_inside(site, path)
    versions = path.with_name(f".{path.name}.versions")
    _refuse_foreign(path, versions)
    was_there = versions.is_dir()
    versions.mkdir(exist_ok=True)
    try:
        with locked(versions):
            for left in (left for left in versions.iterdir() if UNFINISHED.fullmatch(left.name)):
                remove(left)
            version = _put_version(copy, versions)
            _switch(path, version)
            _remove_old(versions, version)
    except BaseException:
        if not was_there:
            remove(versions)
        raise
    return str(path)


def _refuse_inside(site: Path, path: Path) -> None:
    """UsageError for a place that the next build removes."""
    place = path.parent.resolve() / path.name
    if place.is_relative_to(site.resolve()) or (
        place.parent == site.parent.resolve() and staged(site).fullmatch(place.name)
    ):
        raise UsageError(f"{path} lies where {site.name}/ is rebuilt; use a place outside of it")


def _refuse_foreign(path: Path, versions: Path) -> None:
    """UsageError unless what is there is nothing, is empty, or was published here before."""
    if versions.is_symlink():
        raise UsageError(f"{versions} is a link to something else; it was left alone")
    if path.is_symlink():
        if path.resolve().parent != versions.resolve():
            raise UsageError(f"{path} is a link to something else; it was left alone")
    elif path.exists() and (not path.is_dir() or any(path.iterdir())):
        raise UsageError(f"{path} holds something that was not published here; it was left alone")


def _put_version(copy: Path, versions: Path) -> Path:
    """The copy among the versions; one that is there already, but no longer as it was published, is replaced."""
    digest = files_digest(copy.rglob("*"), copy)
    version = versions / digest[:16]
    if version.exists() and files_digest(version.rglob("*"), version) == digest:
        os.utime(version)
        return version
    new = versions / f"new-{secrets.token_hex(4)}"
    try:
        shutil.copytree(copy, new)
        os.utime(new)
        sync_below(new)
        if files_digest(new.rglob("*"), new) != digest:
            raise UsageError(f"{versions.parent} does not keep what is written there: it reads otherwise")
        replace(version, new)
        sync(versions)
    finally:
        remove(new)
    return version


def _switch(path: Path, version: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        path.rmdir()
    link = version.with_name(f"link-{secrets.token_hex(4)}")
    # Relative to where the link ends up, so that the folder above can move.
    link.symlink_to(Path(version.parent.name) / version.name)
    try:
        os.replace(link, path)
        sync(path.parent)
    finally:
        link.unlink(missing_ok=True)


def _remove_old(versions: Path, version: Path) -> None:
    """All versions but this one and the newest of the others; nothing else that lies there."""
    others = [path for path in versions.iterdir() if VERSION.fullmatch(path.name) and path != version]
    ours = [path for path in others if (path / "index.html").is_file() or not any(path.iterdir())]
    for old in sorted(ours, key=lambda path: path.stat().st_mtime)[:-1]:
        remove(old)


def to_branch(copy: Path, place: str, site: Path) -> str:
    """Publish to a branch of a remote of the project's git repository, as its one commit.

    The commit is made in a repository of its own, which is removed: neither the working tree nor the index nor any
    branch is touched. A branch that holds something else is left alone.
    """
    remote, _, branch = place.partition("#")
    branch = branch or BRANCH
    if branch.startswith("refs/"):
        raise UsageError(f"TARGET=git:{place}: {branch} is no name of a branch, which has no refs/ before it")
    ref, there = f"refs/heads/{branch}", f"{remote}, branch {branch}"
    git = ["git", "-C", str(site.parent)]
    if Path(_run([*git, "rev-parse", "--show-toplevel"])) != site.parent.resolve():
        raise UsageError(f"{site.parent} is no git repository of its own; TARGET=dir:PATH needs none")
    if remote not in _run([*git, "remote"]).split() and not re.match(r"(https?|ssh|git|file)://|/|\.", remote):
        raise UsageError(f"TARGET=git:{place}: git knows no remote {remote}; TARGET=dir:PATH needs none")
    _run([*git, "check-ref-format", "--branch", branch])
    with tempfile.TemporaryDirectory(prefix="publish-") as folder:
        made = ["git", "-C", folder]
        _run([*made, "init", "--quiet", "--bare"])
        objects = {"GIT_ALTERNATE_OBJECT_DIRECTORIES": f"{folder}/objects"}
        before = _tip(git, remote, ref)
        if before:
            _run([*git, "fetch", "--quiet", "--no-tags", "--no-write-fetch-head", remote, ref])
            if not _run([*git, "log", "-1", "--format=%s", before]).startswith(SUBJECT):
                said = "holds something that was not published; it was left alone"
                raise UsageError(f"the branch {branch} of {remote} {said}")
        (copy / ".gitattributes").write_text(ATTRIBUTES, encoding="utf-8")
        importing = [sys.executable, "-m", "ghp_import", "--no-jekyll", "--branch", branch, "--message", SUBJECT]
        _run([*importing, str(copy)], {"GIT_DIR": folder, **_author(git)})
        commit, tree = _run([*made, "rev-parse", ref, f"{ref}^{{tree}}"]).split()
        _refuse_other(copy, _run([*made, "ls-tree", "-rz", tree]))
        if before and _run([*git, "rev-parse", f"{before}^{{tree}}"]) == tree:
            return f"{there}, as before"
        _run([*git, "push", "--quiet", f"--force-with-lease={ref}:{before}", remote, f"{commit}:{ref}"], objects)
        if _tip(git, remote, ref) != commit:
            raise UsageError(f"{there} has another commit than the one that was pushed")
    return there


def _tip(git: list[str], remote: str, ref: str) -> str:
    """The commit that a branch of a remote is at, which also lists what is called so in another folder of names."""
    lines = _run([*git, "ls-remote", remote, ref]).splitlines()
    return next((line.partition("\t")[0] for line in lines if line.endswith(f"\t{ref}")), "")


def _refuse_other(copy: Path, listed: str) -> None:
    """UsageError unless what git lists are the bytes of the copy, and nothing has changed them on the way."""
    blobs = dict(line.split("\t", 1)[::-1] for line in listed.split("\0") if line)
    for path in (path for path in copy.rglob("*") if path.is_file()):
        content, name = path.read_bytes(), path.relative_to(copy).as_posix()
        digest = hashlib.sha1(b"blob %d\0" % len(content) + content, usedforsecurity=False).hexdigest()
        if blobs.get(name, "").split()[-1:] != [digest]:
            raise UsageError(f"not published: git has not taken {name} as it is")


def without_password(text: str) -> str:
    """The same without what opens the addresses in it."""
    return re.sub(r"(?<=//)[^/\s]*@", "", text)


def _author(git: list[str]) -> dict[str, str]:
    """Name who git says commits in the project; make, where it can't say."""
    try:
        name, _, address = _run([*git, "var", "GIT_COMMITTER_IDENT"]).rpartition(">")[0].rpartition(" <")
    except UsageError:
        name, address = "make publish", "publish@localhost"
    return {"GIT_COMMITTER_NAME": name, "GIT_COMMITTER_EMAIL": address}


def to_rsync(copy: Path, place: str, site: Path) -> str:
    """Publish with rsync, to a folder of this or another machine or to a module of a daemon."""
    if ":" not in place:
        _refuse_inside(site, Path(os.path.abspath(place)))
    place = place.rstrip("/") + "/"
    there = _rsync_names(place)
    if there and MARK not in there:  # where there is no folder yet there is nothing
        raise UsageError(f"{place} holds something that was not published there; it was left alone")
    options = ["--recursive", "--times", "--perms", "--checksum", "--protect-args", "--delay-updates"]
    # Pages come last, so that what they show is there before them, and what nobody names any more goes after them.
    _run(["rsync", *options, "--exclude=*.html", f"{copy}/", place])
    _run(["rsync", *options, "--delete-delay", f"{copy}/", place])
    reading = ["--recursive", "--checksum", "--dry-run", "--itemize-changes", "--delete", "--protect-args"]
    if differs := _run(["rsync", *reading, f"{copy}/", place]):
        raise UsageError(f"{place} does not keep what is written there: {differs.splitlines()[0]}")
    return place


def _rsync_names(place: str) -> set[str]:
    try:
        listed = _run(["rsync", "--protect-args", "--list-only", place])
    except UsageError as error:
        if "No such file or directory" in str(error) or "change_dir" in str(error):
            return set()
        raise
    return {line.split(maxsplit=4)[4] for line in listed.splitlines() if len(line.split()) > 4} - {"."}


def _run(command: Sequence[str], settings: Mapping[str, str] | None = None) -> str:
    """Return what a program prints; UsageError, with the line that says why, when it fails or is not there."""
    name = "ghp-import" if "ghp_import" in command else command[0]
    own = {each: value for each, value in os.environ.items() if each not in OTHER_REPOSITORY}
    own |= {"GIT_TERMINAL_PROMPT": "0", "LC_ALL": "C", **(settings or {})}
    try:
        done = subprocess.run(command, input="", capture_output=True, text=True, errors="replace", env=own, check=False)
    except FileNotFoundError:
        raise UsageError(f"publishing there needs {name}, which is not there; TARGET=dir:PATH needs nothing") from None
    if done.returncode:
        said = [line.strip() for line in done.stderr.splitlines() if line.strip()]
        reason = said[0] if said else f"exit status {done.returncode}"
        raise UsageError(f"not published: {name}: {reason}")
    return done.stdout.strip()


TARGETS: dict[str, Callable[[Path, str, Path], str]] = {"dir": to_folder, "git": to_branch, "rsync": to_rsync}
