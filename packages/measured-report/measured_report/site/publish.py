"""Publishing: a checked copy of the site goes to a folder, or to a branch of a git repository."""

import os
import re
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path

from measured_report.files.atomic import digests_below, locked, replace, staging_folder, sums
from measured_report.files.errors import ReportError, UsageError
from measured_report.records.replicas import SUMS
from measured_report.site.check import check_site

DEFAULT = "git:origin"
BRANCH = "gh-pages"
SUBJECT = "The report, as make publish made it"
MARK = ".published"  # a file of every copy that is published: only what has it is replaced
ASIDE = ".site-copy"  # a folder beside the site, where the copy lies meanwhile
QUICK = '<meta name="profile" content="quick">'  # of a page of small grids and short runs


def publish(site: Path, target: str) -> str:
    """Put a checked copy of ``site`` at ``dir:PATH`` or ``git:REMOTE#BRANCH``, whole, and return where it lies."""
    scheme, _, place = (target or DEFAULT).partition(":")
    told = f"TARGET={without_password(target)}"
    if scheme not in TARGETS or not place or place.startswith("-") or "\0" in place:
        raise UsageError(f"{told!r} is no place to publish to; use TARGET=dir:PATH or git:REMOTE")
    try:
        (site.parent / ASIDE).mkdir(exist_ok=True)
        with staging_folder(site.parent / ASIDE / "copy") as folder:  # what a killed one has left goes now
            copy = _checked_copy(site, folder / "site")
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
    if not (site / "index.html").is_file():
        raise UsageError(f"{site.name}/ holds no report; make report builds it")
    with locked(site.parent, alone=False):  # not while it is being put in place
        there = digests_below(site)
        if not there.pop(SUMS, "") or (site / SUMS).read_text(encoding="utf-8", errors="replace") != sums(there):
            raise ReportError(f"not published: {site.name}/ is not as it was built; make report builds it again")
        shutil.copytree(site, copy)
    if QUICK.encode() in (copy / "index.html").read_bytes():
        raise UsageError(f"{site.name}/ holds a quick look, not the report; make report builds that")
    if problems := check_site(copy):
        raise ReportError(f"not published, problems found: {len(problems)}; the first: {problems[0]}")
    (copy / MARK).write_text("what make publish made; it removes what else is here\n", encoding="utf-8")
    for path in (copy, *copy.rglob("*")):
        path.chmod(0o755 if path.is_dir() else 0o644)
    return copy


def _to_folder(copy: Path, place: str, site: Path) -> str:
    # Path.expanduser would raise for a user that does not exist.
    path = Path(os.path.abspath(os.path.expanduser(place)))  # noqa: PTH111
    if not path.name or not path.parent.is_dir():
        raise UsageError(f"TARGET=dir:{place}: there is no folder to put it into")
    is_empty = path.is_dir() and not any(path.iterdir())
    if path.is_symlink() or not (is_empty or not path.exists() or (path / MARK).is_file()):
        raise UsageError(f"{path} holds something that was not published here; it was left alone")
    with staging_folder(path) as fresh:
        shutil.copytree(copy, fresh)
        replace(path, fresh)
    return str(path)


def _to_branch(copy: Path, place: str, site: Path) -> str:
    """Publish to a branch of a remote, as its one commit, made in a repository of its own and pushed by address."""
    remote, _, branch = place.partition("#")
    branch = branch or BRANCH
    ref, git, aside = f"refs/heads/{branch}", ["git", "-C", str(site.parent)], copy.with_name("git")
    if Path(_run([*git, "rev-parse", "--show-toplevel"])) != site.parent.resolve():
        raise UsageError(f"{site.parent} is no git repository of its own; TARGET=dir:PATH needs none")
    if _run(["git", "check-ref-format", "--branch", branch]) != branch or branch.startswith(("@", "refs/")):
        raise UsageError(f"{branch} is no name for a branch")
    is_named = remote in _run([*git, "remote"]).splitlines()
    address = _run([*git, "remote", "get-url", "--push", remote]) if is_named else remote
    _run(["git", "init", "--quiet", "--bare", str(aside)])
    own = site.parent / _run([*git, "rev-parse", "--git-path", "objects"])
    (aside / "objects/info/alternates").write_text(f"{own}\n", encoding="utf-8")
    kept_aside = {"GIT_OBJECT_DIRECTORY": f"{aside}/objects"}
    tips = (line.split("\t") for line in _run([*git, "ls-remote", address, ref]).splitlines())
    before = next((tip for tip, name in tips if name == ref), "")
    if before:
        fetching = ["fetch", "--quiet", "--no-tags", "--no-write-fetch-head", "--no-auto-maintenance", address, ref]
        _run([*git, *fetching], **kept_aside)
        if " blob " not in _run([*git, "ls-tree", before, MARK], **kept_aside):
            raise UsageError(f"the branch {branch} of {remote} holds something else; it was left alone")
    importing = [sys.executable, "-m", "ghp_import", "--no-jekyll", "--branch", branch, "--message", SUBJECT]
    author = {"GIT_COMMITTER_NAME": "make publish", "GIT_COMMITTER_EMAIL": "publish@localhost"}
    _run([*importing, str(copy)], GIT_DIR=str(aside), **author)
    commit = _run(["git", "-C", str(aside), "rev-parse", ref])
    _run([*git, "push", "--quiet", f"--force-with-lease={ref}:{before}", address, f"{commit}:{ref}"], **kept_aside)
    return f"{remote}, branch {branch}"


def _run(command: Sequence[str], **settings: str) -> str:
    name = "ghp-import" if "ghp_import" in command else command[0]
    quiet = {"GIT_TERMINAL_PROMPT": "0", "GIT_ALLOW_PROTOCOL": "file:git:http:https:ssh", "LC_ALL": "C"}
    own = {**os.environ, **quiet, **settings}
    try:
        done = subprocess.run(command, input="", capture_output=True, text=True, errors="replace", env=own, check=False)
    except FileNotFoundError:
        raise UsageError(f"publishing there needs {name}, which is not there; TARGET=dir:PATH needs nothing") from None
    if done.returncode:
        said = [line.strip() for line in done.stderr.splitlines() if line.strip()]
        raise UsageError(f"not published: {name}: {said[0] if said else f'exit status {done.returncode}'}")
    return done.stdout.strip()


TARGETS = {"dir": _to_folder, "git": _to_branch}
