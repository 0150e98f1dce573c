"""Ways to hold the cube, from the scene as shipped to all remedies, and what each comes to."""

from collections.abc import Sequence
from dataclasses import dataclass

import pandas as pd

from report.names import worlds_name
from report.parts import Table
from report.quantities import Quantity, absent
from report.results import Results, Row

WORLD_COUNTS = (1, 4096, 16384)


@dataclass(frozen=True)
class Way:
    """One combination of remedies."""

    name: str
    setting: str
    """Kind of contacts, integrator and impratio, and pads."""
    remedies: str
    """What is done about the term, and about positions."""
    timed: str = ""
    """Its case in section cure_cost, where it was timed."""
    may_break: str = ""

    def row(self, results: Results, amplitude: str) -> Row:
        return results.row[f"{self.setting}-{amplitude}-{self.remedies}"]


BEST = Way(
    "all, in normal rows too",
    "newton-euler-400-shipped",
    "full-kept",
    "best",
    "as above; bodies that roll",
)
WAYS = (
    Way("shipped pads", "newton-implicitfast-50-shipped", "plain-rounded", "as-shipped", "holds nothing for long"),
    Way("stiff pads", "newton-implicitfast-50-stiff", "plain-rounded", "", "long steps: see the limits"),
    Way("stiff pads, the term", "newton-implicitfast-50-stiff", "term-rounded", "", "as both"),
    Way("the term", "newton-implicitfast-50-shipped", "term-rounded", "term", "bodies that roll and spin at once"),
    Way("the term, RK4", "newton-rk4-50-shipped", "term-rounded", "term-rk4", "the same; time"),
    Way("the term centred, Euler", "newton-euler-50-shipped", "centred-rounded", "", "as the term; damped drives"),
    Way(
        "and a high impratio", "newton-euler-400-shipped", "centred-rounded", "", "the same; solves with few iterations"
    ),
    Way("and compensated positions", "newton-euler-400-shipped", "centred-kept", "", "the same"),
    BEST,
)
STEPS = ("shipped pads", "the term", "the term centred, Euler", "and a high impratio", "and compensated positions")
"""One remedy more each time."""


def use_table(results: Results) -> Table:
    """What to use: for each way its slips, what it costs, and what it may break."""
    columns: dict[str, Sequence] = {
        "slip, 3 cm": [way.row(results, "3cm").slip_mm for way in WAYS],
        "slip, 10 cm": [way.row(results, "10cm").slip_mm for way in WAYS],
        "held still": [way.row(results, "held").slip_mm for way in WAYS],
    }
    for count in WORLD_COUNTS:
        columns[f"frame, {worlds_name(count)}"] = [_frame_ms(results, way, count) for way in WAYS]
    columns["may break"] = [way.may_break for way in WAYS]
    return Table(pd.DataFrame(columns, index=pd.Index([way.name for way in WAYS], name="what is done")))


def _frame_ms(results: Results, way: Way, count: int) -> Quantity:
    timed = results.others.get("cure_cost")
    for row in timed.rows if timed else []:
        if way.timed and (row.case, row.worlds.value) == (way.timed, count):
            return row.frame_ms
    return absent("ms", "it was not timed")
