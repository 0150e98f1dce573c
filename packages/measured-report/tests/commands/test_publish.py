"""Test that a site is published completely or not at all, into a folder or onto a
branch, and that no other file changes.
"""

import os
import re
import shutil
import signal
from argparse import Namespace
from dataclasses import replace
from pathlib import Path

import pytest
from toys import ROWS, git

from measured_report.commands import publish as publishing
from measured_report.commands.publish import SUMS, publish, sums
from measured_report.files.atomic import digests_below
from measured_report.files.errors import ReportError, UsageError
from measured_report.site.build import build
from measured_report.site.check import check_site

pytestmark = pytest.mark.usefixtures("built")


@pytest.fixture
def place(toy, tmp_path) -> Path:
    """Return the folder with the published site."""
    publish(toy.project.site, f"dir:{tmp_path / 'www'}")
    return tmp_path / "www"


def change(toy, slip_mm: float = 5.0) -> None:
    """Build another site."""
    toy.measure([{**ROWS[0], "slip_mm": slip_mm}, ROWS[1]])
    toy.build()


def test_publishing_replaces_the_folder_that_was_published(toy, place):
    assert check_site(place) == []
    (place / "old.html").write_text("old")
    change(toy)
    publish(toy.project.site, f"dir:{place}")
    assert (place / "cause.html").read_text() == toy.page and not (
        place / "old.html"
    ).exists()
    assert check_site(place) == [] and [
        path.name for path in place.parent.iterdir() if "www" in path.name
    ] == ["www"]


def test_what_changed_since_is_built_before_it_is_published(toy, tmp_path, capsys):
    asked = Namespace(target=f"dir:{tmp_path / 'www'}", address="https://example.org/")
    for sentence, status in (("Another sentence.", 0), ("One more.", 1)):
        toy.write("templates/story.md.j2", f"# The story\n\n{sentence}\n")
        assert publishing.run(toy.project, asked) == status
        text = (tmp_path / "www/index.html").read_text()
        assert sentence in text and "https://example.org/index.html" in text
        toy.record_path.with_name("edition.toml").write_text(
            "{"
        )  # the message names it
    assert "damaged: newton-1.4.0/edition.toml" in capsys.readouterr().err
    quick = replace(toy.project, profile="quick")
    replace(toy, project=quick).measure()
    build(quick)
    with pytest.raises(UsageError, match="quick measurements only"):
        publishing.run(toy.project, asked)


def test_publishing_keeps_the_address_that_the_site_was_built_with(toy, tmp_path):
    """Test that the workflow publishes without repeating the address."""
    address = "https://example.org/a&b/"
    build(toy.project, address)
    asked = Namespace(target=f"dir:{tmp_path / 'www'}", address="")
    for sentence in ("", "Another sentence."):
        toy.write("templates/story.md.j2", f"# The story\n\n{sentence}\n")
        assert publishing.run(toy.project, asked) == 0
        assert (tmp_path / "www/feed.xml").is_file()
        text = (tmp_path / "www/index.html").read_text()
        assert 'rel="canonical" href="https://example.org/a&amp;b/index.html"' in text


def test_what_was_not_published_here_is_left_alone(toy, tmp_path):
    letter = written_by_the_user(tmp_path / "mine")
    (tmp_path / "link").symlink_to(tmp_path / "mine")
    targets = [
        f"dir:{tmp_path}/{name}" for name in ("mine", "link", "no/where", "long" * 64)
    ]
    for target in (
        *targets,
        "dir:/proc/www",
        "dir:~no-one/www",
        "dir:/",
        "dir:",
        "ftp:x",
        "",
    ):
        with pytest.raises(UsageError) as error:
            publish(toy.project.site, target)
        assert "\n" not in str(error.value)
    assert letter.read_text() == "dear" and (tmp_path / "link").is_symlink()


def written_by_the_user(folder: Path) -> Path:
    folder.mkdir()
    (folder / "letter.txt").write_text("dear")
    return folder / "letter.txt"


