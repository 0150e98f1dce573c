"""Find the release or commit of a package that a command names, and its label.

A label names everything that was requested. If several machines measured it, the label
also names the machine. Examples are ``1.8.0``, ``1.8.0+numpy-2.1.0``,
``1.9.0.dev0+g1a2b3c4`` (a commit) and ``1.8.0@cpu``.
"""

import json
import os
import re
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from operator import attrgetter
from pathlib import Path
from typing import Any

from packaging.version import Version

from measured_report.files.config import Config, Report
from measured_report.files.config import report as current
from measured_report.files.errors import UsageError
from measured_report.files.git import git
from measured_report.records.identity import SHORT_COMMIT, full_version

VERSION = re.compile(
    r"""
    [0-9]{1,4} (?:\.[0-9]{1,6}){1,4}  # release
    (?:(?:a|b|rc)[0-9]{1,4})?  # candidate
    (?:\.(?:post|dev)[0-9]{1,12})?
    """,
    re.VERBOSE,
)
REFERENCE = re.compile(r"[A-Za-z0-9][A-Za-z0-9._/-]*")
ADDRESS = re.compile(r"(https?|ssh|file)://[^\s@-][^\s]*")
SECRET = re.compile(r"https?://[^/]*@|://[^/@]*:[^/@]*@|://.*[?#]")
"""Matches an address with a password or a token."""
INDEX = "https://pypi.org/simple"


@dataclass(frozen=True)
class Release:
    """Describe a release or commit of the edition's package, with pinned packages."""

    version: str
    source: str = ""  # `g` and the first digits of the commit; empty for a release
    pins: tuple[tuple[str, str], ...] = ()
    # The machine that measured the results, if another machine has the plain label.
    machine: str = ""
    # The requirement to install; empty if only results are available.
    requirement: str = ""
    spec: str = ""  # the name in commands
    date: str = ""  # of a commit, such as 2026-11-11
    settings: Config = field(default_factory=Config, repr=False, compare=False)

    def __str__(self) -> str:
        label = self.package_version
        for package, version in self.pins:
            label += f"+{self.settings.short_names.get(package, package)}-{version}"
        return f"{label}@{self.machine}" if self.machine else label

    @property
    def package_version(self) -> str:
        """Return the version of the installed package, with its commit."""
        return f"{self.version}+{self.source}" if self.source else self.version

    @property
    def order(self) -> Any:
        """Return a key that sorts versions, with candidates before their releases."""
        return Version(self.version)

    def is_installed_with(self, versions: Mapping[str, str]) -> bool:
        is_installed = versions[self.settings.edition] == self.package_version
        return is_installed and dict(self.pins).items() <= versions.items()


def read_label(text: str, settings: Config | None = None) -> Release | None:
    """Return the release that a label names, or None; ``1.8`` means 1.8.0."""
    settings = settings or current().settings
    # The first package is the edition, whose version is not a pin.
    names = {
        settings.short_names.get(package, package): package
        for package in settings.packages[1:]
    }
    version = VERSION.pattern
    packages = "|".join(map(re.escape, names)) or "(?!)"
    match = re.fullmatch(
        rf"""
        ({version})
        (?: \+(g[0-9a-f]{{7}}) )?  # commit
        ( (?: \+(?:{packages})-{version} )* )  # pinned packages
        (?: @([a-z0-9][a-z0-9-]{{0,60}}) )?  # machine
        """,
        text,
        re.VERBOSE,
    )
    if not match:
        return None
    number, source, pinned, machine = match.groups(default="")
    number = full_version(number)
    requirement = f"{settings.requirement_of(settings.edition)}=={number}"
    pins = {}
    for pin in pinned.split("+")[1:]:
        name, _, pins_version = pin.rpartition("-")
        pins[names[name]] = pins_version
    return Release(
        number,
        source,
        tuple(sorted(pins.items())),
        machine,
        requirement="" if source else requirement,
        spec=text,
        settings=settings,
    )


def release_of(
    spec: str, pins: str = "", option: str = "", report: Report | None = None
) -> Release:
    """Return the release that a command names, with ``pins`` in the format of WITH=."""
    report = report or current()
    settings = report.settings
    option = option or settings.option
    release = read_label(spec, settings) or _commit(spec, option, report)
    versions = dict(release.pins)
    for pin in pins.split():
        package, _, version = pin.partition("==")
        if package not in settings.packages[1:] or not VERSION.fullmatch(version):
            names = ", ".join(settings.packages[1:]) or "none"
            raise UsageError(
                f"WITH={pins} is not a list of PACKAGE==1.2.3: use only packages "
                f"that report.toml lists ({names})"
            )
        versions[package] = full_version(version)
    for package, source in settings.implied.items():
        if package in versions and versions[package] == versions.get(source):
            del versions[package]
    return replace(release, pins=tuple(sorted(versions.items())))


