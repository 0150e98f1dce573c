"""Releases: which packages are to be installed, as they were asked for, and the label of what is measured with them.

A label names all that was asked for and, where several measured it, the machine: ``1.8.0``, ``1.8.0+numpy-2.1.0``,
``1.9.0.dev0+g1a2b3c4`` (a commit), ``1.9.0.dev0+g1a2b3c4.edited``, ``1.8.0@cpu``.
"""

import json
import os
import re
import tempfile
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from typing import Any

from packaging.version import Version

from measured_report.files.config import Config, Report
from measured_report.files.config import report as current
from measured_report.files.errors import UsageError
from measured_report.files.git import git
from measured_report.records.identity import (
    SHORT_COMMIT,
    checkout_source,
    full_version,
    wheel_source,
)

VERSION = re.compile(
    r"[0-9]{1,4}(?:\.[0-9]{1,6}){1,4}(?:(?:a|b|rc)[0-9]{1,4})?(?:\.(?:post|dev)[0-9]{1,12})?"
)
WHEEL = re.compile(
    rf"(?P<package>[A-Za-z0-9_]+)-(?P<version>{VERSION.pattern})-[A-Za-z0-9_.-]+\.whl"
)
REFERENCE = re.compile(r"[A-Za-z0-9][A-Za-z0-9._/-]*")
ADDRESS = re.compile(r"(https?|ssh|file)://[^\s@-][^\s]*")
SECRET = re.compile(
    r"https?://[^/]*@|://[^/@]*:[^/@]*@|://.*[?#]"
)  # in an address that says what opens it
INDEX = "https://pypi.org/simple"


@dataclass(frozen=True)
class Release:
    """Name a release, or other code, of the package whose releases are editions, and what is installed with it."""

    version: str
    source: str = ""  # `g` and a commit, maybe `.edited`; `w` or `x` and the digest of a wheel or folder; or a release
    pins: tuple[tuple[str, str], ...] = ()
    machine: str = ""  # name of the machine that measured it, when the label without it is of another machine
    requirement: str = ""
    """Told to the installer; empty where only the results are known."""
    asked: str = ""
    date: str = ""  # day of the commit, as 2026-11-11; of a release `release_date` asks the index
    checkout: Path | None = None
    """The folder that is installed as it lies there, so that what is edited counts."""
    settings: Config = field(default_factory=Config, repr=False, compare=False)

    def __str__(self) -> str:
        pins = (
            f"+{self.settings.short_names.get(package, package)}-{version}"
            for package, version in self.pins
        )
        return (
            self.package_version
            + "".join(pins)
            + (f"@{self.machine}" if self.machine else "")
        )

    @property
    def package_version(self) -> str:
        """Return the version that is installed, with the code that it is of."""
        return f"{self.version}+{self.source}" if self.source else self.version

    @property
    def order(self) -> Any:
        """Sort by version, as packages do: a development version and a candidate stand before the release."""
        return Version(self.version)

    def is_installed_with(self, versions: Mapping[str, str]) -> bool:
        return (
            versions[self.settings.edition] == self.package_version
            and dict(self.pins).items() <= versions.items()
        )


def read_label(text: str, settings: Config | None = None) -> Release | None:
    """Return the release that a label names; None when it is none. ``1.8`` is 1.8.0."""
    rules = settings or current().settings
    names = {
        rules.short_names.get(package, package): package
        for package in rules.packages[1:]
    }
    version = VERSION.pattern
    match = re.fullmatch(
        rf"({version})(?:\+([a-z][0-9a-f]{{7}}(?:\.edited)?))?"
        rf"((?:\+(?:{'|'.join(map(re.escape, names)) or '(?!)'})-{version})*)(?:@([a-z0-9][a-z0-9-]{{0,60}}))?",
        text,
    )
    if not match:
        return None
    version, source, pinned, machine = match.groups(default="")
    version, pins = (
        full_version(version),
        (pin_text.rpartition("-") for pin_text in pinned.split("+")[1:]),
    )
    requirement = "" if source else f"{rules.requirement_of(rules.edition)}=={version}"
    named = tuple(sorted((names[name], pin) for name, _, pin in pins))
    return Release(version, source, named, machine, requirement, text, settings=rules)


