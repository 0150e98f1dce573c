"""Stacks: which packages are to be installed, as they were asked for, and what an edition of them is called."""

import json
import os
import re
import tempfile
import urllib.request
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

from measured_report.editions.label import VERSION, Label, full_version, read_label
from measured_report.files.config import config
from measured_report.files.errors import UsageError
from measured_report.records.provenance import SHORT_COMMIT, address_source, checkout_source, git, wheel_source

WHEEL = re.compile(rf"(?P<package>[A-Za-z0-9_]+)-(?P<version>{VERSION.pattern})-[A-Za-z0-9_.-]+\.whl")
WEB_ADDRESS = re.compile(r"https?://[^\s@]+")
REFERENCE = re.compile(r"[A-Za-z0-9][A-Za-z0-9._/-]*")
ADDRESS = re.compile(r"(https?|ssh|file)://[^\s@-][^\s]*")
OWN_VERSION = re.compile(r'^version = "([^"]+)"', re.MULTILINE)
INDEX = "https://pypi.org/simple"


@dataclass(frozen=True)
class Stack:
    """The package whose releases are editions, and those that are to be installed with it."""

    label: Label
    requirement: str
    """What the installer is told to install; empty where only the results are known."""
    asked: str
    """As the command named it."""
    date: str = ""
    """Of the commit, as 2026-11-11; of a release ``release_date`` asks the index."""
    checkout: Path | None = None
    """The folder that is installed as it lies there, so that what is edited counts."""


@cache  # a repository or an index is asked once
def stack_of(asked: str, pins: str = "", option: str = "") -> Stack:
    """Find what is asked for, with ``pins`` as WITH= says them; UsageError, one line, when it means nothing."""
    found = _found(asked, option or config().option)
    told = {**dict(found.label.pins), **dict(_read_pins(pins))}
    return replace(found, label=replace(found.label, pins=tuple(sorted(told.items()))))


def _found(asked: str, option: str) -> Stack:
    requirement, package = config().requirement_of(config().package), config().package
    if label := read_label(asked):
        return Stack(label, "" if label.source else f"{requirement}=={label.version}", asked)
    if not asked:
        raise UsageError(f"{option}= names no {config().edition_name}; {option}=1.8.0 does")
    path, _, reference = asked.rpartition("@")
    here = Path(asked).expanduser().resolve()
    wheel = WHEEL.fullmatch(here.name)
    if wheel and wheel["package"].replace("_", "-").lower() == package:
        version = full_version(wheel["version"])
        if WEB_ADDRESS.fullmatch(asked):
            return Stack(Label(version, address_source(asked)), f"{requirement} @ {asked}", asked)
        if here.is_file():
            return Stack(Label(version, wheel_source(here)), f"{requirement} @ {here.as_uri()}", str(here))
    if asked.startswith("git+"):
        address = path.removeprefix("git+")
        if ADDRESS.fullmatch(address) and REFERENCE.fullmatch(reference):
            return _commit(address, reference, asked, option)
        raise UsageError(f"{option}={asked} names no commit; {option}=git+https://HOST/{package}.git@main does")
    if (here / "pyproject.toml").is_file():
        source = checkout_source(here)
        version = _own_version((here / "pyproject.toml").read_text(encoding="utf-8"), asked, option)
        label = Label(version, ".".join(source.split(".")[:2]))
        return Stack(label, str(here), str(here), git(here, "show", "-s", "--format=%cs", "HEAD"), here)
    repository = Path(path).expanduser().resolve()
    if path and repository.is_dir() and REFERENCE.fullmatch(reference):
        return _commit(repository.as_uri(), reference, f"{repository}@{reference}", option)
    kinds = "release number, checkout, wheel or git+https://…@ref"
    raise UsageError(f"{option}={asked} is no {kinds}; {option}=1.8.0 is one")


def _commit(address: str, reference: str, asked: str, option: str) -> Stack:
    """Find a commit of a repository, of which no more is fetched than it takes to say its version and date."""
    with tempfile.TemporaryDirectory() as folder:
        there = Path(folder)
        local = address.removeprefix("file://") if address.startswith("file://") else ""
        commit = git(Path(local), "rev-parse", f"{reference}^{{commit}}") if local else ""
        git(there, "init", "--quiet", "--bare")
        git(there, "fetch", "--quiet", "--depth", "1", "--", address, commit or reference)
        commit, date = git(there, "show", "-s", "--format=%H %cs", "FETCH_HEAD").partition(" ")[::2]
        if not commit:
            raise UsageError(f"{option}={asked} cannot be fetched; git fetch {address} {reference} says why")
        version = _own_version(git(there, "show", f"{commit}:pyproject.toml"), asked, option)
    requirement = f"{config().requirement_of(config().package)} @ git+{address}@{commit}"
    return Stack(Label(version, f"g{commit[:SHORT_COMMIT]}"), requirement, asked, date)


def _own_version(project: str, asked: str, option: str) -> str:
    """The version that the text of a pyproject.toml names."""
    found, package = OWN_VERSION.search(project), config().package
    if not found or f'name = "{package}"' not in project or not VERSION.fullmatch(found[1]):
        lacking = f"its pyproject.toml names no {package} with a version"
        raise UsageError(f"{option}={asked} is no checkout of {config().edition_name}: {lacking}")
    return full_version(found[1])


def _read_pins(text: str) -> Sequence[tuple[str, str]]:
    pins = [word.partition("==")[::2] for word in text.split()]
    if not all(package in config().packages[1:] and VERSION.fullmatch(version) for package, version in pins):
        example = " ".join(f"{package}==1.19.0" for package in config().packages[1:3])
        raise UsageError(f'WITH={text} is no list of versions; WITH="{example}" is one')
    return [(package, full_version(version)) for package, version in pins]


@cache
def release_date(stack: Stack) -> str:
    """The day, as 2026-11-11, on which what was asked for came out; empty where the index does not say."""
    if stack.date or not stack.requirement.startswith(f"{config().requirement_of(config().package)}=="):
        return stack.date
    return _index_dates(config().package).get(stack.label.version, "")


def releases_between(older: Label, newer: Label) -> list[str]:
    """The releases of the index between two, oldest first; candidates and development versions are none."""
    found = map(read_label, releases_of(config().package))
    return [str(label) for label in found if older.order < label.order < newer.order]


def releases_of(package: str) -> list[str]:
    """The releases of a package that the index has, oldest first."""
    found = [label for version in _index_dates(package) if (label := read_label(version))]
    finals = [label for label in found if label.version.replace(".", "").isdigit()]
    return [str(label) for label in sorted(finals, key=lambda label: label.order)]


@cache
def _index_dates(package: str) -> Mapping[str, str]:
    """The day of each version that the index has, which is asked as PEP 700 has it; none where it can't be reached."""
    told = filter(None, map(os.environ.get, ("UV_DEFAULT_INDEX", "UV_INDEX_URL", "PIP_INDEX_URL")))
    address = f"{next(told, INDEX).rstrip('/')}/{package}/"
    request = urllib.request.Request(address, headers={"Accept": "application/vnd.pypi.simple.v1+json"})
    try:
        with urllib.request.urlopen(request, timeout=30) as answer:
            files = json.load(answer)["files"]
    except (OSError, ValueError, KeyError):
        return {}
    wheels = [file for file in files if file["filename"].endswith(".whl") and not file.get("yanked")]
    found = [(file["filename"].split("-")[1], file.get("upload-time", "")[:10]) for file in wheels]
    return {full_version(version): day for version, day in found if VERSION.fullmatch(version)}