def test_an_empty_folder_may_become_the_site_and_what_is_published_can_be_read_by_all(
    toy, tmp_path
):
    (tmp_path / "www").mkdir(mode=0o700)
    publish(toy.project.site, f"dir:{tmp_path}/www")
    assert check_site(tmp_path / "www") == []
    modes = {
        path.is_dir(): path.stat().st_mode & 0o777
        for path in (tmp_path / "www").rglob("*")
    }
    assert (
        modes == {True: 0o755, False: 0o644}
        and (tmp_path / "www").stat().st_mode & 0o777 == 0o755
    )


def spoil(site: Path, more: bytes = b'<a href="x">x</a>') -> None:
    """Add a broken link to a page, as if the build had written it."""
    index = site / "index.html"
    index.write_bytes(index.read_bytes() + more)
    (site / SUMS).write_text(
        sums(
            {
                path: digest
                for path, digest in digests_below(site).items()
                if path != SUMS
            }
        )
    )


DAMAGES = {
    "replaced": lambda site: (site / "license.txt").write_text(
        "<script>alert(1)</script>"
    ),
    "stranger": lambda site: (site / "more.html").write_text("more"),
    "link": lambda site: (site / "passwd").symlink_to("/etc/passwd"),
    "folder": lambda site: (site / "all").symlink_to("/"),
    "no sums": lambda site: (site / SUMS).unlink(),
    "sums of bytes": lambda site: (site / SUMS).write_bytes(b"\xff"),
    "pipe": lambda site: os.mkfifo(site / "pipe"),
    "problem": spoil,
    "bytes": lambda site: spoil(site, b"\xff"),
}


@pytest.mark.parametrize("damage", DAMAGES.values(), ids=DAMAGES)
def test_only_what_the_build_made_and_the_check_passes_is_published(toy, place, damage):
    before = digests_below(place)
    damage(toy.project.site)
    with pytest.raises(ReportError, match=r"^not published[^\n]+$"):
        publish(toy.project.site, f"dir:{place}")
    assert digests_below(place) == before


@pytest.fixture
def remote(toy, tmp_path) -> Path:
    """Return a bare repository that is the origin of the project's repository."""
    bare = tmp_path / "bare.git"
    bare.mkdir()
    git(bare, "init", "--quiet", "--bare")
    root = toy.project.root
    (root / ".gitignore").write_text("/site/*\n/.cache/\n")
    for words in (
        "init --quiet",
        "add .",
        "commit --quiet -m a",
        f"remote add origin {bare}",
    ):
        git(root, *words.split())
    return bare


def test_publishing_to_a_branch_is_one_commit_and_touches_nothing_else(
    toy, remote, tmp_path
):
    root = toy.project.root
    git(
        root, "push", "--quiet", "origin", "HEAD:refs/backup/refs/heads/gh-pages"
    )  # the end of its name is the same
    before = [
        git(root, *arguments)
        for arguments in (("status", "--short"), ("rev-parse", "HEAD"), ("branch",))
    ]
    assert publish(toy.project.site, "") == "origin, branch gh-pages"
    change(toy)
    publish(toy.project.site, "")
    assert git(remote, "rev-list", "--count", "gh-pages") == "1"
    git(root, "checkout", "--quiet", "--", "results")
    after = [
        git(root, *arguments)
        for arguments in (("status", "--short"), ("rev-parse", "HEAD"), ("branch",))
    ]
    assert before == after
    there = tmp_path / "there"
    git(tmp_path, "clone", "--quiet", "--branch", "gh-pages", str(remote), str(there))
    assert (there / "cause.html").read_text() == toy.page and check_site(there) == []


@pytest.mark.parametrize("is_named", [True, False])
def test_a_relative_remote_is_found_from_any_folder(
    toy, remote, tmp_path, monkeypatch, is_named
):
    """Test a path that git reads relative to the folder in which it runs."""
    root = toy.project.root
    address = os.path.relpath(remote, root)
    git(root, "remote", "set-url", "origin", address if is_named else "/nowhere")
    monkeypatch.chdir(tmp_path)
    publish(toy.project.site, "" if is_named else f"git:{address}")
    assert git(remote, "rev-list", "--count", "gh-pages") == "1"


