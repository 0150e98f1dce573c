"""Reads ``[tool.newton-lint]`` from pyproject.toml and comments that ignore rules."""

import functools
import re
import sys
from collections.abc import Collection
from pathlib import Path
from typing import Any

from newton_lint.findings import Finding
from newton_lint.source import Source
from newton_lint.target import TargetError

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

COMMENT = re.compile(r"<!--\s*newton-lint:\s*ignore(?:=([\w,\s-]+?))?\s*-->")


def table_of(folder: Path) -> dict[str, Any]:
    """Return the table of the nearest pyproject.toml in a folder or above it, or {}."""
    for parent in (folder, *folder.parents):
        file = parent / "pyproject.toml"
        if file.is_file():
            try:
                return (
                    tomllib.loads(file.read_text(encoding="utf-8"))
                    .get("tool", {})
                    .get("newton-lint", {})
                )
            except (ValueError, OSError) as error:
                raise TargetError(f"{file}: cannot be read: {error}") from error
    return {}


def is_ignored(finding: Finding, source: Source, rules: Collection[str]) -> bool:
    """Return whether an option, or a comment in the file, ignores a finding's rule.

    A comment applies to the whole file if it precedes the first tag, and otherwise to
    its own line and the next one.
    """
    if finding.rule in rules or source.root is None:
        return finding.rule in rules
    element = finding.element
    root = source.root
    # XML permits no comment within a tag, so it follows the tag or precedes its line.
    near = [(element.file, (1, element.line - 1, element.line))] if element else []
    return any(
        line in lines and (not named or finding.rule in named)
        for file, lines in ((root.file, range(max(root.line, 2))), *near)
        for line, named in _comments(file, file.stat().st_mtime_ns)
    )


@functools.cache
def _comments(file: Path, _: int) -> list[tuple[int, set[str]]]:
    # The second argument is the time of the last change, so that an edited file is
    # read again in a program that calls check several times.
    text = file.read_text(encoding="utf-8", errors="replace")
    return [
        (
            text.count("\n", 0, match.start()) + 1,
            {rule.strip() for rule in (match[1] or "").split(",")} - {""},
        )
        for match in COMMENT.finditer(text)
    ]
