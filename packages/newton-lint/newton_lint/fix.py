"""Writing changes into the files of a scene: a minimal edit of their text, beside which the old one stays."""

import re
from collections.abc import Iterable, Iterator
from pathlib import Path

from newton_lint.findings import Change
from newton_lint.source import Source

TAG = re.compile(rb"""<[^\s/>]+(?:[^>"']|"[^"]*"|'[^']*')*?(?=\s*/?>)""")
"""A tag from its start, without its end."""


def fix(changes: Iterable[Change], source: Source) -> Iterator[str]:
    """Write changes, the first where two say the same attribute, and tell each, or why it can't be written.

    Yields:
        A line for each change.
    """
    edits: dict[Path, dict[int, dict[str, str]]] = {}
    for change in dict.fromkeys(changes):
        element = change.element
        if element is None and change.subject == "option" and source.root is not None:
            element = source.root
        if element is None or not change.attributes:
            yield f"{change}: is not written, for no file is known to say it"
            continue
        into = edits.setdefault(element.file, {}).setdefault(element.start, {})
        for name, value in change.attributes:
            into.setdefault(name, value)
        yield f"{change}: written"
    for file, tags in edits.items():
        old = file.read_bytes()
        kept = file.with_name(f"{file.name}.orig")
        if not kept.exists():
            kept.write_bytes(old)
        file.write_bytes(edited(old, tags, source.root.start if file == source.root.file else -1))
        yield f"{file}: as it was it is {kept.name}"


def edited(text: bytes, tags: dict[int, dict[str, str]], root: int = -1) -> bytes:
    """Set attributes in the tags that start at these bytes; those of the root in an ``<option>`` of it."""
    for start, attributes in sorted(tags.items(), reverse=True):
        tag = TAG.match(text, start)
        if start == root:
            at = text.index(b">", tag.end()) + 1
            said = " ".join(f'{name}="{value}"' for name, value in attributes.items())
            text = text[:at] + f"\n  <option {said}/>".encode() + text[at:]
        else:
            text = text[:start] + _with(tag[0], attributes) + text[tag.end() :]
    return text


def _with(tag: bytes, attributes: dict[str, str]) -> bytes:
    for name, value in attributes.items():
        said = re.compile(rf"""(\s{re.escape(name)}\s*=\s*)("[^"]*"|'[^']*')""".encode())
        new = f'"{value}"'.encode()
        tag = (
            said.sub(lambda match, new=new: match[1] + new, tag)
            if said.search(tag)
            else tag + f" {name}=".encode() + new
        )
    return tag
