"""Stacks: what is to be installed, as it was asked for, and what that is called."""

import json
import os
import re
import tempfile
import urllib.request
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

from measured_report import UsageError
from measured_report.editions.label import SHORT, VERSION, Label, full_version, read_label
from measured_report.records.sources import SHORT_COMMIT, address_source, checkout_source, git, wheel_source

WHEEL = re.compile(rf"newton-(?P<version>{VERSION.pattern})-[A-Za-z0-9_.-]+\.whl")
WHEEL_ADDRESS = re.compile(rf"https?://[^\s@]+/{WHEEL.pattern}")
REFERENCE = re.compile(r"[A-Za-z0-9][A-Za-z0-9._/-]*")
ADDRESS = re.compile(r"(https?|ssh|file)://[^\s@-][^\s]*")
OWN_VERSION = re.compile(r'^version = "([^"]+)"', re.MULTILINE)
PIN = re.compile(rf"(?P<package>{'|'.join(SHORT.values())})==(?P<version>{VERSION.pattern})")
INDEX = "https://pypi.org/simple"
INDEX_VARIABLES = ("UV_DEFAULT_INDEX", "UV_INDEX_URL", "PIP_INDEX_URL")


@dataclass(frozen=True)
class Stack:
    """Newton and the packages that are to be installed with it."""

    label: Label
    newton: str
    """What the installer is told to install; empty where only the results are known."""
    asked: str
    """As NEWTON= said it."""
    date: str = ""
    """Of the commit, as 2026-11-11; of a release ``release_date`` asks the index."""
    checkout: Path | None = None
    """The folder that is installed as it lies there, so that what is edited counts."""


@cache  # a repository or an index is asked once
def stack_of(asked: str, pins: str = "", option: str = "NEWTON") -> Stack:
    """What ``NEWTON=asked WITH=pins`` means; UsageError, one line, when it means nothing."""
    found = _newton_of(asked, option)
    told = {**dict(found.label.pins), **dict(_read_pins(pins))}
    return replace(found, label=replace(found.label, pins=tuple(sorted(told.items()))))


def _newton_of(asked: str, option: str) -> Stack:
    if label := read_label(asked):
        return Stack(label, "" if label.source else f"newton[sim]=={label.version}", asked)
    if not asked:
        raise UsageError(f"{option}= names no Newton; {option}=1.8.0 does")
    path, _, reference = asked.rpartition("@")
    if there := WHEEL_ADDRESS.fullmatch(asked):
        return Stack(Label(full_version(there["version"]), address_source(asked)), f"newton[sim] @ {asked}", asked)
    if asked.startswith("git+"):
        address = path.removeprefix("git+") if ADDRESS.fullmatch(path.removeprefix("git+")) else ""
        if address and REFERENCE.fullmatch(reference):
            return _commit(address, reference, asked, option)
        raise UsageError(f"{option}={asked} names no commit; {option}=git+https://HOST/newton.git@main does")
    here = Path(asked).expanduser().resolve()
    if (here / "pyproject.toml").is_file():
        source = checkout_source(here)
        version = _own_version((here / "pyproject.toml").read_text(encoding="utf-8"), asked, option)
        label = Label(version, ".".join(source.split(".")[:2]))
        return Stack(label, str(here), str(here), git(here, "show", "-s", "--format=%cs", "HEAD"), here)
    if (wheel := WHEEL.fullmatch(here.name)) and here.is_file():
        return Stack(
            Label(full_version(wheel["version"]), wheel_source(here)), f"newton[sim] @ {here.as_uri()}", str(here)
        )
    repository = Path(path).expanduser().resolve()
    if path and repository.is_dir() and REFERENCE.fullmatch(reference):
        return _commit(repository.as_uri(), reference, f"{repository}@{reference}", option)
    raise UsageError(
        f"{option}={asked} is no release number, checkout, wheel or git+https://…@ref; {option}=1.8.0 is one"
    )


def _commit(address: str, reference: str, asked: str, option: str) -> Stack:
    """A commit of a repository, of which no more is fetched than it takes to say its version and date."""
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
    return Stack(Label(version, f"g{commit[:SHORT_COMMIT]}"), f"newton[sim] @ git+{address}@{commit}", asked, date)


def _own_version(project: str, asked: str, option: str) -> str:
    found = OWN_VERSION.search(project)
    if not found or 'name = "newton"' not in project or not VERSION.fullmatch(found[1]):
        raise UsageError(
            f"{option}={asked} is no checkout of Newton: its pyproject.toml names no newton with a version"
        )
    return full_version(found[1])


def _read_pins(text: str) -> Sequence[tuple[str, str]]:
    found = [PIN.fullmatch(word) for word in text.split()]
    if None in found:
        raise UsageError(f'WITH={text} is no list of versions; WITH="warp-lang==1.19.0 mujoco-warp==4.0.0" is one')
    return [(pin["package"], full_version(pin["version"])) for pin in found]


@cache
def release_date(stack: Stack) -> str:
    """The day, as 2026-11-11, on which what was asked for came out; empty where the index does not say."""
    if stack.date or not stack.newton.startswith("newton[sim]=="):
        return stack.date
    return _index_dates("newton").get(stack.label.version, "")


def releases_between(older: Label, newer: Label) -> list[str]:
    """The releases of the index between two, oldest first; candidates and development versions are none."""
    found = [read_label(version) for version in releases_of("newton")]
    return [str(label) for label in found if older.order < label.order < newer.order]


def releases_of(package: str) -> list[str]:
    """The releases of a package that the index has, oldest first."""
    found = [label for version in _index_dates(package) if (label := read_label(version))]
    finals = [label for label in found if label.version.replace(".", "").isdigit()]
    return [str(label) for label in sorted(finals, key=lambda label: label.order)]


@cache
def _index_dates(package: str) -> Mapping[str, str]:
    """The day of each version that the index has, which is asked as PEP 700 has it; none where it can't be reached."""
    index = next(filter(None, map(os.environ.get, INDEX_VARIABLES)), INDEX)
    request = urllib.request.Request(
        f"{index.rstrip('/')}/{package}/", headers={"Accept": "application/vnd.pypi.simple.v1+json"}
    )
    try:
        with urllib.request.urlopen(request, timeout=30) as answer:
            files = json.load(answer)["files"]
    except (OSError, ValueError, KeyError):
        return {}
    wheels = [file for file in files if file["filename"].endswith(".whl") and not file.get("yanked")]
    found = [(file["filename"].split("-")[1], file.get("upload-time", "")[:10]) for file in wheels]
    return {full_version(version): day for version, day in found if VERSION.fullmatch(version)}
