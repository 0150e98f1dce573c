"""Suggestion: what is said behind a name that there is none of, to whoever mistyped it."""

from collections.abc import Iterable
from difflib import get_close_matches


def suggestion(name: str, names: Iterable[str]) -> str:
    """Say ``; near it: `` and the names that are like it; nothing where none is."""
    found = get_close_matches(name, list(names), n=4, cutoff=0.5)
    return f"; near it: {', '.join(found)}" if found else ""
