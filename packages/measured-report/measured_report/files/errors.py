"""Errors: what a command says in one line, in place of a traceback."""

from collections.abc import Iterable
from difflib import get_close_matches


class ReportError(Exception):
    """Tells the reader of its message, which is one line, what to mend."""


class UsageError(ReportError):
    """Tells that what was asked for does not exist or makes no sense; nothing was changed."""


def suggestion(name: str, names: Iterable[str]) -> str:
    """Say ``; near it: `` and the names that are like a mistyped one; nothing where none is."""
    found = get_close_matches(name, list(names), n=4, cutoff=0.5)
    return f"; near it: {', '.join(found)}" if found else ""
