"""Alterations of one record, as other hardware, a bug or a hand might have made it: a column or its rows at a time."""

from collections.abc import Callable, Mapping
from random import Random
from typing import Any

from measured_report.records.columns import REASON, columns_of, is_number, units_of

Row = dict[str, Any]

NUMBERS: Mapping[str, Callable[[Any, Random], Any]] = {
    "null": lambda cell, chance: None,
    "zero": lambda cell, chance: type(cell)(0),
    "negative": lambda cell, chance: -cell,
    "text": lambda cell, chance: "7.77 mm",
    "huge": lambda cell, chance: cell * 10**6,
    "tiny": lambda cell, chance: cell * 1e-9,
    "other": lambda cell, chance: type(cell)(cell * chance.uniform(0.5, 2.0)),
}
"""What may be in the place of a number, by name."""
WORDS: Mapping[str, Callable[[Any, Random], Any]] = {
    "null": lambda cell, chance: None,
    "text": lambda cell, chance: chance.choice(("x", "7.77 mm", "<b>1.23</b>", "{{ 7 }}", "=1+1", "", "a.b/c d", "0")),
    "yes or no": lambda cell, chance: chance.random() < 0.5,
    "number": lambda cell, chance: 7.77,
}
"""What may be in the place of a text, or of yes or no."""
ROWS: Mapping[str, Callable[[list[Row], Random], list[Row]]] = {
    "lost rows": lambda rows, chance: [row for row in rows if chance.random() < 0.5],
    "one row": lambda rows, chance: [chance.choice(rows)],
    "reversed": lambda rows, chance: rows[::-1],
    "in another order": lambda rows, chance: chance.sample(rows, len(rows)),
    "a row twice": lambda rows, chance: [*rows, chance.choice(rows)],
    "rows alike": lambda rows, chance: [{**rows[0], "case": row["case"]} for row in rows],
}
"""What may have become of all rows, by name."""


def altered(record: Mapping[str, Any], chance: Random) -> tuple[str, dict[str, Any]]:
    """The JSON of a record with something in it altered, and what that is in words."""
    rows = [dict(row) for row in record["rows"]]
    if chance.random() < 0.25:
        words, change = chance.choice(list(ROWS.items()))
        rows = change(rows, chance)
    else:
        words, rows = _column_altered(rows, chance)
    return words, {**record, "rows": rows, "units": units_of(rows)}


def _column_altered(rows: list[Row], chance: Random) -> tuple[str, list[Row]]:
    """One column altered, in all rows or in one; a number that goes has its reason beside it, or seldom none."""
    column = chance.choice(columns_of(rows))
    there = [row for row in rows if row.get(column) is not None]
    kinds = NUMBERS if any(is_number(row[column]) for row in there) else WORDS
    name, change = chance.choice([*kinds.items(), ("gone", None)])
    hit = [chance.choice(there)] if there and chance.random() < 0.4 else there
    for row in hit:
        if change is None:
            del row[column]
        elif is_number(row[column]) or kinds is WORDS:
            row[column] = change(row[column], chance)
        if row.get(column, 0) is None and chance.random() < 0.9:
            row[column + REASON] = "the sensor was off"
    return f"{column} {name}{' in one row' * (len(hit) < len(there))}", rows
