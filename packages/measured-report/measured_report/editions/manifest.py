"""Manifests: what an edition was asked for as, and which of its sections were measured, so that none goes unnoticed.

``results/newton-<label>/edition.toml``; an edition without one, as of an older checkout, says nothing of itself.
"""

import json
import sys
from dataclasses import asdict, dataclass
from pathlib import Path

from measured_report.files.files import RecordError, atomic_file, place_of

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

NAME = "edition.toml"


@dataclass(frozen=True)
class Manifest:
    """What is known of an edition besides its records."""

    newton: str
    """As NEWTON= said it: a release, a path or an address."""
    date: str = ""
    """Of the release or the commit, as 2026-11-11; empty where it is not known."""
    sections: tuple[str, ...] = ()
    """Those that have been measured."""


def read_manifest(results: Path) -> Manifest | None:
    """The manifest in a folder of results; None where there is none, RecordError for one that is damaged."""
    path = results / NAME
    if not path.is_file():
        return None
    try:
        found = tomllib.loads(path.read_text(encoding="utf-8"))
        fields = {**found, "sections": tuple(found["sections"])}
        if not all(isinstance(text, str) for text in (fields["newton"], fields["date"], *fields["sections"])):
            raise TypeError("a field is no text")
        return Manifest(**fields)
    except (KeyError, TypeError, ValueError, OSError) as error:
        raise RecordError(f"{place_of(path)} is no whole manifest: {' '.join(str(error).split()):.200}") from None


def write_manifest(results: Path, manifest: Manifest) -> None:
    lines = [f"{name} = {json.dumps(value, ensure_ascii=False)}\n" for name, value in asdict(manifest).items()]
    with atomic_file(results / NAME) as path:
        path.write_text("".join(lines), encoding="utf-8")
