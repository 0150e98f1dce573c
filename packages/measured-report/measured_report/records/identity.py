"""Identity: what a section's numbers depend on, found by reading the sources and never by running them."""

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
    """Holds digests of all that a measurement depends on, except the machine."""

    code: Digest  # of the syntax of all files that the section's module imports
    config: Digest  # of the profile and of the assets that these files name
    packages: Mapping[str, Version]
    profile: Annotated[str, Meta(pattern=r"\A(full|quick)\Z")] = "full"
    files: Mapping[FileName, Digest] = field(
        default_factory=dict
    )  # each of these files, so that a change has a name


def identity_of(
    section: str,
    profile: str,
    root: Path,
    packages: Mapping[str, str] | None = None,
    code: Code | None = None,
) -> Identity:
    """Return the identity that a record of a section has if it is measured now, with the packages installed here."""
    return identity_at(f"experiments.{section}", profile, root, packages, code)


def identity_at(
    module: str,
    profile: str,
    root: Path,
    packages: Mapping[str, str] | None = None,
    code: Code | None = None,
) -> Identity:
    """Return the identity of what a module measures; ``code`` saves reading the files of ``root`` once more."""
    code = code or Code(root)
    if not (file := code.module(module)):
        raise ReportError(f"There is no module {module}")
    sources = {
        code.name_of(path): code.source(path) for path in code.closure(file, GENERATOR)
    }
    digests = {name: source.digest for name, source in sorted(sources.items())}
    named = sorted({asset for source in sources.values() for asset in source.assets})
    assets = {
        asset: code.digest(root / asset) for asset in named if (root / asset).is_file()
    }
    versions = package_versions() if packages is None else packages
    return Identity(
        digest_of(digests),
        digest_of([profile, assets]),
        versions,
        profile,
        {**digests, **assets},
    )


def changes(recorded: Identity, current: Identity) -> list[str]:
    """List what differs between two identities; nothing when the record is fresh."""
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
    """Name the sections: modules or folders of the report's side. One whose name begins with _ is a draft."""
    folder = (root or current().root) / "report" / "sections"
    names = {path.stem for path in folder.glob("*.py")} | {
        path.parent.name for path in folder.glob("*/__init__.py")
    }
    shown = sorted(name for name in names if not name.startswith(("_", ".")))
    if wrong := [name for name in shown if not name.isidentifier()]:
        raise UsageError(
            f"report/sections/{wrong[0]}.py: a section has a name of Python, as my_ball"
        )
    return shown


SHORT_COMMIT = 7
MISSING = "missing"  # version of a package that is not installed
UNNAMED = "unnamed"  # stands in a version for code that no commit names
BYTE_LIMIT = 1 << 30  # of a file that is digested: wheels have hundreds of MiB


def package_versions(settings: Config | None = None) -> dict[str, str]:
    """Return the version of each package here; of the first with its code, where that is not an index's."""
    settings = settings or current().settings
    versions = dict.fromkeys(settings.packages, MISSING)
    for package in versions:
        with suppress(metadata.PackageNotFoundError):
            versions[package] = full_version(metadata.version(package))
    if versions[settings.edition] != MISSING and (source := _source(settings.edition)):
        versions[settings.edition] += f"+{source}"
    return versions


def full_version(version: str) -> str:
    """Write a version with three numbers at least: 2.0 and 2.0.0 are the same."""
    return re.sub(
        r"^[0-9]+(\.[0-9]+)*(?![0-9!])",
        lambda match: match[0] + ".0" * (2 - match[0].count(".")),
        version,
    )


def package_changes(before: Mapping[str, str], after: Mapping[str, str]) -> list[str]:
    versions = {
        name: (before.get(name), after.get(name)) for name in {**before, **after}
    }
    return [
        f"{name} {old} → {new}" for name, (old, new) in versions.items() if old != new
    ]


def _source(package: str) -> str:
    """Return the part of a version that names the code installed here; empty for a package from an index."""
    text = metadata.distribution(package).read_text("direct_url.json")
    if not text:
        return ""
    commit = json.loads(text).get("vcs_info", {}).get("commit_id", "")
    return f"g{commit[:SHORT_COMMIT]}" if commit else UNNAMED


def files_digest(paths: Iterable[Path], root: Path) -> str:
    """Digest files, by their names below ``root`` and what they hold; folders are passed over."""
    digest = hashlib.sha256()
    for path in sorted(paths):
        with suppress(OSError):  # of what can't be read its reader says so
            info = path.stat()
            if stat.S_ISREG(
                info.st_mode
            ):  # what has no size may have no end, and what is larger nobody reads
                content = path.read_bytes() if 0 < info.st_size <= BYTE_LIMIT else b""
                digest.update(
                    os.fsencode(
                        f"{path.relative_to(root).as_posix()}\0{info.st_size}\0"
                    )
                    + content
                )
    return digest.hexdigest()


def sources() -> str:
    return current().sources
