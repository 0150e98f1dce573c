"""Sources: numbers in the results of this generator and of other programs, by pointer, with unit and noise."""

import csv
import json
import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from statistics import fmean
from typing import Any
from urllib.parse import unquote

from measured_report.records.columns import PLAIN, column_of, is_number
from measured_report.site.check_numbers import Data
from measured_report.values.noise import NORMAL, SURE, Z, sampled_noise, t_quantile
from measured_report.values.quantities import FACTOR, POWERS, Quantity

PREFIXED = re.compile(r"([nµmckMGT]|[KMGT]i)?(m|s|g|N|J|W|V|A|K|B|bit|Pa|Hz|rad|mol)")
PREFIXES = {"n": 1e-9, "µ": 1e-6, "m": 1e-3, "c": 1e-2, "k": 1e3, "M": 1e6, "G": 1e9, "T": 1e12}
PREFIXES |= {f"{letter}i": 1024.0**power for power, letter in enumerate("KMGT", 1)}
OTHERS = {"min": (60.0, "s"), "h": (3600.0, "s"), "%": (0.01, PLAIN), PLAIN: (1.0, PLAIN)}
WORDS = {"us": "µs", "μs": "µs", "sec": "s", "second": "s", "seconds": "s", "KB": "kB", "byte": "B", "bytes": "B"}
NAMES = ("name", "fullname", "command", "case")  # keys whose text names a thing of a list
SAMPLES = ("times", "data", "samples")
TIMES = {"mean", "median", "min", "max", "stddev", "iqr", "q1", "q3", "total", "user", "system", *SAMPLES}
OF_ASV = {"time": "s", "timeraw": "s", "mem": "B", "peakmem": "B"}  # units of benchmarks by how their names begin
BELIEVED = ("s", "B", "Hz", "1/s")  # units that the end of a name in any program's results may say
MEDIAN = math.sqrt(math.pi / 2)  # so many times as much as a mean a median scatters


def scale_of(unit: str) -> tuple[float, str] | None:
    """Split a unit into a factor and a unit without prefixes; None for what is no unit."""
    factor, base, unit = 1.0, "", WORDS.get(unit, unit)
    for below, symbol, power in FACTOR.findall(unit):
        match = PREFIXED.fullmatch(symbol) if symbol not in OTHERS else None
        size, plain = (PREFIXES.get(match[1], 1.0), match[2]) if match else OTHERS.get(symbol, (math.nan, symbol))
        factor *= size ** ((-1 if below else 1) * max(1, POWERS.find(power)))
        base += f"{below or '·' * bool(base)}{plain}{power}"
    return (factor, base) if base and factor == factor else None


class Source:
    """Reads results in JSON or CSV; an error, ReportError or one of ``UNRESOLVED``, tells that they are none."""

    def __init__(self, path: Path, read: Callable[[Path], bytes]):
        self.path, self.data, self._names = path, _parsed(path, read(path)), dict[int, dict[str, list[Any]]]()

    def quantity(self, pointer: str) -> tuple[Quantity, str]:
        """Return a number, in a unit without prefix, and the unit that it has here."""
        keys: Sequence[str] = [unquote(key).replace("~1", "/").replace("~0", "~") for key in pointer.split("/")[1:]]
        nodes, names = [self.data], [""]
        while keys:
            node, name, keys = self._child(nodes[-1], keys)
            nodes, names = [*nodes, node], [*names, name]
        value, around, name = _mean(nodes[-1]), nodes[-2] if nodes[1:] else {}, names[-1]
        if isinstance(nodes[-1], Mapping) and (inner := {"value", "point_estimate", "result"} & nodes[-1].keys()):
            return self.quantity(f"{pointer}/{min(inner)}")
        if value is None:
            raise LookupError(f"{pointer} is no number{_listed(nodes[-1])}")
        if isinstance(around, list):  # of samples, or of what asv has beside its results
            columns = ((key, cells) for key, cells in _items(nodes[-3:-2]) if isinstance(cells, list))
            around = {key: cells[int(name)] for key, cells in columns if int(name) < len(cells)}
            name = names[-2]
        noise = _noise(around, name, nodes[-1] if isinstance(nodes[-1], list) else value)
        if isinstance(self.data, Mapping) and {"rows", "units", "identity"} <= self.data.keys() and names[1] == "rows":
            file, row = f"{self.path.parent.name}/{self.path.name}", self.data["rows"].index(nodes[2])
            value, noise = self._data.number(f"{file}#/rows/{row}/{name}")
            if value is None:
                raise LookupError(f"{pointer} was lost")
        unit = self._unit(around, name, names)
        factor, base = scale_of(unit) or (1.0, unit)
        noise = None if noise is None else noise * factor
        return Quantity(value * factor, base, f"{self.path}#{pointer}", noise=noise), unit

    @cached_property
    def _data(self) -> Data:
        return Data(self.path.parents[1])

    def _child(self, node: Any, keys: Sequence[str]) -> tuple[Any, str, Sequence[str]]:
        """Return what the first keys lead to, their name, which may have slashes, and the keys behind them."""
        names = self._called(node) if isinstance(node, list) else node if isinstance(node, Mapping) else {}
        for end in range(len(keys), 0, -1):
            if (name := "/".join(keys[:end])) in names:
                if isinstance(node, list) and len(names[name]) > 1:
                    raise LookupError(f"{name} is there {len(names[name])} times: use its index")
                return names[name][0] if isinstance(node, list) else names[name], name, keys[end:]
        if isinstance(node, list) and re.fullmatch(r"\d{1,8}", keys[0]) and int(keys[0]) < len(node):
            return node[int(keys[0])], keys[0], keys[1:]
        if isinstance(names.get("stats"), Mapping):  # pytest-benchmark's, which need not be named
            return names["stats"], "stats", keys
        raise LookupError(f"there is no {keys[0]:.80}{_listed(names)}")

    def _called(self, things: list[Any]) -> dict[str, list[Any]]:
        if id(things) not in self._names:
            names = self._names[id(things)] = {}
            for thing in (thing for thing in things if isinstance(thing, Mapping)):
                for name in {thing[key] for key in NAMES if isinstance(thing.get(key), str)}:
                    names.setdefault(name, []).append(thing)
        return self._names[id(things)]

    def _unit(self, around: Mapping[str, Any], name: str, names: Sequence[str]) -> str:
        data = self.data if isinstance(self.data, Mapping) else {}
        if "result_columns" in data and name == "result":
            return OF_ASV.get(names[2].rpartition(".")[2].partition("_")[0], PLAIN)
        if name in ("real_time", "cpu_time") or "point_estimate" in around:  # google-benchmark, criterion
            return str(around.get("time_unit", "ns"))
        if name in TIMES and ("machine_info" in data or "command" in around):  # pytest-benchmark, hyperfine
            return "s"
        if isinstance(units := data.get("units"), Mapping) and name in units:
            return str(units[name])
        unit = str(around.get("unit") or (column_of(name).unit if "_" in name else PLAIN))
        return unit if "unit" in around or (scale_of(unit) or (1, ""))[1] in BELIEVED else PLAIN

    def pointers(self, node: Any = None, way: str = "") -> Iterator[str]:
        """Yield the pointers to its numbers, by names where these are unique; not to each sample."""
        node = node if way else self.data
        names = self._called(node).items() if isinstance(node, list) else ()
        called = {id(things[0]): name for name, things in names if len(things) == 1}
        for name, child in enumerate(node) if isinstance(node, list) else _items([node]):
            key = re.sub(r"[\s\"%`<>(){}]", lambda match: f"%{ord(match[0]):02X}", str(called.get(id(child), name)))
            if name not in SAMPLES:
                yield from self.pointers(child, f"{way}/{key}")
        if _mean(node) is not None and not isinstance(node, list):
            yield way


