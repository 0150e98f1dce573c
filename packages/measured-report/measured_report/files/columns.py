"""Describe the columns of records by their names and by ``report.toml``.

The end of a column's name determines its unit.
"""

import re
from collections.abc import Mapping, Sequence
from dataclasses import MISSING, dataclass, fields, is_dataclass
from functools import cache, cached_property
from itertools import chain
from typing import Any, TypeGuard

from measured_report.files.errors import UNPRINTABLE, ReportError
from measured_report.files.settings import FILE, Columns, Config, module_named
from measured_report.files.units import LIKE_UNIT, SYMBOL

_LENGTHS = {
    "mm": "mm",
    "m": "m",
    "mm_s": "mm/s",
    "m_s": "m/s",
    "m_s2": "m/s²",
    "mm_per_cycle": "mm/cycle",
}
_TIMES = {
    "s": "s",
    "ms": "ms",
    "us": "µs",
    "ns": "ns",
    "ms_per_s": "ms/s",
    "per_s": "1/s",
    "hz": "Hz",
    "mrad_s": "mrad/s",
}
_OTHERS = {
    "n": "N",
    "n_m": "N/m",
    "kg": "kg",
    "kg_m3": "kg/m³",
    "bytes": "B",
    "mb": "MB",
    "gb": "GB",
    "percent": "%",
    "count": "1",
}
PLAIN = "1"  # the unit of a number whose column does not name one
LARGEST = {
    "mm": 1e10,
    "m": 1e7,
    "mm/s": 1e10,
    "m/s": 1e7,
    "s": 1e8,
    "ms": 1e9,
    "N": 1e12,
    "kg": 1e9,
    "Hz": 1e4,
}
"""The largest plausible number for each unit; larger ones come from simulations that
diverged.
"""
NEVER_NEGATIVE = {
    "ms",
    "ms/s",
    "s",
    "1/s",
    "Hz",
    "kg",
    "kg/m³",
    "B",
    "mm/cycle",
}  # units of numbers that are never negative
REASON = "_reason"
PERCENTILE = re.compile("_p[0-9]+$")
# The start of the reason for a number that a record must not contain, such as infinity.
IMPLAUSIBLE = "the measurement gave "
TEXT_LIMIT = 4096  # characters; a cell is printed on a page and in messages


TRAITS = (
    "better",
    "resolution",
    "rate_of",
    "known_within",
    "grows_with",
    "trials",
    "unless",
)
"""Properties of a column; each is taken from the first table that sets it."""


@dataclass(frozen=True, kw_only=True)
class Column(Columns):
    """Describe a column by its name and its settings in ``report.toml``."""

    name: str
    unit: str  # `1` if the name does not include a unit
    words: str  # the name in words, without the unit
    least: float  # the smallest plausible number
    largest: float
    kinds: frozenset[str]

    @cached_property
    def is_setting(self) -> bool:
        """Return whether the column was set before the run, like a case's parameter."""
        return not self.kinds.isdisjoint(("parameter", "setting"))

    @cached_property
    def is_exact(self) -> bool:
        """Return whether the column is set or computed from settings, without noise."""
        return self.is_setting or "computed" in self.kinds

    @property
    def is_cost(self) -> bool:
        """Return whether the numbers depend on the machine: times, rates or memory."""
        return "cost" in self.kinds


