"""Publishing: a checked copy of the site goes to a folder, to a branch of a git repository, or over rsync."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

from measured_report.files.atomic import locked
from measured_report.files.errors import ReportError, UsageError
from measured_report.files.staging import digests_below, replace, staging_folder
from measured_report.site.check import check_site

DEFAULT = "git:origin"
BRANCH = "gh-pages"
SUBJECT = "The report, as make publish made it"
SUMS = "SHA256SUMS"  # the file that names all others with their digests, as ``sha256sum --check`` reads it
MARK = ".published"  # a file of every copy that is published: only what has it is replaced
QUICK = '<meta name="profile" content="quick">'  # of a page of small grids and short runs
OF_ANOTHER_GIT = {"GIT_DIR", "GIT_WORK_TREE", "GIT_INDEX_FILE"}  # as a hook sets them


def publish(site: Path, target: str) -> str:
    """Put a checked copy of ``site`` at ``target`` and return where it lies; what can't be put there leaves nothing.

    A target is ``dir:PATH``, ``rsync:HOST:PATH`` or ``git:REMOTE#BRANCH``; empty: the branch gh-pages of origin.
    """
    scheme, _, place = (target or DEFAULT).partition(":")
    told = f"TARGET={without_password(target)}"
    if scheme not in TARGETS or not place or place.startswith("-") or "\0" in place:
        raise UsageError(f"{told!r} is no place to publish to; use TARGET=dir:PATH, rsync:HOST:PATH or git:REMOTE")
    try:
        with tempfile.TemporaryDirectory(prefix="publish-") as folder:
            copy = _checked_copy(site, Path(folder) / "site")
            return without_password(TARGETS[scheme](copy, place, site))
    except UsageError as error:
        raise UsageError(without_password(str(error))) from None
    except OSError as error:
        raise UsageError(f"{told}: {error.strerror or ' '.join(str(error).split())}") from None


def without_password(text: str) -> str:
    """Return a text without what opens the addresses in it."""
    return re.sub(r"(?<=//)[^/\s]*@", "", text)


def _checked_copy(site: Path, copy: Path) -> Path:
    """Copy the site; ReportError where anything is wrong with it. Anyone may read the copy, whatever the umask is."""
    with locked(site.parent, alone=False):  # not while it is being put in place
        if not (site / "index.html").is_file():
            raise UsageError(f"{site.name}/ holds no report; make report builds it")
        shutil.copytree(site, copy, symlinks=True)
    if problem := _change(copy):
        raise ReportError(f"not published: {site.name}/: {problem}; make report builds it again")
    if QUICK in (copy / "index.html").read_text(encoding="utf-8"):
        raise UsageError(f"{site.name}/ holds a quick look, not the report; make report builds that")
    if problems := check_site(copy):
        raise ReportError(f"not published, problems found: {len(problems)}; the first: {problems[0]}")
    (copy / MARK).write_text("what make publish made; it removes what else is here\n", encoding="utf-8")
    copy.chmod(0o755)
    for path in copy.rglob("*"):
        path.chmod(0o755 if path.is_dir() else 0o644)
    return copy


def _change(site: Path) -> str:
    """Say in what a site is not what its build made; nothing where it is."""
    if not (site / SUMS).is_file():
        return f"there is no {SUMS}"
    lines = (line.partition("  ") for line in (site / SUMS).read_text(encoding="utf-8").splitlines())
    told, there = {name: digest for digest, _, name in lines}, digests_below(site)
    links = {path.relative_to(site).as_posix() for path in site.rglob("*") if path.is_symlink()}
    others = {name for name in told | there if told.get(name) != there.get(name)} - {SUMS}
    return f"{min(links | others)} is not of the build" if links | others else ""


def _to_folder(copy: Path, place: str, site: Path) -> str:
    """Publish to a folder of this machine, which is replaced as a whole."""
    # Path.expanduser would raise for a user that does not exist.
    path = Path(os.path.abspath(os.path.expanduser(place)))  # noqa: PTH111
    if not path.name or not path.parent.is_dir():
        raise UsageError(f"TARGET=dir:{place}: there is no folder to put it into")
    _refuse_inside(site, path)
    is_empty = path.is_dir() and not any(path.iterdir())
    if path.is_symlink() or not (is_empty or not path.exists() or (path / MARK).is_file()):
        raise UsageError(f"{path} holds something that was not published here; it was left alone")
    with staging_folder(path) as fresh:
        shutil.copytree(copy, fresh)
        replace(path, fresh)
    return str(path)


def _refuse_inside(site: Path, path: Path) -> None:
    """Refuse a place that the next build removes."""
    place = path.parent.resolve() / path.name
    if place.is_relative_to(site.resolve()):
        raise UsageError(f"{path} lies where {site.name}/ is rebuilt; use a place outside of it")


def _to_branch(copy: Path, place: str, site: Path) -> str:
    """Publish to a branch of a remote of the project's git repository, as its one commit.

    The commit is made in a repository of its own, which is removed: neither the working tree nor the index nor any
    branch is touched. A branch that holds something else is left alone.
    """
    remote, _, branch = place.partition("#")
    branch = branch or BRANCH
    ref, there = f"refs/heads/{branch}", f"{remote}, branch {branch}"
    git = ["git", "-C", str(site.parent)]
    if Path(_run([*git, "rev-parse", "--show-toplevel"])) != site.parent.resolve():
        raise UsageError(f"{site.parent} is no git repository of its own; TARGET=dir:PATH needs none")
    tips = dict(line.split("\t")[::-1] for line in _run([*git, "ls-remote", remote, ref]).splitlines())
    before = tips.get(ref, "")
    if before:
        _run([*git, "fetch", "--quiet", "--no-tags", "--no-write-fetch-head", remote, ref])
        if _run([*git, "log", "-1", "--format=%s", before]) != SUBJECT:
            raise UsageError(f"the branch {branch} of {remote} holds something else; it was left alone")
    with tempfile.TemporaryDirectory(prefix="publish-") as folder:
        _run(["git", "init", "--quiet", "--bare", folder])
        importing = [sys.executable, "-m", "ghp_import", "--no-jekyll", "--branch", branch, "--message", SUBJECT]
        author = {"GIT_COMMITTER_NAME": "make publish", "GIT_COMMITTER_EMAIL": "publish@localhost"}
        _run([*importing, str(copy)], GIT_DIR=folder, **author)
        commit, tree = _run(["git", "-C", folder, "rev-parse", ref, f"{ref}^{{tree}}"]).split()
        if before and _run([*git, "rev-parse", f"{before}^{{tree}}"]) == tree:
            return f"{there}, as before"
        pushing = [*git, "push", "--quiet", f"--force-with-lease={ref}:{before}", remote, f"{commit}:{ref}"]
        _run(pushing, GIT_ALTERNATE_OBJECT_DIRECTORIES=f"{folder}/objects")
    return there


def _to_rsync(copy: Path, place: str, site: Path) -> str:
    """Publish with rsync, to a folder of this or another machine or to a module of a daemon."""
    if ":" not in place:
        _refuse_inside(site, Path(os.path.abspath(place)))
    place = place.rstrip("/") + "/"
    there = _rsync_names(place)
    if there and MARK not in there:
        raise UsageError(f"{place} holds something that was not published there; it was left alone")
    options = ["--recursive", "--times", "--perms", "--checksum", "--protect-args", "--delay-updates"]
    # Pages come last, so that what they show is there before them, and what nobody names any more goes after them.
    _run(["rsync", *options, "--exclude=*.html", f"{copy}/", place])
    _run(["rsync", *options, "--delete-delay", f"{copy}/", place])
    return place


def _rsync_names(place: str) -> set[str]:
    """List what lies in a place; nothing where there is no folder yet."""
    try:
        listed = _run(["rsync", "--protect-args", "--list-only", place])
    except UsageError as error:
        if "No such file or directory" in str(error) or "change_dir" in str(error):
            return set()
        raise
    return {line.split(maxsplit=4)[4] for line in listed.splitlines() if len(line.split()) > 4} - {"."}


def _run(command: Sequence[str], **settings: str) -> str:
    """Return what a program prints; UsageError, with the line that says why, when it fails or is not there."""
    name = "ghp-import" if "ghp_import" in command else command[0]
    own = {each: value for each, value in os.environ.items() if each not in OF_ANOTHER_GIT}
    own |= {"GIT_TERMINAL_PROMPT": "0", "LC_ALL": "C", **settings}
    try:
        done = subprocess.run(command, input="", capture_output=True, text=True, errors="replace", env=own, check=False)
    except FileNotFoundError:
        raise UsageError(f"publishing there needs {name}, which is not there; TARGET=dir:PATH needs nothing") from None
    if done.returncode:
        said = [line.strip() for line in done.stderr.splitlines() if line.strip()]
        raise UsageError(f"not published: {name}: {said[0] if said else f'exit status {done.returncode}'}")
    return done.stdout.strip()


TARGETS = {"dir": _to_folder, "git": _to_branch, "rsync": _to_rsync}
