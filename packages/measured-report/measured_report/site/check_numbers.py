"""Check of the numbers on a page: each is the number that its source has."""

import json
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path
from typing import Any

from measured_report.files.config import Report
from measured_report.values.format import BELOW, WRITES, format_code, read_number
from measured_report.values.quantities import VALUES_FILE

UNRESOLVED = (OSError, ValueError, LookupError, TypeError)
Number = tuple[Mapping[str, str], str, bool]
"""Attributes and text of an element, and whether it is a part of code."""


NOISES = [2 * 10.0**exponent for exponent in range(-10, 4)]
"""Noises by which a number may be written, as shares of it: one of these gives nearly every
way to write it, and the next ones the others."""
FINE_NOISES = [10 ** (step / 20) for step in range(-200, 80)]
INTERVAL = " ± "  # between a number and its noise


class Data:
    """Read the data that a page's numbers point into."""

    def __init__(self, folder: Path, report: Report):
        self.folder = folder
        self.report = report
        self.file = cache(self._read)

    def _read(self, name: str) -> Any:
        return json.loads((self.folder / name).read_text(encoding="utf-8"))

    def number(self, source: str) -> tuple[float | int | None, Sequence[float | None]]:
        """Return a number and the noises that it may be written by.

        The noise of a derived value stands beside it; that of a cell comes from all
        measurements, so that it may have any number of digits. An error is raised if the
        pointer leads nowhere.
        """
        name, _, pointer = source.partition("#")
        cell = _resolve(self.file(name), pointer)
        if name.endswith(VALUES_FILE):
            return cell["value"], [cell["noise"]]
        if not pointer.startswith("/rows/"):
            return cell, [None]
        row_pointer, _, column = pointer.rpartition("/")
        row = _resolve(self.file(name), row_pointer)
        cell = self.report.columns.number_of(column, row)
        size = abs(cell or 0.0)
        return cell, [None, 0.0, *(size * share for share in (*NOISES, *FINE_NOISES))]


def check_number(number: Number, data: Data) -> Iterator[str]:
    """Say what is wrong with a number that a page shows."""
    attributes, printed, is_code = number
    source = attributes.get("data-src", "")
    try:
        value, noises = data.number(source)
        write = WRITES[attributes.get("data-as", "")]
        if len(noises) > 1 and printed.startswith(BELOW):
            # What is printed of a number below its noise is the noise.
            noises = [float(read_number(printed.removeprefix(BELOW)) or 0)]
        if len(noises) > 1 and INTERVAL in printed:
            # The noise of a cell is printed to two digits.
            noises = [float(read_number(printed.partition(INTERVAL)[2]) or 0)]
        if is_code:
            is_right = printed == format_code(value)
        else:
            is_right = any(write(value, noise=noise) == printed for noise in noises)
    except UNRESOLVED:
        yield f"{source} resolves to nothing"
        return
    stated = json.loads(attributes.get("value") or "null")
    if stated != value or not is_right:
        yield f"{source} is {value}, but {printed} ({stated}) is shown"


def _resolve(data: Any, pointer: str) -> Any:
    for key in pointer.removeprefix("/").split("/"):
        data = data[int(key)] if isinstance(data, list) else data[key]
    return data