def test_two_addresses_to_push_to_are_one_line(toy, remote, tmp_path):
    root = toy.project.root
    for address in (remote, tmp_path / "other.git"):
        git(root, "remote", "set-url", "--add", "--push", "origin", str(address))
    with pytest.raises(UsageError, match="origin has several addresses to push to: "):
        publish(toy.project.site, "")
    assert git(remote, "for-each-ref") == ""


@pytest.mark.parametrize("name", ["www", "figures/www", ""])
def test_the_site_is_not_published_into_itself(toy, tmp_path, name):
    (tmp_path / "alias").symlink_to(toy.project.site)
    for site in (toy.project.site, tmp_path / "alias"):
        with pytest.raises(UsageError, match="is inside site/, which every build"):
            publish(toy.project.site, f"dir:{site / name}")


@pytest.fixture(params=["worktree", "shallow"])
def clone(request, toy, remote, tmp_path) -> Path:
    """Return a copy of the project and its site, made as git makes copies."""
    root, there = toy.project.root, tmp_path / "copy"
    git(root, "push", "--quiet", "origin", "HEAD:refs/heads/main")
    git(remote, "symbolic-ref", "HEAD", "refs/heads/main")
    if request.param == "worktree":
        git(root, "worktree", "add", "--quiet", str(there))
    else:
        git(tmp_path, "clone", "--quiet", "--depth", "1", remote.as_uri(), str(there))
    shutil.copytree(toy.project.site, there / "site", dirs_exist_ok=True)
    return there


def test_publishing_leaves_a_clone_whole_whoever_publishes_next(toy, remote, clone):
    root = toy.project.root
    before = [git(clone, *words) for words in (("for-each-ref",), ("count-objects",))]
    publish(clone / "site", "")
    assert [
        git(clone, *words) for words in (("for-each-ref",), ("count-objects",))
    ] == before
    change(toy)
    publish(toy.project.site, "")  # by another user
    for words in (
        "fsck --strict",
        "gc --quiet --prune=now",
        "log --all",
        "fetch --quiet",
        "fsck --strict",
    ):
        git(clone, *words.split())
    publish(clone / "site", "")
    assert (
        git(clone, "status", "--short") == ""
        and git(remote, "rev-list", "--count", "gh-pages") == "1"
    )
    git(remote, "config", "receive.denyNonFastForwards", "true")
    with pytest.raises(UsageError, match=r"^not published: git: .*non-fast-forward.*$"):
        publish(root / "site", "")
    git(root, "fsck", "--strict")


def test_finding_8_a_report_inside_another_repository_is_not_pushed_to_its_origin(
    toy, remote, tmp_path
):
    inner = toy.project.root / "inner"
    shutil.copytree(toy.project.site, inner / "site")
    with pytest.raises(UsageError, match="is not the root of a git repository"):
        publish(inner / "site", "")
    assert git(remote, "for-each-ref") == ""


@pytest.mark.parametrize(
    "target",
    [
        "git:https://someone:secr@et@there/x.git",
        "ftp:https://someone:secret@there/x.git",
        "dir:https://someone:secret@there/www",
    ],
)
def test_finding_8_a_token_is_not_printed(toy, remote, monkeypatch, target):
    settings = {
        "COUNT": "1",
        "KEY_0": f"url.{remote.parent}/.insteadOf",
        "VALUE_0": "https://someone:secr@et@there/",
    }
    for name, value in settings.items():
        monkeypatch.setenv(f"GIT_CONFIG_{name}", value)
    remote.rename(remote.with_name("x.git"))
    try:
        said = publish(toy.project.site, target)
    except UsageError as error:
        said = str(error)
    assert "://there/" in said and "et@" not in said


