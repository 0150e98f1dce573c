"""Compute the identity of a section: digests of everything that its numbers depend on.

The source files are read, but never run.
"""

import hashlib
import json
import os
import re
import stat
from collections.abc import Iterable, Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from importlib import metadata
from pathlib import Path
from typing import Annotated

from msgspec import Meta

from measured_report.files.atomic import folder_fault
from measured_report.files.config import Config
from measured_report.files.config import report as current
from measured_report.files.errors import ReportError, UsageError
from measured_report.records.code import GENERATOR, Code, digest_of

Digest = Annotated[str, Meta(pattern=r"\A[0-9a-f]{64}\Z")]
FileName = Annotated[
    str, Meta(pattern=r"\A(?!.*\.\.)[A-Za-z0-9_][A-Za-z0-9_./-]*\Z", max_length=200)
]
Version = Annotated[
    str,
    Meta(
        pattern=r"\A(missing|[0-9]+(\.[0-9]+)*[a-z0-9.]*(\+[a-z0-9.]+)?)\Z",
        max_length=64,
    ),
]


@dataclass(frozen=True)
class Identity:
    """Digests of everything that a measurement depends on, except the machine."""

    code: Digest  # of the syntax of all files that the section's module imports
    config: Digest  # of the profile and of the assets that these files name
    packages: Mapping[str, Version]
    profile: Annotated[str, Meta(pattern=r"\A(full|quick)\Z")] = "full"
    files: Mapping[FileName, Digest] = field(default_factory=dict)
    """The digest of each file, so that messages can name the files that changed."""


def identity_of(
    section: str,
    profile: str,
    root: Path,
    packages: Mapping[str, str] | None = None,
    code: Code | None = None,
) -> Identity:
    """Return the identity that a section's record would have if it were measured now.

    The default of ``packages`` is the installed packages.
    """
    return identity_at(
        f"experiments.{section}", profile, root, packages=packages, code=code
    )


def identity_at(
    module: str,
    profile: str,
    root: Path,
    packages: Mapping[str, str] | None = None,
    code: Code | None = None,
) -> Identity:
    """Return the identity of the measurement that a module makes.

    If ``code`` is passed, the files of ``root`` are not read again.
    """
    code = code or Code(root)
    if not (file := code.module(module)):
        raise ReportError(
            f"module {module} does not exist: create it or correct the section's name"
        )
    digests, assets = code.digests([file], root, GENERATOR)
    versions = package_versions() if packages is None else packages
    return Identity(
        code=digest_of(digests),
        config=digest_of([profile, assets]),
        packages=versions,
        profile=profile,
        files={**digests, **assets},
    )


def changes(recorded: Identity, current: Identity) -> list[str]:
    """Return the differences between two identities; a fresh record has none."""
    names = sorted({*recorded.files, *current.files})
    changed = [
        name for name in names if recorded.files.get(name) != current.files.get(name)
    ]
    differences = []
    if recorded.code != current.code:
        differences += [
            f"code: {name}" for name in changed if name.endswith(".py")
        ] or ["code"]
    if recorded.config != current.config:
        parts = [f"config: {name}" for name in changed if not name.endswith(".py")]
        if recorded.profile != current.profile:
            parts.append(f"config: profile {recorded.profile} → {current.profile}")
        differences += parts or ["config"]
    return differences + [
        f"packages: {change}"
        for change in package_changes(recorded.packages, current.packages)
    ]


def sections(root: Path | None = None) -> list[str]:
    """Return the names of the sections: modules or folders in ``report/sections``.

    A module whose name begins with _ is a draft and is left out.
    """
    folder = (root or current().root) / "report" / "sections"
    for place in (folder.parent, folder):
        if fault := folder_fault(place):
            raise ReportError(fault)
    names = {path.stem for path in folder.glob("*.py")} | {
        path.parent.name for path in folder.glob("*/__init__.py")
    }
    finished = sorted(name for name in names if not name.startswith(("_", ".")))
    invalid = [
        name for name in finished if not (name.isascii() and name.isidentifier())
    ]
    if invalid:
        raise UsageError(
            f"report/sections/{invalid[0]}.py has an invalid name: use a Python name "
            "such as my_ball"
        )
    return finished


SHORT_COMMIT = 7
MISSING = "missing"  # version of a package that is not installed
UNNAMED = "unnamed"  # replaces the commit in the version of code without one
BYTE_LIMIT = (
    1 << 30
)  # largest file of which a digest is computed; wheels have hundreds of MiB


def package_versions(settings: Config | None = None) -> dict[str, str]:
    """Return the versions of the installed packages, the edition's package first.

    The version of the edition's package includes its commit if it was not installed
    from an index.
    """
    settings = settings or current().settings
    versions = {settings.edition: MISSING}
    for package in settings.packages:
        with suppress(metadata.PackageNotFoundError):
            versions[package] = full_version(metadata.version(package))
    if versions[settings.edition] != MISSING and (source := _source(settings.edition)):
        versions[settings.edition] += f"+{source}"
    return versions


def full_version(version: str) -> str:
    """Return a version with at least three numbers, because 2.0 means 2.0.0."""
    match = re.match(r"[0-9]+(\.[0-9]+)*(?![0-9!])", version)
    if not match:
        return version
    missing = 2 - match[0].count(".")
    return match[0] + ".0" * missing + version[match.end() :]


def package_changes(before: Mapping[str, str], after: Mapping[str, str]) -> list[str]:
    """Return the packages whose versions differ; an unlisted one counts as missing."""
    before, after = _with_implied(before, after), _with_implied(after, before)
    versions = {
        name: (before.get(name, MISSING), after.get(name, MISSING))
        for name in {**before, **after}
    }
    return [
        f"{name} {old} → {new}" for name, (old, new) in versions.items() if old != new
    ]


def _with_implied(
    versions: Mapping[str, str], others: Mapping[str, str]
) -> Mapping[str, str]:
    """Return versions with those packages of ``others`` that they imply."""
    implied = {
        name: versions[source]
        for name, source in current().settings.implied.items()
        if source in versions and versions[source] == others.get(name)
    }
    return {**implied, **versions}


def _source(package: str) -> str:
    """Return the part of a version that identifies installed code.

    It is empty for a package from an index.
    """
    text = metadata.distribution(package).read_text("direct_url.json")
    if not text:
        return ""
    commit = json.loads(text).get("vcs_info", {}).get("commit_id", "")
    return f"g{commit[:SHORT_COMMIT]}" if commit else UNNAMED


def files_digest(paths: Iterable[Path], root: Path) -> str:
    """Return a digest of files by their names below ``root`` and their contents.

    Folders are ignored.
    """
    digest = hashlib.sha256()
    for path in sorted(paths):
        # If a file cannot be read, the code that uses it reports the error.
        with suppress(OSError):
            info = path.stat()
            if stat.S_ISREG(info.st_mode):
                # Some devices and files of /proc report the size 0 but never end. No
                # command reads files above the limit.
                content = path.read_bytes() if 0 < info.st_size <= BYTE_LIMIT else b""
                name = f"{path.relative_to(root).as_posix()}\0{info.st_size}\0"
                digest.update(os.fsencode(name) + content)
    return digest.hexdigest()
