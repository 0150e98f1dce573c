"""Check site/ and put it at TARGET, or on the branch gh-pages of git's origin."""

import dataclasses
import os
import shutil
from collections.abc import Callable
from functools import partial
from pathlib import Path

from measured_report.commands.options import Arguments, shared
from measured_report.commands.page import build_site
from measured_report.editions.project import Project
from measured_report.files.atomic import (
    digests_below,
    locked,
    put_in_place,
    staging_folder,
    sums,
    write_file,
)
from measured_report.files.errors import ReportError, UsageError, without_secrets
from measured_report.files.git import run_git
from measured_report.records.replicas import SUMS
from measured_report.site.check import check_site

OPTIONS = {
    "target": {"default": "", "help": "where to publish: dir:PATH or git:REMOTE"},
    **shared("address"),
}
DEFAULT, BRANCH = "git:origin", "gh-pages"
SUBJECT = "The report, as make publish made it"
MARK = (
    ".published"  # a file of every copy that is published: only what has it is replaced
)
ASIDE = ".site-copy"  # a folder beside the site, where the copy lies meanwhile
DOMAIN = "CNAME"  # a file that GitHub keeps on the branch
ALONE = (
    "core.autocrlf=false",
    "core.bare=false",
    "push.followTags=false",
    "push.recurseSubmodules=no",
)
AUTHOR = {
    f"GIT_{role}_{field}": value
    for role in ("AUTHOR", "COMMITTER")
    for field, value in (("NAME", "make publish"), ("EMAIL", "publish@localhost"))
}
PROTOCOLS = "file:git:http:https:ssh"
QUICK = (
    '<meta name="profile" content="quick">'  # of a page of small grids and short runs
)


def run(project: Project, arguments: Arguments) -> int:
    """Build the site, where something that it is made from has changed, and publish it; 1 where a record is damaged."""
    page, is_damaged = project.site / "index.html", False
    if page.is_file():
        profile = "quick" if QUICK.encode() in page.read_bytes() else project.profile
        is_damaged, _ = build_site(
            dataclasses.replace(project, profile=profile), arguments.address
        )
    print(f"published at {publish(project.site, arguments.target)}")
    return int(is_damaged)


def publish(site: Path, target: str) -> str:
    """Put a checked copy of ``site`` at ``dir:PATH`` or ``git:REMOTE#BRANCH``, whole, and return where it lies."""
    scheme, _, location = (target or DEFAULT).partition(":")
    option = f"TARGET={target}"
    if (
        scheme not in TARGETS
        or not location
        or location.startswith("-")
        or "\0" in location
    ):
        raise UsageError(
            f"{option!r} is no place to publish to; use TARGET=dir:PATH or git:REMOTE"
        )
    try:
        (site.parent / ASIDE).mkdir(exist_ok=True)
        with staging_folder(
            site.parent / ASIDE / "copy"
        ) as folder:  # what a killed one has left goes now
            return without_secrets(
                TARGETS[scheme](_checked_copy(site, folder / "site"), location, site)
            )
    except OSError as error:
        raise UsageError(
            f"{option}: {error.strerror or ' '.join(str(error).split())}"
        ) from None


def _checked_copy(site: Path, copy: Path) -> Path:
    """Copy the site; ReportError where anything is wrong with it. Anyone may read the copy, whatever the umask is."""
    if not (site / "index.html").is_file():
        raise UsageError(f"{site.name}/ holds no report; make report builds it")
    with locked(site.parent, alone=False):  # not while it is being put in place
        digests = digests_below(site)
        if not digests.pop(SUMS, "") or (site / SUMS).read_text(
            encoding="utf-8", errors="replace"
        ) != sums(digests):
            raise ReportError(
                f"not published: {site.name}/ is not as it was built; make report builds it again"
            )
        shutil.copytree(site, copy)
    if QUICK.encode() in (copy / "index.html").read_bytes():
        raise UsageError(
            f"{site.name}/ holds a quick look, not the report; make report builds that"
        )
    if problems := check_site(copy):
        raise ReportError(
            f"not published, problems found: {len(problems)}; the first: {problems[0]}"
        )
    write_file(copy / MARK, "what make publish made; it removes what else is here\n")
    for path in (copy, *copy.rglob("*")):
        path.chmod(0o755 if path.is_dir() else 0o644)
    return copy


