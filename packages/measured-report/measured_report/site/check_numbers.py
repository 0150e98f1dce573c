"""Check of the numbers on a page: each is the number that its source has."""

import json
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

from measured_report.files.config import Report
from measured_report.records.replicas import measurements_beside, read_replica
from measured_report.values.cells import evidence_of
from measured_report.values.evidence import Evidence, Repeated, repeats_of
from measured_report.values.format import WRITES, format_code
from measured_report.values.quantities import VALUES_FILE

UNRESOLVED = (OSError, ValueError, LookupError, TypeError)
Number = tuple[Mapping[str, str], str, bool]
"""Attributes and text of an element, and whether it is a part of code."""


class Data:
    """Read the data that a page's numbers point into."""

    def __init__(self, folder: Path, report: Report):
        self.folder, self.report = folder, report
        self.file = cache(self._read)
        self._evidence = cache(self._evidence_of)
        self._repeats = cache(self._repeats_in)
        self._replica = cache(read_replica)  # which is of all sections

    def _read(self, name: str) -> Any:
        return json.loads((self.folder / name).read_text(encoding="utf-8"))

    def number(self, source: str) -> tuple[float | int | None, float | None]:
        """Return a number and its noise; an error where the pointer leads to none."""
        name, _, pointer = source.partition("#")
        cell = _resolve(self.file(name), pointer)
        if name.endswith(VALUES_FILE):
            return cell["value"], cell["noise"]
        if not pointer.startswith("/rows/"):
            return cell, None
        row_pointer, _, column = pointer.rpartition("/")
        row = _resolve(self.file(name), row_pointer)
        cell = self.report.columns.number_of(column, row)
        estimate = self._evidence(name).estimate(column, row, self.report.columns)
        return cell, estimate.written_noise if estimate else None

    def _evidence_of(self, name: str) -> Evidence:
        records = measurements_beside(self.folder / name, self._replica)
        return evidence_of(
            {name: records}, self._repeats(Path(name).parent), self.report.columns
        )[name]

    def _repeats_in(self, folder: Path) -> Repeated:
        noise = folder / f"{self.report.settings.noise_section}.json"
        if not (self.folder / noise).is_file():
            return {}
        return repeats_of(self.file(str(noise))["rows"], self.report.columns)


def check_number(number: Number, data: Data) -> Iterator[str]:
    """Say what is wrong with a number that a page shows."""
    attributes, printed, is_code = number
    source = attributes.get("data-src", "")
    try:
        value, noise = data.number(source)
        write = WRITES[attributes.get("data-as", "")]
        text = format_code(value) if is_code else write(value, noise=noise)
    except UNRESOLVED:
        yield f"{source} resolves to nothing"
        return
    stated = json.loads(attributes.get("value") or "null")
    if stated != value or printed != text:
        yield f"{source} is {value}, but {printed} ({stated}) is shown"


def _resolve(data: Any, pointer: str) -> Any:
    for key in pointer.removeprefix("/").split("/"):
        data = data[int(key)] if isinstance(data, list) else data[key]
    return data
