"""Provide the measurements of a section to its module."""

import operator
import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cache, cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from measured_report.files.atomic import RecordError
from measured_report.files.columns import PLAIN, REASON, Schema
from measured_report.files.config import report
from measured_report.files.errors import ReportError, suggestion
from measured_report.files.groups import single
from measured_report.records.record import Origin, Record, trace_path
from measured_report.records.traces import load_trace
from measured_report.values.evidence import Evidence
from measured_report.values.format import label_of
from measured_report.values.noise import Estimate
from measured_report.values.quantities import (
    VALUES_FILE,
    Quantity,
    Value,
    absent,
    combined,
)

if TYPE_CHECKING:  # slow to import, and a cached build does not need it
    import pandas as pd

MEANS = "rows"  # the first part of the names for means over a row's measurements


class ResultsError(ReportError):
    """Signals that a section cannot be derived or printed from its results.

    For example, the results do not have a column that it uses.
    """


@dataclass(frozen=True)
class Series:
    """The series of a trace by frame, or the reason why it is missing."""

    value: "pd.DataFrame | None"
    source: str
    reason: str = ""
    origins: frozenset[Origin] = frozenset()

    @property
    def reads(self) -> frozenset[str]:
        """Return the pointer to the series."""
        return frozenset({self.source})


class Row:
    """Gives access to the cells of a row: ``row.drag_n`` is a Quantity.

    If the number is missing, the Quantity has a reason instead of a value. Texts and
    flags are returned unchanged. ``plain`` contains the cells as the record stores
    them, and ``source`` is the pointer to the row below the site's ``data/``.
    """

    def __init__(self, results: "Results", index: int | None, case: str = ""):
        self._results = results
        self._record = results.record
        self._index = index
        self.plain: Mapping[str, Any] = (
            {"case": case} if index is None else self._record.rows[index]
        )
        count = (
            sum(row["case"] == case for row in self._record.rows)
            if index is None
            else 0
        )
        lack = (
            f"there are {count} rows of case {case}"
            if count > 1
            else f"there is no single row of case {case}"
        )
        self._lack = lack if index is None else ""
        self.source = f"{results.source}#/rows/{index}"
        self._origins = frozenset({self._record.origin})
        self._read = cache(self._cell)  # a section reads the same cell many times

    def __getitem__(self, column: str) -> Any:
        return self._read(column)

    def _cell(self, column: str) -> Any:
        units = self._record.units
        case = self.plain["case"]
        if column not in self.plain:
            if column in units:
                return absent(units[column], self._lack or f"{case} has no {column}")
            # A text or flag may be missing in a row, but a name that no row has is wrong.
            if not any(column in row for row in self._record.rows):
                similar = suggestion(column, units)
                lack = self._lack or f"{case} has no column {column}{similar}"
                raise ResultsError(f"{self._record.section}: {lack}")
            return ""
        value = self._results.columns.number_of(column, self.plain)
        if column not in units or isinstance(value, bool | str):
            return value
        unit = units[column]
        origins = self._origins
        pointer = f"{self.source}/{column}"
        if value is None:
            reason = self.plain.get(column + REASON)
            reason = reason or self.columns.trials_problem(column, self.plain) or "lost"
            reason = ": ".join(filter(None, (self.label, reason)))
            return Quantity(None, unit, pointer, reason, origins)
        estimate = self.estimate(column)
        if not estimate:
            return Quantity(value, unit, pointer, "", origins)
        details = (
            estimate.written_noise,
            estimate.note,
            estimate.samples,
            estimate.is_shared,
        )
        if estimate.value == value:
            return Quantity(value, unit, pointer, "", origins, *details)
        mean = f"{self._results.values_file}/{MEANS}.{self._index}.{column}"
        return Value(
            estimate.value,
            unit,
            mean,
            "",
            origins,
            *details,
            sources=(pointer,),
            roots=frozenset({pointer}),
        )

    def __getattr__(self, column: str) -> Any:
        if column.startswith("_"):
            raise AttributeError(column)
        return self[column]

    def __contains__(self, column: str) -> bool:
        return column in self.plain

    def __bool__(self) -> bool:
        """Return whether the record has this row."""
        return not self._lack

    def estimate(self, column: str) -> Estimate | None:
        """Return the estimate of a number, or None if its scatter is not known."""
        results = self._results
        return results.evidence.estimate(column, self.plain, results.columns)

    @property
    def columns(self) -> Schema:
        """Return the schema of the columns."""
        return self._results.columns

    @property
    def label(self) -> str:
        """Return the label of the case."""
        return label_of(self.plain["case"], self._results.labels)


class Rows(dict[str, Any]):
    """Rows by case. A case with no row or several rows has a row without cells."""

    def __init__(self, rows: Mapping[str, Row], results: "Results"):
        super().__init__(rows)
        self._results = results

    def __missing__(self, case: str) -> Row:
        return Row(self._results, None, case)