def _to_folder(copy: Path, location: str, site: Path) -> str:
    # Path.expanduser would raise for a user that does not exist.
    path = Path(os.path.abspath(os.path.expanduser(location)))  # noqa: PTH111
    if not path.name or not path.parent.is_dir():
        raise UsageError(f"TARGET=dir:{location}: there is no folder to put it into")
    is_free = not path.exists() or (path.is_dir() and not any(path.iterdir()))
    if path.is_symlink() or not (is_free or (path / MARK).is_file()):
        raise UsageError(
            f"{path} holds something that was not published here; it was left alone"
        )
    with staging_folder(path) as fresh:
        shutil.copytree(copy, fresh)
        put_in_place(path, fresh)
    return str(path)


def _to_branch(copy: Path, location: str, site: Path) -> str:
    """Publish to a branch of a remote, as its one commit, made in the copy and pushed by address."""
    if not shutil.which("git"):
        raise UsageError(
            "publishing there needs git, which is not there; TARGET=dir:PATH needs nothing"
        )
    try:
        return _pushed(copy, location, site.parent)
    except UsageError as error:
        raise UsageError(f"not published: {error}") from None


def _pushed(copy: Path, location: str, root: Path) -> str:
    remote, _, branch = location.partition("#")
    branch = branch or BRANCH
    ref = f"refs/heads/{branch}"
    here = partial(run_git, root)
    if Path(here("rev-parse", "--show-toplevel")) != root.resolve():
        raise UsageError(
            f"{root} is no git repository of its own; TARGET=dir:PATH needs none"
        )
    is_plain = here("check-ref-format", "--branch", branch) == branch
    if not is_plain or branch.startswith(("@", "refs/")):
        raise UsageError(f"{branch} is no name for a branch")
    is_named = remote in here("remote").splitlines()
    address = here("remote", "get-url", "--push", remote) if is_named else remote
    # The clone's settings say who pushes, and nothing else.
    config = root / here("rev-parse", "--git-path", "config")
    settings = [f"include.path={config}", *ALONE]
    options = [option for setting in settings for option in ("-c", setting)]
    there = partial(run_git, copy, *options, GIT_ALLOW_PROTOCOL=PROTOCOLS, **AUTHOR)
    there("init", "--quiet")
    before = _tip(there, address, ref)
    if before:
        there("fetch", "--quiet", "--depth", "1", "--no-tags", address, ref)
        names = there("ls-tree", "--name-only", before).splitlines()
        if MARK not in names:
            raise UsageError(
                f"the branch {branch} of {remote} holds something else; it was left alone"
            )
        if DOMAIN in names and not (copy / DOMAIN).exists():
            write_file(copy / DOMAIN, there("show", f"{before}:{DOMAIN}") + "\n")
    write_file(copy / ".nojekyll", "")
    there("add", "--all", "--force")
    there("commit", "--quiet", "--no-gpg-sign", "--message", SUBJECT)
    commit = there("rev-parse", "HEAD")
    lease = f"--force-with-lease={ref}:{before}"
    there("push", "--quiet", lease, address, f"{commit}:{ref}")
    if _tip(there, address, ref) != commit:
        raise ReportError(
            f"not published: {remote} does not have it on its branch {branch}"
        )
    return f"{remote}, branch {branch}"


def _tip(git: Callable[..., str], address: str, ref: str) -> str:
    """Return the commit that a branch of a remote is at; empty if it has none."""
    for line in git("ls-remote", address, ref).splitlines():
        tip, name = line.split("\t")
        if name == ref:
            return tip
    return ""


TARGETS = {"dir": _to_folder, "git": _to_branch}
