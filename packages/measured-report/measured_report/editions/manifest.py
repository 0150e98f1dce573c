"""Manifests: what an edition was asked for as, and which of its sections were measured, so that none goes unnoticed.

``edition.toml`` beside the records; an edition without one, as of an older checkout, says nothing of itself.
"""

import json
import os
from pathlib import Path

import msgspec
from msgspec import Struct

from measured_report.files.atomic import RecordError, atomic_file, read_own_file, short_path
from measured_report.files.config import config, parse_toml
from measured_report.records.columns import UNPRINTABLE, name_problem

NAME = "edition.toml"
BYTE_LIMIT = 1 << 20


class Manifest(Struct, frozen=True, forbid_unknown_fields=True):
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
    if not os.path.lexists(path):
        return None
    content = read_own_file(path, BYTE_LIMIT)
    try:
        found = parse_toml(content.decode("utf-8"))
        for text in (value for value in [*found.values(), *found.get("sections", ())] if isinstance(value, str)):
            if problem := name_problem(text):
                raise ValueError(f"{UNPRINTABLE.sub('?', text)!r:.80} {problem}")
        told = {"asked": found.pop(config().package), "date": found.pop("date"), "sections": found.pop("sections")}
        return msgspec.convert({**told, **found}, Manifest)
    except (KeyError, ValueError, RecursionError) as error:
        raise RecordError(f"{short_path(path)} is no whole manifest: {' '.join(str(error).split()):.200}") from None


def write_manifest(results: Path, manifest: Manifest) -> None:
    fields = {config().package: manifest.asked, "date": manifest.date, "sections": manifest.sections}
    lines = [f"{name} = {json.dumps(value, ensure_ascii=False)}\n" for name, value in fields.items()]
    with atomic_file(results / NAME) as path:
        path.write_text("".join(lines), encoding="utf-8")
