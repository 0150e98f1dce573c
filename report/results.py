"""Results: one section's record as its section module sees it."""

import math
import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import pandas as pd

from report import ReportError
from report.quantities import VALUES_FILE, Quantity, Value, mixed
from report.records.record import Origin, Record
from report.records.traces import load_trace, trace_path


class ResultsError(ReportError):
    """A section module or its template names something that its results don't have."""


@dataclass(frozen=True)
class Series:
    """A per-frame series, or the reason why there is none."""

    value: pd.DataFrame | None
    source: str
    reason: str = ""
    origins: frozenset[Origin] = frozenset()


class Row:
    """One row of a record: ``row.slip_mm`` is a Quantity; text and yes or no stay as they are."""

    def __init__(self, record: Record, index: int, source: str):
        self._cells = record.rows[index]
        self._units = record.units
        self._place = f"{record.section}: {self._cells['case']}"
        self._source = f"{source}#/rows/{index}"
        self._origins = frozenset({record.origin})

    def __getitem__(self, column: str) -> Any:
        if column not in self._cells:
            raise ResultsError(f"{self._place} has no column {column}")
        value = self._cells[column]
        if column not in self._units or isinstance(value, bool | str):
            return value
        reason = self._cells.get(f"{column}_reason", "")
        return Quantity(value, self._units[column], f"{self._source}/{column}", reason, self._origins)

    def __getattr__(self, column: str) -> Any:
        if column.startswith("_"):
            raise AttributeError(column)
        return self[column]

    def __contains__(self, column: str) -> bool:
        return column in self._cells

    @property
    def columns(self) -> list[str]:
        return list(self._cells)


class Rows(dict):
    """Rows by case."""

    def __missing__(self, case: str):
        raise ResultsError(f"there is no single row of case {case!r}; there are: {', '.join(self)}")


@dataclass(frozen=True)
class Results:
    """What was measured for one section of one release, and what has been derived from it."""

    record: Record
    path: Path
    others: Mapping[str, "Results"] = field(default_factory=dict, repr=False)
    """Results of the sections that stand before this one on the page."""
    derived: dict[str, Value] = field(default_factory=dict)
    """Every derived value by name, for the site's values file."""

    @property
    def source(self) -> str:
        """Where the record lies below the site's ``data/``."""
        return f"{self.path.parent.name}/{self.path.name}"

    @cached_property
    def rows(self) -> list[Row]:
        return [Row(self.record, index, self.source) for index in range(len(self.record.rows))]

    @cached_property
    def row(self) -> Rows:
        """Rows by case, those whose case is not unique left out."""
        cases = [row.case for row in self.rows]
        return Rows({row.case: row for row in self.rows if cases.count(row.case) == 1})

    @cached_property
    def seconds(self) -> Quantity:
        """How long the measurement took."""
        return Quantity(self.record.measured["seconds"], "s", f"{self.source}#/measured/seconds")

    def trace(self, case: str) -> Series:
        path, seals = trace_path(self.path, case), self.record.traces
        source = f"{path.parent.name}/{path.name}"
        if not os.path.lexists(path) if seals is None else case not in seals:
            return Series(None, source, f"there is no {path.name}")
        return Series(load_trace(path, seals[case] if seals else None), source, origins=frozenset({self.record.origin}))

    def value(
        self,
        name: str,
        formula: str,
        function: Callable[..., float],
        *sources: Quantity | Series,
        unit: str = "1",
        across: bool = False,
    ) -> Value:
        """The value ``name``: ``function`` of what the sources hold, as ``formula`` says in words.

        It does not exist when one of its sources doesn't, when ``function`` has no finite result, or when the sources
        were measured with different releases or on different machines; ``across`` says that this is the point.
        """
        if name in self.derived:
            raise ResultsError(f"{self.record.section}: the value {name} is derived twice")
        origins = [source.origins for source in sources]
        refusal = "" if across else mixed(*origins)
        value, reason = (None, refusal) if refusal else _evaluate(function, sources)
        self.derived[name] = Value(
            value=value,
            unit=unit,
            source=f"{self.path.parent.name}/{VALUES_FILE}#/{self.record.section}/{name}",
            reason=reason,
            origins=frozenset().union(*origins),
            formula=formula,
            sources=tuple(source.source for source in sources if source.source),
        )
        return self.derived[name]

    def chosen(self, name: str, why: str, value: float, unit: str = "1") -> Value:
        """The value ``name``, which nobody measured: a bound that was set, and ``why`` in words."""
        return self.value(name, f"chosen: {why}", lambda: value, unit=unit)


def _evaluate(function: Callable[..., float], sources: tuple[Quantity | Series, ...]) -> tuple[float | None, str]:
    reasons = [source.reason for source in sources if source.value is None]
    if reasons:
        return None, reasons[0]
    try:
        values = [source.value for source in sources]
        # Given a single number these two would look for the largest or smallest in it.
        value = function(values, default=math.nan) if function in (max, min) else function(*values)
    except ZeroDivisionError:
        return None, "it would be a division by zero"
    value = getattr(value, "item", lambda: value)()
    return (value, "") if math.isfinite(value) else (None, "it has no finite value")