class Schema:
    """Describe the columns of a report: ``schema["depth_mm"]`` is a `Column`.

    Args:
        settings: the settings of ``report.toml``, which complement the columns' names.
        parameters: the parameters of a case with their defaults, or ``MISSING``.
    """

    def __init__(self, settings: Config, parameters: Mapping[str, Any]):
        self.settings = settings
        self.parameters = parameters
        self._columns: dict[str, Column] = {}
        own_units = _LENGTHS | _TIMES | _OTHERS
        for end, unit in settings.units.items():
            if not unit:
                raise ReportError(f"{FILE}: units has {end} without a unit: add one")
            if own_units.get(end, unit) != unit:
                raise ReportError(
                    f"{FILE}: units has {end}, which already means {own_units[end]}: "
                    "use another ending"
                )
        self.units: Mapping[str, str] = own_units | dict(settings.units)
        """The units by the end of a column's name; the longest matching end counts."""

    def __getitem__(self, name: str) -> Column:
        if name not in self._columns:
            self._columns[name] = self._column(name)
        return self._columns[name]

    def _column(self, name: str) -> Column:
        declared = [
            table
            for table in self.settings.columns
            if name in table.names or re.fullmatch(table.pattern, name)
        ]
        if len({table.better for table in declared if name in table.names} - {""}) > 1:
            raise ReportError(
                f"{FILE}: column {name} is listed both as lower-is-better and "
                "as higher-is-better"
            )
        unit = self.units.get(self._end(name), PLAIN)
        largest = LARGEST.get(unit, 1e18)
        signs = [table.signed for table in declared if table.signed is not None]
        # The first table that states the sign wins over the unit.
        is_signed = [*signs, unit not in NEVER_NEGATIVE][0]
        kinds = {table.kind for table in declared} - {""}
        if name in self.parameters:
            kinds.add("parameter")
        traits = {}
        for trait in TRAITS:
            values = filter(None, (getattr(table, trait) for table in declared))
            traits[trait] = next(values, getattr(Columns, trait))
        return Column(
            name=name,
            unit=unit,
            words=self._words(name, unit),
            least=-largest if is_signed else 0.0,
            largest=largest,
            kinds=frozenset(kinds),
            **traits,
        )

    def _end(self, name: str) -> str:
        """Return the longest known end of a name, which determines the unit.

        An end like ``_p95`` is ignored.
        """
        pieces = PERCENTILE.sub("", name).split("_")
        ends = ("_".join(pieces[start:]) for start in range(len(pieces)))
        return next((end for end in ends if end in self.units), "")

    def unit_problem(self, name: str) -> str:
        """Return the problem with the unit of a column, or an empty string.

        For example, the unit of ``speed_km_s`` is s, because km_s is not known.
        """
        end = self._end(name)
        unit = self[name].unit
        match = LIKE_UNIT.search(PERCENTILE.sub("", name).removesuffix(f"_{end}"))
        if not match or (end and (unit == PLAIN or len(match[1]) == 1)):
            return ""
        missing = "_".join(filter(None, (match[1], end)))
        return (
            f"column {name} has {f'the unit {unit}' if end else 'no unit'}: add "
            f"{missing} to units in {FILE}, or rename the column"
        )

    def _words(self, name: str, unit: str) -> str:
        ends = [
            end
            for end in self.units
            if self.units[end] == unit != PLAIN and name.endswith(f"_{end}")
        ]
        return name.removesuffix(f"_{max(ends, key=len)}" if ends else "").replace(
            "_", " "
        )

    def is_unit(self, text: str) -> bool:
        """Return whether a text is a unit or combines units with ``/`` and ``·``."""
        unknown = {
            factor for factor in re.split("[/·]", text) if not SYMBOL.fullmatch(factor)
        }
        declared = {
            factor
            for unit in self.units.values()
            for factor in (unit, *re.split("[/·]", unit))
        }
        return unknown <= declared

    def changed_parameters(self, row: Mapping[str, Any]) -> dict[str, Any]:
        """Return the parameters of a row's case that differ from their defaults."""
        return {
            name: cell
            for name, cell in row.items()
            if self.parameters.get(name, MISSING) not in (MISSING, cell)
        }

    def changes_text(self, row: Mapping[str, Any]) -> str:
        """Return the parameters that differ from their defaults as text."""
        changed = self.changed_parameters(row).items()
        return ", ".join(f"{name} {value}" for name, value in changed)

    def number_of(self, column: str, row: Mapping[str, Any]) -> Any:
        """Return a cell of a row, or None if the cell has no meaning.

        This is the case if the run failed, or if more trials succeeded than there were.
        """
        if row.get(self[column].unless) or self.trials_problem(column, row):
            return None
        return row[column]

    def trials_problem(self, column: str, row: Mapping[str, Any]) -> str:
        """Return the problem with a count, or share, of trials, or an empty string."""
        name = self[column].trials
        count = row.get(name)
        value = row[column]
        if not count or value is None:
            return ""
        largest = count if column.endswith("_count") else 1
        if 0 <= value <= largest:
            return ""
        return f"{row['case']} has {column} {value:g}, with {name} {count:g}"

    def units_of(self, rows: Sequence[Mapping[str, Any]]) -> dict[str, str]:
        """Return the units of all columns with numbers, including missing numbers."""
        columns = columns_of(rows)
        numeric = {
            name for row in rows for name, cell in row.items() if is_number(cell)
        }
        names = [name for name in columns if name in numeric]
        names += [
            name.removesuffix(REASON) for name in columns if name.endswith(REASON)
        ]
        return {name: self[name].unit for name in names}

    def number_problem(self, name: str, value: int | float) -> str:
        """Return the problem with a number in column ``name``, or an empty string."""
        column = self[name]
        if column.least <= value <= column.largest:
            return ""
        return (
            f"is {value!r:.20}, outside of the range {column.least:g} to "
            f"{column.largest:g}"
        )

    def refuse_mixed(
        self, rows: Sequence[Mapping[str, Any]], recorded: Mapping[str, str]
    ) -> None:
        """Raise ValueError if rows contradict their columns.

        The ``recorded`` units must agree with the names of the columns, a column must
        not mix numbers, text and booleans, and numbers must be in the range of their
        column.
        """
        units = self.units_of(rows)
        for name in sorted({*units, *recorded}):
            if recorded.get(name) != units.get(name):
                raise ValueError(
                    f"the unit of {name} is {recorded.get(name)}, but its name implies "
                    f"{units.get(name)}"
                )
        for name in columns_of(rows):
            cells = [(row, row[name]) for row in rows if name in row]
            types = {type(cell) for _, cell in cells} - {int, float, type(None)}
            if types and (name in units or self[name].unit != PLAIN):
                raise ValueError(f"{name} contains values that are not numbers")
            if len(types) > 1:
                raise ValueError(f"{name} contains both text and booleans")
            if name not in units:
                continue
            if not all(row.get(name + REASON) for row, cell in cells if cell is None):
                raise ValueError(f"{name} is null without a {name}{REASON}")
            numbers = [cell for _, cell in cells if cell is not None]
            for number in (min(numbers), max(numbers)) if numbers else ():
                if problem := self.number_problem(name, number):
                    raise ValueError(f"{name} {problem}")


