"""Writing changes into the files of a scene: a minimal edit of their text, beside which the old one stays."""

import contextlib
import itertools
import os
import re
import stat
import tempfile
from collections.abc import Iterable
from pathlib import Path
from xml.parsers import expat

from newton_lint.findings import Change
from newton_lint.source import Element, Source, Texts

TAG = re.compile(rb"""<([^\s/>]+)(?:[^>"']|"[^"]*"|'[^']*')*?(?=\s*/?>)""")
"""A tag from its start, without its end."""
ATTRIBUTE = re.compile(rb"""(\s)([^\s="'/<>]+)(\s*=\s*)("[^"]*"|'[^']*')""")
NEW = {"option": "<option {}/>", "exclude": "<contact><exclude {}/></contact>"}
"""What a change without an element adds to the root, by its subject."""


class Unwritable(Exception):
    """A change that cannot be written, said in words that follow it."""


def edited(changes: Iterable[Change], source: Source, texts: Texts) -> dict[Path, bytes]:
    """Return the texts of the files that changes alter.

    Args:
        texts: What files are taken to hold, as the source does.

    Raises:
        Unwritable: No file is known to say it, or its text is not where it was.
    """
    edits: dict[Path, dict[int, tuple[Element, list[Change]]]] = {}
    for change in changes:
        element = change.element or (source.root if change.subject in NEW else None)
        if element is None or not change.attributes:
            raise Unwritable("no file is known to say it")
        edits.setdefault(element.file, {}).setdefault(element.start, (element, []))[1].append(change)
    return {file: _edited(texts.get(file) or file.read_bytes(), tags) for file, tags in edits.items()}


def _edited(text: bytes, tags: dict[int, tuple[Element, list[Change]]]) -> bytes:
    expected = _elements(text)
    for start, (element, changes) in sorted(tags.items(), reverse=True):
        tag = TAG.match(text, start)
        at = next((index for index, each in enumerate(expected) if each[0] == start), -1)
        if tag is None or at < 0 or tag[1].decode(errors="replace") != element.tag:
            raise Unwritable("its text is not where it is looked for")
        for change in changes:
            if change.element is None:
                end = text.index(b">", tag.end()) + 1
                line = b"\r\n" if b"\r\n" in text else b"\n"
                said = " ".join(f'{name}="{_escaped(value)}"' for name, value in change.attributes)
                text = text[:end] + line + b"  " + NEW[change.subject].format(said).encode() + text[end:]
                expected[at + 1 : at + 1] = [
                    (-1, *each[1:]) for each in _elements(NEW[change.subject].format(said).encode())
                ]
            else:
                new = _with(tag[0], dict(change.attributes))
                text = text[:start] + new + text[tag.end() :]
                expected[at] = (start, element.tag, expected[at][2] | dict(change.attributes))
                tag = TAG.match(text, start)
    try:
        kept = [each[1:] for each in _elements(text)] == [each[1:] for each in expected]
    except expat.ExpatError:
        kept = False
    if not kept:
        raise Unwritable("its text would not read as it should")
    return text


def _elements(text: bytes) -> list[tuple[int, str, dict[str, str]]]:
    """Return start, tag and attributes of each element."""
    parser, found = expat.ParserCreate(), []
    parser.StartElementHandler = lambda tag, attributes: found.append((parser.CurrentByteIndex, tag, attributes))
    parser.Parse(text, True)
    return found


def _with(tag: bytes, attributes: dict[str, str]) -> bytes:
    left = dict(attributes)

    def said(match: re.Match) -> bytes:
        name = match[2].decode(errors="replace")
        if name not in left:
            return match[0]
        return match[1] + match[2] + match[3] + f'"{_escaped(left.pop(name))}"'.encode()

    tag = ATTRIBUTE.sub(said, tag)
    return tag + "".join(f' {name}="{_escaped(value)}"' for name, value in left.items()).encode()


def _escaped(value: str) -> str:
    return value.replace("&", "&amp;").replace("<", "&lt;").replace('"', "&quot;")


def write(texts: Texts) -> list[Path]:
    """Replace files, each whole or not at all, and return where what they held is kept.

    Raises:
        OSError: One can't be written; then all hold what they held.
    """
    done: list[tuple[Path, Path]] = []
    try:
        for file, text in texts.items():
            real = file.resolve(strict=True)
            if not stat.S_IMODE(real.stat().st_mode) & 0o222:
                raise PermissionError(f"{file}: is read-only")
            kept = _kept(real)
            done.append((real, kept))
            _replace(real, text)
    except BaseException:
        undo(done)
        raise
    return [kept for _, kept in done]


def undo(done: Iterable[tuple[Path, Path]]) -> None:
    """Give files back what they held."""
    for real, kept in done:
        with contextlib.suppress(OSError):
            os.replace(kept, real)


def _kept(real: Path) -> Path:
    """Copy a file beside itself under a name that is free."""
    for number in itertools.count(1):
        kept = real.with_name(f"{real.name}.orig{number if number > 1 else ''}")
        if not os.path.lexists(kept):
            _replace(kept, real.read_bytes(), real)
            return kept


def _replace(file: Path, text: bytes, like: Path | None = None) -> None:
    handle, name = tempfile.mkstemp(prefix=f".{file.name[:60]}.", dir=file.parent)
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(text)
            stream.flush()
            os.fsync(stream.fileno())
        found = (like or file).stat()
        Path(name).chmod(stat.S_IMODE(found.st_mode))
        with contextlib.suppress(OSError):
            os.chown(name, found.st_uid, found.st_gid)
        os.replace(name, file)
    except BaseException:
        with contextlib.suppress(OSError):
            Path(name).unlink()
        raise
