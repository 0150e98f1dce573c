"""Check that each number on a page is the number in its source."""

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
"""The attributes and the text of an element, and whether it is inside ``code``."""


class Data:
    """Read the files of data to which the numbers of pages point."""

    def __init__(self, folder: Path, report: Report):
        self.folder = folder
        self.report = report
        self.file = cache(self._read)

    def _read(self, name: str) -> Any:
        return json.loads((self.folder / name).read_text(encoding="utf-8"))

    def number(self, source: str) -> tuple[float | int | None, float | None]:
        """Return a number and its noise; raise an error if the pointer is invalid.

        The entry of a derived value contains its noise. The noise of a cell is computed
        from all measurements, and is in a separate file.
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
    """Yield the problem with a number on a page, if there is one."""
    attributes, printed, is_code = number
    source = attributes.get("data-src", "")
    try:
        value, noise = data.number(source)
        write = WRITES[attributes.get("data-as", "")]
        text = format_code(value) if is_code else write(value, noise=noise)
    except UNRESOLVED:
        yield f"{source} does not point to a number"
        return
    stated = json.loads(attributes.get("value") or "null")
    if stated != value or printed != text:
        yield f"{source} is {value}, but the page shows {printed} ({stated})"


def _resolve(data: Any, pointer: str) -> Any:
    for key in pointer.removeprefix("/").split("/"):
        data = data[int(key)] if isinstance(data, list) else data[key]
    return data
