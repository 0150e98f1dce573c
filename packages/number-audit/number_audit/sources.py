"""Finds each number of a result file by the names that lead to it.

The units and the noise of pytest-benchmark, pyperf, hyperfine, asv, criterion, Google
Benchmark, k6, lm-eval and JUnit are known as well.
"""

import math
import re
from collections import Counter, defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path
from typing import Any, TypeGuard
from urllib.parse import unquote

from number_audit.files import AuditError
from number_audit.quantities import (
    NO_UNIT,
    Quantity,
    Z,
    is_known,
    mean_noise,
    sample_mean,
    split_unit,
)
from number_audit.readers import read_data

NAMES = "name case command benchmark operation label id".split()
"""Keys whose text is used as the name of an element of a list."""

SAMPLES = ("times", "data", "samples")
"""Keys of a list with several samples of one number."""

IN_SECONDS = "mean|median|min|max|stddev|iqr|q1|q3|total|user|system|times|data"
"""Matches keys of pytest-benchmark and hyperfine whose values are in seconds."""

ERROR_RATIO = {"mean": 1.0, "median": 1.2533}
"""The standard error of a statistic of many samples, relative to the standard error of
the mean.
"""

CELL = re.compile(
    r"[*_]*(?P<number>[-+]?\d{1,20}(\.\d{0,20})?([eE][-+]?\d{1,3})?)\s?(?P<unit>\S{0,9}?)[*_]*"
)
"""Matches a number in a text, such as a cell of a table."""

ASV_BENCHMARK = r"/results/[^/]*\b{}_\w+(/result|/0)?(/\d+)?"
UNITS_OF_FORMATS = (
    ("machine_info", f".*/({IN_SECONDS})", "s"),  # pytest-benchmark
    ("result_columns", ASV_BENCHMARK.format("time"), "s"),
    ("result_columns", ASV_BENCHMARK.format("(peak)?mem"), "B"),
    ("root_group", r"/metrics/(http_req_(?!failed)\w+|\w+_duration)\b.*", "ms"),  # k6
    ("root_group", r"/metrics/data_(received|sent)/count", "B"),
    ("root_group", r"/metrics/data_(received|sent)/rate", "B/s"),
    ("testsuite", ".*/time", "s"),  # JUnit
    ("testcase", ".*/time", "s"),
)
"""A key at the top of a file, a pattern of places in such a file, and their unit."""

NoiseOfRecord = Callable[[Path, int, str], float | None]
"""A function that returns the noise of a number from its file, row and column.

A record is JSON with the keys "identity" and "rows". It does not state any noise, but
the program that measured it may be able to compute it.
"""


@dataclass(frozen=True)
class Place:
    """A number, or several samples of it, in a file."""

    key: str
    value: Any
    beside: Mapping[str, Any]
    """The object or the row that contains it."""
    unit: str = ""
    """The unit of a number in a text, such as 12.3 ms."""


class Source:
    """The numbers of one result file."""

    def __init__(
        self, path: Path, content: bytes, noise_of_record: NoiseOfRecord | None = None
    ):
        self._path = path
        self._noise_of_record = noise_of_record
        data = read_data(path.suffix, content.decode("utf-8-sig"))
        self._data = data if isinstance(data, Mapping) else {}
        self.places = dict(_places(data, "", "", {}))
        self._by_simple_pointer = defaultdict(list)
        for pointer, place in self.places.items():
            simple_pointer = _simple_pointer(pointer, place.key)
            self._by_simple_pointer[simple_pointer].append(pointer)

    def quantity(self, quoted: str) -> Quantity:
        """Return the number at a place, such as ``/benchmarks/sort/stats/mean``."""
        pointer = unquote(quoted)
        if pointer not in self.places:
            candidates = self._by_simple_pointer.get(
                _simple_pointer(pointer, pointer.rpartition("/")[2]), ()
            )
            if len(candidates) != 1:
                raise AuditError(f"no number at {pointer:.120}{self._similar(pointer)}")
            [pointer] = candidates
        place = self.places[pointer]
        noise: float | None
        if isinstance(place.value, list):
            value, noise = sample_mean(place.value)
        else:
            value = place.value
            noise = self._noise(pointer, place)
        if not math.isfinite(value):
            raise AuditError(f"the number at {pointer:.120} is not finite")
        offsets = {}
        if noise is not None and math.isfinite(noise):
            offsets = {f"{self._path}#{pointer}": noise}
        return Quantity(value, self._unit(pointer, place), offsets)

    def _similar(self, pointer: str) -> str:
        """Return a text that lists similar places with the same key, or ""."""
        key = pointer.rpartition("/")[2]
        candidates = [name for name, place in self.places.items() if place.key == key]
        # The comparison of long names is slow, and a file can have 100,000 places.
        matches = get_close_matches(pointer, candidates[:99], n=4, cutoff=0.5)
        return f"; similar: {', '.join(matches)}" if matches else ""

    def _noise(self, pointer: str, place: Place) -> float | None:
        """Return the noise of a number, or None if it is unknown."""
        is_in_record = "identity" in self._data and pointer.startswith("/rows/")
        if is_in_record and self._noise_of_record:
            row = self._data["rows"].index(place.beside)
            return self._noise_of_record(self._path, row, place.key)
        name = place.beside.get("aggregate_name")
        if name in ERROR_RATIO:  # Google Benchmark
            scatter = self.places.get(pointer.replace(f"_{name}/", "_stddev/"))
            count = place.beside.get("repetitions")
            if scatter and is_number(count) and count > 1:
                return ERROR_RATIO[name] * mean_noise(scatter.value, count)
        return _stated_noise(place.key, place.beside)

    def _unit(self, pointer: str, place: Place) -> str:
        """Return the unit that the file states or the key ends in, such as slip_mm."""
        key = place.key
        beside = place.beside
        if place.unit:
            return place.unit
        for name, pattern, unit in UNITS_OF_FORMATS:
            if name in self._data and re.fullmatch(pattern, pointer):
                return unit
        if "command" in beside and re.fullmatch(IN_SECONDS, key):  # hyperfine
            return "s"
        if key in ("real_time", "cpu_time", "point_estimate"):
            return str(beside.get("time_unit", "ns"))  # Google Benchmark, criterion
        if key == "bytes_per_second":  # Google Benchmark
            return "B/s"
        if key == "value":
            return str(beside.get("unit", NO_UNIT))
        units = self._data.get("units")
        if isinstance(units, Mapping) and key in units:
            return str(units[key])
        return split_unit(key)[1]