def test_a_branch_that_holds_something_else_is_left_alone(toy, remote):
    git(
        toy.project.root,
        "push",
        "--quiet",
        "origin",
        "HEAD:refs/heads/gh-pages",
        "HEAD:refs/heads/main",
    )
    before = git(remote, "for-each-ref")
    for target in ("", "git:origin", "git:origin#main"):
        with pytest.raises(UsageError, match="that make publish did not write"):
            publish(toy.project.site, target)
    assert git(remote, "for-each-ref") == before


@pytest.mark.parametrize(
    "target",
    ["nowhere", "fd::17", "--upload-pack=touch x"]
    + [
        f"origin#{branch}"
        for branch in ("a..b", "@", "HEAD", "a b", "-x", "refs/heads/z")
    ],
)
def test_what_git_can_not_publish_to_is_one_line(toy, remote, target):
    with pytest.raises(UsageError) as error:
        publish(toy.project.site, f"git:{target}")
    assert not re.search("\n|usage|exit status 1$", str(error.value))


def test_without_a_repository_publishing_says_what_needs_none(toy, monkeypatch):
    monkeypatch.setenv("GIT_CEILING_DIRECTORIES", str(toy.project.root.parent))
    with pytest.raises(UsageError, match="not a git repository"):
        publish(toy.project.site, "")
    monkeypatch.setenv("PATH", "/nowhere")
    with pytest.raises(
        UsageError,
        match="not published: git is not installed: install it",
    ):
        publish(toy.project.site, "")


def test_what_a_killed_publish_leaves_goes_with_the_next(toy, tmp_path, monkeypatch):
    monkeypatch.setattr(
        publishing,
        "put_in_place",
        lambda *folders: os.kill(os.getpid(), signal.SIGKILL),
    )
    if not (child := os.fork()):
        publish(toy.project.site, f"dir:{tmp_path}/www")
    assert os.waitpid(child, 0)[1] == signal.SIGKILL
    monkeypatch.undo()
    publish(toy.project.site, f"dir:{tmp_path}/www")
    assert check_site(tmp_path / "www") == [] and not any(
        (toy.project.root / publishing.ASIDE).iterdir()
    )


def test_publishing_is_done_beside_hooks_and_settings_and_is_seen(
    toy, remote, tmp_path, monkeypatch
):
    root = toy.project.root
    git(root, "tag", "-a", "mine", "-m", "mine")
    for folder in (root / ".git/hooks", tmp_path / "hooks"):
        folder.mkdir(exist_ok=True)
        hook = folder / "pre-push"
        hook.write_text(f"#!/bin/sh\ngit fetch origin\ntouch {tmp_path}/ran\n")
        hook.chmod(0o755)
    for setting in (
        f"core.hooksPath {tmp_path / 'hooks'}",
        "push.recurseSubmodules only",
        "push.followTags true",
    ):
        git(root, "config", *setting.split())
    monkeypatch.setenv("GIT_DIR", ".git")  # as in a hook
    publish(toy.project.site, "")
    monkeypatch.delenv("GIT_DIR")
    assert git(remote, "for-each-ref", "--format=%(refname)") == "refs/heads/gh-pages"
    assert not (tmp_path / "ran").exists()
    for words in ("fetch --quiet", "log --all", "fsck --strict"):
        git(root, *words.split())
    git(tmp_path, "clone", "--quiet", "--branch", "gh-pages", str(remote), "work")
    (tmp_path / "work/CNAME").write_text("report.example\n")
    for words in ("add CNAME", "commit --quiet -m CNAME", "push --quiet"):
        git(tmp_path / "work", *words.split())
    publish(toy.project.site, "")
    assert git(remote, "show", "gh-pages:CNAME") == "report.example"
    (remote / "hooks/post-update").write_text(
        "#!/bin/sh\ngit update-ref -d refs/heads/gh-pages\n"
    )
    (remote / "hooks/post-update").chmod(0o755)
    monkeypatch.setattr(
        publishing, "SUBJECT", "Another commit, though all is done in a second"
    )
    with pytest.raises(
        ReportError, match="not published, because origin does not have the new commit"
    ):
        publish(toy.project.site, "")
