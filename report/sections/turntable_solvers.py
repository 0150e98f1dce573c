"""The box on the turning table with Newton's other solvers: which of them let it walk, and whether the step is why."""

from collections.abc import Mapping

import pandas as pd
from markupsafe import Markup

from report.claims import Claim, Outcome, at_least, at_most
from report.deriving.arithmetic import extreme, ratio, size_share
from report.parts import Section, Table
from report.quantities import Value, absent
from report.results import Results, Row

order = 142
page = "fix"

SOLVERS = {
    "mujoco": "MuJoCo Warp",
    "xpbd": "XPBD",
    "kamino": "Kamino",
    "featherstone": "Featherstone",
    "semi-implicit": "semi-implicit",
    "vbd": "VBD",
}
LONG, SHORT = "2ms", "1ms"
"""Steps."""
Growths = Mapping[tuple[str, str], Value]
"""By solver and step, of those that keep the box where it belongs."""


def derive(results: Results) -> Section:
    rows = {(solver, step): results.row[f"{solver}-{step}"] for solver in SOLVERS for step in (LONG, SHORT)}
    growths = {key: _growth(results, key, row) for key, row in rows.items() if row and row.stays}
    return Section(
        tables={"solvers": _table(rows, growths)},
        claims=[_nobody_stands(results, growths), _goes_with_step(results, growths), _kamino_is_step(results, growths)],
    )


def _growth(results: Results, key: tuple[str, str], row: Row) -> Value:
    formula = f"growth_per_s of {row.case}, in percent of the distance from the axis"
    return results.value("_".join(key), formula, lambda rate: 100 * rate, row.growth_per_s, unit="%/s")


def _of(growths: Growths, solver: str, step: str) -> Value:
    return growths.get((solver, step)) or absent("%/s", f"{SOLVERS[solver]} does not hold the box, or was not run")
