"""Results: one section's record as its section module sees it."""

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

if (
    TYPE_CHECKING
):  # it takes long to import, and what is kept from before needs none of it
    import pandas as pd

MEANS = (
    "rows"  # begins the names of values that are means of several measurements of a row
)


class ResultsError(ReportError):
    """Tells that from its results a section can't be derived, or can't be said, as by a name that they don't have."""


@dataclass(frozen=True)
class Series:
    """Holds a per-frame series, or the reason why there is none."""

    value: "pd.DataFrame | None"
    source: str
    reason: str = ""
    origins: frozenset[Origin] = frozenset()

    @property
    def reads(self) -> frozenset[str]:
        """Return a pointer to itself."""
        return frozenset({self.source})


class Row:
    """Reads one row: ``row.drag_n`` is a Quantity, an absent one where there is none; text, yes and no stay so.

    ``plain`` has its cells as the record has them, ``source`` its pointer below the site's ``data/``.
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
        self._read = cache(self._cell)  # a section asks for the same again and again

    def __getitem__(self, column: str) -> Any:
        return self._read(column)

    def _cell(self, column: str) -> Any:
        units = self._record.units
        case = self.plain["case"]
        if column not in self.plain:
            if column in units:
                return absent(units[column], self._lack or f"{case} has no {column}")
            if not any(
                column in row for row in self._record.rows
            ):  # what nobody has is neither yes nor no
                lack = (
                    self._lack
                    or f"{case} has no column {column}{suggestion(column, units)}"
                )
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
        """Tell whether the record has it."""
        return not self._lack

    def estimate(self, column: str) -> Estimate | None:
        """Return what is known of one of its numbers; None where nobody knows how that scatters."""
        results = self._results
        return results.evidence.estimate(column, self.plain, results.columns)

    @property
    def columns(self) -> Schema:
        """Return the schema of the columns of its record."""
        return self._results.columns

    @property
    def label(self) -> str:
        """Return what people call its case."""
        return label_of(self.plain["case"], self._results.labels)


class Rows(dict[str, Any]):
    """Holds rows by case; of a case that has no single row, one without anything."""

    def __init__(self, rows: Mapping[str, Row], results: "Results"):
        super().__init__(rows)
        self._results = results

    def __missing__(self, case: str) -> Row:
        return Row(self._results, None, case)


@dataclass(frozen=True)
class Results:
    """Holds measurements of one section of one release, and what has been derived from them."""

    record: Record
    path: Path
    others: Mapping[str, "Results"] = field(
        default_factory=dict, repr=False
    )  # of sections before this one on the page
    derived: dict[str, Value] = field(
        default_factory=dict
    )  # every derived value by name, for the site's values file
    evidence: Evidence = field(
        default_factory=Evidence, repr=False
    )  # what all measurements of it say of its numbers
    label: str = ""  # name of the section in figures and tables
    labels: Mapping[str, str] = field(default_factory=dict, repr=False)
    """What people call its cases, see ``label_of``; a number that is not there says of which run it is."""
    columns: Schema = field(default_factory=lambda: report().columns, repr=False)

    @property
    def edition(self) -> str:
        """Return the label of the edition that it belongs to."""
        return self.columns.settings.edition_in(self.path.parent.name)

    @property
    def source(self) -> str:
        """Return where the record lies below the site's ``data/``."""
        return f"{self.path.parent.name}/{self.path.name}"

    @property
    def values_file(self) -> str:
        """Return the pointer to its derived values below the site's ``data/``."""
        return f"{self.path.parent.name}/{VALUES_FILE}#/{self.record.section}"

    @cached_property
    def rows(self) -> list[Row]:
        """Return all rows but those that say of a setting, or of a text, why it is not there."""
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
        """Return rows by case, those whose case is not unique left out."""
        return Rows(single((row.plain["case"], row) for row in self.rows), self)

    def means(self, names: Iterable[str]) -> dict[str, Value]:
        """Return those of its numbers that are means of measurements and have these names among its values."""
        places = {name: name.split(".") for name in sorted(names)}
        return {
            name: Row(self, int(index))[column]
            for name, (_, index, column) in places.items()
        }

    def trace(self, case: str) -> Series:
        """Return the trace of a case, ``.value`` a table; None, and the reason, where there is none."""
        path = trace_path(self.path, case)
        source = f"{path.parent.name}/{path.name}"
        if not (seal := self.record.traces.get(case)):
            return Series(None, source, f"there is no {path.name}")
        if len(table := self.loaded(path)) != seal.row_count:
            raise RecordError(
                f"{source} has {len(table)} rows, and its record says {seal.row_count}"
            )
        return Series(table, source, origins=frozenset({self.record.origin}))

    def loaded(self, path: Path) -> "pd.DataFrame":
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
        """Derive the value ``name``: arithmetic on quantities, as ``a / b``, which ``formula`` says in words.

        What is no arithmetic is a function of what the sources hold, with a ``unit``. The value does not exist when a
        source doesn't, when it has no finite result, or when the sources are of different releases or machines, unless
        ``across``. Its noise is what theirs make of it, unless it ``is_noise``.
        """
        if name in self.derived:
            raise ResultsError(
                f"{self.record.section}: the value {name} is derived twice"
            )
        if isinstance(function, Quantity):
            unit = function.unit
            sources = (function,)
            function = operator.pos
        if re.search(r"[\s/~#]", name):
            raise ResultsError(
                f"the value {name!r} has a blank or one of / ~ #, which no pointer to it can have"
            )
        assert formula.strip(), (
            f"the value {name} has no words for how it is computed, or why it was chosen"
        )
        if not self.columns.is_unit(unit):
            raise ResultsError(
                f"the value {name} has the unit {unit}, not known here; units in report.toml adds it"
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
        sources = tuple(leaf.source for leaf in term.leaves if leaf.source)
        fields = {name: getattr(term, name) for name in names} | {
            "sources": sources,
            "formula": formula,
        }
        self.derived[name] = Value(source=f"{self.values_file}/{name}", **fields)
        return self.derived[name]

    def chosen(self, name: str, why: str, value: float, unit: str = PLAIN) -> Value:
        """Set the value ``name``, which nobody measured: a bound, and ``why`` in words."""
        return self.value(
            name,
            f"chosen: {why}" if why.strip() else "",
            operator.pos,
            value,
            unit=unit,
        )
