"""Identity: what a section's numbers depend on, found by reading the sources and never by running them."""

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Annotated

from msgspec import Meta

from measured_report.files.root import ROOT
from measured_report.records.code import digest_of, files, roots_of
from measured_report.records.provenance import package_changes, package_versions

Digest = Annotated[str, Meta(pattern=r"\A[0-9a-f]{64}\Z")]
FileName = Annotated[str, Meta(pattern=r"\A(?!.*\.\.)[A-Za-z0-9_][A-Za-z0-9_./-]*\Z", max_length=200)]
Version = Annotated[str, Meta(pattern=r"\A(missing|[0-9]+(\.[0-9]+)*[a-z0-9.]*(\+[a-z0-9.]+)?)\Z", max_length=64)]
Profile = Annotated[str, Meta(pattern=r"\A(full|quick)\Z")]


@dataclass(frozen=True)
class Identity:
    """Holds digests of all that a measurement depends on, except the machine."""

    code: Digest
    """Digest of the definitions that its ``measure`` may run; see ``code``."""
    config: Digest
    """Digest of the profile and of the assets that these name."""
    packages: Mapping[str, Version]
    """Version by package."""
    profile: Profile = "full"
    files: Mapping[FileName, Digest] = field(default_factory=dict)
    """Digest by file, of what lies in it of these: so that a change can be named. Where it lies does not count."""


def identity_of(section: str, profile: str, root: Path = ROOT, packages: Mapping[str, str] | None = None) -> Identity:
    """Return the identity that a section's ``measure`` has now, with ``packages`` or else those installed here."""
    return identity_at(f"experiments.{section}.measure", profile, root, packages)


def identity_at(name: str, profile: str, root: Path = ROOT, packages: Mapping[str, str] | None = None) -> Identity:
    """Return the identity of what has a dotted name, or of all that a module of that name has."""
    digest, code, named = files().graph(roots_of(root)).told(name)
    there = (asset for asset in named if (root / asset).is_file())
    assets = {asset: hashlib.sha256((root / asset).read_bytes()).hexdigest() for asset in there}
    return Identity(
        code=digest,
        config=digest_of([profile, sorted(assets.values())]),
        packages=package_versions() if packages is None else packages,
        profile=profile,
        files=dict(sorted({**code, **assets}.items())),
    )


def changes(recorded: Identity, current: Identity) -> list[str]:
    """Say what differs between two identities; nothing when the record is fresh."""
    sides = recorded.files.items(), current.files.items()
    same = {digest for _, digest in sides[0]} & {digest for _, digest in sides[1]}  # it may lie elsewhere now
    changed = sorted({name for side in sides for name, digest in side if digest not in same})
    words = []
    if recorded.code != current.code:
        words += [f"code: {name}" for name in changed if name.endswith(".py")] or ["code"]
    if recorded.config != current.config:
        parts = [f"config: {name}" for name in changed if not name.endswith(".py")]
        if recorded.profile != current.profile:
            parts.append(f"config: profile {recorded.profile} → {current.profile}")
        words += parts or ["config"]
    return words + [f"packages: {change}" for change in package_changes(recorded.packages, current.packages)]


def sections(root: Path = ROOT) -> list[str]:
    """Name the sections: those that have a module, or a folder of modules, on the report's side."""
    folder = root / "report" / "sections"
    found = {path.stem for path in folder.glob("[!.]*.py")} | {
        path.parent.name for path in folder.glob("*/__init__.py")
    }
    return sorted(found - {"__init__"})
