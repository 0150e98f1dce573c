"""Manifests: what an edition was asked for as, and which of its sections were measured, so that none goes unnoticed.

``edition.toml`` beside the records; an edition without one, as of an older checkout, says nothing of itself.
"""

import json
from dataclasses import dataclass
from pathlib import Path

from measured_report.files.atomic import RecordError, atomic_file, short_path
from measured_report.files.config import config, read_toml

NAME = "edition.toml"


@dataclass(frozen=True)
class Manifest:
    """What is known of an edition besides its records."""

    asked: str
    """As the command that measured it named its package: a release, a path or an address."""
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
        found = read_toml(path)
        manifest = Manifest(found.pop(config().package), found.pop("date"), tuple(found.pop("sections")))
        if found or not all(isinstance(text, str) for text in (manifest.asked, manifest.date, *manifest.sections)):
            raise TypeError("a field is no text, or unknown")
        return manifest
    except (KeyError, TypeError, ValueError, OSError) as error:
        raise RecordError(f"{short_path(path)} is no whole manifest: {' '.join(str(error).split()):.200}") from None


def write_manifest(results: Path, manifest: Manifest) -> None:
    fields = {config().package: manifest.asked, "date": manifest.date, "sections": manifest.sections}
    with atomic_file(results / NAME) as path:
        lines = [f"{name} = {json.dumps(value, ensure_ascii=False)}\n" for name, value in fields.items()]
        path.write_text("".join(lines), encoding="utf-8")
