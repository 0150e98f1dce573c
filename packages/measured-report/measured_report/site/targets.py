"""Targets: where a checked copy of the site can be published, and how it gets there as a whole."""

import os
import re
import secrets
import shutil
import subprocess
import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path

from measured_report import UsageError
from measured_report.files.files import locked
from measured_report.files.staging import remove, replace
from measured_report.records.identity import files_digest

MARK = ".published"
"""A file of every copy that is published: only what has it is replaced."""
VERSION = re.compile(r"[0-9a-f]{16}")
UNFINISHED = re.compile(r"(new|link)-[0-9a-f]+")
BRANCH = "gh-pages"
SUBJECT = "The report, as make publish made it"


def to_folder(copy: Path, place: str, site: Path) -> str:
    """Publish to a folder of this machine.

    The path becomes a symbolic link. The versions lie beside it, in ``.<name>.versions/<digest>/``, and publishing
    replaces the link. The version before stays, for those who are reading it.
    """
    # Path.expanduser would raise for a user that does not exist.
    path = Path(os.path.abspath(os.path.expanduser(place)))  # noqa: PTH111
    versions = path.with_name(f".{path.name}.versions")
    if not path.name or not path.parent.is_dir():
        raise UsageError(f"TARGET=dir:{place}: there is no folder {path.parent}")
    if path.parent.resolve().joinpath(path.name).is_relative_to(site.resolve()):
        raise UsageError(f"TARGET=dir:{place} lies inside {site.name}/, which is rebuilt; use a place outside of it")
    _refuse_foreign(path, versions)
    was_there = versions.is_dir()
    versions.mkdir(exist_ok=True)
    try:
        with locked(versions):
            for left in versions.iterdir():
                if UNFINISHED.fullmatch(left.name):
                    remove(left)
            version = _put_version(copy, versions)
            _switch(path, version)
            _remove_old(versions, version)
    except BaseException:
        if not was_there:
            remove(versions)
        raise
    return str(path)


def _refuse_foreign(path: Path, versions: Path) -> None:
    """Only what is not there, is empty, or was published here before may be replaced."""
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
        replace(version, new)
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

    Neither the working tree nor the index nor any local branch is touched. A branch that holds something else is left
    alone.
    """
    remote, _, branch = place.partition("#")
    branch = branch or BRANCH
    git = _Git(site.parent)
    if remote not in git("remote").split() and not re.match(r"(https?|ssh|git|file)://|/|\.", remote):
        raise UsageError(f"TARGET=git:{place}: git knows no remote {remote}; TARGET=dir:PATH needs none")
    ref = f"refs/heads/{branch}"
    git("check-ref-format", "--branch", branch)
    before = git("ls-remote", remote, ref).partition("\t")[0]
    if before:
        git("fetch", "--quiet", "--no-tags", "--no-write-fetch-head", remote, ref)
        if not git("log", "-1", "--format=%s", before).startswith(SUBJECT):
            raise UsageError(
                f"the branch {branch} of {remote} holds something that was not published; it was left alone"
            )
    (copy / ".nojekyll").touch()
    with tempfile.TemporaryDirectory(prefix="publish-") as folder:
        with_index = {"GIT_INDEX_FILE": f"{folder}/index"}
        git("--work-tree", str(copy), "add", "--all", "--force", "--", str(copy), settings=with_index)
        tree = git("write-tree", settings=with_index)
    if before and git("rev-parse", f"{before}^{{tree}}") == tree:
        return f"{remote}, branch {branch}, as before"
    commit = git("commit-tree", tree, "-m", SUBJECT, settings=_author(git))
    git("push", "--quiet", f"--force-with-lease={ref}:{before}", remote, f"{commit}:{ref}")
    return f"{remote}, branch {branch}"


class _Git:
    """Git in one repository; what it has against something is said in one line."""

    def __init__(self, root: Path):
        self.root = root

    def __call__(self, *arguments: str, settings: Mapping[str, str] | None = None) -> str:
        environment = {**os.environ, "GIT_TERMINAL_PROMPT": "0", "LC_ALL": "C", **(settings or {})}
        # Set by a hook or another git, these would lead to another repository.
        for name in ("GIT_DIR", "GIT_WORK_TREE"):
            environment.pop(name, None)
        settled = ["-c", "core.autocrlf=false", "-c", "core.safecrlf=false"]
        return _run(["git", "-C", str(self.root), *settled, *arguments], "git", environment)


def _author(git: _Git) -> dict[str, str]:
    try:
        git("var", "GIT_COMMITTER_IDENT")
        return {}
    except UsageError:
        who = {"NAME": "make publish", "EMAIL": "publish@localhost"}
        return {f"GIT_{role}_{part}": value for role in ("AUTHOR", "COMMITTER") for part, value in who.items()}


def to_rsync(copy: Path, place: str, site: Path) -> str:
    """Publish with rsync, to a folder of this or another machine or to a module of a daemon."""
    place = place.rstrip("/") + "/"
    there = _rsync_names(place)
    if there and MARK not in there:
        raise UsageError(f"{place} holds something that was not published there; it was left alone")
    options = ["--recursive", "--times", "--perms", "--checksum", "--protect-args", "--delay-updates"]
    # Pages come last, so that what they show is there before them, and what nobody names any more goes after them.
    _run(["rsync", *options, "--exclude=*.html", f"{copy}/", place], "rsync")
    _run(["rsync", *options, "--delete-delay", f"{copy}/", place], "rsync")
    return place


def _rsync_names(place: str) -> set[str]:
    """What lies at a place already; nothing where there is no folder yet."""
    try:
        listed = _run(["rsync", "--protect-args", "--list-only", place], "rsync")
    except UsageError as error:
        if "No such file or directory" in str(error) or "change_dir" in str(error):
            return set()
        raise
    return {line.split(maxsplit=4)[4] for line in listed.splitlines() if len(line.split()) > 4} - {"."}


def _run(command: list[str], name: str, environment: Mapping[str, str] | None = None) -> str:
    """What a program prints; UsageError, with the line that says why, when it fails or is not there."""
    try:
        done = subprocess.run(
            command,
            capture_output=True,
            text=True,
            errors="replace",
            check=False,
            env=environment,
            stdin=subprocess.DEVNULL,
        )
    except FileNotFoundError:
        raise UsageError(f"publishing there needs {name}, which is not there; TARGET=dir:PATH needs nothing") from None
    if done.returncode:
        said = [line.strip() for line in done.stderr.splitlines() if line.strip()]
        raise UsageError(f"not published: {name}: {said[0] if said else f'exit status {done.returncode}'}")
    return done.stdout.strip()


TARGETS: dict[str, Callable[[Path, str, Path], str]] = {"dir": to_folder, "git": to_branch, "rsync": to_rsync}
"""How a copy gets to a place, by how the target begins."""
