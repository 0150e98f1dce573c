"""Reads result files of several types into dictionaries and lists."""

import csv
import io
import json
import re
import sys
from collections.abc import Callable, Mapping
from importlib import import_module
from statistics import fmean
from typing import Any
from xml.etree import ElementTree

from number_audit.files import AuditError
from number_audit.quantities import NO_UNIT, sample_mean
from number_audit.tables import read_tables


def read_data(suffix: str, text: str) -> Any:
    """Return the content of a file whose name ends in ``suffix``.

    A damaged file raises an error of the library that reads its type.
    """
    return READERS.get(suffix.lower(), _json)(text)


def _json(text: str) -> Any:
    # Floats can be read quickly however many digits they have.
    data = json.loads(text, parse_int=float)
    is_pyperf = isinstance(data, Mapping) and any(
        "runs" in benchmark
        for benchmark in data.get("benchmarks") or ()
        if isinstance(benchmark, Mapping)
    )
    return _pyperf(data) if is_pyperf else data


def _pyperf(data: Mapping[str, Any]) -> dict[str, Any]:
    """Return the mean of each benchmark, and its noise from the means of processes."""
    means = {}
    for benchmark in data["benchmarks"]:
        metadata = data.get("metadata", {}) | benchmark.get("metadata", {})
        runs = [fmean(run["values"]) for run in benchmark["runs"] if run.get("values")]
        value, noise = sample_mean(runs) if len(runs) > 1 else (fmean(runs), None)
        unit = {"second": "s", "byte": "B"}.get(metadata.get("unit", "second"), NO_UNIT)
        means[metadata["name"]] = {"value": value, "noise": noise, "unit": unit}
    return {"benchmarks": means}


def _json_lines(text: str) -> list[Any]:
    lines = filter(str.strip, text.split("\n"))
    return [json.loads(line, parse_int=float) for line in lines]


def _csv(text: str) -> list[dict[str, str]]:
    first_line = text.partition("\n")[0]
    return _table(text, max(",;", key=first_line.count))


def _tsv(text: str) -> list[dict[str, str]]:
    return _table(text, "\t")


def _table(text: str, delimiter: str) -> list[dict[str, str]]:
    """Read a table whose first column names the rows."""
    header, *rows = csv.reader(io.StringIO(text, newline=""), delimiter=delimiter)
    return [dict(zip(("name", *header[1:]), row, strict=False)) for row in rows]


def _markdown(text: str) -> list[dict[str, dict[str, str]]]:
    """Return the cells of each table by their row and column."""
    tables = []
    for table in read_tables(text):
        rows: dict[str, dict[str, str]] = {}
        for cell in table.cells:
            content = re.sub(r"<!--.*?-->", "", cell.text).strip()
            rows.setdefault(cell.row, {})[cell.column] = content
        tables.append(rows)
    return tables


def _xml(text: str) -> Any:
    """Return the attributes and children of each element, as in JUnit's reports."""
    if "<!DOCTYPE" in text:
        raise AuditError("XML with a DOCTYPE is not supported")

    def content_of(element: ElementTree.Element) -> dict[str, Any]:
        children: dict[str, Any] = {}
        for child in element:
            children.setdefault(child.tag, []).append(content_of(child))
        return element.attrib | children

    return content_of(ElementTree.fromstring(text))


def _toml(text: str) -> Any:
    module = "tomllib" if sys.version_info >= (3, 11) else "tomli"
    return _imported(module, "toml").loads(text)


def _yaml(text: str) -> Any:
    yaml = _imported("yaml", "yaml")
    loader = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
    # A short text with aliases can stand for billions of numbers.
    if any(isinstance(token, yaml.AliasToken) for token in yaml.scan(text, loader)):
        raise AuditError("YAML with aliases is not supported")
    return yaml.load(text, loader)


def _imported(module: str, extra: str) -> Any:
    try:
        return import_module(module)
    except ImportError:
        install = f"pip install number-audit[{extra}]"
        raise AuditError(f"this file needs another package: {install}") from None


READERS: Mapping[str, Callable[[str], Any]] = {
    ".csv": _csv,
    ".tsv": _tsv,
    ".jsonl": _json_lines,
    ".md": _markdown,
    ".xml": _xml,
    ".toml": _toml,
    ".yaml": _yaml,
    ".yml": _yaml,
}
"""Functions that read a file by the ending of its name. Other files are JSON."""
