"""Group values by key."""

from collections.abc import Iterable
from typing import TypeVar

K = TypeVar("K")
T = TypeVar("T")


def grouped(pairs: Iterable[tuple[K, T]]) -> dict[K, list[T]]:
    """Return lists of the values with the same key, in order."""
    groups: dict[K, list[T]] = {}
    for key, value in pairs:
        groups.setdefault(key, []).append(value)
    return groups


def single(pairs: Iterable[tuple[K, T]]) -> dict[K, T]:
    """Return the values by key, without keys that have several values."""
    return {
        key: values[0] for key, values in grouped(pairs).items() if len(values) == 1
    }
