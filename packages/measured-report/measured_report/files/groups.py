"""Groups: things by what they share."""

from collections.abc import Iterable
from typing import TypeVar

K = TypeVar("K")
T = TypeVar("T")


def grouped(pairs: Iterable[tuple[K, T]]) -> dict[K, list[T]]:
    """Gather things by their keys, in order."""
    groups: dict[K, list[T]] = {}
    for key, thing in pairs:
        groups.setdefault(key, []).append(thing)
    return groups


def single(pairs: Iterable[tuple[K, T]]) -> dict[K, T]:
    """Return things by their keys, those that share one left out."""
    return {
        key: things[0] for key, things in grouped(pairs).items() if len(things) == 1
    }
