"""Alterations: a record as other hardware, a bug or a hand might have made it, one column or its rows at a time.

Whatever is altered, the pages stand, without a number that no record has, and what can't be shown is named in one line.
``python -m tests.torture`` tries that on whole records, and a test on small ones.
"""

import json
import os
import shutil
import signal
from argparse import Namespace
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import nullcontext, redirect_stderr, redirect_stdout
from io import StringIO
from random import Random
from traceback import extract_tb
from typing import Any
from unittest.mock import patch

from markupsafe import Markup

from measured_report.commands import page
from measured_report.editions.project import Project, own_release
from measured_report.editions.stack import stack_of
from measured_report.files.atomic import remove
from measured_report.files.cache import FOLDER as CACHE
from measured_report.parts.drawing import Drawing
from measured_report.parts.section import Figure, Pictures
from measured_report.records.columns import REASON, columns_of, is_number, units_of
from measured_report.site.check import check_site

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


LIMIT_S = 300
"""A build that takes longer does not end."""
AT_ONCE, DRAWN_EVERY = 10, 4
"""So many records are altered at once, since most of the time goes into the pages of the others; and how seldom what is
to be drawn is drawn, which takes longer than all else."""


def alterations(world, trial, moments: int, release: str) -> Iterator:
    """Records altered at random, of all sections of the own release and of another one.

    The pages are built in this process, which has loaded by then what takes longer than a build.
    """
    trial.name = f"altered records, {AT_ONCE} at once: no traceback, no false number, each shown or named in one line"
    whole = type(world).made(world.root.parent / "whole", {own_release(): (), release: ()}, {})
    project = Project(own_release(), root=whole.root)
    build_page(project)
    cache, kept = whole.root / CACHE, whole.root.parent / "kept"
    cache.rename(kept)
    paths = sorted(project.results.parent.glob("*/*.json"))
    while trial.tried < trial.of:
        chance = Random(trial.tried)
        before = {path: path.read_bytes() for path in chance.sample(paths, AT_ONCE)}
        words = {}
        for path, content in before.items():
            words[path], record = altered(json.loads(content), chance)
            path.write_text(json.dumps(record), encoding="utf-8")
        remove(cache)
        shutil.copytree(kept, cache, copy_function=os.link)  # what is written there takes the place of the link
        is_drawn = trial.tried % (AT_ONCE * DRAWN_EVERY) == 0
        with nullcontext() if is_drawn else patch.multiple(Drawing, begin=lambda *_: None, all=_undrawn):
            status, lines = build_page(project)
        is_said = status == bool(lines) and all(line.startswith("damaged: ") for line in lines)
        found = [] if is_said else [f"status {status}: {' / '.join(lines)[-300:]}"]
        found += check_site(project.site)[:2]
        for path in before:
            place = f"{path.parent.name}/{path.name}"
            shown, named = project.site / "data" / place, [line for line in lines if place in line]
            is_shown = shown.is_file() and shown.read_bytes() == path.read_bytes()
            own = [] if is_shown or len(named) == 1 else [f"not shown, and named in {len(named)} lines"]
            trial(f"{place}, {words[path]}", *own, *found)
            found = []  # it is of all of them, and counts once
        for path, content in before.items():
            path.write_bytes(content)
        yield trial


UNDRAWN = Markup('<svg class="broad" viewBox="0 0 1 1" role="img"></svg>')


def _undrawn(_: Drawing, figures: Sequence[Figure], meanwhile: Callable[[], None]) -> list[Pictures]:
    meanwhile()
    return [(UNDRAWN, UNDRAWN)] * len(figures)


def build_page(project: Project) -> tuple[int, list[str]]:
    """Build the site as ``make page`` does; its status, and what it says is wrong, a line each."""
    said = StringIO()
    signal.signal(signal.SIGALRM, signal.default_int_handler)
    signal.alarm(LIMIT_S)
    try:
        with redirect_stdout(StringIO()), redirect_stderr(said):
            status = page.run(project, Namespace(stack=stack_of(project.release), address=""))
    except (Exception, KeyboardInterrupt) as error:
        where = extract_tb(error.__traceback__)[-1]
        return -1, [*said.getvalue().splitlines(), f"{type(error).__name__}: {error} ({where.name}:{where.lineno})"]
    finally:
        signal.alarm(0)
    return status, said.getvalue().splitlines()
