"""Edits the files of a scene: changes only the affected tags and keeps a copy."""

import contextlib
import itertools
import os
import re
import shutil
import stat
from collections.abc import Iterable
from pathlib import Path

from newton_lint.changes import Change
from newton_lint.source import Element, Source, Texts

TAG = re.compile(rb"""<([^\s/>]+)(?:[^>"']|"[^"]*"|'[^']*')*?(?=\s*/?>)""")
"""Matches a tag from its start to before its closing bracket."""
ATTRIBUTE = re.compile(rb"""(\s)([^\s="'/<>]+)(\s*=\s*)("[^"]*"|'[^']*')""")
NEW = {"option": "<option {}/>", "exclude": "<contact><exclude {}/></contact>"}
"""Maps the kind of a change without an element to the tag to add to the root."""


class Unwritable(Exception):
    """A change cannot be written. The message is a clause that gives the reason."""


def edited(
    changes: Iterable[Change], source: Source | None, texts: Texts
) -> dict[Path, bytes]:
    """Return the new text of each file that the changes alter.

    Args:
        texts: Contents that replace those of the files on disk.

    Raises:
        Unwritable: A change has no place in the files.
    """
    placed = []
    for change in changes:
        element = change.element
        if element is None and source and change.kind in NEW:
            element = source.root
        if element is None or not change.attributes:
            raise Unwritable("no file defines this attribute")
        placed.append((element, change))
    new: dict[Path, bytes] = {}
    # Later tags come first, so that the positions of earlier ones stay valid.
    for element, change in sorted(placed, key=lambda placement: -placement[0].start):
        file = element.file
        text = new.get(file) or texts.get(file) or file.read_bytes()
        new[file] = _edited(text, element, change)
    return new


def _edited(text: bytes, element: Element, change: Change) -> bytes:
    """Return a text with one change, in an element or as a new child of the root."""
    tag = TAG.match(text, element.start)
    if tag is None or tag[1].decode(errors="replace") != element.tag:
        raise Unwritable("the file has changed since it was read")
    if change.element:
        new = _with(tag[0], dict(change.attributes))
        return text[: tag.start()] + new + text[tag.end() :]
    end = text.index(b">", tag.end()) + 1
    line = b"\r\n" if b"\r\n" in text else b"\n"
    attributes = " ".join(
        f'{name}="{_escaped(value)}"' for name, value in change.attributes
    )
    child = NEW[change.kind].format(attributes).encode()
    return text[:end] + line + b"  " + child + text[end:]


def _with(tag: bytes, attributes: dict[str, str]) -> bytes:
    """Return a tag with new attributes, each in its old place or at the end."""
    missing = dict(attributes)

    def replaced(match: re.Match) -> bytes:
        name = match[2].decode(errors="replace")
        if name not in missing:
            return match[0]
        return (
            match[1] + match[2] + match[3] + f'"{_escaped(missing.pop(name))}"'.encode()
        )

    tag = ATTRIBUTE.sub(replaced, tag)
    return (
        tag
        + "".join(
            f' {name}="{_escaped(value)}"' for name, value in missing.items()
        ).encode()
    )


def _escaped(value: str) -> str:
    return value.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")


def write(texts: Texts) -> list[tuple[Path, Path]]:
    """Replace all the files, or none if one of them raises OSError.

    Returns:
        The resolved path of each file, and the path of its backup.
    """
    replaced: list[tuple[Path, Path]] = []
    try:
        for file, text in texts.items():
            # A link stays a link. Root may write read-only files too.
            real = file.resolve(strict=True)
            if not stat.S_IMODE(real.stat().st_mode) & 0o222:
                raise PermissionError(f"{file} is read-only")
            names = (
                f"{real.name}.orig{number if number > 1 else ''}"
                for number in itertools.count(1)
            )
            backup = next(
                path for path in map(real.with_name, names) if not os.path.lexists(path)
            )
            shutil.copy2(real, backup)
            replaced.append((real, backup))
            # This keeps the mode and the owner; the backup has the old contents.
            real.write_bytes(text)
    except BaseException:
        undo(replaced)
        raise
    return replaced


def undo(replaced: Iterable[tuple[Path, Path]]) -> None:
    """Restore files from their backups."""
    for real, backup in replaced:
        with contextlib.suppress(OSError):
            os.replace(backup, real)
