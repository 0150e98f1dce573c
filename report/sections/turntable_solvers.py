"""The box on the turning table with Newton's other solvers: which of them let it walk, and whether the step is why."""

from collections.abc import Mapping

import pandas as pd

from measured_report.claims.claims import Claim, all_of, at_least, at_most
from measured_report.parts.parts import Section, Table
from measured_report.values.quantities import Value, absent
from measured_report.values.results import Results, Row
from report.shared.arithmetic import cell_count, extreme, ratio

order = 142
page = "cure"
label = "turntable, other solvers"

SOLVERS = {
    "mujoco": "MuJoCo Warp",
    "xpbd": "XPBD",
    "kamino": "Kamino",
    "featherstone": "Featherstone",
    "semi-implicit": "semi-implicit",
    "vbd": "VBD",
}
LONG, SHORT = STEPS = ("2ms", "1ms")
Growths = Mapping[tuple[str, str], Value]
"""By solver and step, of those that keep the box where it belongs."""


def derive(results: Results) -> Section:
    rows = {(solver, step): results.row[f"{solver}-{step}"] for solver in SOLVERS for step in STEPS}
    growths = {key: _growth(results, key, row) for key, row in rows.items() if row and row.stays}
    return Section(
        tables={"solvers": _table(rows, growths)},
        claims=[_only_here_it_stays(results, rows, growths), _kamino_walks_by_its_step(results, rows, growths)],
    )


def _growth(results: Results, key: tuple[str, str], row: Row) -> Value:
    formula = f"growth_per_s of {row.case}, in percent of the distance from the axis"
    return results.value("_".join(key), formula, lambda rate: 100 * rate, row.growth_per_s, unit="%/s")


def _only_here_it_stays(results: Results, rows: Mapping[tuple[str, str], Row], growths: Growths) -> Claim:
    """Whether half the step halves the walk in the other solvers, and not in MuJoCo Warp."""
    kept = {
        solver: ratio(
            results,
            f"{solver}_kept",
            "growth with half the step over that with the whole",
            growths[solver, SHORT],
            growths[solver, LONG],
        )
        for solver in SOLVERS
        if {(solver, SHORT), (solver, LONG)} <= set(growths)
    }
    mine = kept.get("mujoco") or absent("1", "MuJoCo Warp was not run")
    largest = extreme(results, "others_kept", "largest of the others", max, [kept[s] for s in kept if s != "mujoco"])
    count = cell_count(results, "other_count", "others", [kept[s] for s in kept if s != "mujoco"])
    most = results.chosen("kept_most", "about half", 0.6)
    least = results.chosen("kept_least", "about as much", 0.9)
    lost = absent("%/s", "MuJoCo Warp does not hold the box, or was not run")
    long, short = (growths.get(("mujoco", step)) or lost for step in STEPS)
    numbers = {"growth_long": long, "growth_short": short, "largest": largest, "count": count}
    numbers |= {"long": rows["mujoco", LONG].step_ms, "short": rows["mujoco", SHORT].step_ms}
    return Claim("only_here_it_stays", all_of(at_least(mine, least), at_most(largest, most)), numbers=numbers)


def _kamino_walks_by_its_step(results: Results, rows: Mapping[tuple[str, str], Row], growths: Growths) -> Claim:
    """A contact at rest at one end of a step, which moves by its velocity there, walks by half of what bends its
    path."""
    found = growths.get(("kamino", LONG)) or absent("%/s", "Kamino does not hold the box, or was not run")
    law = results.value(
        "step_walk",
        "ω² h / 2, in percent of the distance from the axis",
        lambda step_ms, turn: 100 * turn**2 * 1e-3 * step_ms / 2,
        rows["kamino", LONG].step_ms,
        results.chosen("turn", "given: how fast the table turns [rad/s]", 2.0),
        unit="%/s",
    )
    off = results.value(
        "step_walk_off", "growth over that, less one", lambda a, b: 100 * abs(a / b - 1), found, law, unit="%"
    )
    bound = results.chosen("step_walk_bound", "the same", 5.0, unit="%")
    return Claim("kamino_walks_by_its_step", at_most(off, bound), numbers={"growth": found, "law": law})


def _table(rows: Mapping[tuple[str, str], Row], growths: Growths) -> Table:
    def cell(solver: str, step: str):
        row = rows[solver, step]
        if row and not row.stays:
            return "sinks in or lost" if row.end_radius_mm.value is not None else row.end_radius_mm
        return growths.get((solver, step)) or absent("%/s", "it was not run")

    columns = {f"step of {step.replace('ms', ' ms')}": [cell(solver, step) for solver in SOLVERS] for step in STEPS}
    return Table(pd.DataFrame(columns, index=pd.Index(list(SOLVERS.values()), name="solver")))
