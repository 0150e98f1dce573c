"""Columns: what is known of the numbers in a column: the end of its name is their unit, the rest in ``report.toml``."""

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import MISSING, dataclass, fields, is_dataclass
from functools import cache, cached_property
from itertools import chain
from typing import Any, TypeGuard

from measured_report.files.config import FILE, ColumnTraits, cached_in_report, config, module_of
from measured_report.files.errors import UNPRINTABLE, ReportError

_LENGTHS = {"mm": "mm", "m": "m", "mm_s": "mm/s", "m_s": "m/s", "m_s2": "m/s²", "mm_per_cycle": "mm/cycle"}
_TIMES = {"s": "s", "ms": "ms", "ms_per_s": "ms/s", "per_s": "1/s", "hz": "Hz", "mrad_s": "mrad/s"}
_OTHERS = {"n": "N", "n_m": "N/m", "kg": "kg", "kg_m3": "kg/m³", "bytes": "B", "count": "1"}
SYMBOL = re.compile(r"(?:[nµmkMGT]?(?:m|s|g|N|J|W|V|A|K|B|bit|Pa|Hz|rad|mol)|cm|min|h|°C?|%|1|dB)[²³]?")
"""A unit that nobody declares; several make one with ``/`` and ``·``. Numbers are never converted, so this is all."""
PLAIN = "1"  # the unit of a number whose column names none
LARGEST = {"mm": 1e10, "m": 1e7, "mm/s": 1e10, "m/s": 1e7, "s": 1e8, "ms": 1e9, "N": 1e12, "kg": 1e9, "Hz": 1e4}
"""The largest number that is believed, by unit: what an exploding simulation gives lies below it."""
NEVER_NEGATIVE = {"ms", "ms/s", "s", "1/s", "Hz", "kg", "kg/m³", "B", "mm/cycle"}  # units of numbers that have no sign
REASON = "_reason"
UNBELIEVED = "the measurement gave "  # begins the reason of a number that no record may hold, as one that is not finite
TEXT_LIMIT = 4096


@dataclass(frozen=True, kw_only=True)
class Column(ColumnTraits):
    """Describes a column; what ``report.toml`` says of it is told there."""

    name: str
    unit: str  # `1` where the name says none
    least: float  # of the numbers that are believed, as the next
    largest: float
    kinds: frozenset[str]

    @cached_property
    def is_setting(self) -> bool:
        """Tell whether it was set before a run: a parameter of a case, or how much was run."""
        return not self.kinds.isdisjoint(("parameter", "setting"))

    @property
    def words(self) -> str:
        """Write its name in words, without the unit."""
        ends = [end for end, unit in units().items() if unit == self.unit != PLAIN and self.name.endswith(f"_{end}")]
        return self.name.removesuffix(f"_{max(ends, key=len)}" if ends else "").replace("_", " ")

    @cached_property
    def is_exact(self) -> bool:
        """Tell whether it holds what was set, or made from that alone, and so has no noise."""
        return self.is_setting or "computed" in self.kinds


@cached_in_report
def units() -> Mapping[str, str]:
    """Return the unit by the end of a column's name; the longest end that fits counts."""
    known = _LENGTHS | _TIMES | _OTHERS
    if other := [end for end, unit in config().units.items() if not unit or known.get(end, unit) != unit]:
        raise ReportError(f"{FILE}: units has {other[0]}, which is {known.get(other[0], 'empty')}: take another end")
    return known | dict(config().units)


@cached_in_report
def column_of(name: str) -> Column:
    declared = [table for table in config().columns if name in table.names or re.fullmatch(table.pattern, name)]
    if len({table.better for table in declared if name in table.names} - {""}) > 1:
        raise ReportError(f"{FILE}: of {name} both less and more is better, by two tables of columns")
    pieces = re.sub("_p[0-9]+$", "", name).split("_")
    ends = ("_".join(pieces[start:]) for start in range(len(pieces)))
    unit = next((units()[end] for end in ends if end in units()), PLAIN)
    largest = LARGEST.get(unit, 1e18)
    signed = next((table.signed for table in declared if table.signed is not None), unit not in NEVER_NEGATIVE)
    kinds = {table.kind for table in declared if table.kind} | ({"parameter"} if name in parameters() else set())
    names = [field.name for field in fields(ColumnTraits)]
    traits = {field: value for table in reversed(declared) for field in names if (value := getattr(table, field))}
    least = -largest if signed else 0.0
    return Column(name=name, unit=unit, least=least, largest=largest, kinds=frozenset(kinds), **traits)


