"""Check of the numbers and bounds on a page, in sentences, tables and drawings: each is what its source says."""

import json
import re
from collections.abc import Iterator, Mapping
from decimal import Decimal
from functools import cache, cached_property
from pathlib import Path
from typing import Any

from measured_report.files.config import config
from measured_report.pages.sections import labels_of
from measured_report.records.replicas import measurements_beside
from measured_report.site.page_reader import PageReader
from measured_report.values.format import (
    format_code,
    format_least,
    format_most,
    format_number,
    label_of,
    read_number,
    spellings,
    undusted,
    whole,
)
from measured_report.values.noise import NOISE, Floor, cell_noise, floors_of
from measured_report.values.quantities import LEAST, MOST, SAME, VALUES_FILE
from measured_report.values.scatter import Apart, apart

WRITES = {"": format_number, MOST: format_most, LEAST: format_least}
"""Writers of numbers in words, by how the page says that they are written."""
RELEASE = r" \d+(?:\.\w+)+(?:[+@-]\w+(?:\.\w+)*)*"
EDITION = [re.escape(config().edition_name) + RELEASE] if config().edition_name else []
TYPED = re.compile("|".join([*config().formulas, *EDITION]) or "(?!)")
"""Numbers in drawings and in their words that are names and formulas."""
ABOVE = ("at most", "within", "no more than", "not more than", "up to", "as much as")
BELOW = ("at least", "no less than", "not less than")
SIDES = dict.fromkeys(ABOVE, MOST) | dict.fromkeys(BELOW, LEAST) | {"more than": LEAST, "less than": MOST}
"""Sides from which words bound the number behind them."""
NOT = re.compile(r"\b(?:no|not|nothing|none|never|neither|nor|nowhere|cannot|without)\b", re.IGNORECASE)
"""Words that may turn *more than* and *less than* round, in the same sentence."""
END = re.compile(r"[.;:]\s")
WORDS = rf"\b({'|'.join(SIDES)})\s(?:a factor of\s)?"
NUMBER = r'<data value="([^"]+)"([^>]*)>([^<]*)</data>'
BEFORE = re.compile(WORDS + NUMBER, re.IGNORECASE)
BEHIND = re.compile(rf"{NUMBER}(?:\s[^\s<]{{1,5}})?\s(at (?:most|least))\b")
LAST = re.compile(WORDS + "$", re.IGNORECASE)
OTHER_TAG = re.compile(r"<(?!/?data\b)[^>]*>")


class Data:
    """Read the data that a page's numbers point into."""

    def __init__(self, folder: Path):
        self.folder = folder
        self.file, self._floors, self._apart = cache(self._read), cache(self._floors_beside), cache(self._apart_in)

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
        row = _resolve(self.file(name), place)
        known = cell_noise(column, row, self._floors(name.rpartition("/")[0])), self._apart(name).noise(column, row)
        return kept, max((noise for noise in known if noise is not None), default=None)

    def _floors_beside(self, folder: str) -> Mapping[str, Floor]:
        noise = f"{folder}/{NOISE}.json"
        if not (self.folder / noise).is_file():
            return {}
        return floors_of(self.file(noise)["rows"], self.file(noise)["units"])

    def _apart_in(self, name: str) -> Apart:
        records = measurements_beside(self.folder / name)
        return apart(records) if len(records) > 1 else Apart()

    @cached_property
    def names(self) -> re.Pattern:
        """Match what has a number in it and is none: labels of cases, whole and in parts, and the texts of records."""
        names: set[str] = set()
        for path in self.folder.glob("*/*.json"):
            if path.name != VALUES_FILE:
                rows, labels = self.file(str(path.relative_to(self.folder)))["rows"], labels_of(path.stem)
                names |= {" ".join(cell.split()) for row in rows for cell in row.values() if isinstance(cell, str)}
                for label in (label_of(row["case"], labels) for row in rows if "case" in row):
                    names |= {label, *label.split(", ")}
        longest_first = sorted((name for name in names if re.search(r"\d", name)), key=len, reverse=True)
        return re.compile(rf"(?<![\w.])(?:{'|'.join(map(re.escape, longest_first))})(?![\w.]*\d)")


def check_numbers(page: PageReader, data: Data) -> list[str]:
    """Say what is wrong with the numbers of a page, a line each."""
    return [*_check_written(page, data), *_check_drawn(page, data), *_check_cells(page, data)]


def _check_written(page: PageReader, data: Data) -> list[str]:
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
        elif kept and noise and (said := read_number(text)) is not None and abs(float(said) - kept) > noise:
            problems.append(f"{source} is {kept} within {noise}, and rounded to {text}")
    return problems


