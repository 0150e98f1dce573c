"""Check site/ and publish it to TARGET (default: branch gh-pages of git's origin)."""

import dataclasses
import html
import os
import re
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
from measured_report.files.git import WITHOUT_HOOKS, run_git
from measured_report.records.replicas import SUMS
from measured_report.site.check import check_site

OPTIONS = {
    "target": {
        "default": "",
        "help": "place to publish to: dir:PATH or git:REMOTE#BRANCH",
    },
    **shared("address"),
}
DEFAULT = "git:origin"
BRANCH = "gh-pages"
SUBJECT = "Publish the report with make publish"
# A file in every published copy; folders and branches without it are not replaced.
MARK = ".published"
ASIDE = ".site-copy"  # a folder beside the site for the temporary copy
DOMAIN = "CNAME"  # a file of GitHub that stays on the branch
# Settings of the clone that must not apply to the copy.
OVERRIDES = (
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
PROTOCOLS = "file:git:http:https:ssh"  # without ext, which runs a command
# Marks a page that shows small grids and short runs.
QUICK = '<meta name="profile" content="quick">'
CANONICAL = re.compile('<link rel="canonical" href="([^"]*)index.html">')


def run(project: Project, arguments: Arguments) -> int:
    """Build the site again if it exists, and publish it.

    Return 1 if a record cannot be read or shown.
    """
    page = project.site / "index.html"
    is_damaged = False
    if page.is_file():
        profile = "quick" if QUICK.encode() in page.read_bytes() else project.profile
        is_damaged, _ = build_site(
            dataclasses.replace(project, profile=profile),
            arguments.address or _address_of(page),
        )
    print(f"published at {publish(project.site, arguments.target)}")
    return int(is_damaged)


def _address_of(page: Path) -> str:
    """Return the canonical address of a built page, or an empty string."""
    match = CANONICAL.search(page.read_text(encoding="utf-8", errors="replace"))
    return html.unescape(match[1]) if match else ""


def publish(site: Path, target: str) -> str:
    """Put a checked copy of ``site`` at its target and return the place.

    The target is ``dir:PATH`` or ``git:REMOTE#BRANCH``. Readers of the target get either
    the previous site or the complete new one.
    """
    scheme, _, location = (target or DEFAULT).partition(":")
    option = f"TARGET={target}"
    if (
        scheme not in TARGETS
        or not location
        or location.startswith("-")
        or "\0" in location
    ):
        raise UsageError(
            f"{option!r} is not a place to publish to: use TARGET=dir:PATH or "
            "git:REMOTE#BRANCH"
        )
    try:
        (site.parent / ASIDE).mkdir(exist_ok=True)
        # This also removes the copy of a command that was killed.
        with staging_folder(site.parent / ASIDE / "copy") as folder:
            return without_secrets(
                TARGETS[scheme](_checked_copy(site, folder / "site"), location, site)
            )
    except UsageError as error:
        raise UsageError(f"not published: {error}") from None
    except OSError as error:
        raise UsageError(
            f"{option}: {error.strerror or ' '.join(str(error).split())}"
        ) from None


def _checked_copy(site: Path, copy: Path) -> Path:
    """Copy the site and check the copy; raise ReportError if there is a problem.

    Everyone can read the copy, even if the umask is strict.
    """
    if not (site / "index.html").is_file():
        raise UsageError(
            f"{site.name}/ does not contain a report: build it with make report"
        )
    # The lock keeps other processes from replacing the site during the copy.
    with locked(site.parent, alone=False):
        digests = digests_below(site)
        if not digests.pop(SUMS, "") or (site / SUMS).read_text(
            encoding="utf-8", errors="replace"
        ) != sums(digests):
            raise ReportError(
                f"not published, because {site.name}/ was changed after it was "
                "built: build it again with make report"
            )
        shutil.copytree(site, copy)
    if QUICK.encode() in (copy / "index.html").read_bytes():
        raise UsageError(
            f"{site.name}/ contains quick measurements only: build the report with "
            "make report"
        )
    if problems := check_site(copy):
        raise ReportError(
            f"not published, because the check found {len(problems)} problems: fix "
            f"them, starting with {problems[0]}"
        )
    write_file(
        copy / MARK,
        "make publish wrote this folder and will remove any other file in it\n",
    )
    for path in (copy, *copy.rglob("*")):
        path.chmod(0o755 if path.is_dir() else 0o644)
    return copy


def _to_folder(copy: Path, location: str, site: Path) -> str:
    # Path.expanduser raises an error for a user that does not exist.
    path = Path(os.path.abspath(os.path.expanduser(location)))  # noqa: PTH111
    if not path.name or not path.parent.is_dir():
        raise UsageError(
            f"TARGET=dir:{location}: the parent folder does not exist: create it first"
        )
    if path.resolve().is_relative_to(site.resolve()):
        raise UsageError(
            f"TARGET=dir:{location} is inside {site.name}/, which every build "
            "replaces: use a folder outside of it"
        )
    is_free = not path.exists() or (path.is_dir() and not any(path.iterdir()))
    if path.is_symlink() or not (is_free or (path / MARK).is_file()):
        raise UsageError(
            f"{path} contains files that make publish did not write: use an empty "
            "folder"
        )
    with staging_folder(path) as fresh:
        shutil.copytree(copy, fresh)
        put_in_place(path, fresh)
    return str(path)


def _to_branch(copy: Path, location: str, site: Path) -> str:
    """Publish a copy as the only commit on a branch of a remote.

    The commit is made in the copy and pushed to the address of the remote.
    """
    root = site.parent
    remote, _, branch = location.partition("#")
    branch = branch or BRANCH
    ref = f"refs/heads/{branch}"
    run_in_clone = partial(run_git, root)
    if Path(run_in_clone("rev-parse", "--show-toplevel")) != root.resolve():
        raise UsageError(
            f"{root} is not the root of a git repository: use TARGET=dir:PATH"
        )
    is_plain = run_in_clone("check-ref-format", "--branch", branch) == branch
    if not is_plain or branch.startswith(("@", "refs/")):
        raise UsageError(
            f"{branch} is not a valid branch name: use TARGET=git:REMOTE#BRANCH"
        )
    address = remote
    if remote in run_in_clone("remote").splitlines():
        address = run_in_clone("remote", "get-url", "--push", "--all", remote)
    if "\n" in address:
        raise UsageError(
            f"{remote} has several addresses to push to: publish to each of them with "
            f"TARGET=git:ADDRESS#{branch}"
        )
    if (root / address).exists():  # a relative path, which the copy would not find
        address = str((root / address).resolve())
    # Use the clone's settings to authenticate, and override settings that affect the
    # copy. They may name a folder of hooks.
    config = root / run_in_clone("rev-parse", "--git-path", "config")
    settings = [f"include.path={config}", *WITHOUT_HOOKS, *OVERRIDES]
    options = [option for setting in settings for option in ("-c", setting)]
    run_in_copy = partial(
        run_git, copy, *options, GIT_ALLOW_PROTOCOL=PROTOCOLS, **AUTHOR
    )
    run_in_copy("init", "--quiet")
    before = _tip(run_in_copy, address, ref)
    if before:
        run_in_copy("fetch", "--quiet", "--depth", "1", "--no-tags", address, ref)
        names = run_in_copy("ls-tree", "--name-only", before).splitlines()
        if MARK not in names:
            raise UsageError(
                f"the branch {branch} of {remote} has files that make publish did "
                "not write: use another branch"
            )
        if DOMAIN in names and not (copy / DOMAIN).exists():
            run_in_copy("checkout", before, "--", DOMAIN)
    write_file(copy / ".nojekyll", "")
    run_in_copy("add", "--all", "--force")
    run_in_copy("commit", "--quiet", "--no-gpg-sign", "--message", SUBJECT)
    commit = run_in_copy("rev-parse", "HEAD")
    lease = f"--force-with-lease={ref}:{before}"
    run_in_copy("push", "--quiet", lease, address, f"{commit}:{ref}")
    if _tip(run_in_copy, address, ref) != commit:
        raise ReportError(
            f"not published, because {remote} does not have the new commit on the "
            f"branch {branch}: run make publish again"
        )
    return f"{remote}, branch {branch}"


def _tip(git: Callable[..., str], address: str, ref: str) -> str:
    """Return the newest commit on a remote branch, or an empty string."""
    for line in git("ls-remote", address, ref).splitlines():
        tip, name = line.split("\t")
        if name == ref:
            return tip
    return ""


TARGETS = {"dir": _to_folder, "git": _to_branch}