@cached_in_report
def parameters() -> Mapping[str, Any]:
    """Return the parameters of a case and their defaults, ``MISSING`` for one that has none."""
    module, _, name = config().case.partition(":")
    case = getattr(module_of("case"), name, None) if module else None
    if module and not is_dataclass(case):
        raise ReportError(f"{FILE}: case = {config().case!r}: there is no such dataclass")
    return {field.name: field.default for field in fields(case)} if case else {}


def is_cost(column: str) -> bool:
    """Tell whether a column's numbers are of the machine: times, rates, bytes."""
    return "cost" in column_of(column).kinds


def is_unit(text: str) -> bool:
    unknown = {factor for factor in re.split("[/·]", text) if not SYMBOL.fullmatch(factor)}
    return not unknown or unknown <= {factor for unit in units().values() for factor in (unit, *re.split("[/·]", unit))}


def unlike(units: Iterable[str]) -> list[str]:
    """Return two units of one kind that are not the same, as ms and s are; nothing where there are none."""
    kinds: dict[str, str] = {}
    for unit in units:
        kind = re.sub(r"(?<![^/·])[nµmkMGT](?=(?:m|s|g|N|J|W|V|A|K|B|bit|Pa|Hz|rad|mol)(?![a-zA-Z]))", "", unit)
        if kinds.setdefault(kind, unit) != unit:
            return [kinds[kind], unit]
    return []


def changed_parameters(row: Mapping[str, Any]) -> dict[str, Any]:
    """Return the parameters of a row's case that differ from their defaults."""
    return {name: cell for name, cell in row.items() if parameters().get(name, MISSING) not in (MISSING, cell)}


def number_of(column: str, row: Mapping[str, Any]) -> Any:
    """Return a cell of a row, None for a number that what was lost does not have."""
    return None if row.get(column_of(column).unless) else row[column]


def units_of(rows: Sequence[Mapping[str, Any]]) -> dict[str, str]:
    """Return the units of the columns that hold numbers, missing ones included."""
    columns, numeric = columns_of(rows), {name for row in rows for name, cell in row.items() if is_number(cell)}
    names = [name for name in columns if name in numeric]
    names += [name.removesuffix(REASON) for name in columns if name.endswith(REASON)]
    return {name: column_of(name).unit for name in names}


def refuse_mixed(rows: Sequence[Mapping[str, Any]], noted: Mapping[str, str]) -> None:
    """Raise ValueError unless the units given are those of the columns' names, and a column holds one kind of thing."""
    units = units_of(rows)
    for name in sorted({*units, *noted}):
        if noted.get(name) != units.get(name):
            raise ValueError(f"the unit of {name} is given as {noted.get(name)}, and its name says {units.get(name)}")
    for name in columns_of(rows):
        holding = [row for row in rows if name in row]
        types = {type(row[name]) for row in holding} - {int, float, type(None)}
        if types and (name in units or column_of(name).unit != PLAIN):
            raise ValueError(f"{name} is not all numbers")
        if len(types) > 1:
            raise ValueError(f"{name} is text in one row and yes or no in another")
        if name in units and not all(row.get(name + REASON) for row in holding if row[name] is None):
            raise ValueError(f"{name} is null without a {name}{REASON}")
        numbers = [row[name] for row in holding if row[name] is not None] if name in units else []
        for number in (min(numbers), max(numbers)) if numbers else ():
            if problem := number_problem(name, number):
                raise ValueError(f"{name} {problem}")


def columns_of(rows: Sequence[Mapping[str, Any]]) -> list[str]:
    """Name all columns, in the order in which the rows have them."""
    return list(dict.fromkeys(chain.from_iterable(rows)))


def is_number(value: Any) -> TypeGuard[int | float]:
    return isinstance(value, int | float) and not isinstance(value, bool)


def plain(cell: Any, name: str) -> Any:
    """Return a cell as Python has it where it is NumPy's; ReportError for what no record may hold."""
    value = cell.item() if getattr(cell, "ndim", None) == 0 else cell
    if value is None or isinstance(value, bool | int | float | str):
        return value
    raise ReportError(f"the column {name} has {value!r:.80}, which is no number, text, yes or no")


def number_problem(name: str, value: int | float) -> str:
    """Say what is wrong with a number in the column ``name``; empty when nothing is."""
    column = column_of(name)
    if column.least <= value <= column.largest:
        return ""
    return f"is {value!r:.20}, and no number from {column.least:g} to {column.largest:g}"


def name_problem(text: str) -> str:
    """Say what is wrong with a text that is printed as a part of a line; empty when nothing is."""
    return text_problem(text) or ("has a tab or more than one line" if re.search(r"[\n\t]", text) else "")


@cache
def text_problem(text: str) -> str:
    if len(text) > TEXT_LIMIT:
        return f"is a text of more than {TEXT_LIMIT} characters"
    match = UNPRINTABLE.search(text)
    return f"has the character U+{ord(match[0][0]):04X}, which is no text" if match else ""