class Repeats:
    """Result files of the same measurement, repeated at different times."""

    def __init__(self, name: str, sources: Sequence[Source]):
        self.name = name
        self._sources = sources
        self.places = sources[0].places

    def quantity(self, quoted: str) -> Quantity:
        """Return the mean over the files; its noise includes their scatter."""
        quantities = [source.quantity(quoted) for source in self._sources]
        if len(quantities) == 1:
            return quantities[0]
        if len({quantity.unit for quantity in quantities}) > 1:
            raise AuditError(f"the files of {self.name} have different units")
        # The scatter between few files can be small by chance, so their own noise is a
        # lower limit.
        mean, noise = sample_mean([quantity.value for quantity in quantities])
        own_noise = math.hypot(*(quantity.noise for quantity in quantities))
        noise = max(noise, own_noise / len(quantities))
        offsets = {f"{self.name}#{quoted}": noise}
        return Quantity(mean, quantities[0].unit, offsets)


def _simple_pointer(pointer: str, key: str) -> str:
    return simplified(pointer.removesuffix(key) + split_unit(key)[0])


def simplified(name: str) -> str:
    """Return a name without capital letters and signs, because tables often change
    these.
    """
    return re.sub(r"[\W_]+", " ", name.casefold()).strip()


def _places(
    node: Any, pointer: str, key: str, beside: Mapping[str, Any]
) -> Iterator[tuple[str, Place]]:
    """Yield each number below a node, with the names that lead to it."""
    if isinstance(node, Mapping):
        for name, child in node.items():
            yield from _places(child, f"{pointer}/{name}", str(name), node)
    elif isinstance(node, list):
        if key in SAMPLES and len(node) > 1 and all(map(is_number, node)):
            yield pointer, Place(key, node, beside)
            return
        for name, child in zip(_names(node), node, strict=True):
            yield from _places(child, f"{pointer}/{name}", "", {})
    elif is_number(node):
        yield pointer, Place(key, float(node), beside)
    elif isinstance(node, str) and (match := CELL.fullmatch(node)):
        unit = match["unit"]
        if not unit or is_known(unit):
            yield pointer, Place(key, float(match["number"]), beside, unit)


def _names(elements: Sequence[Any]) -> list[str]:
    """Return the name of each element if it is unique, otherwise its index."""
    names = []
    for element in elements:
        texts = map(element.get, NAMES) if isinstance(element, Mapping) else ()
        names.append(next((text for text in texts if isinstance(text, str)), ""))
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
    metric, comma, method = key.partition(",")
    error_key = f"{metric}_stderr{comma}{method}"  # lm-eval
    if key == "point_estimate":  # criterion
        error_key = "standard_error"
    error = beside.get(error_key)
    if is_number(error):
        return Z * error
    deviation = beside.get("stddev")
    times = beside.get("times")
    count = len(times) if isinstance(times, list) else beside.get("rounds")
    if key in ERROR_RATIO and is_number(deviation) and is_number(count) and count > 1:
        return ERROR_RATIO[key] * mean_noise(deviation, count)
    return None


def is_number(value: Any) -> TypeGuard[float]:
    """Return whether a value is a finite number."""
    is_real = isinstance(value, int | float) and not isinstance(value, bool)
    return is_real and abs(value) < math.inf