def _text(number: Mapping[str, str], kept: float | int | None, noise: float | None, data: Data) -> str:
    """Write a number as it has to be where it is."""
    text, how = format_number(kept, noise=noise), number.get("data-as", "")
    if number["in"] == "code":
        return format_code(kept)
    if how in WRITES:
        return WRITES[how](kept, noise=noise)
    other, its_noise = data.number(how) if how else (None, None)
    is_same = how and format_number(other, noise=its_noise) == text and number["text"] == SAME
    return number["text"] if is_same else text


def _check_drawn(page: PageReader, data: Data) -> list[str]:
    """Check that every number of a drawing and of its words is as its source says, or a name or a tick."""
    problems = []
    for drawn in page.drawn:
        rest = drawn.text
        for source in drawn.sources:
            try:
                value, noise = data.number(source)
                texts = (
                    spellings(value, noise)
                    if drawn.is_drawn
                    else [write(value, noise=noise) for write in WRITES.values()]
                )
            except (OSError, ValueError, LookupError, TypeError):
                problems.append(f"{source} resolves to nothing")
                continue
            found = [whole(text) for text in texts if whole(text).search(rest)]
            if not found:
                problems.append(f"{source} is {value}, which is not said by: {drawn.text}")
            else:
                rest = found[0].sub("", rest, count=1)
        if not drawn.is_tick and re.search(r"\d", rest) and (number := re.search(r"\d\S*", _unnamed(rest, data))):
            problems.append(f"the number {number[0]} leads nowhere in: {drawn.text}")
    return problems


def _check_cells(page: PageReader, data: Data) -> list[str]:
    """Check that words in tables have no numbers but those of names, and of words that a record has."""
    left = ((cell, _unnamed(cell, data)) for cell in page.cells if re.search(r"\d", cell))
    return [
        f"the number {number[0]} leads nowhere in the cell: {cell.strip()}"
        for cell, rest in left
        if (number := re.search(r"\d\S*", rest))
    ]


def _unnamed(text: str, data: Data) -> str:
    """Return a text without names and formulas."""
    return data.names.sub("", TYPED.sub("", text))


def _resolve(data: Any, pointer: str) -> Any:
    for part in pointer.removeprefix("/").split("/"):
        data = data[int(part)] if isinstance(data, list) else data[part]
    return data


def check_bounds(html: str, page: PageReader, data: Data) -> list[str]:
    """Say which bounds of a page err, in its sentences and in the words of its drawings, a line each."""
    text = OTHER_TAG.sub("", html).replace("&nbsp;", " ")
    return [
        f"{words} {written} errs: it is {value}"
        for words, value, written, side in (*_bounds_said(text), *_bounds_drawn(page, data))
        if written != SAME and _errs(Decimal(repr(undusted(float(value)))), written, side)
    ]


def _bounds_said(text: str) -> Iterator[tuple[str, str, str, str]]:
    """Yield the words of each bound, its value, how that is written, and which bound it has to be, if that is plain."""
    for found in BEFORE.finditer(text):
        words, value, attributes, written = found.groups()
        chosen = re.search(f'data-as="({MOST}|{LEAST})"', attributes)
        yield words, value, written, _side(words, text, found.start()) or (chosen[1] if chosen else "")
    for found in BEHIND.finditer(text):
        value, _, written, words = found.groups()
        yield words, value, written, SIDES[words]


def _bounds_drawn(page: PageReader, data: Data) -> Iterator[tuple[str, str, str, str]]:
    """Yield the same for drawings; what is written as a bound there, and is none, has no words."""
    for drawn in page.drawn:
        for value, noise in map(data.number, drawn.sources):
            texts = dict.fromkeys(write(value, noise=noise) for write in WRITES.values()) if value is not None else ()
            places = {text: found.start() for text in texts if (found := whole(text).search(drawn.text))}
            for text in list(places)[:1]:
                words = LAST.search(drawn.text[: places[text]])
                if words:
                    yield words[1], str(value), text, _side(words[1], drawn.text, words.start())
                elif text not in spellings(value, noise):
                    yield "", str(value), text, ""


def _side(words: str, text: str, place: int) -> str:
    """Return ``MOST`` or ``LEAST``; empty where what else the sentence says may turn it round."""
    sentence = END.split(text[max(0, place - 400) : place])[-1] + END.split(text[place : place + 400])[0]
    is_turned = words.lower() in ("more than", "less than") and NOT.search(sentence)
    return "" if is_turned else SIDES[words.lower()]


def _errs(value: Decimal, written: str, side: str) -> bool:
    """Tell whether a number as it is written is on the wrong side of its value, or is none; any, without a side."""
    said = read_number(written)
    if said is None:
        return True
    return {MOST: said < value, LEAST: said > value}.get(side, said != value)