def release_of(
    spec: str, pins: str = "", option: str = "", report: Report | None = None
) -> Release:
    """Find what is asked for, with ``pins`` as WITH= says them; UsageError, one line, when it means nothing."""
    report = report or current()
    release, packages = (
        _resolved(spec, option or report.settings.option, report),
        report.settings.packages[1:],
    )
    named = [pin.partition("==")[::2] for pin in pins.split()]
    if not all(
        package in packages and VERSION.fullmatch(version) for package, version in named
    ):
        names = ", ".join(packages) or "none"
        raise UsageError(
            f"WITH={pins} is no list of PACKAGE==1.2.3; packages of report.toml has: {names}"
        )
    versions = {
        **dict(release.pins),
        **{package: full_version(version) for package, version in named},
    }
    return replace(release, pins=tuple(sorted(versions.items())))


def _resolved(spec: str, option: str, report: Report) -> Release:
    settings, root = report.settings, report.root
    package = settings.edition
    requirement = settings.requirement_of(package)
    if label := read_label(spec, settings):
        return label
    if not spec:
        raise UsageError(
            f"{option}= names no {settings.edition_name}; {option}=1.2.3 does"
        )
    if SECRET.search(spec):
        raise UsageError(
            f"{option}= has what opens the address, which would be kept; git's credential helper keeps it"
        )
    address, _, reference = spec.rpartition("@")
    path, repository = folder_at(spec, root), folder_at(address, root)
    wheel = WHEEL.fullmatch(path.name)
    if (
        wheel
        and path.is_file()
        and wheel["package"].replace("_", "-").lower() == package
    ):
        version = full_version(wheel["version"])
        required, asked = f"{requirement} @ {path.as_uri()}", plain(path, root)
        return Release(
            version,
            wheel_source(path),
            requirement=required,
            asked=asked,
            settings=settings,
        )
    if (
        spec.startswith("git+")
        and ADDRESS.fullmatch(address[4:])
        and REFERENCE.fullmatch(reference)
    ):
        return _commit(address[4:], reference, spec, option, report)
    if (path / "pyproject.toml").is_file():
        source = ".".join(checkout_source(path, package).split(".")[:2])
        version = _own_version(
            (path / "pyproject.toml").read_text(encoding="utf-8"),
            spec,
            option,
            settings,
        )
        date = git(path, "show", "-s", "--format=%cs", "HEAD")
        return Release(
            version, source, (), "", str(path), plain(path, root), date, path, settings
        )
    if address and repository.is_dir() and REFERENCE.fullmatch(reference):
        return _commit(repository.as_uri(), reference, spec, option, report)
    kinds = "release number, checkout, wheel or git+https://HOST/NAME.git@ref"
    raise UsageError(f"{option}={spec} is no {kinds}; {option}=1.2.3 is one")


def folder_at(text: str, root: Path | None = None) -> Path:
    """Return what a path leads to from the report's folder, where make runs, or from a home."""
    # Path.expanduser would raise for a user that does not exist.
    return ((root or current().root) / os.path.expanduser(text)).resolve()  # noqa: PTH111


def plain(path: Path, root: Path) -> str:
    """Write a path as anybody may read it: from the report's folder, or from a home; nothing of this machine."""
    root, home = root.resolve(), folder_at("~", root)
    is_elsewhere = path.is_relative_to(home) and not path.is_relative_to(root.parent)
    return (
        f"~/{path.relative_to(home)}" if is_elsewhere else os.path.relpath(path, root)
    )


