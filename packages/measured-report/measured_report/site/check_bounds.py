"""Check of the bounds that a page says: none errs against its own value for being rounded."""

import re
from collections.abc import Iterator
from decimal import Decimal

from measured_report.site.check_numbers import WRITES, Data
from measured_report.site.page_reader import PageReader
from measured_report.values.format import read_number, spellings, undusted, whole
from measured_report.values.quantities import LEAST, MOST, SAME

ABOVE = ("at most", "within", "no more than", "not more than")
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


def check_bounds(html: str, page: PageReader, data: Data) -> list[str]:
    """Say which bounds of a page err, in its sentences and in the words of its drawings, a line each."""
    text = OTHER_TAG.sub("", html).replace("&nbsp;", " ")
    return [
        f"{words} {written} errs: it is {value}"
        for words, value, written, side in (*_said(text), *_drawn(page, data))
        if written != SAME and _errs(Decimal(repr(undusted(float(value)))), written, side)
    ]


def _said(text: str) -> Iterator[tuple[str, str, str, str]]:
    """Yield the words of each bound, its value, how that is written, and which bound it has to be, if that is plain."""
    for found in BEFORE.finditer(text):
        words, value, attributes, written = found.groups()
        chosen = re.search(f'data-as="({MOST}|{LEAST})"', attributes)
        yield words, value, written, _side(words, text, found.start()) or (chosen[1] if chosen else "")
    for found in BEHIND.finditer(text):
        value, _, written, words = found.groups()
        yield words, value, written, SIDES[words]


def _drawn(page: PageReader, data: Data) -> Iterator[tuple[str, str, str, str]]:
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
    """``MOST`` or ``LEAST``; empty where what else the sentence says may turn it round."""
    sentence = END.split(text[max(0, place - 400) : place])[-1] + END.split(text[place : place + 400])[0]
    is_turned = words.lower() in ("more than", "less than") and NOT.search(sentence)
    return "" if is_turned else SIDES[words.lower()]


def _errs(value: Decimal, written: str, side: str) -> bool:
    """Tell whether a number as it is written is on the wrong side of its value, or is none; any, without a side."""
    said = read_number(written)
    if said is None:
        return True
    return {MOST: said < value, LEAST: said > value}.get(side, said != value)