@dataclass(frozen=True)
class Results:
    """The measurements of a section in an edition, and its derived values."""

    record: Record
    path: Path
    others: Mapping[str, "Results"] = field(default_factory=dict, repr=False)
    """The results of the sections that this one can read."""
    derived: dict[str, Value] = field(default_factory=dict)
    """All derived values by name."""
    evidence: Evidence = field(default_factory=Evidence, repr=False)
    """All measurements of the section. They determine the noise of its numbers."""
    label: str = ""  # name of the section in figures and tables
    labels: Mapping[str, str] = field(default_factory=dict, repr=False)
    """The labels of the cases, see ``label_of``. The reason for a missing number begins
    with the label of its case."""
    columns: Schema = field(default_factory=lambda: report().columns, repr=False)

    @property
    def edition(self) -> str:
        """Return the label of the edition."""
        return self.columns.settings.edition_in(self.path.parent.name)

    @property
    def source(self) -> str:
        """Return the path of the record below the site's ``data/``."""
        return f"{self.path.parent.name}/{self.path.name}"

    @property
    def values_file(self) -> str:
        """Return the pointer to the derived values below the site's ``data/``."""
        return f"{self.path.parent.name}/{VALUES_FILE}#/{self.record.section}"

    @cached_property
    def rows(self) -> list[Row]:
        """Return all rows, except rows without one of the settings or texts."""
        return [
            Row(self, index)
            for index, row in enumerate(self.record.rows)
            if not self._lacks_setting(row)
        ]

    def _lacks_setting(self, row: Mapping[str, Any]) -> bool:
        names = (
            name
            for name, cell in row.items()
            if cell is None and row.get(name + REASON)
        )
        return any(
            name not in self.record.units or "parameter" in self.columns[name].kinds
            for name in names
        )

    @cached_property
    def row(self) -> Rows:
        """Return rows by case, except cases that have several rows."""
        return Rows(single((row.plain["case"], row) for row in self.rows), self)

    def means(self, names: Iterable[str]) -> dict[str, Value]:
        """Return the means over measurements that have these names as values."""
        values = {}
        for name in sorted(names):
            _, index, column = name.split(".")
            values[name] = Row(self, int(index))[column]
        return values

    def trace(self, case: str) -> Series:
        """Return the trace of a case, with a table as its ``.value``.

        If the trace is missing, the value is None and there is a reason.
        """
        path = trace_path(self.path, case)
        source = f"{path.parent.name}/{path.name}"
        if not (seal := self.record.traces.get(case)):
            return Series(None, source, f"there is no {path.name}")
        if len(table := self.loaded(path)) != seal.row_count:
            raise RecordError(
                f"{source} has {len(table)} rows, but its record expects "
                f"{seal.row_count}: restore the file or measure the section again"
            )
        return Series(table, source, origins=frozenset({self.record.origin}))

    def loaded(self, path: Path) -> "pd.DataFrame":
        """Return the trace that is stored in a file."""
        return load_trace(path)

    def value(
        self,
        name: str,
        formula: str,
        function: Callable[..., float] | Quantity,
        *sources: Quantity | Series | float,
        unit: str = PLAIN,
        across: bool = False,
        is_noise: bool = False,
    ) -> Value:
        """Derive the value ``name``, whose ``formula`` describes the computation in
        words. ``function`` is arithmetic with quantities, such as ``a / b``, or a
        function of the values of ``sources`` with a ``unit``. The value is missing if a
        source is missing, if the result is not finite, or if the sources are from
        different releases or machines and ``across`` is not set. Its noise is computed
        from the noise of the sources. A value that ``is_noise`` has no noise itself.
        """
        if name in self.derived:
            raise ResultsError(
                f"{self.record.section}: the value {name} is derived twice: rename one "
                "of them"
            )
        if not (isinstance(function, Quantity) or callable(function)):
            raise ResultsError(
                f"the value {name} = {function!r} was not measured: use "
                "results.chosen(…)"
            )
        if isinstance(function, Quantity):
            unit = function.unit
            sources = (function,)
            function = operator.pos
        if re.search(r"[\s/~#]", name):
            raise ResultsError(
                f"the name {name!r} of a value contains white space or one of / ~ #: "
                "rename it, because pointers cannot contain these characters"
            )
        assert formula.strip(), (
            f"the value {name} has no formula: describe in words how it is computed or "
            "why it was chosen"
        )
        if not self.columns.is_unit(unit):
            raise ResultsError(
                f"the value {name} has the unknown unit {unit}: add it to units in "
                "report.toml"
            )
        term = combined(function, *sources, unit=unit, across=across)
        names = (
            "value",
            "unit",
            "reason",
            "origins",
            *(() if is_noise else ("noise", "samples", "is_shared")),
            "roots",
        )
        fields = {name: getattr(term, name) for name in names}
        fields["sources"] = tuple(leaf.source for leaf in term.leaves if leaf.source)
        fields["formula"] = formula
        self.derived[name] = Value(source=f"{self.values_file}/{name}", **fields)
        return self.derived[name]

    def chosen(self, name: str, why: str, value: float, unit: str = PLAIN) -> Value:
        """Set the value ``name`` to a chosen number, such as a bound.

        ``why`` is the reason for the choice in words.
        """
        return self.value(
            name,
            f"chosen: {why}" if why.strip() else "",
            operator.pos,
            value,
            unit=unit,
        )