def _commit(
    address: str, reference: str, spec: str, option: str, report: Report
) -> Release:
    """Find a commit of a repository, of which no more is fetched than it takes to say its version and date."""
    with tempfile.TemporaryDirectory() as folder:
        fetched = Path(folder)
        local = address.removeprefix("file://") if address.startswith("file://") else ""
        commit = (
            git(Path(local), "rev-parse", f"{reference}^{{commit}}") if local else ""
        )
        git(fetched, "init", "--quiet", "--bare")
        git(
            fetched,
            "fetch",
            "--quiet",
            "--depth",
            "1",
            "--",
            address,
            commit or reference,
        )
        commit, date = git(
            fetched, "show", "-s", "--format=%H %cs", "FETCH_HEAD"
        ).partition(" ")[::2]
        if not commit:
            raise UsageError(
                f"{option}={spec} cannot be fetched; git fetch {address} {reference} says why"
            )
        version = _own_version(
            git(fetched, "show", f"{commit}:pyproject.toml"),
            spec,
            option,
            report.settings,
        )
    settings = report.settings
    requirement = (
        f"{settings.requirement_of(settings.edition)} @ git+{address}@{commit}"
    )
    asked = f"{plain(Path(local), report.root)}@{reference}" if local else spec
    source = f"g{commit[:SHORT_COMMIT]}"
    return Release(
        version,
        source,
        requirement=requirement,
        asked=asked,
        date=date,
        settings=settings,
    )


def _own_version(project: str, spec: str, option: str, settings: Config) -> str:
    match, package = (
        re.search(r'^version = "([^"]+)"', project, re.MULTILINE),
        settings.edition,
    )
    if (
        not match
        or f'name = "{package}"' not in project
        or not VERSION.fullmatch(match[1])
    ):
        lacking = f"its pyproject.toml names no {package} with a version"
        raise UsageError(
            f"{option}={spec} is no checkout of {settings.edition_name}: {lacking}"
        )
    return full_version(match[1])


def release_date(release: Release) -> str:
    """Find the day, as 2026-11-11, on which it came out; empty where the index does not say."""
    package = release.settings.edition
    if release.date or not release.requirement.startswith(
        f"{release.settings.requirement_of(package)}=="
    ):
        return release.date
    return _index_dates(package).get(release.version, "")


def releases_between(older: Release, newer: Release) -> list[Release]:
    releases = releases_of(older.settings.edition, older.settings)
    return [
        release for release in releases if older.order < release.order < newer.order
    ]


def releases_of(package: str, settings: Config | None = None) -> list[Release]:
    """Return the releases of a package in the index, oldest first; candidates and development versions are none."""
    finals = [
        version
        for version in _index_dates(package)
        if version.replace(".", "").isdigit()
    ]
    releases = filter(None, (read_label(version, settings) for version in finals))
    return sorted(releases, key=lambda release: release.order)


@cache
def _index_dates(package: str) -> Mapping[str, str]:
    """Return the day of each version in the index, as PEP 700 has it; none where it can't be reached."""
    import urllib.request  # which takes long to import, and few commands ask the index

    indexes = filter(
        None, map(os.environ.get, ("UV_DEFAULT_INDEX", "UV_INDEX_URL", "PIP_INDEX_URL"))
    )
    address = f"{next(indexes, INDEX).rstrip('/')}/{package}/"
    request = urllib.request.Request(
        address, headers={"Accept": "application/vnd.pypi.simple.v1+json"}
    )
    try:
        with urllib.request.urlopen(request, timeout=30) as answer:
            files = json.load(answer)["files"]
    except (OSError, ValueError, KeyError):
        return {}
    wheels = [
        file
        for file in files
        if file["filename"].endswith(".whl") and not file.get("yanked")
    ]
    days = [
        (file["filename"].split("-")[1], file.get("upload-time", "")[:10])
        for file in wheels
    ]
    return {
        full_version(version): day
        for version, day in days
        if VERSION.fullmatch(version)
    }
