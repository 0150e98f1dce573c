"""Check of the numbers on a page: each is the number that its source has."""

import json
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any

from measured_report.files.config import Report
from measured_report.values.format import WRITES, format_code
from measured_report.values.quantities import NOISE_FILE, VALUES_FILE

UNRESOLVED = (OSError, ValueError, LookupError, TypeError)
Number = tuple[Mapping[str, str], str, bool]
"""Attributes and text of an element, and whether it is a part of code."""


class Data:
    """Read the data that a page's numbers point into."""

    def __init__(self, folder: Path, report: Report):
        self.folder = folder
        self.report = report
        self.file = cache(self._read)

    def _read(self, name: str) -> Any:
        return json.loads((self.folder / name).read_text(encoding="utf-8"))

    def number(self, source: str) -> tuple[float | int | None, float | None]:
        """Return a number and its noise; raise an error if the pointer leads nowhere.

        The noise of a derived value stands beside it. That of a cell comes from all
        measurements and stands in a file of its own.
        """
        name, _, pointer = source.partition("#")
        cell = _resolve(self.file(name), pointer)
        if name.endswith(VALUES_FILE):
            return cell["value"], cell["noise"]
        if not pointer.startswith("/rows/"):
            return cell, None
        row_pointer, _, column = pointer.rpartition("/")
        row = _resolve(self.file(name), row_pointer)
        noises = self.file(str(Path(name).parent / NOISE_FILE))
        return self.report.columns.number_of(column, row), noises.get(source)


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