def _items(nodes: Sequence[Any]) -> Iterator[tuple[str, Any]]:
    for node in nodes:
        yield from node.items() if isinstance(node, Mapping) else ()


def _listed(names: Any) -> str:
    return f"; there are {', '.join(map(str, names)):.120}" if isinstance(names, Mapping) and names else ""


def _parsed(path: Path, text: bytes) -> Any:
    """Read JSON or CSV; asv's columns get their names, the repetitions of a google-benchmark become samples of one."""
    if path.suffix in (".csv", ".tsv"):
        lines = text.decode("utf-8-sig").splitlines()
        delimiter = "\t" if path.suffix == ".tsv" else max(",;", key=lines[0].count) if lines else ","
        return [{"name": next(iter(row.values()), ""), **row} for row in csv.DictReader(lines, delimiter=delimiter)]
    data = json.loads(text)
    if isinstance(data, Mapping) and "result_columns" in data:
        columns, results = data["result_columns"], data["results"].items()
        return {**data, "results": {name: dict(zip(columns, cells, strict=False)) for name, cells in results if cells}}
    if not (isinstance(data, Mapping) and "context" in data and isinstance(data.get("benchmarks"), list)):
        return data
    runs: dict[str, list[Any]] = {}
    for run in data["benchmarks"]:
        runs.setdefault(run["name"], []).append(run)
    for run, *rest in runs.values():
        run |= {key: [run[key], *(again[key] for again in rest)] for key in run if rest and isinstance(run[key], float)}
    return {**data, "benchmarks": [run for run, *_ in runs.values()]}


def _mean(node: Any) -> float | None:
    """Return a number, also of a cell of CSV, or the mean of samples; None for what is none."""
    if isinstance(node, str) and re.fullmatch(r"[-+]?\d{1,20}(\.\d{0,20})?(e[-+]?\d{1,3})?", node.lower()):
        return float(node)
    value = fmean(node) if isinstance(node, list) and node and all(map(is_number, node)) else node
    return value if is_number(value) and math.isfinite(value) else None


def _noise(around: Mapping[str, Any], name: str, node: Any) -> float | None:
    """Bound how far a number may be from the truth; None where its source does not say."""
    if isinstance(node, list):
        return sampled_noise(node) if len(node) > 1 else None
    interval = around.get("confidence_interval") or {}  # criterion's
    low, high = interval.get("lower_bound"), interval.get("upper_bound")
    low, high = around.get("stats_ci_99_a", low), around.get("stats_ci_99_b", high)  # asv's
    if name in ("point_estimate", "result") and is_number(low) and is_number(high) and high < math.inf:
        return (high - low) / 2 * Z / NORMAL.inv_cdf((1 + interval.get("confidence_level", 0.99)) / 2)
    if name == "value" and is_number(around.get("noise")):
        return float(around["noise"])
    samples = next((around[key] for key in SAMPLES if isinstance(around.get(key), list)), ())
    count = around.get("rounds") or around.get("count") or len(samples)
    deviation = around.get("stddev")
    scale = {"mean": 1.0, "median": MEDIAN, "ops": node / (around.get("mean") or 1)}.get(name)
    if not (scale and is_number(deviation) and is_number(count) and count > 1):
        return None
    return t_quantile(SURE, count - 1) * deviation / math.sqrt(count) * scale