def case_parameters(settings: Config) -> Mapping[str, Any]:
    """Return the fields of the dataclass ``case`` with defaults, or ``MISSING``."""
    if not settings.case:
        return {}
    module, _, name = settings.case.partition(":")
    case = getattr(module_named("case", module), name, None)
    if not is_dataclass(case):
        raise ReportError(
            f"{FILE}: case = {settings.case!r} does not exist or is not a "
            "dataclass: use module:name"
        )
    return {field.name: field.default for field in fields(case)}


def columns_of(rows: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return the names of all columns in the order of the rows."""
    return list(dict.fromkeys(chain.from_iterable(rows)))


def implausible_cells(row: Mapping[str, Any]) -> dict[str, str]:
    """Return the reasons why implausible numbers were not recorded, by column."""
    reasons = {
        name.removesuffix(REASON): str(cell)
        for name, cell in row.items()
        if name.endswith(REASON)
    }
    return {
        name: reason
        for name, reason in reasons.items()
        if reason.startswith(IMPLAUSIBLE)
    }


def is_number(value: Any) -> TypeGuard[int | float]:
    # A tuple, because making a union for each cell would be as slow as all other steps
    # together.
    return isinstance(value, (int, float)) and not isinstance(value, bool)


def plain(cell: Any, name: str) -> Any:
    """Return a cell as a plain Python value.

    Raise ReportError for a value that a record cannot contain, such as a list.
    """
    value = cell.item() if getattr(cell, "ndim", None) == 0 else cell
    if value is None or isinstance(value, bool | int | float | str):
        return value
    raise ReportError(
        f"column {name} contains {value!r:.80}: use numbers, text, True or False"
    )


def name_problem(text: str) -> str:
    """Return the problem with a text that is printed in a line, or an empty string."""
    return text_problem(text) or (
        "contains a tab or a line break" if re.search(r"[\n\t]", text) else ""
    )


@cache
def text_problem(text: str) -> str:
    if len(text) > TEXT_LIMIT:
        return f"is longer than {TEXT_LIMIT} characters"
    return unprintable(text)


def unprintable(text: str) -> str:
    match = UNPRINTABLE.search(text)
    return (
        f"contains the character U+{ord(match[0][0]):04X}, which cannot be printed"
        if match
        else ""
    )