def folder_at(text: str, root: Path) -> Path:
    """Return the absolute path of a path that starts at the report's folder or at ~."""
    # Path.expanduser raises an error for a user that does not exist.
    return (root / os.path.expanduser(text)).resolve()  # noqa: PTH111


def _short_path(path: Path, root: Path) -> str:
    """Return a path relative to the report or to ~, without the name of a user.

    A path elsewhere, which may lead through another home folder, is shortened to its
    last part.
    """
    root = root.resolve()
    if path.is_relative_to(root.parent):
        return os.path.relpath(path, root)
    home = folder_at("~", root)
    return f"~/{path.relative_to(home)}" if path.is_relative_to(home) else path.name


def _commit(spec: str, option: str, report: Report) -> Release:
    """Return the release of a commit, fetching as few files as possible."""
    settings = report.settings
    if SECRET.search(spec):
        raise UsageError(
            f"{option}= contains a password or a token, which would be stored: use "
            "git's credential helper"
        )
    address, _, reference = spec.removeprefix("git+").rpartition("@")
    repository = folder_at(address.removeprefix("file://"), report.root)
    stored_spec = f"git+{address}@{reference}"
    commit = reference
    if address and repository.is_dir():
        address = repository.as_uri()
        stored_spec = f"{_short_path(repository, report.root)}@{reference}"
        # git fetch accepts branches and full commits, but not HEAD~1 or short commits.
        commit = git(repository, "rev-parse", f"{reference}^{{commit}}") or reference
    if not (ADDRESS.fullmatch(address) and REFERENCE.fullmatch(reference)):
        kinds = "a release number, git+https://HOST/NAME.git@COMMIT or FOLDER@COMMIT"
        raise UsageError(f"{option}={spec} does not name a release: use {kinds}")
    with tempfile.TemporaryDirectory() as folder:
        fetched = Path(folder)
        git(fetched, "init", "--quiet", "--bare")
        git(fetched, "fetch", "--quiet", "--depth", "1", "--", address, commit)
        show = git(fetched, "show", "-s", "--format=%H %cs", "FETCH_HEAD")
        project = git(fetched, "show", "FETCH_HEAD:pyproject.toml")
    commit, _, date = show.partition(" ")
    if not commit:
        raise UsageError(
            f"{option}={spec} cannot be fetched: run git fetch {address} "
            f"{reference} to see why"
        )
    version = re.search(r'^version = "([^"]+)"', project, re.MULTILINE)
    is_package = f'name = "{settings.edition}"' in project
    if not (version and is_package and VERSION.fullmatch(version[1])):
        raise UsageError(
            f"{option}={spec} is not a commit of {settings.edition_name}: use one "
            f"whose pyproject.toml has the name {settings.edition} and a version"
        )
    requirement = settings.requirement_of(settings.edition)
    return Release(
        full_version(version[1]),
        f"g{commit[:SHORT_COMMIT]}",
        requirement=f"{requirement} @ git+{address}@{commit}",
        spec=stored_spec,
        date=date,
        settings=settings,
    )


def release_date(release: Release) -> str:
    """Return the date of a release, such as 2026-11-11, or an empty string."""
    if release.source:
        return release.date
    return _index_dates(release.settings.edition).get(release.version, "")


def releases_between(older: Release, newer: Release) -> list[Release]:
    releases = releases_of(older.settings.edition, older.settings)
    return [
        release for release in releases if older.order < release.order < newer.order
    ]


def releases_of(package: str, settings: Config | None = None) -> list[Release]:
    """Return the final releases of a package in the index, oldest first."""
    versions = _index_dates(package)
    finals = [version for version in versions if version.replace(".", "").isdigit()]
    releases = filter(None, (read_label(version, settings) for version in finals))
    return sorted(releases, key=attrgetter("order"))


@cache
def _index_dates(package: str) -> Mapping[str, str]:
    """Return the date of each version in the index (PEP 700).

    Return no dates if the index cannot be reached.
    """
    # This import is slow, and few commands need it.
    import urllib.request

    variables = ("UV_DEFAULT_INDEX", "UV_INDEX_URL", "PIP_INDEX_URL")
    index = next(filter(None, map(os.environ.get, variables)), INDEX)
    request = urllib.request.Request(
        f"{index.rstrip('/')}/{package}/",
        headers={"Accept": "application/vnd.pypi.simple.v1+json"},
    )
    try:
        with urllib.request.urlopen(request, timeout=30) as response:
            files = json.load(response)["files"]
    except (OSError, ValueError, KeyError):
        return {}
    dates = {}
    for file in files:
        if file["filename"].endswith(".whl") and not file.get("yanked"):
            version = file["filename"].split("-")[1]
            if VERSION.fullmatch(version):
                dates[full_version(version)] = file.get("upload-time", "")[:10]
    return dates
