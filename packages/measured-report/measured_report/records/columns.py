"""Columns: what a column's name says of the numbers in it: their unit, and the range that they can lie in."""

import math
import re
from collections.abc import Mapping, Sequence
from functools import cache
from itertools import chain
from typing import Any, TypeGuard

UNITS = {
    "mm_per_cycle": "mm/cycle",
    "kg_m3": "kg/m³",
    "ms_per_s": "ms/s",
    "mrad_s": "mrad/s",
    "mm_s": "mm/s",
    "n_m": "N/m",
    "per_s": "1/s",
    "m_s2": "m/s²",
    "m_s": "m/s",
    "bytes_per_world": "B",
    "bytes": "B",
    "mm": "mm",
    "m": "m",
    "n": "N",
    "s": "s",
    "ms": "ms",
    "hz": "Hz",
    "kg": "kg",
    "count": "1",
}
"""Unit by the end of a column's name; the longest end that fits counts."""

PLAIN = "1"
"""The unit of a number whose column names none."""
LARGEST = {"mm": 1e10, "m": 1e7, "mm/s": 1e10, "m/s": 1e7, "s": 1e8, "ms": 1e9, "N": 1e12, "kg": 1e9, "Hz": 1e9}
"""The largest number that is believed, by unit: what an exploding simulation gives lies below it."""
LARGEST_OF_OTHERS = 1e18
NEVER_NEGATIVE = {"ms", "ms/s", "s", "1/s", "Hz", "kg", "kg/m³", "B", "mm/cycle"}
"""Units of numbers that have no sign."""
MAGNITUDE = re.compile(
    r"(.*_)?(slip|wander|oscillation|penetration|pose_difference|numerical_error|c_difference|edge)_mm"
    r"|.*excess_speed_mm_s|.*_floor_mm(_s)?|(normal|tangential|grip)_force_n|stiffness_n_m|(.*_)?count|substeps|worlds"
)
"""Columns of other units whose numbers have no sign either: a slip is a distance."""
SIGNED = re.compile(r"increment_.*|(used|authored)_.*|(.*_)?growth_per_s")
"""Columns whose numbers have one in spite of their unit: what is added a cycle, what a model was given, a growth."""

PERCENTILE = re.compile(r"_p[0-9]+$")
COLUMN = re.compile(r"[a-z][a-z0-9_]{0,79}")
REASON = "_reason"
UNBELIEVED = "the measurement gave "
"""How the reason begins of a number that was measured and that no record may hold, such as one that is not finite."""
TEXT_LIMIT = 4096
UNPRINTABLE = re.compile(
    "[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069\ud800-\udfff\ue000-\uf8ff\U000f0000-\U0010ffff]"
)
"""Characters that no text needs: control, text turned round, halves of others, and those that mean what one likes."""


@cache
def unit_of(column: str) -> str:
    """The unit that a column's name says; ``1`` when it says none."""
    words = PERCENTILE.sub("", column).split("_")
    ends = ("_".join(words[start:]) for start in range(len(words)))
    return next((UNITS[end] for end in ends if end in UNITS), PLAIN)


def units_of(rows: Sequence[Mapping[str, Any]]) -> dict[str, str]:
    """Units of the columns that hold numbers, missing ones included."""
    there = columns_of(rows)
    columns = [column for column in there if any(is_number(row.get(column)) for row in rows)]
    columns += [column.removesuffix(REASON) for column in there if column.endswith(REASON)]
    return {column: unit_of(column) for column in columns}


def columns_of(rows: Sequence[Mapping[str, Any]]) -> list[str]:
    """All columns, in the order in which the rows have them."""
    return list(dict.fromkeys(chain.from_iterable(rows)))


def is_number(value: Any) -> TypeGuard[int | float]:
    return isinstance(value, int | float) and not isinstance(value, bool)


@cache
def is_column(name: str) -> bool:
    return bool(COLUMN.fullmatch(name))


@cache
def range_of(column: str) -> tuple[float, float]:
    """The least and the largest number that is believed in a column."""
    unit = unit_of(column)
    largest = LARGEST.get(unit, LARGEST_OF_OTHERS)
    has_no_sign = MAGNITUDE.fullmatch(column) or (unit in NEVER_NEGATIVE and not SIGNED.fullmatch(column))
    return 0.0 if has_no_sign else -largest, largest


def number_problem(column: str, value: int | float) -> str:
    """What is wrong with a number in ``column``, in words; empty when nothing is."""
    least, largest = range_of(column)
    if least <= value <= largest:
        return ""
    if isinstance(value, float) and not math.isfinite(value):
        return f"is {value}; a number that does not exist is null, with its {column}{REASON}"
    if -largest <= value < least:
        return f"is {value:g}, and can't be negative"
    unit = unit_of(column)
    return f"is beyond {largest:g}{'' if unit == PLAIN else f' {unit}'}"


def text_problem(text: str) -> str:
    """What is wrong with a text, in words; empty when nothing is."""
    if len(text) > TEXT_LIMIT:
        return f"is a text of more than {TEXT_LIMIT} characters"
    found = UNPRINTABLE.search(text)
    return f"has the character U+{ord(found[0]):04X}, which is no text" if found else ""
