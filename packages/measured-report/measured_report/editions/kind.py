"""Kinds: how the record of a section stands to the code that would measure it now."""

from enum import Enum


class Kind(str, Enum):
    """Name one; it is its own text."""

    FRESH = "fresh"
    STALE = "stale"
    MISSING = "missing"
    DAMAGED = "damaged"
    NOT_SHOWN = "not shown"  # the record is whole, and code or words can't use it

    def __str__(self) -> str:
        return self.value

    def __format__(self, spec: str) -> str:
        return format(self.value, spec)
