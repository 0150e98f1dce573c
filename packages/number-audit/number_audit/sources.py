"""Reads result files and finds each number by the names that lead to it.

CSV tables and any JSON are supported. For pytest-benchmark, hyperfine, criterion,
google-benchmark and asv, the units and the noise are known as well.
"""

import csv
import io
import json
import math
import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from difflib import get_close_matches
from pathlib import Path
from typing import Any, TypeGuard
from urllib.parse import unquote

from number_audit.files import AuditError
from number_audit.quantities import (
    NO_UNIT,
    UNITS,
    Quantity,
    Z,
    mean_noise,
    sample_mean,
)

NAMES = ("name", "case", "command", "benchmark", "operation", "label", "id")
"""Keys whose text is the name of an element of a list."""

SAMPLES = ("times", "data", "samples")
"""Keys of a list with several samples of one number."""

IN_SECONDS = {
    *("mean", "median", "min", "max", "stddev", "iqr", "q1", "q3"),
    *("total", "user", "system", "times", "data"),
}
"""Keys of pytest-benchmark and hyperfine with a value in seconds."""

ERROR_RATIO = {"mean": 1.0, "median": 1.2533}
"""Ratio of the standard error to that of the mean of many samples."""

CELL = re.compile(r"[-+]?\d{1,20}(\.\d{0,20})?(e[-+]?\d{1,3})?", re.IGNORECASE)
"""Matches a number in a CSV table."""

NoiseOfRecord = Callable[[Path, int, str], float | None]
"""Returns the noise of a number in a record by its file, row and column.

A record is JSON with the keys "identity" and "rows". It has no noise, but the program
that measured it may know the noise.
"""


@dataclass(frozen=True)
class Place:
    """A number, or several samples of it, in a file."""

    key: str
    value: Any
    beside: Mapping[str, Any] = field(default_factory=dict)
    """The object or the row that contains it."""


class Source:
    """The numbers of one result file."""

    def __init__(
        self, path: Path, content: bytes, noise_of_record: NoiseOfRecord | None = None
    ):
        self._path = path
        self._noise_of_record = noise_of_record
        text = content.decode("utf-8-sig")
        if path.suffix.lower() == ".csv":
            self._data: Any = _table(text)
        else:
            # Floats can be read quickly however many digits they have.
            self._data = json.loads(text, parse_int=float)
        self.places = dict(_places(self._data, ""))

    def quantity(self, pointer: str) -> Quantity:
        """Return the number at a place, such as ``/benchmarks/sort/stats/mean``."""
        way = unquote(pointer)
        if way not in self.places:
            raise AuditError(f"no number at {way:.120}{self._similar(way)}")
        place = self.places[way]
        noise: float | None
        if isinstance(place.value, list):
            value, noise = sample_mean(place.value)
        else:
            value = float(place.value)
            noise = self._noise(way, place)
        if not math.isfinite(value):
            raise AuditError(f"the number at {way:.120} is not finite")
        offsets = None
        if noise is not None and math.isfinite(noise):
            offsets = {f"{self._path}#{way}": noise}
        return Quantity(value, self._unit(place), offsets)

    def _similar(self, way: str) -> str:
        """Return a text that lists similar places with the same key, or ""."""
        key = way.rpartition("/")[2]
        pointers = [other for other, place in self.places.items() if place.key == key]
        matches = get_close_matches(way, pointers[:99], n=4, cutoff=0.5)
        return f"; similar: {', '.join(matches)}" if matches else ""

    def _noise(self, way: str, place: Place) -> float | None:
        """Return the noise of a number, or None if it is unknown."""
        is_in_record = "identity" in self._data and way.startswith("/rows/")
        if is_in_record and self._noise_of_record:
            row = self._data["rows"].index(place.beside)
            return self._noise_of_record(self._path, row, place.key)
        return _stated_noise(place.key, place.beside)

    def _unit(self, place: Place) -> str:
        """Return the unit that the file states or the key ends in, such as slip_mm."""
        key = place.key
        beside = place.beside
        has_seconds = "machine_info" in self._data or "command" in beside
        if key in IN_SECONDS and has_seconds:  # pytest-benchmark, hyperfine
            return "s"
        if key in ("real_time", "cpu_time", "point_estimate"):
            return str(beside.get("time_unit", "ns"))  # google-benchmark, criterion
        if key == "value":
            return str(beside.get("unit", NO_UNIT))
        units = self._data.get("units") if isinstance(self._data, Mapping) else None
        if isinstance(units, Mapping) and key in units:
            return str(units[key])
        stem, _, end = key.rpartition("_")
        return end if end in UNITS and stem and not stem.endswith("per") else NO_UNIT


def _table(text: str) -> list[dict[str, str]]:
    """Read a CSV table whose first column names the rows."""
    first_line = text.partition("\n")[0]
    delimiter = max(",;", key=first_line.count)
    try:
        header, *rows = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter)
    except csv.Error as error:
        raise AuditError(f"the table cannot be read: {error}") from None
    return [dict(zip(("name", *header[1:]), row, strict=False)) for row in rows]


def _places(
    node: Any, way: str, key: str = "", beside: Mapping[str, Any] | None = None
) -> Iterator[tuple[str, Place]]:
    """Yield each number below a node, with the names that lead to it."""
    if isinstance(node, Mapping):
        for name, child in node.items():
            yield from _places(child, f"{way}/{name}", name, node)
    elif isinstance(node, list):
        if key in SAMPLES and len(node) > 1 and all(map(is_number, node)):
            yield way, Place(key, node, beside or {})
            return
        for name, child in zip(_names(node), node, strict=True):
            yield from _places(child, f"{way}/{name}")
    elif is_number(node) or (isinstance(node, str) and CELL.fullmatch(node)):
        yield way, Place(key, node, beside or {})


def _names(elements: Sequence[Any]) -> list[str]:
    """Return the name of each element if it is unique, otherwise its index."""
    names = []
    for element in elements:
        table = element if isinstance(element, Mapping) else {}
        named = (table[key] for key in NAMES if isinstance(table.get(key), str))
        names.append(next(named, ""))
    counts = Counter(names)
    return [
        name if name and counts[name] == 1 else str(index)
        for index, name in enumerate(names)
    ]


def _stated_noise(key: str, beside: Mapping[str, Any]) -> float | None:
    """Compute the noise of a number from the scatter that the file states beside it."""
    if key == "value":
        noise = beside.get("noise")
        return noise if is_number(noise) else None
    if key == "point_estimate":  # criterion
        error = beside.get("standard_error")
        return Z * error if is_number(error) else None
    deviation = beside.get("stddev")
    count = _sample_count(beside)
    if key in ERROR_RATIO and is_number(deviation) and count > 1:
        return ERROR_RATIO[key] * mean_noise(deviation, count)
    return None


def _sample_count(beside: Mapping[str, Any]) -> float:
    """Return the number of samples of a mean; 0 if the file does not state it."""
    for key in ("rounds", "runs", "times"):
        count = beside.get(key)
        if isinstance(count, list) and count:
            return len(count)
        if is_number(count) and count:
            return count
    return 0


def is_number(value: Any) -> TypeGuard[float]:
    """Return whether a value is a finite number."""
    return isinstance(value, float) and math.isfinite(value)
