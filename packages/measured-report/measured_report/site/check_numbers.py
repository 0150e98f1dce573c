"""Check of the numbers and bounds on a page: each is what its source says."""

import json
import re
from collections.abc import Iterator, Mapping
from decimal import Decimal
from functools import cache
from pathlib import Path
from typing import Any

from measured_report.site.page_reader import PageReader
from measured_report.values.format import format_code, format_least, format_most, format_number, read_number, undusted
from measured_report.values.noise import NOISE, Floor, cell_noise, floors_of
from measured_report.values.quantities import LEAST, MOST, SAME, VALUES_FILE

WRITES = {"": format_number, MOST: format_most, LEAST: format_least}
"""Writers of numbers in words, by how the page says that they are written."""
ABOVE = ("at most", "within", "no more than", "not more than")
BELOW = ("at least", "no less than", "not less than")
SIDES = dict.fromkeys(ABOVE, MOST) | dict.fromkeys(BELOW, LEAST) | {"more than": LEAST, "less than": MOST}
"""Sides from which words bound the number behind them."""
NOT = re.compile(r"\b(?:no|not|nothing|none|never|neither|nor|nowhere|cannot|without)\b", re.IGNORECASE)
"""Words that may turn *more than* and *less than* round, in the same sentence."""
END = re.compile(r"[.;:]\s")
BEFORE = re.compile(rf"\b({'|'.join(SIDES)})\s(?:a factor of\s)?{{(\d+)}}", re.IGNORECASE)
BEHIND = re.compile(r"{(\d+)}(?:\s[^\s{]{1,5})?\s(at (?:most|least))\b")


class Data:
    """Read the data that a page's numbers point into."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.file, self._floors = cache(self._read), cache(self._floors_beside)

    def _read(self, name: str) -> Any:
        return json.loads((self.folder / name).read_text(encoding="utf-8"))

    def number(self, source: str) -> tuple[float | int | None, float | None]:
        """Return a number and its noise; an error where the pointer leads to none."""
        name, _, pointer = source.partition("#")
        kept = _resolve(self.file(name), pointer)
        if name.endswith(VALUES_FILE):
            return kept["value"], kept["noise"]
        if not pointer.startswith("/rows/"):
            return kept, None
        place, _, column = pointer.rpartition("/")
        return kept, cell_noise(column, _resolve(self.file(name), place), self._floors(name.rpartition("/")[0]))

    def _floors_beside(self, folder: str) -> Mapping[str, Floor]:
        noise = f"{folder}/{NOISE}.json"
        if not (self.folder / noise).is_file():
            return {}
        return floors_of(self.file(noise)["rows"], self.file(noise)["units"])


def check_numbers(page: PageReader, data: Data) -> list[str]:
    """Say what is wrong with the numbers of a page, a line each."""
    problems = []
    for number in page.numbers:
        source = number.get("data-src", "")
        try:
            kept, noise = data.number(source)
            text = _text(number, kept, noise, data)
        except (OSError, ValueError, LookupError, TypeError):
            problems.append(f"{number.get('data-src')} resolves to nothing")
            continue
        shown = json.loads(number["value"]) if number.get("value") else None
        if shown != kept or number["text"] != text:
            problems.append(f"{source} is {kept}, but {number['text']} ({shown}) is shown")
    return problems


def _text(number: Mapping[str, str], kept: float | int | None, noise: float | None, data: Data) -> str:
    """Write a number as it has to be where it is."""
    text, how = format_number(kept, noise=noise), number.get("data-as", "")
    if number["in"] == "code":
        return format_code(kept)
    if how in WRITES:
        return WRITES[how](kept, noise=noise)
    if how.isdigit():
        return format_number(kept, noise=noise, digits=int(how))
    other, its_noise = data.number(how) if how else (None, None)
    is_same = how and format_number(other, noise=its_noise) == text and number["text"] == SAME
    return number["text"] if is_same else text


def _resolve(data: Any, pointer: str) -> Any:
    for part in pointer.removeprefix("/").split("/"):
        data = data[int(part)] if isinstance(data, list) else data[part]
    return data


def check_bounds(page: PageReader) -> list[str]:
    """Say which bounds in a page's sentences err, a line each."""
    return [
        f"{words} {number['text']} errs: it is {number['value']}"
        for words, number, side in _bounds(page)
        if number.get("value") and number["text"] != SAME and _errs(number, side)
    ]


def _bounds(page: PageReader) -> Iterator[tuple[str, Mapping[str, str], str]]:
    """Yield the words of each bound, its number, and which bound it has to be, if that is plain."""
    for found in BEFORE.finditer(page.words):
        words, number = found[1], page.numbers[int(found[2])]
        chosen = number.get("data-as") if number.get("data-as") in (MOST, LEAST) else ""
        yield words, number, _side(words, page.words, found.start()) or chosen or ""
    for found in BEHIND.finditer(page.words):
        yield found[2], page.numbers[int(found[1])], SIDES[found[2]]


def _side(words: str, text: str, place: int) -> str:
    """Return ``MOST`` or ``LEAST``; empty where what else the sentence says may turn it round."""
    sentence = END.split(text[max(0, place - 400) : place])[-1] + END.split(text[place : place + 400])[0]
    is_turned = words.lower() in ("more than", "less than") and NOT.search(sentence)
    return "" if is_turned else SIDES[words.lower()]


def _errs(number: Mapping[str, str], side: str) -> bool:
    """Tell whether a number as it is written is on the wrong side of its value, or is none; any, without a side."""
    value, said = Decimal(repr(undusted(float(number["value"])))), read_number(number["text"])
    if said is None:
        return True
    return {MOST: said < value, LEAST: said > value}.get(side, said != value)
