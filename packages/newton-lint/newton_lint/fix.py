"""Writing changes into the files of a scene: a minimal edit of their text, beside which the old one stays."""

import contextlib
import itertools
import os
import re
import shutil
import stat
import tempfile
from collections.abc import Iterable
from pathlib import Path

from newton_lint.findings import Change
from newton_lint.source import Element, Source, Texts

TAG = re.compile(rb"""<([^\s/>]+)(?:[^>"']|"[^"]*"|'[^']*')*?(?=\s*/?>)""")
"""A tag from its start, without its end."""
ATTRIBUTE = re.compile(rb"""(\s)([^\s="'/<>]+)(\s*=\s*)("[^"]*"|'[^']*')""")
NEW = {"option": "<option {}/>", "exclude": "<contact><exclude {}/></contact>"}
"""What a change without an element adds to the root, by its subject."""


class Unwritable(Exception):
    """A change that cannot be written, said in words that follow it."""


def edited(
    changes: Iterable[Change], source: Source | None, texts: Texts
) -> dict[Path, bytes]:
    """Return the texts of the files that changes alter, or raise Unwritable; ``texts`` stand for what files hold."""
    edits: dict[Path, dict[int, tuple[Element, list[Change]]]] = {}
    for change in changes:
        element = change.element or (
            source.root if source and change.subject in NEW else None
        )
        if element is None or not change.attributes:
            raise Unwritable("no file is known to say it")
        edits.setdefault(element.file, {}).setdefault(element.start, (element, []))[
            1
        ].append(change)
    return {
        file: _edited(texts.get(file) or file.read_bytes(), tags)
        for file, tags in edits.items()
    }


def _edited(text: bytes, tags: dict[int, tuple[Element, list[Change]]]) -> bytes:
    for start, (element, changes) in sorted(
        tags.items(), reverse=True
    ):  # from the end, so that no start moves
        for change in changes:
            tag = TAG.match(text, start)
            if tag is None or tag[1].decode(errors="replace") != element.tag:
                raise Unwritable("its text is not where it is looked for")
            if change.element is None:
                end = text.index(b">", tag.end()) + 1
                line = b"\r\n" if b"\r\n" in text else b"\n"
                attributes = " ".join(
                    f'{name}="{_escaped(value)}"' for name, value in change.attributes
                )
                child = NEW[change.subject].format(attributes).encode()
                text = text[:end] + line + b"  " + child + text[end:]
            else:
                text = (
                    text[:start]
                    + _with(tag[0], dict(change.attributes))
                    + text[tag.end() :]
                )
    return text


def _with(tag: bytes, attributes: dict[str, str]) -> bytes:
    """Return a tag with attributes in place of those of the same names, or behind all: the rest stays as it was."""
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
    """Replace files, all or, with an OSError, none; return each, as it was resolved, and where its text is kept."""
    replaced: list[tuple[Path, Path]] = []
    try:
        for file, text in texts.items():
            real = file.resolve(
                strict=True
            )  # os.replace would put a file in place of a link
            if not stat.S_IMODE(real.stat().st_mode) & 0o222:
                raise PermissionError(
                    f"{file}: is read-only"
                )  # os.replace asks for the folder's permission alone
            names = (
                f"{real.name}.orig{number if number > 1 else ''}"
                for number in itertools.count(1)
            )
            backup = next(
                path for path in map(real.with_name, names) if not os.path.lexists(path)
            )
            shutil.copy2(real, backup)
            replaced.append((real, backup))
            _replace(real, text)
    except BaseException:
        undo(replaced)
        raise
    return replaced


def undo(replaced: Iterable[tuple[Path, Path]]) -> None:
    """Give files back what they held."""
    for real, backup in replaced:
        with contextlib.suppress(OSError):
            os.replace(backup, real)


def _replace(file: Path, text: bytes) -> None:
    handle, name = tempfile.mkstemp(
        prefix=f".{file.name[:60]}.", dir=file.parent
    )  # os.replace crosses no file system
    try:
        with os.fdopen(handle, "wb") as stream:
            stream.write(text)
            stream.flush()
            os.fsync(
                stream.fileno()
            )  # or a power cut may leave the new name with nothing in it
        status = file.stat()
        shutil.copymode(file, name)
        with contextlib.suppress(OSError):  # only root gives files away
            os.chown(name, status.st_uid, status.st_gid)
        os.replace(name, file)
    except BaseException:
        with contextlib.suppress(OSError):
            Path(name).unlink()
        raise
